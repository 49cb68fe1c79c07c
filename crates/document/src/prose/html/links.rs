//! Links and images: permitted targets and sources.

use super::{Image, Writer};
use crate::prose::text::anchor;
use model::{Diagnostic, Span};
use pulldown_cmark::{Event, Tag, TagEnd};
use units::markup::escaped;
use units::words;

impl Writer<'_> {
    /// Opens a link. A link to a forbidden target is reported and written as text.
    pub(super) fn link(&mut self, destination: &str, span: Span) {
        if let Some(title) = destination.strip_prefix('#') {
            self.open(&format!("<a href=\"#{}\">", escaped(&anchor(title))), "</a>");
        } else if has_scheme(destination, "mailto:") {
            self.open(&format!("<a href=\"{}\">", escaped(destination)), "</a>");
        } else if has_scheme(destination, "http://") || has_scheme(destination, "https://") {
            let href = escaped(destination);
            self.open(&format!("<a href=\"{href}\" target=\"_blank\" rel=\"noopener noreferrer\">"), "</a>");
        } else {
            self.diagnostics.push(
                Diagnostic::error("link", words!("a link cannot lead to `{}`", shortened(destination)), span)
                    .with_hint(words(
                        "links lead to http:, https: or mailto: addresses or to a heading (`#activities`)",
                    )),
            );
            self.open("", "");
        }
    }

    /// Begins an image. Only images embedded in the document are shown.
    pub(super) fn image(&mut self, source: &str, span: Span) {
        let kinds = ["png", "jpeg", "gif", "webp"];
        let allowed = kinds.iter().any(|kind| has_scheme(source, &format!("data:image/{kind};base64,")));
        let around = if allowed {
            (format!("<img src=\"{}\" alt=\"", escaped(source)), "\">")
        } else {
            self.diagnostics.push(
                Diagnostic::error("image", words!("an image cannot come from `{}`", shortened(source)), span)
                    .with_hint(words("the page makes no requests: embed it, `data:image/png;base64,...`")),
            );
            ("<span class=\"problem\">".to_owned(), "</span>")
        };
        self.image = Some(Image { around, alternative: String::new(), nested: 0 });
    }

    /// Consumes the events inside the alternative text of an image; returns other events.
    pub(super) fn inside_image<'e>(&mut self, event: Event<'e>) -> Option<Event<'e>> {
        let Some(image) = &mut self.image else {
            return Some(event);
        };
        match event {
            Event::Start(Tag::Image { .. }) => image.nested += 1,
            Event::End(TagEnd::Image) if image.nested > 0 => image.nested -= 1,
            Event::End(TagEnd::Image) => {
                let html = format!("{}{}{}", image.around.0, escaped(&image.alternative), image.around.1);
                self.out.push_str(&html);
                self.image = None;
            }
            Event::Text(text) | Event::Code(text) | Event::InlineMath(text) => image.alternative.push_str(&text),
            Event::SoftBreak | Event::HardBreak => image.alternative.push(' '),
            _ => {}
        }
        None
    }
}

/// True if an address begins with `scheme` (ASCII), ignoring case.
fn has_scheme(address: &str, scheme: &str) -> bool {
    address.get(..scheme.len()).is_some_and(|start| start.eq_ignore_ascii_case(scheme))
}

/// First 40 characters of a long address, for a message.
fn shortened(address: &str) -> String {
    match address.char_indices().nth(40) {
        Some((end, _)) => format!("{}...", &address[..end]),
        None => address.to_owned(),
    }
}

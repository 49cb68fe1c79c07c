//! What was found in a document, with its places in the text.

use crate::app::App;
use document::page::Source;
use leptos::prelude::*;
use model::{Diagnostic, Severity, Span};

/// In place of the apparatus, for a document that does not run.
pub fn view(app: App) -> AnyView {
    let words = app.words();
    let (sources, findings) = app.with(|lab| (lab.sources.clone(), lab.findings.clone())).unwrap_or_default();
    if sources.is_empty() {
        return view! { <section class="broken"><h2>{words.nothing}</h2><p>{words.nothing_intro}</p></section> }
            .into_any();
    }
    let list = list(app, &sources, &findings);
    view! { <section class="broken"><h2>{words.broken}</h2><p>{words.broken_intro}</p>{list}</section> }.into_any()
}

/// Remarks on a document that runs; nothing if there are none.
pub fn remarks(app: App) -> AnyView {
    let words = app.words();
    let (sources, findings) = app.with(|lab| (lab.sources.clone(), lab.findings.clone())).unwrap_or_default();
    if findings.is_empty() {
        return ().into_any();
    }
    let list = list(app, &sources, &findings);
    view! { <section><h3>{words.warnings}</h3>{list}</section> }.into_any()
}

fn list(app: App, sources: &[Source], findings: &[(usize, Diagnostic)]) -> AnyView {
    let items = findings
        .iter()
        .map(|(file, diagnostic)| {
            let source = sources.get(*file);
            view! { <li>{finding(app, source, diagnostic)}</li> }
        })
        .collect_view();
    view! { <ol class="findings">{items}</ol> }.into_any()
}

fn finding(app: App, source: Option<&Source>, diagnostic: &Diagnostic) -> AnyView {
    let words = app.words();
    let (kind, class) = match diagnostic.severity {
        Severity::Error => (words.error, "finding error"),
        Severity::Warning => (words.warning, "finding warning"),
    };
    let places = source.map(|source| {
        diagnostic
            .labels
            .iter()
            .map(|label| {
                let place = Place::of(&source.text, label.span);
                let head = format!("{}, {} {}", source.name, words.line, place.line);
                view! {
                    <p class="place">{head}</p>
                    <pre tabindex="0"><code>{place.before}<mark>{place.marked}</mark>{place.after}</code></pre>
                    <p class="label">{label.text.clone()}</p>
                }
            })
            .collect_view()
    });
    let notes = diagnostic
        .notes
        .iter()
        .map(|note| view! { <pre tabindex="0" class="reason">{note.clone()}</pre> })
        .collect_view();
    let hints = diagnostic
        .hints
        .iter()
        .map(|hint| view! { <p class="remedy"><strong>{words.help}": "</strong>{hint.clone()}</p> })
        .collect_view();
    view! {
        <article class=class>
            <h3><span class="badge">{kind}</span>" "{diagnostic.message.clone()}</h3>
            {places}{notes}{hints}
            <p class="code">{diagnostic.code}</p>
        </article>
    }
    .into_any()
}

/// A span within its line.
struct Place {
    line: usize,
    before: String,
    marked: String,
    after: String,
}

impl Place {
    /// The line of `text` in which `span` begins; of a span over several lines, what is in the first one.
    fn of(text: &str, span: Span) -> Self {
        let boundary = |mut at: usize| {
            at = at.min(text.len());
            while !text.is_char_boundary(at) {
                at -= 1;
            }
            at
        };
        let start = boundary(span.start);
        let first = text[..start].rfind('\n').map_or(0, |at| at + 1);
        let last = text[start..].find('\n').map_or(text.len(), |at| start + at);
        let end = boundary(span.end).clamp(start, last);
        Self {
            line: text[..start].matches('\n').count() + 1,
            before: text[first..start].to_owned(),
            marked: text[start..end].to_owned(),
            after: text[end..last].to_owned(),
        }
    }
}

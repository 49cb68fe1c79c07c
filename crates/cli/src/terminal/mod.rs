//! Output of diagnostics: as text with the source line (here), and as JSON (`findings.rs`).

pub(crate) mod excerpt;
pub(crate) mod findings;
pub(crate) mod language;
pub(crate) mod output;
pub(crate) mod progress;
pub(crate) mod unfinished;
pub(crate) mod visible;

use crate::arguments::Color;
use codespan_reporting::diagnostic as shown;
use codespan_reporting::files::SimpleFiles;
use codespan_reporting::term;
use codespan_reporting::term::termcolor::{Ansi, NoColor, WriteColor};
use excerpt::Excerpt;
use model::{Diagnostic, Severity, Span};
use runner::{Loaded, Sources};
use std::io::{IsTerminal, Write};
use units::Language;
use visible::{Visible, visible};

/// Settings of messages on the terminal.
#[derive(Clone, Copy, Debug)]
pub struct Terminal {
    color: Color,
    /// The language of messages.
    pub language: Language,
}

impl Terminal {
    /// Settings with this use of colour and this language.
    pub fn new(color: Color, language: Language) -> Self {
        Self { color, language }
    }

    fn colors(self, is_terminal: bool) -> bool {
        let plain = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty())
            || std::env::var_os("TERM").is_some_and(|value| value == "dumb");
        match self.color {
            Color::Always => true,
            Color::Never => false,
            Color::Auto => is_terminal && !plain,
        }
    }

    /// True if text on the standard output is coloured.
    pub fn standard_output_colors(self) -> bool {
        self.colors(std::io::stdout().is_terminal())
    }

    /// Writes all findings about a document to the standard error.
    pub fn report(self, loaded: &Loaded) {
        let colors = self.colors(std::io::stderr().is_terminal());
        write(&findings_as_text(std::slice::from_ref(loaded), self.language, colors));
    }

    /// Writes one finding about a document to the standard error.
    pub fn report_one(self, sources: &Sources, diagnostic: &Diagnostic) {
        let colors = self.colors(std::io::stderr().is_terminal());
        write(&rendered(sources, [(0, diagnostic)], self.language, colors));
    }

    /// Writes an error without a position in a document.
    pub fn error(self, message: &str, hint: Option<&str>) {
        let notes = hint.map(|hint| hinted(hint, self.language)).into_iter().collect();
        let error = shown::Diagnostic::error().with_message(message).with_notes(notes);
        let colors = self.colors(std::io::stderr().is_terminal());
        write(&emitted(&SimpleFiles::new(), [error], self.language, colors));
    }

    /// Writes a finding about measured data to the standard error.
    pub fn note(self, finding: &analysis::finding::Finding) {
        let text = finding.text(self.language);
        self.print(&format!("{}: {text}\n", self.language.say("note")));
    }

    /// Writes text to the standard error, with control characters escaped.
    pub fn print(self, text: &str) {
        write(&visible(text));
    }
}

/// Writes to the standard error. If that is closed, the message is lost.
fn write(text: &str) {
    let _ = std::io::stderr().lock().write_all(text.as_bytes());
}

/// Text of all findings with their positions.
pub fn findings_as_text(documents: &[Loaded], language: Language, colors: bool) -> String {
    let mut text = String::new();
    for loaded in documents {
        let findings = loaded.opened.diagnostics.iter().map(|(file, diagnostic)| (*file, diagnostic));
        text.push_str(&rendered(&loaded.sources, findings, language, colors));
    }
    text
}

fn rendered<'a>(
    sources: &Sources,
    findings: impl IntoIterator<Item = (usize, &'a Diagnostic)>,
    language: Language,
    colors: bool,
) -> String {
    let mut files = SimpleFiles::new();
    let texts: Vec<&str> = sources.texts().map(|(_, text)| text).collect();
    let ids: Vec<usize> = sources.texts().map(|(path, text)| files.add(path.display().to_string(), text)).collect();
    let findings = findings.into_iter().filter_map(|(file, diagnostic)| {
        let (&id, &text) = (ids.get(file)?, texts.get(file)?);
        Some(with_places(diagnostic, id, text, language))
    });
    emitted(&files, findings, language, colors)
}

fn hinted(hint: &str, language: Language) -> String {
    format!("{}: {hint}", language.say("hint"))
}

fn with_places(diagnostic: &Diagnostic, file: usize, text: &str, language: Language) -> shown::Diagnostic<usize> {
    let severity = match diagnostic.severity {
        Severity::Error => shown::Severity::Error,
        Severity::Warning => shown::Severity::Warning,
    };
    let labels = diagnostic.labels.iter().enumerate().map(|(index, label)| {
        let range = inside(label.span, text).range();
        let place = if index == 0 { shown::Label::primary(file, range) } else { shown::Label::secondary(file, range) };
        place.with_message(label.text.text(language))
    });
    let hints = diagnostic.hints.iter().map(|hint| hinted(&hint.text(language), language));
    let notes = diagnostic.notes.iter().map(|note| note.text(language).into_owned()).chain(hints);
    shown::Diagnostic::new(severity)
        .with_code(diagnostic.code)
        .with_message(diagnostic.message.text(language))
        .with_labels(labels.collect())
        .with_notes(notes.collect())
}

fn emitted<'a>(
    files: &'a SimpleFiles<String, &'a str>,
    findings: impl IntoIterator<Item = shown::Diagnostic<usize>>,
    language: Language,
    colors: bool,
) -> String {
    let mut text = String::new();
    for mut finding in findings {
        let mut bytes = Vec::new();
        let writer: &mut dyn WriteColor =
            if colors { &mut Visible::new(Ansi::new(&mut bytes)) } else { &mut Visible::new(NoColor::new(&mut bytes)) };
        let excerpt = Excerpt::of(files, &mut finding, language);
        // Writing to memory cannot fail, and all labels are inside their texts.
        let _ = term::emit_to_write_style(writer, &term::Config::default(), &excerpt, &finding);
        let _ = writer.flush();
        let shown = String::from_utf8_lossy(&bytes);
        // The library starts with the English name of the severity.
        let [error, warning] = language.say_all(["error", "warning"]);
        let shown = shown.replacen("error[", &[error, "["].concat(), 1);
        text.push_str(&shown.replacen("warning[", &[warning, "["].concat(), 1));
    }
    text
}

/// The span, clipped to the text and to character boundaries.
fn inside(span: Span, text: &str) -> Span {
    let end = text.ceil_char_boundary(span.end.min(text.len()));
    let start = text.floor_char_boundary(span.start.min(end));
    Span::new(start, end)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_outside_the_text_are_moved_inside() {
        assert_eq!(inside(Span::new(40, 50), "γ"), Span::new(2, 2));
        assert_eq!(inside(Span::new(1, 1), "γ"), Span::new(0, 2));
        assert_eq!(inside(Span::new(2, 1), "abc"), Span::new(1, 1));
    }
}

//! What was found in a document, with its places in the text.

use crate::app::App;
use crate::views::*;
use document::page::Source;
use model::{Diagnostic, Label, Severity};
use units::{Language, Words};

/// In place of the apparatus, for a document that does not run.
pub fn view(app: App) -> View {
    let words = app.words();
    let (sources, findings) = app.with(|lab| (lab.sources.clone(), lab.findings.clone())).unwrap_or_default();
    if sources.is_empty() {
        return section().class("broken").child(h2().child(words.nothing)).child(p().child(words.nothing_intro)).into();
    }
    let list = list(app, &sources, &findings);
    section().class("broken").child(h2().child(words.broken)).child(p().child(words.broken_intro)).child(list).into()
}

/// Remarks on a document that runs; nothing if there are none.
pub fn remarks(app: App) -> View {
    let words = app.words();
    let (sources, findings) = app.with(|lab| (lab.sources.clone(), lab.findings.clone())).unwrap_or_default();
    if findings.is_empty() {
        return View::new();
    }
    let list = list(app, &sources, &findings);
    section().child(h3().child(words.warnings)).child(list).into()
}

fn list(app: App, sources: &[Source], findings: &[(usize, Diagnostic)]) -> HtmlOl {
    let item = |(file, diagnostic): &(usize, Diagnostic)| li().child(finding(app, sources.get(*file), diagnostic));
    ol().class("findings").each(findings, item)
}

fn finding(app: App, source: Option<&Source>, diagnostic: &Diagnostic) -> HtmlArticle {
    let (words, language) = (app.words(), Language::of(app.language.get_untracked().tag()));
    let (kind, class) = match diagnostic.severity {
        Severity::Error => (words.error, "finding error"),
        Severity::Warning => (words.warning, "finding warning"),
    };
    let (text, name) = source.map_or(("", ""), |source| (&source.text, &source.name));
    let places = if source.is_some() { places(text, &diagnostic.labels, language) } else { Vec::new() };
    let note = |note: &Words| pre().tabindex("0").class("reason").child(note.text(language).to_owned());
    let hint = |hint: &Words| {
        let text = hint.text(language).to_owned();
        p().class("remedy").child(strong().child(words.help).child(": ")).child(text)
    };
    article()
        .class(class)
        .child(
            h3().child(span().class("badge").child(kind))
                .child(" ")
                .child(diagnostic.message.text(language).to_owned()),
        )
        .each(places, |place| place.view(app, name))
        .each(&diagnostic.notes, note)
        .each(&diagnostic.hints, hint)
        .child(p().class("code").child(diagnostic.code))
}

/// A line of the source with what is marked in it.
struct Place {
    number: usize,
    /// The line, cut into what is marked and what is not.
    pieces: Vec<(String, bool)>,
    /// What is marked, and what there is to say about it.
    remarks: Vec<(String, String)>,
}

/// The lines that the labels mark, in the order of the labels; several labels of one line share it.
fn places(text: &str, labels: &[Label], language: Language) -> Vec<Place> {
    let mut lines: Vec<(usize, usize, Vec<&Label>)> = Vec::new();
    for label in labels {
        let start = boundary(text, label.span.start);
        let first = text[..start].rfind('\n').map_or(0, |at| at + 1);
        let last = text[start..].find('\n').map_or(text.len(), |at| start + at);
        match lines.iter_mut().find(|line| line.0 == first) {
            Some(line) => line.2.push(label),
            None => lines.push((first, last, vec![label])),
        }
    }
    lines.into_iter().map(|(first, last, labels)| Place::of(text, (first, last), &labels, language)).collect()
}

/// The nearest place at or before `at` where a character begins.
fn boundary(text: &str, at: usize) -> usize {
    let mut at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

impl Place {
    /// Of a span over several lines, what is in the first one is marked.
    fn of(text: &str, (first, last): (usize, usize), labels: &[&Label], language: Language) -> Self {
        let span = |label: &Label| {
            let start = boundary(text, label.span.start);
            (start, boundary(text, label.span.end).clamp(start, last))
        };
        let mut spans: Vec<(usize, usize)> = labels.iter().map(|label| span(label)).collect();
        spans.sort_unstable();
        let (mut pieces, mut at) = (Vec::new(), first);
        for (start, end) in spans {
            let start = start.max(at);
            pieces.push((text[at..start].to_owned(), false));
            at = end.max(start);
            pieces.push((text[start..at].to_owned(), true));
        }
        pieces.push((text[at..last].to_owned(), false));
        let remark = |label: &&Label| {
            let (start, end) = span(label);
            (text[start..end].to_owned(), label.text.text(language).to_owned())
        };
        let remarks = labels.iter().filter(|label| !label.text.is_empty()).map(remark).collect();
        Self { number: text[..first].matches('\n').count() + 1, pieces, remarks }
    }

    fn view(self, app: App, file: &str) -> View {
        let head = format!("{file}, {} {}", app.words().line, self.number);
        let piece =
            |(piece, marked): (String, bool)| if marked { mark().child(piece).into() } else { View::from(piece) };
        let remark = |(marked, remark): (String, String)| li().child(code().child(marked)).child(" ").child(remark);
        View::from((
            p().class("place").child(head),
            pre().tabindex("0").child(code().each(self.pieces, piece)),
            ul().class("remarks").each(self.remarks, remark),
        ))
    }
}

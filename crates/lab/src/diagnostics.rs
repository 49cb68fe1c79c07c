//! What was found in a document, with its places in the text.

use crate::app::App;
use document::page::Source;
use leptos::prelude::*;
use model::{Diagnostic, Label, Severity};

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
        places(&source.text, &diagnostic.labels).into_iter().map(|place| place.view(app, &source.name)).collect_view()
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

/// A line of the source with what is marked in it.
struct Place {
    number: usize,
    /// The line, cut into what is marked and what is not.
    pieces: Vec<(String, bool)>,
    /// What is marked, and what there is to say about it.
    remarks: Vec<(String, String)>,
}

/// The lines that the labels mark, in the order of the labels; several labels of one line share it.
fn places(text: &str, labels: &[Label]) -> Vec<Place> {
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
    lines.into_iter().map(|(first, last, labels)| Place::of(text, first, last, &labels)).collect()
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
    fn of(text: &str, first: usize, last: usize, labels: &[&Label]) -> Self {
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
            (text[start..end].to_owned(), label.text.clone())
        };
        let remarks = labels.iter().filter(|label| !label.text.is_empty()).map(remark).collect();
        Self { number: text[..first].matches('\n').count() + 1, pieces, remarks }
    }

    fn view(self, app: App, file: &str) -> AnyView {
        let head = format!("{file}, {} {}", app.words().line, self.number);
        let line = self
            .pieces
            .into_iter()
            .map(|(piece, marked)| if marked { view! { <mark>{piece}</mark> }.into_any() } else { piece.into_any() })
            .collect_view();
        let remarks = self
            .remarks
            .into_iter()
            .map(|(marked, remark)| view! { <li><code>{marked}</code>" "{remark}</li> })
            .collect_view();
        view! {
            <p class="place">{head}</p>
            <pre tabindex="0"><code>{line}</code></pre>
            <ul class="remarks">{remarks}</ul>
        }
        .into_any()
    }
}

//! Diagnostics of a document, with their places in the text.

use crate::app::App;
use crate::{documents::titles, documents::visited};
use document::page::Source;
use model::{Diagnostic, Fix, Label, Severity};
use std::rc::Rc;
use units::alphabet::capitalised;
use units::order::sort;
use units::{Language, Words};
use view::views::*;

/// Actions on a diagnostic whose text is open. Files are identified by their index.
#[derive(Clone)]
pub struct Leads {
    /// Goes to a place in a file: (file index, byte offset).
    pub go: Rc<dyn Fn(usize, usize)>,
    /// Applies a remedy to a file, if possible.
    pub fix: Option<CarryOut>,
}

/// Applies a remedy to the file with this index.
pub type CarryOut = Rc<dyn Fn(usize, &Fix)>;

/// Warnings about a document that runs; empty if there are none.
pub fn remarks(app: App) -> View {
    let words = app.words();
    let (sources, findings) = app.with(|lab| (lab.sources.clone(), lab.findings.clone())).unwrap_or_default();
    if findings.is_empty() {
        return View::new();
    }
    let list = list(app, &sources, &findings, None);
    section().child(h3().child(words.warnings)).child(list).into()
}

/// List of diagnostics. With `leads`, each place is a link to the text, and remedies have buttons.
pub fn list(app: App, sources: &[Source], findings: &[(usize, Diagnostic)], leads: Option<Leads>) -> HtmlOl {
    let names = visited::names(sources);
    let item = |(file, diagnostic): &(usize, Diagnostic)| {
        let leads = leads.clone().map(|leads| (leads, *file));
        let source = names.get(*file).zip(sources.get(*file)).map(|(name, source)| (name.as_str(), &*source.text));
        li().child(finding(app, source, diagnostic, leads))
    };
    ol().class("findings").each(findings, item)
}

/// Short form of a diagnostic beside its place: message, reason, remedies.
pub fn brief(app: App, text: &str, diagnostic: &Diagnostic, carry_out: CarryOut) -> HtmlDiv {
    let language = app.language.get_untracked();
    let class = if diagnostic.severity == Severity::Error { "brief error" } else { "brief warning" };
    let fixes: Vec<View> =
        diagnostic.fixes.iter().map(|fix| fix_button(app, text, fix, (carry_out.clone(), 0)).into()).collect();
    div()
        .class(class)
        .child(p().class("what").child(with_code(&capitalised(&diagnostic.message.text(language)))).child("."))
        .each(&diagnostic.hints, |hint| hint_of(app, hint))
        .maybe((!fixes.is_empty()).then(|| div().class("actions").child(fixes)))
}

fn hint_of(app: App, hint: &Words) -> HtmlP {
    let hint = with_code(&hint.text(app.language.get_untracked()));
    p().class("remedy").child(strong().child(app.words().help).child(": ")).child(hint)
}

/// Button that applies a remedy to the file with this index.
fn fix_button(app: App, text: &str, fix: &Fix, (carry_out, file): (CarryOut, usize)) -> HtmlButton {
    let own = fix.clone();
    let title = with_code(&capitalised(&fix.title(text).text(app.language.get_untracked())));
    button().class("quiet outlined fix").when(events::click, move |_| carry_out(file, &own)).child(title)
}

fn finding(
    app: App,
    source: Option<(&str, &str)>,
    diagnostic: &Diagnostic,
    leads: Option<(Leads, usize)>,
) -> HtmlArticle {
    let (words, language) = (app.words(), app.language.get_untracked());
    let (kind, class) = match diagnostic.severity {
        Severity::Error => (words.error, "finding error"),
        Severity::Warning => (words.warning, "finding warning"),
    };
    let (text, name) = source.map_or(("", ""), |(name, text)| (text, name));
    let places = if source.is_some() { places(text, &diagnostic.labels, language) } else { Vec::new() };
    let note = |note: &Words| pre().tabindex("0").class("reason").child(with_code(&note.text(language)));
    let fixes = leads.as_ref().and_then(|(leads, file)| Some((leads.fix.clone()?, *file)));
    let fix = |fix: &Fix| Some(fix_button(app, text, fix, fixes.clone()?));
    let fixes: Vec<View> = diagnostic.fixes.iter().filter_map(fix).map(View::from).collect();
    let title = titles::title(diagnostic.code, language);
    article()
        .class(class)
        .child(h3().child(span().class("badge").child(kind)).child(" ").child(title))
        .child(p().class("what").child(with_code(&capitalised(&diagnostic.message.text(language)))).child("."))
        .each(places, |place| place.view(app, name, leads.clone()))
        .each(&diagnostic.notes, note)
        .each(&diagnostic.hints, |hint| hint_of(app, hint))
        .maybe((!fixes.is_empty()).then(|| div().class("actions").child(fixes)))
}

/// Sentence of a diagnostic or of a report; text between backticks is code.
pub fn with_code(sentence: &str) -> View {
    // An unpaired last backtick is an ordinary character.
    let paired = sentence.matches('`').count() / 2 * 2;
    let mut pieces = sentence.splitn(paired + 1, '`');
    let mut views: Vec<View> = Vec::new();
    while let Some(text) = pieces.next() {
        views.push(text.to_owned().into());
        if let Some(marked) = pieces.next() {
            views.push(code().child(marked.to_owned()).into());
        }
    }
    views.into()
}

/// A source line with its marked spans.
struct Place {
    number: usize,
    /// Start of the line in the text, in bytes.
    start: usize,
    /// The line in pieces: (text, true if marked).
    pieces: Vec<(String, bool)>,
    /// Marked texts with their remarks.
    remarks: Vec<(String, String)>,
}

/// Lines marked by the labels, in the order of the labels; labels in the same line share it.
fn places(text: &str, labels: &[Label], language: Language) -> Vec<Place> {
    let mut lines: Vec<(usize, usize, Vec<&Label>)> = Vec::new();
    for label in labels {
        let start = text.floor_char_boundary(label.span.start);
        let first = text[..start].rfind('\n').map_or(0, |at| at + 1);
        let last = text[start..].find('\n').map_or(text.len(), |at| start + at);
        match lines.iter_mut().find(|line| line.0 == first) {
            Some(line) => line.2.push(label),
            None => lines.push((first, last, vec![label])),
        }
    }
    lines.into_iter().map(|(first, last, labels)| Place::of(text, (first, last), &labels, language)).collect()
}

impl Place {
    /// Marks the labels in one line. Of a span over several lines, the part in the first line is marked.
    fn of(text: &str, (first, last): (usize, usize), labels: &[&Label], language: Language) -> Self {
        let span = |label: &Label| {
            let start = text.floor_char_boundary(label.span.start);
            (start, text.floor_char_boundary(label.span.end).clamp(start, last))
        };
        let mut spans: Vec<(usize, usize)> = labels.iter().map(|label| span(label)).collect();
        sort(&mut spans);
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
            (text[start..end].to_owned(), label.text.text(language).into_owned())
        };
        let remarks = labels.iter().filter(|label| !label.text.is_empty()).map(remark).collect();
        let start = labels.iter().map(|label| span(label).0).min().unwrap_or(first);
        Self { number: text[..first].matches('\n').count() + 1, start, pieces, remarks }
    }

    /// View of the line; `leads` go to the text of the file with this index.
    fn view(self, app: App, file: &str, leads: Option<(Leads, usize)>) -> View {
        let head = format!("{file}, {} {}", app.words().line, self.number);
        let start = self.start;
        let head: View = match leads {
            Some((leads, file)) => {
                button().class("pick").when(events::click, move |_| (leads.go)(file, start)).child(head).into()
            }
            None => head.into(),
        };
        let piece =
            |(piece, marked): (String, bool)| if marked { mark().child(piece).into() } else { View::from(piece) };
        let remark =
            |(marked, remark): (String, String)| li().child(code().child(marked)).child(" ").child(with_code(&remark));
        View::from((
            p().class("place").child(head),
            pre().tabindex("0").child(code().each(self.pieces, piece)),
            ul().class("remarks").each(self.remarks, remark),
        ))
    }
}

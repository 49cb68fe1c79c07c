//! What was found in a document, with its places in the text.

use crate::app::App;
use crate::{titles, visited};
use document::page::Source;
use model::{Diagnostic, Fix, Label, Severity};
use std::rc::Rc;
use units::{Language, Words};
use view::views::*;

/// What can be done with a finding where its text is open. Files are meant by their numbers.
#[derive(Clone)]
pub struct Leads {
    /// Goes to a place of a file, in bytes.
    pub go: Rc<dyn Fn(usize, usize)>,
    /// Changes a file as a remedy says, where that is possible.
    pub fix: Option<CarryOut>,
}

/// Changes the file of a number as a remedy says.
pub type CarryOut = Rc<dyn Fn(usize, &Fix)>;

/// Remarks on a document that runs; nothing if there are none.
pub fn remarks(app: App) -> View {
    let words = app.words();
    let (sources, findings) = app.with(|lab| (lab.sources.clone(), lab.findings.clone())).unwrap_or_default();
    if findings.is_empty() {
        return View::new();
    }
    let list = list(app, &sources, &findings, None);
    section().child(h3().child(words.warnings)).child(list).into()
}

/// The findings; where the text can be corrected, each place leads to it there, and remedies can be carried out.
pub fn list(app: App, sources: &[Source], findings: &[(usize, Diagnostic)], leads: Option<Leads>) -> HtmlOl {
    let names = visited::names(sources);
    let item = |(file, diagnostic): &(usize, Diagnostic)| {
        let leads = leads.clone().map(|leads| (leads, *file));
        let source = names.get(*file).zip(sources.get(*file)).map(|(name, source)| (name.as_str(), &*source.text));
        li().child(finding(app, source, diagnostic, leads))
    };
    ol().class("findings").each(findings, item)
}

/// A finding in a few words, where the place is in sight: what is wrong, why, and what can be done.
pub fn brief(app: App, text: &str, diagnostic: &Diagnostic, carry_out: CarryOut) -> HtmlDiv {
    let language = app.language.get_untracked();
    let class = if diagnostic.severity == Severity::Error { "brief error" } else { "brief warning" };
    let fixes: Vec<View> =
        diagnostic.fixes.iter().map(|fix| fix_button(app, text, fix, (carry_out.clone(), 0)).into()).collect();
    div()
        .class(class)
        .child(p().class("what").child(with_code(&capitalised(diagnostic.message.text(language)))).child("."))
        .each(&diagnostic.hints, |hint| hint_of(app, hint))
        .maybe((!fixes.is_empty()).then(|| div().class("actions").child(fixes)))
}

fn hint_of(app: App, hint: &Words) -> HtmlP {
    let hint = with_code(hint.text(app.language.get_untracked()));
    p().class("remedy").child(strong().child(app.words().help).child(": ")).child(hint)
}

/// A button that changes the file of a number as a remedy says.
fn fix_button(app: App, text: &str, fix: &Fix, (carry_out, file): (CarryOut, usize)) -> HtmlButton {
    let own = fix.clone();
    let title = with_code(&capitalised(fix.title(text).text(app.language.get_untracked())));
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
    let note = |note: &Words| pre().tabindex("0").class("reason").child(with_code(note.text(language)));
    let fixes = leads.as_ref().and_then(|(leads, file)| Some((leads.fix.clone()?, *file)));
    let fix = |fix: &Fix| Some(fix_button(app, text, fix, fixes.clone()?));
    let fixes: Vec<View> = diagnostic.fixes.iter().filter_map(fix).map(View::from).collect();
    let title = titles::title(diagnostic.code, language);
    article()
        .class(class)
        .child(h3().child(span().class("badge").child(kind)).child(" ").child(title))
        .child(p().class("what").child(with_code(&capitalised(diagnostic.message.text(language)))).child("."))
        .each(places, |place| place.view(app, name, leads.clone()))
        .each(&diagnostic.notes, note)
        .each(&diagnostic.hints, |hint| hint_of(app, hint))
        .maybe((!fixes.is_empty()).then(|| div().class("actions").child(fixes)))
}

/// With a capital at its beginning.
fn capitalised(sentence: &str) -> String {
    let mut letters = sentence.chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
}

/// A sentence of a diagnostic: what stands in it between backticks is code.
fn with_code(sentence: &str) -> View {
    // Without its partner the last backtick is one.
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

/// A line of the source with what is marked in it.
struct Place {
    number: usize,
    /// Where in the text it begins, in bytes.
    start: usize,
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
        let start = labels.iter().map(|label| span(label).0).min().unwrap_or(first);
        Self { number: text[..first].matches('\n').count() + 1, start, pieces, remarks }
    }

    /// `leads` go to the text of the file of this number.
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

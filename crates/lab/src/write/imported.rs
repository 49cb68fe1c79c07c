//! The report of an import beside the text that it has made, and the original source of a quantity.

use super::findings;
use crate::app::App;
use crate::documents::diagnostics::with_code;
use crate::documents::imported::is_open;
use view::views::*;

/// Entries of the report, folded behind their number; hidden for other documents.
pub fn view(app: App) -> View {
    changing(move || {
        app.written.track();
        let Some(imported) = app.imported.get_clone().filter(|report| is_open(app, report)) else { return View::new() };
        let words = app.words();
        let language = app.language.get_untracked();
        let entry = |entry: &ejss::Entry| {
            let sentence = with_code(&entry.sentence(language));
            match entry.document_line {
                Some(line) => {
                    let go = move |_| go_to_line(app, line);
                    li().child(button().class("quiet").when(events::click, go).child(sentence))
                }
                None => li().child(sentence),
            }
        };
        let list = ul().each(imported.entries(), entry);
        let first = match imported.listed_because() {
            None => words.import_translated.to_owned(),
            Some(why) => format!("{} {}.", words.import_listed, why.text(language)),
        };
        let count = format!("{} ({})", words.import_report, imported.entries().len());
        let details = details()
            .class("imported")
            .id("import-report")
            .child(summary().child(count))
            .child(p().class("note").child(with_code(&first)))
            .child(list);
        details.into()
    })
}

/// The lines of the original that determine a quantity.
pub fn original(app: App, word: &str) -> Option<HtmlSpan> {
    let imported = app.imported.get_clone().filter(|report| is_open(app, report))?;
    let lines: Vec<String> = imported.originals(word).map(|original| original.source.clone()).collect();
    if lines.is_empty() {
        return None;
    }
    let title = span().class("soft").child(app.words().import_original);
    Some(span().class("original").id("original").child(title).child(" ").child(code().child(lines.join("  ·  "))))
}

/// Goes to a line of the document, counted from 1.
fn go_to_line(app: App, line: usize) {
    let place = app.read_writing(|writing| {
        let text = writing.texts().first().map(String::as_str).unwrap_or_default();
        text.split_inclusive('\n').take(line - 1).map(str::len).sum()
    });
    findings::go_to(app, 0, place);
}

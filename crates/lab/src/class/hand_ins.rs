//! Table of the hand-ins: who, from which file, and how the verification ended.

use super::room::Part;
use super::{window, words};
use crate::app::App;
use crate::documents::project;
use class::collection::Collection;
use class::page::{copied_text, state_text};
use class::verify::meaning;
use units::Language;
use view::views::*;

/// Maximum number of rows before all are asked for.
const FEW: usize = 100;

/// Row of a file.
#[derive(Clone, PartialEq)]
struct Row {
    index: usize,
    sender: String,
    seat: Option<u32>,
    file: String,
    /// Lines about the verification.
    lines: Vec<String>,
    is_hand_in: bool,
}

/// The section.
pub fn view(app: App) -> View {
    let words = words::of(app);
    let language = app.language.get_untracked();
    let is_whole = create_signal(false);
    let count = memo(move || app.class.read(Part::HandIns, |collection| collection.entries().len()));
    let most = move || if is_whole.get() { usize::MAX } else { FEW };
    let rows = memo(move || app.class.read(Part::HandIns, |collection| rows(collection, most(), language)));
    let table = move || {
        let head = [words.number, words.pseudonym, words.verification, words.work, words.name, words.seat, words.file];
        let head = tr().each(head, column_head);
        let body = tbody().each(rows.get_clone(), |own| row(app, own));
        table_in("table", words.table, Some(head), body)
    };
    let more = move || {
        let count = count.get();
        if count <= FEW || is_whole.get() {
            return View::new();
        }
        let label = words.show_all.replace('#', &count.to_string());
        button().class("quiet").when(events::click, move |_| is_whole.set(true)).child(label).into()
    };
    let copies = move || {
        let copies = app.class.read(Part::Copies, |collection| {
            let text = |copied| copied_text(copied, collection, language);
            collection
                .copies()
                .iter()
                .take(FEW)
                .map(|copied| (copied.is_common_source, text(copied)))
                .collect::<Vec<_>>()
        });
        each(copies, |(is_common, text)| p().class(if is_common { "note" } else { "refusal" }).child(text))
    };
    View::from((changing(table), changing(more), changing(copies), note(meaning().text(language).into_owned())))
}

fn rows(collection: &Collection, most: usize, language: Language) -> Vec<Row> {
    let row = |(index, entry): (usize, &class::collection::Entry)| Row {
        index,
        sender: entry.sender().to_owned(),
        seat: entry.hand_in().and_then(|hand_in| hand_in.sender.seat),
        file: entry.file().to_owned(),
        lines: state_text(entry, collection, language),
        is_hand_in: entry.hand_in().is_some(),
    };
    collection.entries().iter().enumerate().take(most).map(row).collect()
}

fn row(app: App, row: Row) -> HtmlTr {
    let words = words::of(app);
    let Row { index, sender, seat, file, lines, is_hand_in } = row;
    let name = is_hand_in.then(|| {
        let pseudonym = sender.clone();
        input()
            .r#type("text")
            .id(format!("class-name-{index}"))
            .autocomplete("off")
            .attr("aria-label", format!("{} {sender}", words.name_of))
            .attr("value", app.class.name(&sender))
            .when(events::input, move |event| {
                app.class.set_name(&pseudonym, &value_of(&event));
            })
    });
    let open = is_hand_in.then(|| {
        let open = move |_| {
            let work = app.class.read_once(|class| Some(class.entries().get(index)?.hand_in()?.work.clone()));
            if let Some(work) = work {
                window::close();
                project::show(app, &file_name(app, index), work);
            }
        };
        button().class("quiet").id(format!("class-open-{index}")).when(events::click, open).child(words.open_work)
    });
    tr().child(row_head((index + 1).to_string()))
        .child(td().child(sender))
        .child(td().each(lines, |line| div().child(line)))
        .child(td().maybe(open))
        .child(td().maybe(name))
        .child(td().child(seat.map_or_else(String::new, |seat| seat.to_string())))
        .child(td().child(file))
}

fn file_name(app: App, index: usize) -> String {
    app.class.read_once(|class| class.entries().get(index).map_or_else(String::new, |entry| entry.file().to_owned()))
}

//! Dashboard of a class: hand-ins of all groups, computed again, with their curves, results and answers.

mod adding;
mod against;
mod answers;
mod computing;
mod curves;
mod drawn;
mod empty;
mod folder;
mod hand_ins;
mod live;
mod results;
mod room;
mod snapshots;
mod survey;
mod wall;
mod window;
mod words;

pub use adding::{add, add_of_folders, is_hand_in};
pub use folder::folders;
pub use live::listen;
pub use room::Room;
pub use survey::{SurveyRoom, add as add_sheets, is_sheet};
pub use window::open;

use crate::app::App;
use ::class::page;
use room::Part;
use view::views::*;
use view::{browser, pieces};

/// Content of the tab *Class*: a button that opens the dashboard.
pub fn door(app: App) -> View {
    let words = words::of(app);
    let open = button().class("action").id("open-class").when(events::click, move |_| open(app)).child(words.open);
    section().class("card step").attr("aria-label", words.title).child(note(words.intro)).child(open).into()
}

/// The dialogs of the dashboard and of the wall. Their contents exist only while they are open.
pub fn dialogs(app: App) -> View {
    let words = words::of(app);
    let dashboard = pieces::dialog(window::ID, "class-title", words.title, words.close)
        .when(events::close, move |_| app.class.set_open(false))
        .child(changing(move || if app.class.is_open() { contents(app) } else { View::new() }));
    View::from((dashboard, wall::dialog(app)))
}

fn contents(app: App) -> View {
    let words = words::of(app);
    let any = memo(move || app.class.read(Part::Status, |collection| !collection.entries().is_empty()));
    let part = |id: &'static str, title: &'static str, content: View| {
        section().id(id).attr("aria-label", title).child(h3().child(title)).child(content)
    };
    let parts = move || {
        if !any.get() {
            return View::new();
        }
        let left = div()
            .class("column")
            .child(part("class-curves", words.curves, curves::view(app)))
            .child(part("class-snapshots", words.snapshots, snapshots::view(app)))
            .child(part("class-stuck", words.stuck, results::stuck(app)));
        let right = div()
            .class("column")
            .child(part("class-results", words.results, results::view(app)))
            .child(part("class-against", words.against, against::view(app)))
            .child(part("class-answers", words.answers, answers::view(app)));
        View::from((left, right, part("class-hand-ins", words.hand_ins, hand_ins::view(app))))
    };
    let tools = div()
        .class("ways")
        .child(adding::choice(app, "class-choose", words.choose_files, false))
        .child(adding::choice(app, "class-folder", words.choose_folder, true))
        .child(changing(move || if any.get() { exports(app) } else { View::new() }));
    let language = app.language.get_untracked();
    let said = move || app.class.read(Part::Status, |collection| page::count_text(collection, language));
    let status = p().class("note").role("status").id("class-said").child(text(said));
    let refusal = p().class("refusal").role("alert").child(text(move || app.class.refusal()));
    div()
        .class("room")
        .child(note(words.intro))
        .child(tools)
        .child(refusal)
        .child(status)
        .child(changing(parts))
        .child(survey::view(app))
        .into()
}

/// Buttons that save a report, or remove everything.
fn exports(app: App) -> View {
    let words = words::of(app);
    let language = app.language.get_untracked();
    let report = move |_| {
        let (x, y) = app.class.axes();
        let asked = against::asked(app, &x.get_clone_untracked(), &y.get_clone_untracked()).unwrap_or_default();
        let html = app.class.read_once(|class| page::html(class, &asked, language, ""));
        browser::save_text("class.html", "text/html", &html);
    };
    let workbook = move |_| {
        let bytes = app.class.read_once(|class| page::workbook(class, language));
        let kind = "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet";
        browser::save_bytes("class.xlsx", kind, &bytes);
    };
    let button = |id: &'static str, label: &'static str| button().class("quiet").id(id).child(label);
    View::from((
        button("class-report", words.save_report).when(events::click, report),
        button("class-workbook", words.save_workbook).when(events::click, workbook),
        button("class-clear", words.clear).when(events::click, move |_| app.class.clear()),
    ))
}

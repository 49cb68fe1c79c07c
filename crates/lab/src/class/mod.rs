//! Dashboard of a class: hand-ins of all groups, computed again, with their curves, results and answers.

mod adding;
mod answers;
mod curves;
mod folder;
mod hand_ins;
mod results;
mod room;
mod snapshots;
mod wall;
mod words;

pub use adding::{add, add_of_folders, is_hand_in};
pub use folder::folders;
pub use room::Room;

use crate::app::App;
use ::class::page::{self, Look};
use view::views::*;
use view::{browser, pieces, theme};
use web_sys::HtmlDialogElement;

/// Id of the dialog.
const ID: &str = "class";
/// Widest figure, in pixels.
const WIDEST: f64 = 700.0;

/// Opens the dashboard.
pub fn open(app: App) {
    app.class.set_open(true);
    if let Some(dialog) = browser::by_id::<HtmlDialogElement>(ID).filter(|dialog| !dialog.open()) {
        let _ = dialog.show_modal();
    }
}

/// Closes the dashboard.
fn close() {
    if let Some(dialog) = browser::by_id::<HtmlDialogElement>(ID) {
        dialog.close();
    }
}

/// Title of the dashboard.
pub fn title(app: App) -> &'static str {
    words::of(app).title
}

/// Section of the publishing dialog with a button that opens the dashboard.
pub fn door(app: App) -> View {
    let words = words::of(app);
    let open = button().class("action").id("open-class").when(events::click, move |_| open(app)).child(words.open);
    View::from((note(words.intro), div().class("ways").child(open)))
}

/// The dialogs of the dashboard and of the wall. Their contents exist only while they are open.
pub fn dialogs(app: App) -> View {
    let words = words::of(app);
    let dashboard = pieces::dialog(ID, "class-title", words.title, words.close)
        .when(events::close, move |_| app.class.set_open(false))
        .child(changing(move || if app.class.is_open() { contents(app) } else { View::new() }));
    View::from((dashboard, wall::dialog(app)))
}

fn contents(app: App) -> View {
    let words = words::of(app);
    let any = memo(move || app.class.read(|collection| !collection.entries().is_empty()));
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
        let right = div().class("column").child(part("class-results", words.results, results::view(app))).child(part(
            "class-answers",
            words.answers,
            answers::view(app),
        ));
        View::from((left, right, part("class-hand-ins", words.hand_ins, hand_ins::view(app))))
    };
    let tools = div()
        .class("ways")
        .child(adding::choice(app, "class-choose", words.choose_files, false))
        .child(adding::choice(app, "class-folder", words.choose_folder, true))
        .child(changing(move || if any.get() { exports(app) } else { View::new() }));
    let language = app.language.get_untracked();
    let said = move || app.class.read(|collection| page::count_text(collection, language));
    let status = p().class("note").role("status").id("class-said").child(text(said));
    let refusal = p().class("refusal").role("alert").child(text(move || app.class.refusal()));
    div().class("room").child(note(words.intro)).child(tools).child(refusal).child(status).child(changing(parts)).into()
}

/// Buttons that save a report, or remove everything.
fn exports(app: App) -> View {
    let words = words::of(app);
    let language = app.language.get_untracked();
    let report = move |_| {
        let html = app.class.read_once(|class| page::html(class, language, env!("CARGO_PKG_VERSION"), ""));
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

/// Size, colours and language of the figures in the dashboard.
fn look(app: App) -> Look {
    let width = window().inner_width().ok().and_then(|width| width.as_f64()).unwrap_or(WIDEST);
    let width = (width - 80.0).clamp(280.0, WIDEST);
    Look { width, height: 300.0, palette: theme::palette(), language: app.language.get_untracked() }
}

/// A figure from its SVG.
fn figure_of(svg: String) -> HtmlDiv {
    div().class("class-figure").inner_html(svg)
}

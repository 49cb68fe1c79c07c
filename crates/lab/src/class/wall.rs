//! View for the projector: collected work without names, together or one after another. Nothing appears before it is shown
//! from the dashboard.

use super::drawn::figure_of;
use super::room::Wall;
use super::words;
use crate::app::App;
use class::collection::{Collection, CurveGroup, Member, Snapshot, Snapshots};
use class::page::{self, Look};
use view::views::*;
use view::{browser, page::theme, pieces};
use wasm_bindgen::JsValue;
use web_sys::{HtmlDialogElement, KeyboardEvent};

/// Id of the dialog.
const ID: &str = "wall";

/// Work on the wall.
enum Content {
    Figure(String),
    /// Text of a question as safe markup, and the typed answer.
    Answer(String, String),
}

/// Shows the collected work: all together if it is curves of one quantity, otherwise the first piece.
pub fn show(app: App) {
    let snapshots = app.class.snapshots();
    let are_together = app.class.read_once(|collection| together(collection, &snapshots).is_some());
    app.class.set_wall(if are_together { Wall::Together } else { Wall::One(0) });
    if let Some(dialog) = browser::by_id::<HtmlDialogElement>(ID) {
        let _ = dialog.show_modal();
    }
}

/// The dialog over the whole window. It is empty while it is closed.
pub fn dialog(app: App) -> HtmlDialog {
    let words = words::of(app);
    let by_key = move |event: KeyboardEvent| match event.key().as_str() {
        "ArrowRight" | "PageDown" | " " => step(app, 1),
        "ArrowLeft" | "PageUp" => step(app, -1),
        _ => {}
    };
    pieces::dialog(ID, "wall-title", words.wall_title, words.close)
        .when(events::close, move |_| app.class.set_wall(Wall::Closed))
        .when(events::keydown, by_key)
        .child(changing(move || contents(app)))
}

/// Goes on by one piece of work. Before the first one all are shown together, if they can be.
fn step(app: App, by: isize) {
    let snapshots = app.class.snapshots();
    let count = snapshots.list().len();
    let next = match (app.class.wall(), by) {
        (Wall::Closed, _) => return,
        (Wall::Together, 1) => Wall::One(0),
        (Wall::Together, _) => Wall::Together,
        (Wall::One(0), -1) if app.class.read_once(|collection| together(collection, &snapshots).is_some()) => {
            Wall::Together
        }
        (Wall::One(place), by) => Wall::One(place.saturating_add_signed(by).min(count.saturating_sub(1))),
    };
    app.class.set_wall(next);
}

fn contents(app: App) -> View {
    let words = words::of(app);
    let (wall, snapshots) = (app.class.wall(), app.class.snapshots());
    let letters = snapshots.letters();
    let (title, content) = match wall {
        Wall::Closed => return View::new(),
        Wall::Together => {
            let found = app.class.read_once(|collection| {
                let (group, members) = together(collection, &snapshots)?;
                Some(Content::Figure(page::curves(collection, &group, &members, &letters, look(app))))
            });
            (letters.join(", "), found)
        }
        Wall::One(place) => {
            let snapshot = snapshots.list().get(place).copied();
            let found = app.class.read_once(|collection| one(app, collection, snapshot?, letters.get(place)?));
            let number = format!("{}/{}", place + 1, letters.len());
            (format!("{} · {number}", letters.get(place).map_or("", String::as_str)), found)
        }
    };
    let content = match content {
        None => View::new(),
        Some(Content::Figure(svg)) => figure_of(svg).into(),
        Some(Content::Answer(prompt, typed)) => {
            View::from((div().class("prompt").inner_html(prompt), p().class("wall-answer").child(typed)))
        }
    };
    let turn = |label: &'static str, id: &'static str, by: isize| {
        button().class("quiet").id(id).when(events::click, move |_| step(app, by)).child(label)
    };
    View::from((
        p().class("wall-letter").role("status").child(title),
        div().class("wall-content").child(content),
        div().class("ways").child(turn(words.wall_previous, "wall-previous", -1)).child(turn(
            words.wall_next,
            "wall-next",
            1,
        )),
    ))
}

/// The figure fills the window below the title; its texts are as large as those of a page 1000 pixels wide.
fn look(app: App) -> Look {
    let size =
        |length: Result<JsValue, JsValue>, usual| length.ok().and_then(|length| length.as_f64()).unwrap_or(usual);
    let (width, height) = (size(window().inner_width(), 1000.0), size(window().inner_height(), 700.0));
    let scale = ((width - 80.0) / 1000.0).max(1.0);
    Look {
        width: ((width - 80.0) / scale).max(280.0),
        height: ((height - 240.0) / scale).clamp(160.0, 700.0),
        palette: theme::palette(),
        language: app.language.get_untracked(),
    }
}

/// Group of a measured curve.
fn group_of(collection: &Collection, member: Member) -> Option<CurveGroup> {
    collection.curve_groups().into_iter().find(|group| group.members.contains(&member))
}

/// The collected curves, if all are of one quantity and there are at least two.
fn together(collection: &Collection, snapshots: &Snapshots) -> Option<(CurveGroup, Vec<Member>)> {
    let curve = |snapshot: &Snapshot| match snapshot {
        Snapshot::Curve(member) => Some(*member),
        Snapshot::Answer { .. } => None,
    };
    let members: Vec<Member> = snapshots.list().iter().map(curve).collect::<Option<_>>()?;
    let group = group_of(collection, *members.first()?)?;
    let is_one = members.len() > 1 && members.iter().all(|member| group.members.contains(member));
    is_one.then_some((group, members))
}

fn one(app: App, collection: &Collection, snapshot: Snapshot, letter: &str) -> Option<Content> {
    match snapshot {
        Snapshot::Curve(member) => {
            let group = group_of(collection, member)?;
            Some(Content::Figure(page::curves(collection, &group, &[member], &[letter.to_owned()], look(app))))
        }
        Snapshot::Answer { hand_in, answer } => {
            let own = collection.answer(hand_in, answer)?;
            let typed = own.attempts.last().map_or(&own.typed, |last| &last.typed);
            Some(Content::Answer(own.prompt.clone(), typed.clone()))
        }
    }
}

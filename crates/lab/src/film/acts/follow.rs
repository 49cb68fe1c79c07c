//! Second step: the subject of tracking.

use super::radius;
use super::tool::{fold, take_tool, tool_button};
use crate::app::App;
use crate::film::aim::{Kind, Tool};
use crate::film::{tools, words};
use desk::Subject;
use view::browser;
use view::views::*;

/// Kinds of subjects, the clicks, and aids for difficult pictures.
pub fn view(app: App) -> View {
    let words = words::of(app);
    let kinds = [
        (Kind::Surface, "film-kind-surface", words.kind_surface),
        (Kind::Arms, "film-kind-arms", words.kind_arms),
        (Kind::Body, "film-kind-body", words.kind_body),
        (Kind::Hand, "film-kind-hand", words.kind_hand),
    ];
    let kind = |(kind, id, name): (Kind, &'static str, &'static str)| {
        let choose = move |_| {
            app.films.kind.set(kind);
            take_tool(app, Tool::Subject);
        };
        button()
            .class("chip")
            .id(id)
            .attr("aria-pressed", move || (app.films.kind.get() == kind).to_string())
            .when(events::click, choose)
            .child(name)
    };
    let hint = move || match app.films.kind.get() {
        Kind::Surface => words.hint_surface.to_owned(),
        Kind::Arms => words.hint_arms.to_owned(),
        Kind::Body => words.hint_body.to_owned(),
        Kind::Hand => words.hint_hand.to_owned(),
    };
    let click = div()
        .class("chips")
        .child(tool_button(app, "film-click", Tool::Subject, words.click_it))
        .child(changing(move || bodies(app)));
    View::from((
        div().class("chips").role("group").attr("aria-label", words.kinds).each(kinds, kind),
        note(text(hint)),
        click,
        radius::view(app),
        help(app),
    ))
}

/// Choice of the body to which the next click belongs.
fn bodies(app: App) -> View {
    let words = words::of(app);
    if app.films.kind.get() != Kind::Body {
        return View::new();
    }
    let count = app.films.now.with(|now| match now.as_ref().map(|now| &now.subject) {
        Some(Subject::Bodies(bodies)) => bodies.len(),
        _ => 0,
    });
    if count == 0 {
        return View::new();
    }
    each(0..(count + 1).min(desk::MOST_BODIES), move |number| {
        let choose = move |_| {
            app.films.body.set(number);
            take_tool(app, Tool::Subject);
            browser::focus("film-frame");
        };
        let name =
            if number < count { format!("{} {}", words.body, number + 1) } else { words.another_body.to_owned() };
        button()
            .class("chip")
            .attr("aria-pressed", move || (app.films.body.get() == number).to_string())
            .when(events::click, choose)
            .child(name)
    })
}

/// Aids for inclined tubes and moving cameras.
fn help(app: App) -> View {
    let words = words::of(app);
    let has_surface = memo(move || {
        app.films.now.with(|now| matches!(now.as_ref().map(|now| &now.subject), Some(Subject::Surfaces(_))))
    });
    let marks = memo(move || app.films.now.with(|now| now.as_ref().map_or(0, |now| now.marks.len())));
    let forget = move |_| tools::set_marks(app, Vec::new());
    let tube = tool_button(app, "film-tube", Tool::Tube, words.tube);
    let still = tool_button(app, "film-still", Tool::Still, words.fixed_marks);
    fold(words.difficult)
        .child(div().class("chips").child(tube.hidden(move || !has_surface.get())).child(still))
        .child(note(words.difficult_note))
        .child(changing(move || {
            if marks.get() == 0 {
                return View::new();
            }
            let name = format!("{} ({})", words.forget_marks, marks.get());
            button().class("quiet").id("film-forget-marks").when(events::click, forget).child(name).into()
        }))
        .into()
}

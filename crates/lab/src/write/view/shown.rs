//! The controls and the values: their labels, their order, and which values are shown.

use crate::app::App;
use crate::write::fields::{Piece, refuse};
use crate::write::typing;
use document::edit::{exchange_statements, set_hidden, set_label};
use document::form::{Place, Shown, shown};
use view::browser;
use view::icons;
use view::views::*;

/// The controls.
pub fn controls(app: App) -> HtmlDiv {
    list(app, &[Place::Size, Place::Parameter], app.words().controls_none)
}

/// The values.
pub fn values(app: App) -> HtmlDiv {
    list(app, &[Place::Unknown, Place::Computed], app.words().values_none)
}

fn list(app: App, places: &'static [Place], none: &'static str) -> HtmlDiv {
    let all = memo(move || {
        app.typed.track();
        app.written.track();
        shown(&document::read(&typing::text(app, 0)))
    });
    let shapes = memo(move || {
        all.with(|all| all.iter().map(|one| (one.number, one.place, one.name.clone())).collect::<Vec<_>>())
    });
    let rows = move || {
        let shapes = shapes.get_clone();
        let of = |place: Place| shapes.iter().filter(move |(_, own, _)| *own == place).collect::<Vec<_>>();
        let rows: Vec<View> = places
            .iter()
            .flat_map(|&place| {
                let own = of(place);
                let numbers: Vec<usize> = own.iter().map(|(number, ..)| *number).collect();
                let row = |(at, (number, _, name)): (usize, &(usize, Place, String))| {
                    let before = at.checked_sub(1).and_then(|before| numbers.get(before)).copied();
                    let neighbours = place.is_ordered().then(|| (before, numbers.get(at + 1).copied()));
                    View::from(row(app, all, *number, name, neighbours))
                };
                own.into_iter().enumerate().map(row).collect::<Vec<_>>()
            })
            .collect();
        if rows.is_empty() { note(none).into() } else { View::from(ul().class("shown-list").child(rows)) }
    };
    div().child(changing(rows))
}

/// Name, label, whether it is shown, and the buttons that exchange it with the one before and the one after.
fn row(
    app: App,
    all: ReadSignal<Vec<Shown>>,
    number: usize,
    name: &str,
    neighbours: Option<(Option<usize>, Option<usize>)>,
) -> HtmlLi {
    let words = app.words();
    let refusal = create_signal(None::<String>);
    let read = move |part: fn(&Shown) -> String| {
        memo(move || all.with(|all| all.iter().find(|one| one.number == number).map(part).unwrap_or_default()))
    };
    let label = Piece {
        id: id(number, "label"),
        name: format!("{name}: {}", words.column_label),
        text: read(|one| one.label.clone()),
        refusal,
        write: Box::new(move |typed| {
            let text = typing::text(app, 0);
            typing::change(app, 0, &text, |outline| set_label(outline, number, typed)).map(|_| ())
        }),
    };
    let place = all.with_untracked(|all| all.iter().find(|one| one.number == number).map(|one| one.place));
    let visible = place.is_some_and(|place| place >= Place::Unknown).then(|| {
        let hidden = read(|one| one.is_hidden.to_string());
        let set = move |event| {
            let text = typing::text(app, 0);
            let hidden = !is_checked(&event);
            refuse(refusal, typing::act(app, 0, &text, |outline| set_hidden(outline, number, hidden)).err());
        };
        let tick = input()
            .r#type("checkbox")
            .attr("aria-label", format!("{name}: {}", words.value_shown))
            .prop("checked", move || hidden.with(|hidden| hidden == "false"))
            .when(events::change, set);
        switch(tick, words.value_shown)
    });
    let order = neighbours.map(|(before, after)| {
        let move_to = move |other: Option<usize>, part: &'static str| {
            let Some(other) = other else { return };
            let text = typing::text(app, 0);
            match typing::act(app, 0, &text, |outline| exchange_statements(outline, number, other)) {
                Ok(_) => browser::focus_later(id(other, part)),
                Err(refusal) => app.complain(refusal),
            }
        };
        let up = button().class("icon small").id(id(number, "up")).called(format!("{}: {name}", words.move_up));
        let down = button().class("icon small").id(id(number, "down")).called(format!("{}: {name}", words.move_down));
        div()
            .class("order")
            .child(up.disabled(before.is_none()).child(icons::up()).when(events::click, move |_| move_to(before, "up")))
            .child(
                down.disabled(after.is_none())
                    .child(icons::down())
                    .when(events::click, move |_| move_to(after, "down")),
            )
    });
    li().class("shown-row")
        .child(code().class("word").child(name.to_owned()))
        .child(label.line(app).attr("placeholder", words.column_label))
        .maybe(visible)
        .maybe(order)
        .child(refusal_of(refusal))
}

fn id(number: usize, part: &str) -> String {
    format!("shown-{number}-{part}")
}

//! Controls and values: labels, order, and which values are shown.

use crate::app::App;
use crate::write::fields::{Piece, refuse};
use crate::write::typing;
use document::edit::{add_group, exchange_statements, remove_statement, set_hidden, set_label};
use document::form::{Place, Shown, shown};
use view::browser;
use view::pieces::icons;
use view::views::*;

/// List of the controls.
pub fn controls(app: App) -> HtmlDiv {
    list(app, &[Place::Size, Place::Parameter], app.words().controls_none, Some(add_button))
}

/// List of the values.
pub fn values(app: App) -> HtmlDiv {
    list(app, &[Place::Unknown, Place::Computed], app.words().values_none, None)
}

/// Button that adds a group of controls and moves the focus to its name.
fn add_button(app: App) -> HtmlButton {
    let add = move |_| {
        let text = typing::text(app, 0);
        match typing::act(app, 0, &text, |outline| add_group(outline, app.words().group_new)) {
            Ok(edits) => {
                let at = edits.first().map_or(0, |edit| edit.span.start);
                let all = shown(&document::read(&typing::text(app, 0)));
                if let Some(group) = all.iter().find(|one| one.is_group && one.label_at.start >= at) {
                    browser::focus_later(id(group.number, "label"));
                }
            }
            Err(refusal) => app.complain(refusal),
        }
    };
    labelled(icons::plus(), app.words().group_add).id("add-group").when(events::click, add)
}

fn list(app: App, places: &'static [Place], none: &'static str, below: Option<fn(App) -> HtmlButton>) -> HtmlDiv {
    let all = memo(move || {
        app.typed.track();
        app.written.track();
        shown(&document::read(&typing::text(app, 0)))
    });
    // Determines the rows; everything else changes inside them.
    let shapes = memo(move || {
        let shape = |one: &Shown| (one.number, one.place, one.is_group, one.name.clone());
        all.with(|all| all.iter().map(shape).collect::<Vec<_>>())
    });
    let rows = move || {
        let shapes = shapes.get_clone();
        let mut rows = ul().class("shown-list");
        let mut is_empty = true;
        for &place in places {
            let own: Vec<_> = shapes.iter().filter(|(_, of, ..)| *of == place).collect();
            let number = |at: usize| own.get(at).map(|(number, ..)| *number);
            for (at, (own, _, is_group, name)) in own.iter().enumerate() {
                let neighbours = place.is_ordered().then(|| (at.checked_sub(1).and_then(number), number(at + 1)));
                let name = if *is_group { app.words().group } else { name };
                rows = rows.child(row(app, all, *own, name, neighbours));
                is_empty = false;
            }
        }
        if is_empty { note(none).into() } else { View::from(div().child(rows).maybe(below.map(|below| below(app)))) }
    };
    div().child(changing(rows))
}

/// Row: name, label, visibility, and buttons that swap it with its neighbours; a group can be removed.
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
    let (is_value, is_group) = all.with_untracked(|all| {
        let own = all.iter().find(|one| one.number == number);
        own.map_or((false, false), |one| (one.place >= Place::Unknown, one.is_group))
    });
    let visible = is_value.then(|| {
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
    let remove = is_group.then(|| {
        let remove = move |_| {
            let text = typing::text(app, 0);
            let removed = typing::act(app, 0, &text, |outline| Ok(vec![remove_statement(outline, number)?]));
            refuse(refusal, removed.err());
            browser::focus_later("add-group".to_owned());
        };
        cross(words.group_remove.to_owned()).when(events::click, remove)
    });
    li().class(if is_group { "shown-row group" } else { "shown-row" })
        .child(code().class("word").child(name.to_owned()))
        .child(label.line(app).attr("placeholder", words.column_label))
        .maybe(visible)
        .maybe(remove)
        .maybe(order)
        .child(refusal_of(refusal))
}

fn id(number: usize, part: &str) -> String {
    format!("shown-{number}-{part}")
}

//! Readouts with their symbols.

use crate::app::App;
use crate::controls::member;
use crate::pieces::followed::followed;
use crate::pieces::portions::in_portions;
use crate::pieces::steady::steady;
use crate::stage::tiles;
use crate::views::*;
use play::{Readout, ReadoutKind};

/// Maximum number of readouts in sight without *More*.
const MAIN: usize = 3;

/// The readouts that are always in sight: the first that change with time, or constant ones if too few do. None of them is hidden
/// by a question.
pub fn main(app: App) -> HtmlSection {
    let [main, _] = divided(app);
    let on_tiles = tiles::values(app);
    let is_on_tile = move |readout: &Readout| on_tiles.contains(&readout.name);
    let all_are = main.iter().all(|(_, readout)| is_on_tile(readout));
    let class = if all_are { "readouts card on-tiles" } else { "readouts card" };
    let mut readouts = part("readouts", class, app.words().readouts);
    let now = followed(app, &readouts.node(), |play| play.readouts());
    // Values on tiles above the plot stand here for screen readers, and where tiles have no room.
    let rows = dl().each(main, |(index, readout)| {
        let row = row(app, now, index, &readout);
        if is_on_tile(&readout) { row.class("on-tile") } else { row }
    });
    readouts.child(div().class("values").child(rows))
}

/// The others: first those that change with time, then constant ones.
pub fn further(app: App) -> HtmlSection {
    let words = app.words();
    let [_, others] = divided(app);
    let mut readouts = part("further-readouts", "readouts card", words.further_readouts);
    let now = followed(app, &readouts.node(), |play| play.readouts());
    let (changing, constant): (Vec<_>, Vec<_>) = others.into_iter().partition(|(_, readout)| readout.varies);
    let titled = |title: &'static str, rows: Vec<(usize, Readout)>| {
        (!rows.is_empty()).then(|| div().class("values").child(h3().child(title)).child(list(app, now, rows)))
    };
    let hides = app.read(|play| play.basis().hides_values());
    let shown = input()
        .r#type("checkbox")
        .prop("checked", move || {
            app.changes.values.track();
            app.read(|play| play.answers().shows_hidden())
        })
        .when(events::change, move |event| {
            app.act(|play| play.change_answers(|answers, _| answers.show_hidden(is_checked(&event))))
        });
    readouts
        .maybe(titled(words.changing, changing))
        .maybe(titled(words.constants, constant))
        .maybe(hides.then(|| switch(shown, words.show_hidden)))
}

/// Number of the others that no question hides.
pub fn further_count(app: App) -> usize {
    let [_, others] = divided(app);
    others.iter().filter(|(_, readout)| !readout.hidden).count()
}

/// The readouts with their places: those in sight without *More*, and the others.
fn divided(app: App) -> [Vec<(usize, Readout)>; 2] {
    let all: Vec<Readout> = app.read(|play| play.readouts());
    // The independent variable is shown by the clock.
    let rows = all.into_iter().enumerate().filter(|(_, readout)| readout.kind != ReadoutKind::Independent);
    let (mut main, mut others): (Vec<_>, Vec<_>) = rows.partition(|(_, readout)| readout.varies && !readout.hidden);
    let beyond: Vec<_> = main.drain(MAIN.min(main.len())..).collect();
    others.splice(0..0, beyond);
    while main.len() < MAIN
        && let Some(place) = others.iter().position(|(_, readout)| !readout.hidden)
    {
        main.push(others.remove(place));
    }
    [main, others]
}

fn list(app: App, now: ReadSignal<Vec<Readout>>, rows: Vec<(usize, Readout)>) -> HtmlDl {
    dl().child(in_portions(rows, move |(index, readout)| row(app, now, *index, readout).into()))
}

/// A row: name and symbol, the member fields, the value. A value that a question asks for is not listed.
fn row(app: App, now: ReadSignal<Vec<Readout>>, index: usize, readout: &Readout) -> HtmlDiv {
    let hidden = move || now.with(|list| list.get(index).is_some_and(|readout| readout.hidden));
    let get =
        move |part: fn(&Readout) -> &String| now.with(|list| list.get(index).map(part).cloned().unwrap_or_default());
    let symbol = (!readout.symbol.is_empty()).then(|| span().class("symbol").inner_html(readout.symbol.clone()));
    let picker = readout.members.clone().map(|members| {
        let called = if readout.label.is_empty() { members.name.clone() } else { readout.label.clone() };
        let shown = move || now.with(|list| list.get(index).and_then(|readout| readout.members.clone()));
        member::pickers(app, &called, members, shown)
    });
    let label = span().class("label").child(text(move || get(|readout| &readout.label)));
    div().hidden(hidden).child(dt().child(label).child(span().class("unbroken").maybe(symbol).maybe(picker))).child(
        dd().child(span().class("value").child(steady(move || get(|readout| &readout.value))))
            .child(unit_of(text(move || get(|readout| &readout.unit)))),
    )
}

//! Readouts with their symbols.

use crate::app::App;
use crate::controls::member;
use crate::pieces::portions::in_portions;
use crate::pieces::sight::in_sight;
use crate::pieces::steady::steady;
use crate::views::*;
use play::{Play, Readout, ReadoutKind};

/// The readouts: first those that change with time, then constant ones.
pub fn view(app: App) -> HtmlSection {
    let words = app.words();
    let first: Vec<Readout> = app.read(|play| play.readouts());
    let mut readouts = part("readouts", "readouts card", words.readouts);
    let now = followed(app, &readouts.node(), |play| play.readouts());
    // The independent variable is shown by the clock.
    let list = |varies: bool, title: &'static str| {
        let belongs = |readout: &Readout| readout.varies == varies && readout.kind != ReadoutKind::Independent;
        let rows: Vec<(usize, Readout)> =
            first.iter().cloned().enumerate().filter(|(_, readout)| belongs(readout)).collect();
        (!rows.is_empty()).then(|| {
            let rows = in_portions(rows, move |(index, readout)| row(app, now, *index, readout).into());
            div().class("values").child(h3().child(title)).child(dl().child(rows))
        })
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
        .maybe(list(true, words.changing))
        .maybe(list(false, words.constants))
        .maybe(hides.then(|| switch(shown, words.show_hidden)))
}

/// Signal with a value that changes with time, updated in the same frame as the curves. While the run plays it is
/// updated only if `element` is in sight.
pub fn followed<T: Clone + Default + PartialEq>(
    app: App,
    element: &web_sys::Element,
    mut read: impl FnMut(&mut Play) -> T + 'static,
) -> ReadSignal<T> {
    let seen = in_sight(element);
    let now = create_signal(T::default());
    effect(move || {
        app.changes.transport.track();
        app.changes.parameters.track();
        if !seen.get() && app.read(|play| play.time_line().is_playing()) {
            return;
        }
        app.changes.frame.track();
        let read = app.read(&mut read);
        if now.with_untracked(|now| *now != read) {
            now.set(read);
        }
    });
    *now
}

/// A row: name and symbol, the member fields, the value.
fn row(app: App, now: ReadSignal<Vec<Readout>>, index: usize, readout: &Readout) -> HtmlDiv {
    let why = app.words().hidden_why;
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
    div().child(dt().child(label).child(span().class("unbroken").maybe(symbol).maybe(picker))).child(
        dd().attr("title", move || hidden().then_some(why))
            .attr("data-hidden", move || hidden().then_some("true"))
            .child(span().class("value").child(steady(move || get(|readout| &readout.value))))
            .child(unit_of(text(move || get(|readout| &readout.unit)))),
    )
}

//! Points that are left out of fits: a button that makes a press on a point in a plot leave it out, and their number.

use crate::app::App;
use view::browser;
use view::views::*;

/// Button, how it is used, and the rows that are left out.
pub fn view(app: App) -> HtmlDiv {
    let words = app.words();
    let records = memo(move || {
        app.records.track();
        app.read_desk(|desk| {
            desk.records().list().iter().map(|record| (record.id, record.excluded)).collect::<Vec<_>>()
        })
    });
    let count = move || records.with(|records| records.iter().map(|(_, excluded)| excluded).sum::<usize>());
    let pressed = app.leaving_out;
    let leave = button()
        .class("quiet")
        .id("leave-out")
        .attr("aria-pressed", move || pressed.get().to_string())
        .attr("aria-describedby", "leave-out-note")
        .when(events::click, move |_| pressed.update(|pressed| *pressed = !*pressed))
        .child(words.fit_leave_out);
    let take_back = move |_| {
        let ids = records.with(|records| records.iter().map(|(id, _)| *id).collect::<Vec<_>>());
        for id in ids {
            app.act_on_desk(|desk| desk.change_records(|records, _| records.include_all(id)));
        }
        browser::focus("leave-out");
    };
    let take_back = button()
        .class("text")
        .id("take-back")
        .hidden(move || count() == 0)
        .when(events::click, take_back)
        .child(words.fit_take_back);
    let number = move || match count() {
        0 => String::new(),
        count => format!("{}: {count}", words.fit_rows_left_out),
    };
    div()
        .class("intake leaving-out")
        .child(leave)
        .child(span().class("note").id("rows-left-out").child(text(number)))
        .child(take_back)
        .child(note(words.fit_leave_out_note).id("leave-out-note").hidden(move || !pressed.get()))
}

//! The recorded run as a table, shown as a window of rows, and as CSV.

use crate::app::App;
use crate::views::*;
use crate::{browser, panel::tabs};

/// Number of rows in the window.
const ROWS: usize = 20;

/// The table and its tools. While they are folded or another tab is open, they are not updated.
pub fn view(app: App) -> HtmlDiv {
    let words = app.words();
    let head = app.read(|play| play.values().table_header());
    let start = create_signal(0_usize);
    let follow = create_signal(true);
    let length = move || {
        app.changes.values.track();
        app.read(|play| play.values().table_length())
    };
    let last_start = move || length().saturating_sub(ROWS);
    let open = memo(move || app.tab.get() == tabs::EXPLORE && app.table_open.get());
    let body = move || {
        if !open.get() {
            return View::new();
        }
        app.changes.values.track();
        let now = app.read(|play| play.values().table_row_now());
        if follow.get() {
            start.set(now.saturating_sub(ROWS - 1));
        }
        let from = start.get().min(last_start());
        let rows = app.read(|play| play.values().table_rows(from..from + ROWS));
        let row = |(number, cells): (usize, Vec<String>)| {
            let present = from + number == now;
            let mut cells = cells.into_iter();
            tr().attr("aria-current", present.then_some("true"))
                .child(th().scope("row").maybe(cells.next()))
                .each(cells, |cell| td().child(cell))
        };
        each(rows.into_iter().enumerate(), row)
    };
    let go = move |to: usize| {
        follow.set(false);
        start.set(to.min(last_start()));
    };
    let at = move || start.get().min(last_start());
    let range = move || format!("{}–{} / {} {}", at() + 1, (at() + ROWS).min(length()), length(), words.rows);
    let turn = |name: &'static str, arrow: &'static str, to: fn(usize) -> usize| {
        button().class("icon").called(name).when(events::click, move |_| go(to(at()))).child(arrow)
    };
    let pager = div()
        .class("pager")
        .role("group")
        .attr("aria-label", words.rows)
        .child(turn(words.row_first, "⇤", |_| 0))
        .child(turn(words.row_previous, "←", |at| at.saturating_sub(ROWS)))
        .child(span().class("range").child(text(range)))
        .child(turn(words.row_next, "→", |at| at + ROWS))
        .child(turn(words.row_last, "⇥", |_| usize::MAX));
    let tick = input()
        .r#type("checkbox")
        .prop("checked", move || follow.get())
        .when(events::change, move |event| follow.set(is_checked(&event)));
    let take = |id: &'static str, name: &'static str, take: fn(App)| {
        button().class("quiet").id(id).when(events::click, move |_| take(app)).child(name)
    };
    let actions = div()
        .class("actions")
        .child(take("copy-csv", words.copy_csv, copy))
        .child(take("save-csv", words.save_csv, save))
        .child(app.host().save_buttons());
    let bar = div().class("data-bar").child(pager).child(switch(tick, words.follow)).child(actions);
    let head = tr().each(head, column_head);
    let table = table_in("table", words.table, Some(head), tbody().child(changing(body)));
    div().class("data").child(bar).child(table)
}

/// Copies the text without the byte-order mark, which is meant for files.
fn copy(app: App) {
    crate::panel::reading::copy(app, app.read(|play| play.values().csv()).trim_start_matches('\u{feff}'));
}

fn save(app: App) {
    browser::save_text(&format!("{}.csv", app.host().stem()), "text/csv", &app.read(|play| play.values().csv()));
}

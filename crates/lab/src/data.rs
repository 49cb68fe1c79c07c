//! The recorded run as a table, a window of rows at a time, and as CSV.

use crate::app::App;
use crate::{browser, notebook};
use leptos::prelude::*;

/// Rows in the window.
const ROWS: usize = 20;

/// The table and its tools, in the notebook's tab of this number. While another tab is open it costs nothing.
pub fn view(app: App, tab: usize) -> AnyView {
    let words = app.words();
    let head = app.read(|session| session.table_header());
    let head = head.into_iter().map(|cell| view! { <th scope="col">{cell}</th> }).collect_view();
    let start = RwSignal::new(0_usize);
    let follow = RwSignal::new(true);
    let length = move || {
        app.changes.values.track();
        app.read(|session| session.table_length())
    };
    let last_start = move || length().saturating_sub(ROWS);
    let open = Memo::new(move |_| app.tab.get() == tab);
    let body = move || {
        if !open.get() {
            return Vec::new();
        }
        app.changes.values.track();
        let now = app.read(|session| session.table_row_now());
        if follow.get() {
            start.set(now.saturating_sub(ROWS - 1));
        }
        let from = start.get().min(last_start());
        let rows = app.read(|session| session.table_rows(from..from + ROWS));
        rows.into_iter()
            .enumerate()
            .map(|(number, cells)| {
                let mut cells = cells.into_iter();
                let first = cells.next();
                let cells = cells.map(|cell| view! { <td>{cell}</td> }).collect_view();
                let present = from + number == now;
                view! { <tr aria-current=present.then_some("true")><th scope="row">{first}</th>{cells}</tr> }
            })
            .collect_view()
    };
    let go = move |to: usize| {
        follow.set(false);
        start.set(to.min(last_start()));
    };
    let at = move || start.get().min(last_start());
    let range = move || format!("{}–{} / {} {}", at() + 1, (at() + ROWS).min(length()), length(), words.rows);
    view! {
        <div class="data">
            <div class="data-bar">
                <div class="pager" role="group" aria-label=words.rows>
                    <button type="button" class="icon" aria-label=words.row_first title=words.row_first on:click=move |_| go(0)>"⇤"</button>
                    <button type="button" class="icon" aria-label=words.row_previous title=words.row_previous on:click=move |_| go(at().saturating_sub(ROWS))>"←"</button>
                    <span class="range">{range}</span>
                    <button type="button" class="icon" aria-label=words.row_next title=words.row_next on:click=move |_| go(at() + ROWS)>"→"</button>
                    <button type="button" class="icon" aria-label=words.row_last title=words.row_last on:click=move |_| go(usize::MAX)>"⇥"</button>
                </div>
                <label class="switch">
                    <input type="checkbox" prop:checked=move || follow.get() on:change=move |event| follow.set(event_target_checked(&event)) />
                    <span>{words.follow}</span>
                </label>
                <div class="actions">
                    <button type="button" class="quiet" id="copy-csv" on:click=move |_| notebook::copy(app, &app.read(|session| session.csv()))>{words.copy_csv}</button>
                    <button type="button" class="quiet" id="save-csv" on:click=move |_| save(app)>{words.save_csv}</button>
                    <button type="button" class="quiet" id="save-xlsx" on:click=move |_| save_workbook(app)>{words.save_xlsx}</button>
                </div>
            </div>
            <div class="table" tabindex="0" role="region" aria-label=words.table>
                <table>
                    <caption class="visually-hidden">{words.table}</caption>
                    <thead><tr>{head}</tr></thead>
                    <tbody>{body}</tbody>
                </table>
            </div>
        </div>
    }
    .into_any()
}

fn save(app: App) {
    browser::save_text(&format!("{}.csv", stem(app)), "text/csv", &app.read(|session| session.csv()));
}

fn save_workbook(app: App) {
    let kind = "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet";
    browser::save_bytes(&format!("{}.xlsx", stem(app)), kind, &app.read(|session| session.workbook()));
}

/// The name of the document's file without its ending.
fn stem(app: App) -> String {
    let name = app.with(|lab| lab.sources.first().map(|file| file.name.clone())).flatten().unwrap_or_default();
    let name = name.rsplit('/').next().unwrap_or_default().trim_end_matches(".md");
    if name.is_empty() { "run".to_owned() } else { name.to_owned() }
}

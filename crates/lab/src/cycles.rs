//! An oscillation cycle by cycle: a choice of plots, the table, the words. Nothing is computed while it is closed.

use crate::app::App;
use crate::{browser, plots};
use leptos::html;
use leptos::prelude::*;
use session::{CyclesView, ExportKind};

/// The section; nothing while there is no record.
pub fn view(app: App) -> impl IntoView {
    let any = Memo::new(move |_| {
        app.changes.records.track();
        app.read(|session| !session.records().is_empty())
    });
    move || if any.get() { card(app) } else { ().into_any() }
}

fn card(app: App) -> AnyView {
    let words = app.words();
    let open = RwSignal::new(app.read(|session| session.looks_at_cycles()));
    // Raised whenever something else is looked at.
    let looked = RwSignal::new(0_u32);
    let details = NodeRef::<html::Details>::new();
    let toggled = move |_| {
        let now = details.get_untracked().is_some_and(|details| details.open());
        if now != open.get_untracked() {
            app.act(|session| session.open_cycles(now));
            open.set(now);
        }
    };
    view! {
        <details node_ref=details class="cycles card" id="cycles" open=open.get_untracked() on:toggle=toggled>
            <summary><h3>{words.cycles_title}</h3></summary>
            {move || if open.get() { content(app, looked) } else { ().into_any() }}
        </details>
    }
    .into_any()
}

fn content(app: App, looked: RwSignal<u32>) -> AnyView {
    let words = app.words();
    let index = app.read(|session| session.cycle_plot());
    let shown = move |index: usize| {
        app.changes.plots.track();
        app.read(|session| session.plots().get(index).is_some_and(|plot| plot.offered))
    };
    let found = move || {
        looked.track();
        app.changes.records.track();
        app.read(|session| session.cycles())
    };
    let sentences = move || {
        let sentences = found().map(|found| found.sentences).unwrap_or_default();
        sentences.into_iter().map(|sentence| view! { <p>{sentence}</p> }).collect_view()
    };
    view! {
        <p class="note">{words.cycles_intro}</p>
        {choices(app, looked)}
        <div class="verdicts">{sentences}</div>
        {plots::figure(app, index, shown)}
        {move || found().filter(|found| !found.rows.is_empty()).map(|found| table(app, found))}
    }
    .into_any()
}

/// Which column, which quantity, against what.
fn choices(app: App, looked: RwSignal<u32>) -> AnyView {
    let words = app.words();
    let columns = move || {
        looked.track();
        app.changes.records.track();
        let columns = app.read(|session| session.cycle_columns());
        let option = |column: session::CycleColumn| {
            let value = format!("{}-{}", column.record, column.column);
            view! { <option value=value selected=column.selected>{column.label}</option> }
        };
        columns.into_iter().map(option).collect_view()
    };
    let (names, drawn) = app.read(|session| session.cycle_quantities());
    let options = names
        .into_iter()
        .enumerate()
        .map(|(number, name)| view! { <option value=number.to_string() selected=number == drawn>{name}</option> })
        .collect_view();
    let against = move || {
        looked.track();
        app.read(|session| session.cycles_against_amplitude())
    };
    let draw = move |quantity: Option<usize>, amplitude: Option<bool>| {
        app.act(|session| {
            let (now, so) = (session.cycle_quantities().1, session.cycles_against_amplitude());
            session.show_cycles(quantity.unwrap_or(now), amplitude.unwrap_or(so));
        });
        looked.update(|count| *count += 1);
    };
    let choose = move |value: String| {
        let (record, column) = value.split_once('-').unwrap_or_default();
        if let (Ok(record), Ok(column)) = (record.parse(), column.parse()) {
            app.act(|session| session.choose_cycles(record, column));
            looked.update(|count| *count += 1);
        }
    };
    let side = move |label: &'static str, amplitude: bool| {
        view! {
            <button type="button" class="chip" aria-pressed=move || (against() == amplitude).to_string()
                on:click=move |_| draw(None, Some(amplitude))>{label}</button>
        }
    };
    view! {
        <div class="looking">
            <span class="quantity"><label for="cycles-column">{words.cycles_column}</label>
                <select id="cycles-column" on:change=move |event| choose(event_target_value(&event))>{columns}</select></span>
            <span class="quantity"><label for="cycles-quantity">{words.cycles_quantity}</label>
                <select id="cycles-quantity" on:change=move |event| draw(event_target_value(&event).parse().ok(), None)>{options}</select></span>
            <div class="chips" role="group" aria-label=words.cycles_against>
                <span class="note" aria-hidden="true">{words.cycles_against}</span>
                {side(words.cycles_time, false)}
                {side(words.cycles_amplitude, true)}
            </div>
        </div>
    }
    .into_any()
}

fn table(app: App, found: CyclesView) -> AnyView {
    let words = app.words();
    let heads = found.heads.into_iter().map(|head| view! { <th scope="col">{head}</th> }).collect_view();
    let rows = found
        .rows
        .into_iter()
        .map(|(kind, cells)| {
            let cells = cells.into_iter().map(|cell| view! { <td>{cell}</td> }).collect_view();
            view! { <tr><th scope="row">{kind}</th>{cells}</tr> }
        })
        .collect_view();
    let save = move |kind: ExportKind| {
        if let Some(file) = app.read(|session| session.export_cycles(kind)) {
            browser::save_bytes(&file.name, file.kind, &file.bytes);
        }
    };
    view! {
        <p class="note">{words.cycles_run}</p>
        <div class="table" tabindex="0" role="region" aria-label=words.cycles_title>
            <table>
                <caption class="visually-hidden">{words.cycles_title}</caption>
                <thead><tr><th scope="col">{words.cycles_turn}</th>{heads}</tr></thead>
                <tbody>{rows}</tbody>
            </table>
        </div>
        <p class="note">{words.cycles_note}</p>
        <div class="intake">
            <button type="button" class="quiet" on:click=move |_| save(ExportKind::Csv)>"CSV"</button>
            <button type="button" class="quiet" on:click=move |_| save(ExportKind::Workbook)>"XLSX"</button>
        </div>
    }
    .into_any()
}

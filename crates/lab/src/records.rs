//! The records: what is drawn of them, what their columns are taken for, what they hide.

use crate::app::App;
use crate::{browser, derivatives, icons};
use leptos::prelude::*;
use session::{ColumnView, RecordView};

/// Rows of the preview.
const ROWS: usize = 4;

/// The list of records; nothing while there are none.
pub fn view(app: App) -> impl IntoView {
    let words = app.words();
    let choice = derivatives::Choice::new();
    move || {
        app.changes.records.track();
        let records = app.read(|session| session.records());
        let items: Vec<AnyView> = records.into_iter().map(|record| item(app, record, choice)).collect();
        if items.is_empty() {
            return ().into_any();
        }
        view! { <section class="records" aria-label=words.records>{items}</section> }.into_any()
    }
}

fn item(app: App, record: RecordView, choice: derivatives::Choice) -> AnyView {
    let words = app.words();
    let id = record.id;
    let remove = format!("{}: {}", words.remove_record, record.name);

    let findings: Vec<AnyView> =
        record.findings.iter().map(|finding| view! { <li>{finding.clone()}</li> }.into_any()).collect();
    let findings = (!findings.is_empty())
        .then(|| view! { <div class="hidden-things"><h4>{words.findings}</h4><ul>{findings}</ul></div> }.into_any());
    view! {
        <article class="record card" aria-labelledby=format!("record-{id}")>
            <div class="record-head">
                <h3 id=format!("record-{id}")>{record.name.clone()}</h3>
                {record.synthetic.then(|| view! { <span class="tag" title=words.sample_title>{words.synthetic}</span> })}
                <span class="note">{format!("{} {}", record.rows, words.rows)}</span>
                {(!record.lasting).then(|| view! { <span class="note">{words.not_lasting}</span> })}
                <label class="switch">
                    <input type="checkbox" id=format!("show-record-{id}") prop:checked=record.shown on:change=move |event| {
                        let shown = event_target_checked(&event);
                        app.act(|session| session.show_record(id, shown));
                        browser::focus_later(format!("show-record-{id}"));
                    } />
                    <span>{words.show_record}</span>
                </label>
                <button type="button" class="icon small" title=remove.clone() aria-label=remove on:click=move |_| {
                    app.act(|session| session.remove_record(id));
                    browser::focus_later("choose-record".to_owned());
                }>{icons::cross()}</button>
            </div>
            {preview(app, &record)}
            {derivatives::view(app, &record, choice)}
            {findings}
        </article>
    }
    .into_any()
}

fn preview(app: App, record: &RecordView) -> AnyView {
    let words = app.words();
    let id = record.id;
    let measurable = app.read(|session| session.measurable());
    let columns = &record.columns;
    let each = |cell: &dyn Fn(&ColumnView) -> AnyView| columns.iter().map(cell).collect::<Vec<_>>();
    let made = |how: &str| (!how.is_empty()).then(|| view! { <span class="note made">{how.to_owned()}</span> });
    let heads = each(&|column| view! { <th scope="col">{column.head.clone()}{made(&column.made)}</th> }.into_any());
    let quantities = each(&|column| quantity(app, id, column, &measurable));
    let units = each(&|column| unit(app, id, column));
    let fitted = each(&|column| fitted(app, id, column));
    let rows: Vec<Vec<String>> =
        columns.iter().map(|column| app.read(|session| session.record_cells(id, column.index, 0..ROWS))).collect();
    let rows: Vec<AnyView> = (0..ROWS.min(record.rows))
        .map(|row| {
            let cells: Vec<AnyView> = rows
                .iter()
                .map(|column| view! { <td>{column.get(row).cloned().unwrap_or_default()}</td> }.into_any())
                .collect();
            view! { <tr><th scope="row">{row + 1}</th>{cells}</tr> }.into_any()
        })
        .collect();
    let label = format!("{}: {}", words.preview, record.name);
    let caption = label.clone();
    view! {
        <div class="table" tabindex="0" role="region" aria-label=label>
            <table>
                <caption class="visually-hidden">{caption}</caption>
                <thead><tr><th scope="col">{words.column}</th>{heads}</tr></thead>
                <tbody>
                    <tr><th scope="row">{words.column_measures}</th>{quantities}</tr>
                    <tr><th scope="row">{words.column_unit}</th>{units}</tr>
                    <tr><th scope="row">{words.column_fitted}</th>{fitted}</tr>
                    {rows}
                </tbody>
            </table>
        </div>
    }
    .into_any()
}

/// What a control of a column is called.
fn name(app: App, what: fn(&crate::words::Words) -> &'static str, column: &ColumnView) -> String {
    format!("{}, {}", what(app.words()), column.head)
}

fn quantity(app: App, record: u32, column: &ColumnView, measurable: &[(String, String)]) -> AnyView {
    let (index, id) = (column.index, format!("measures-{record}-{}", column.index));
    let option = |value: &str, label: &str| {
        let selected = column.quantity == value;
        view! { <option value=value.to_owned() selected=selected>{label.to_owned()}</option> }.into_any()
    };
    let options: Vec<AnyView> = std::iter::once(option("", app.words().column_off))
        .chain(measurable.iter().map(|(value, label)| option(value, label)))
        .collect();
    let again = id.clone();
    view! {
        <td><select id=id aria-label=name(app, |words| words.column_measures, column) on:change=move |event| {
            let name = event_target_value(&event);
            app.act(|session| session.set_column_quantity(record, index, &name));
            browser::focus_later(again.clone());
        }>{options}</select></td>
    }
    .into_any()
}

fn unit(app: App, record: u32, column: &ColumnView) -> AnyView {
    if column.quantity.is_empty() {
        return view! { <td></td> }.into_any();
    }
    let (index, id) = (column.index, format!("unit-{record}-{}", column.index));
    let again = id.clone();
    view! {
        <td><input type="text" class="number" id=id aria-label=name(app, |words| words.column_unit, column)
            autocomplete="off" spellcheck="false" enterkeyhint="done" prop:value=column.unit.clone()
            on:change=move |event| {
                let typed = event_target_value(&event);
                let refusal = app.attempt(|session| session.set_column_unit(record, index, &typed));
                app.record_refusal.set(refusal);
                browser::focus_later(again.clone());
            } /></td>
    }
    .into_any()
}

fn fitted(app: App, record: u32, column: &ColumnView) -> AnyView {
    if !column.fittable {
        return view! { <td></td> }.into_any();
    }
    let (index, id) = (column.index, format!("fitted-{record}-{}", column.index));
    let again = id.clone();
    view! {
        <td><input type="checkbox" id=id aria-label=name(app, |words| words.column_fitted, column) prop:checked=column.fitted
            on:change=move |event| {
                let fitted = event_target_checked(&event);
                app.act(|session| session.set_column_fitted(record, index, fitted));
                browser::focus_later(again.clone());
            } /></td>
    }
    .into_any()
}

//! List of records: what is plotted, the meaning of their columns, data quality.

use crate::app::App;
use crate::{measuring::derivatives, measuring::intake};
use desk::{ColumnView, ExportKind, RecordView};
use view::browser;
use view::views::*;

/// Number of column values shown in the preview.
const ROWS: usize = 3;

/// The present records.
type Records = ReadSignal<Vec<RecordView>>;

/// List of records; empty while there are none.
pub fn view(app: App) -> View {
    let choice = derivatives::Choice::new();
    let records = memo(move || {
        app.records.track();
        app.read_desk(|desk| desk.records().list())
    });
    // Without the units, which the user may be typing.
    let items = memo(move || {
        let mut items = records.get_clone();
        items.iter_mut().flat_map(|item| &mut item.columns).for_each(|column| column.unit.clear());
        items
    });
    changing(move || {
        let items = items.get_clone();
        if items.is_empty() {
            return View::new();
        }
        let list = section().class("records").attr("aria-label", app.words().records);
        list.each(items, |record| item(app, records, record, choice)).into()
    })
}

fn item(app: App, records: Records, record: RecordView, choice: derivatives::Choice) -> HtmlArticle {
    let words = app.words();
    let id = record.id;
    let label_of_remove = format!("{}: {}", words.remove_record, record.name);
    let tick = tick(format!("show-record-{id}"), record.shown, move |shown| {
        app.act_on_desk(|desk| desk.change_records(|records, _| records.show(id, shown)));
    });
    let remove = move |_| {
        app.act_on_desk(|desk| desk.change_records(|records, _| records.remove(id)));
        browser::focus_later("choose-record".to_owned());
    };
    let remove = cross(label_of_remove).when(events::click, remove);
    let head = div()
        .class("record-head")
        .child(h3().id(format!("record-{id}-name")).child(record.name.clone()))
        .maybe(record.synthetic.then(|| span().class("tag").title(words.sample_title).child(words.synthetic)))
        .child(span().class("note").child(format!("{} {}", record.rows, words.rows)))
        .maybe((!record.lasting).then(|| span().class("note").child(words.not_lasting)))
        .child(switch(tick, words.show_record))
        .child(remove);
    let findings = (!record.findings.is_empty()).then(|| {
        let findings = ul().each(&record.findings, |finding| li().child(finding.clone()));
        div().class("hidden-things").child(h4().child(words.findings)).child(findings)
    });
    let is_new = move || app.new_record.get() == Some(id);
    article()
        .class(move || if is_new() { "record card new" } else { "record card" })
        .id(format!("record-{id}"))
        .tabindex("-1")
        .attr("aria-labelledby", format!("record-{id}-name"))
        .when(events::animationend, move |_| app.new_record.set(None))
        .child(head)
        .child(variable(app, &record))
        .child(preview(app, records, &record))
        .child(derivatives::view(app, &record, choice))
        .maybe(findings)
        .child(exports(app, &record))
}

/// Choice of the independent variable; a question if several interpretations are possible.
fn variable(app: App, record: &RecordView) -> HtmlLabel {
    let words = app.words();
    let (record, choices) = (record.id, record.variables.clone());
    let open = choices.iter().all(|choice| !choice.chosen);
    let id = format!("variable-{record}");
    let again = id.clone();
    let shown = choices.clone().into_iter().enumerate();
    let choose = move |event| {
        let place = value_of(&event).parse::<usize>().ok();
        if let Some(choice) = place.and_then(|place| choices.get(place)) {
            app.act_on_desk(|desk| {
                desk.change_records(|records, open| records.set_variable(open, record, &choice.columns))
            });
            browser::focus_later(again.clone());
        }
    };
    let asked = open.then(|| option().value("").selected(true).child(words.variable_asked));
    let select = select()
        .id(id)
        .attr("aria-invalid", open.then_some("true"))
        .when(events::change, choose)
        .maybe(asked)
        .each(shown, |(place, choice)| option().value(place.to_string()).selected(choice.chosen).child(choice.text));
    label().class("field").child(span().child(words.variable)).child(select)
}

/// Export buttons of a record.
fn exports(app: App, record: &RecordView) -> HtmlDiv {
    let id = record.id;
    let save = |name: &'static str, kind: ExportKind| {
        let save = move |_| {
            if let Some(file) = app.read_desk(|desk| desk::export_record(desk, id, kind)) {
                browser::save_bytes(&file.name, file.kind, &file.bytes);
            }
        };
        let label = format!("{} {name}: {}", app.words().save_record, record.name);
        button()
            .class("quiet")
            .id(format!("record-{id}-{kind:?}"))
            .attr("aria-label", label)
            .when(events::click, save)
            .child(name)
    };
    div().class("intake").child(save("CSV", ExportKind::Csv)).child(save("XLSX", ExportKind::Workbook))
}

/// A row per column: its quantity, its unit, whether it is fitted, and its first values.
fn preview(app: App, records: Records, record: &RecordView) -> HtmlDiv {
    let words = app.words();
    let id = record.id;
    let measurable = app.read_desk(|desk| desk.records().measurable());
    let line = |column: &ColumnView| {
        let made = (!column.made.is_empty()).then(|| span().class("note made").child(column.made.clone()));
        let (index, rows) = (column.index, 0..ROWS.min(record.rows));
        // The record of a film changes while the user works on the film.
        let first = memo(move || {
            app.records.track();
            let cells = app.read_desk(|desk| desk.records().cells(id, index, rows.clone())).into_iter();
            cells.map(|cell| if cell.is_empty() { "–".to_owned() } else { cell }).collect::<Vec<_>>().join(" · ")
        });
        let first = span().class("note first-values").child(text(move || first.get_clone()));
        tr().child(row_head(column.head.clone()).maybe(made).child(first))
            .child(quantity(app, id, column, &measurable))
            .child(unit(app, records, id, column))
            .child(fitted(app, id, column))
    };
    let heads = [words.column, words.column_measures, words.column_unit, words.column_fitted];
    let body = tbody().each(&record.columns, line);
    table_in("table", format!("{}: {}", words.preview, record.name), Some(tr().each(heads, column_head)), body)
}

/// Accessible name of a control of a column.
fn name(app: App, what: fn(&crate::words::Words) -> &'static str, column: &ColumnView) -> String {
    format!("{}, {}", what(app.words()), column.head)
}

fn quantity(app: App, record: u32, column: &ColumnView, measurable: &[(String, String)]) -> HtmlTd {
    let (index, id) = (column.index, format!("measures-{record}-{}", column.index));
    let again = id.clone();
    let choose = move |event| {
        let name = value_of(&event);
        app.act_on_desk(|desk| desk.change_records(|records, open| records.set_quantity(open, record, index, &name)));
        browser::focus_later(again.clone());
    };
    let choice = |value: &str, label: &str| {
        option().value(value.to_owned()).selected(column.quantity == value).child(label.to_owned())
    };
    let select = select()
        .id(id)
        .attr("aria-label", name(app, |words| words.column_measures, column))
        .when(events::change, choose)
        .child(choice("", app.words().column_off))
        .each(measurable, |(value, label)| choice(value, label));
    td().child(select)
}

fn unit(app: App, records: Records, record: u32, column: &ColumnView) -> View {
    if column.quantity.is_empty() {
        return td().into();
    }
    let (index, id) = (column.index, format!("unit-{record}-{}", column.index));
    let again = id.clone();
    let now = memo(move || {
        records.with(|records| {
            let columns = records.iter().filter(|other| other.id == record).flat_map(|record| &record.columns);
            columns.filter(|column| column.index == index).map(|column| column.unit.as_str()).collect::<String>()
        })
    });
    let take = move |event| {
        let typed = value_of(&event);
        let refusal = app
            .attempt_on_desk(|desk| desk.change_records(|records, open| records.set_unit(open, record, index, &typed)));
        intake::refuse(app, refusal);
        browser::focus_later(again.clone());
    };
    let words = app.words();
    let note = (!column.unit_origin.is_empty()).then(|| {
        let class = match (column.unit_asked, column.unit_assumed) {
            (true, _) => "origin asked",
            (_, true) => "origin assumed",
            _ => "origin",
        };
        span().class(class).id(format!("origin-{record}-{index}")).child(column.unit_origin.clone())
    });
    let field = short_field(id)
        .attr("aria-label", name(app, |words| words.column_unit, column))
        .attr("aria-describedby", note.is_some().then(|| format!("origin-{record}-{index}")))
        .attr("aria-invalid", column.unit_asked.then_some("true"))
        .attr("placeholder", column.unit_asked.then_some(words.column_unit_asked))
        .enterkeyhint("done")
        .prop("value", now)
        .when(events::change, take);
    td().class("unit-cell").child(field).maybe(note).into()
}

fn fitted(app: App, record: u32, column: &ColumnView) -> View {
    if !column.fittable {
        return td().into();
    }
    let (index, id) = (column.index, format!("fitted-{record}-{}", column.index));
    let tick = tick(id, column.fitted, move |fitted| {
        app.act_on_desk(|desk| desk.change_records(|records, _| records.set_fitted(record, index, fitted)));
    });
    td().child(tick.attr("aria-label", name(app, |words| words.column_fitted, column))).into()
}

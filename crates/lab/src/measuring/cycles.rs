//! Analysis of an oscillation cycle by cycle: choice of plots, table, explanations. Nothing is computed while it is
//! closed.

use crate::app::App;
use desk::{CycleColumn, CyclesView, ExportKind};
use view::browser;
use view::stage::plots;
use view::views::*;
use web_sys::HtmlDetailsElement;

/// The section; empty while there are no records.
pub fn view(app: App) -> View {
    let any = memo(move || {
        app.records.track();
        app.read_desk(|desk| !desk.records().list().is_empty())
    });
    changing(move || if any.get() { card(app) } else { View::new() })
}

fn card(app: App) -> View {
    let words = app.words();
    let open = create_signal(app.read_desk(|desk| desk.cycles().is_open()));
    // Raised whenever another selection is made.
    let looked = create_signal(0_u32);
    let mut details = details();
    let node: HtmlDetailsElement = details.node();
    let toggled = move |_| {
        let now = node.open();
        if now != open.get_untracked() {
            app.act_on_desk(|desk| desk.change_cycles(|cycles| cycles.open(now)));
            open.set(now);
        }
    };
    details
        .class("cycles card")
        .id("cycles")
        .open(open.get_untracked())
        .when(events::toggle, toggled)
        .child(summary().child(h3().child(words.cycles_title)))
        .child(changing(move || if open.get() { content(app, looked) } else { View::new() }))
        .into()
}

fn content(app: App, looked: Signal<u32>) -> View {
    let words = app.words();
    let index = app.read_desk(|desk| desk.cycles().plot());
    let shown = move || app.plot(index).is_some_and(|plot| plot.offered);
    let found = memo(move || {
        looked.track();
        app.records.track();
        app.read_desk(|desk| desk.cycles().table())
    });
    let sentences = move || {
        let sentences = found.get_clone().map(|found| found.sentences).unwrap_or_default();
        each(sentences, |sentence| p().child(sentence))
    };
    let found = move || match found.get_clone().filter(|found| !found.rows.is_empty()) {
        Some(found) => table(app, found),
        None => View::new(),
    };
    View::from((
        note(words.cycles_intro),
        choices(app, looked),
        div().class("verdicts").child(changing(sentences)),
        plots::figure(app.page, index, Box::new(shown)),
        changing(found),
    ))
}

/// Choice of column, quantity and abscissa.
fn choices(app: App, looked: Signal<u32>) -> HtmlDiv {
    let words = app.words();
    let columns = move || {
        looked.track();
        app.records.track();
        let columns = app.read_desk(|desk| desk.cycles().columns());
        let choose = |column: CycleColumn| {
            let value = format!("{}-{}", column.record, column.column);
            option().value(value).selected(column.selected).child(column.label)
        };
        each(columns, choose)
    };
    let (names, drawn) = app.read_desk(|desk| desk.cycles().quantities());
    let quantity =
        |(number, name): (usize, String)| option().value(number.to_string()).selected(number == drawn).child(name);
    let against = move || {
        looked.track();
        app.read_desk(|desk| desk.cycles().is_against_amplitude())
    };
    let draw = move |quantity: Option<usize>, amplitude: Option<bool>| {
        app.act_on_desk(|desk| {
            let (now, so) = (desk.cycles().quantities().1, desk.cycles().is_against_amplitude());
            desk.change_cycles(|cycles| cycles.show(quantity.unwrap_or(now), amplitude.unwrap_or(so)));
        });
        looked.update(|count| *count += 1);
    };
    let choose = move |value: String| {
        let (record, column) = value.split_once('-').unwrap_or_default();
        if let (Ok(record), Ok(column)) = (record.parse(), column.parse()) {
            app.act_on_desk(|desk| desk.change_cycles(|cycles| cycles.choose(record, column)));
            looked.update(|count| *count += 1);
        }
    };
    let side = move |label: &'static str, amplitude: bool| {
        button()
            .class("chip")
            .attr("aria-pressed", move || (against() == amplitude).to_string())
            .when(events::click, move |_| draw(None, Some(amplitude)))
            .child(label)
    };
    let column = select()
        .id("cycles-column")
        .when(events::change, move |event| choose(value_of(&event)))
        .child(changing(columns));
    let quantity = select()
        .id("cycles-quantity")
        .when(events::change, move |event| draw(value_of(&event).parse().ok(), None))
        .each(names.into_iter().enumerate(), quantity);
    let against = div()
        .class("chips")
        .role("group")
        .attr("aria-label", words.cycles_against)
        .child(span().class("note").attr("aria-hidden", "true").child(words.cycles_against))
        .child(side(words.cycles_time, false))
        .child(side(words.cycles_amplitude, true));
    div()
        .class("looking")
        .child(field_of("cycles-column", words.cycles_column).child(column))
        .child(field_of("cycles-quantity", words.cycles_quantity).child(quantity))
        .child(against)
}

fn table(app: App, found: CyclesView) -> View {
    let words = app.words();
    let row = |(kind, cells)| tr().child(row_head(kind)).each(cells, |cell: String| td().child(cell));
    let save = move |kind: ExportKind| {
        if let Some(file) = app.read_desk(|desk| desk.cycles().export(kind)) {
            browser::save_bytes(&file.name, file.kind, &file.bytes);
        }
    };
    let save = |name: &'static str, kind: ExportKind| {
        button().class("quiet").when(events::click, move |_| save(kind)).child(name)
    };
    let head = tr().child(column_head(words.cycles_turn)).each(found.heads, column_head);
    View::from((
        note(words.cycles_run),
        table_in("table", words.cycles_title, Some(head), tbody().each(found.rows, row)),
        note(words.cycles_note),
        div().class("intake").child(save("CSV", ExportKind::Csv)).child(save("XLSX", ExportKind::Workbook)),
    ))
}

//! Form of a plot: its title, quantities, abscissa and style, and its place among the plots.

use super::forms::Plots;
use crate::write::fields::{Piece, named, refuse};
use crate::write::{briefs, typing};
use document::edit::{exchange_plots, remove_plot, set_plot};
use document::form::{PlotCell, plottable};
use view::browser;
use view::pieces::icons;
use view::views::*;

/// Id of a part of a plot.
fn id(number: usize, part: &str) -> String {
    format!("plot-form-{number}-{part}")
}

/// Card of a plot with its cells.
pub fn view(plots: Plots, number: usize, count: usize, cells: &[PlotCell]) -> HtmlLi {
    let words = plots.app.words();
    let refusal = create_signal(None::<String>);
    let named = |part: &str| format!("{} {}: {part}", words.plot, number + 1);
    let piece = |kind: PlotCell, name: &str| Piece {
        id: id(number, &format!("{kind:?}").to_lowercase()),
        name: named(name),
        text: text_of(plots, number, kind),
        refusal,
        write: Box::new(move |typed| write(plots, number, kind, typed)),
    };
    let has = |kind: PlotCell| cells.contains(&kind);
    let titled = |name: &'static str, field: View| {
        div().class("plot-line").child(span().class("word").attr("aria-hidden", "true").child(name)).child(field)
    };
    let head = if has(PlotCell::Title) {
        View::from(piece(PlotCell::Title, words.text_title).line(plots.app))
    } else {
        let typing = plots.typing;
        let field = piece(PlotCell::Text, words.panel_text).lines(plots.app);
        let field = field.when(events::focus, move |_| typing.set(true)).when(events::blur, move |_| typing.set(false));
        field.into()
    };
    let curves = has(PlotCell::Curves).then(|| {
        let field = piece(PlotCell::Curves, words.plot_curves).lines(plots.app);
        let add = adding(plots, number, named(words.plot_add_curve), refusal);
        titled(words.plot_curves, View::from((field, add)))
    });
    let across = has(PlotCell::Across).then(|| {
        let list = id(number, "names");
        let names = quantities(plots, true);
        let options = changing(move || each(names.get_clone(), |(name, _)| option().value(name)));
        let field = piece(PlotCell::Across, words.plot_against).line(plots.app).attr("list", list.clone());
        titled(words.plot_against, View::from((field, datalist().id(list).child(options))))
    });
    let kind = has(PlotCell::Kind)
        .then(|| titled(words.plot_kind, kinds(plots, number, named(words.plot_kind), refusal).into()));
    let equal = has(PlotCell::Equal).then(|| {
        let text = text_of(plots, number, PlotCell::Equal);
        let set = move |event| {
            let value = if is_checked(&event) { "equal axes" } else { "" };
            refuse(refusal, write(plots, number, PlotCell::Equal, value).err());
        };
        let tick = input()
            .r#type("checkbox")
            .attr("aria-label", named(words.plot_equal))
            .prop("checked", move || text.with(|text| !text.is_empty()))
            .when(events::change, set);
        switch(tick, words.plot_equal)
    });
    li().class("plot-form")
        .child(div().class("plot-head").child(head).child(order(plots, number, count)))
        .maybe(curves)
        .maybe(across)
        .child(div().class("plot-row").maybe(kind).maybe(equal))
        .child(faults(plots, number))
        .child(refusal_of(refusal))
}

fn text_of(plots: Plots, number: usize, kind: PlotCell) -> ReadSignal<String> {
    memo(move || {
        plots.all.with(|all| {
            let cell = all.get(number).and_then(|part| part.cell(kind));
            cell.map(|(text, _)| text.to_owned()).unwrap_or_default()
        })
    })
}

fn write(plots: Plots, number: usize, kind: PlotCell, typed: &str) -> Result<(), String> {
    let text = typing::text(plots.app, 0);
    typing::change(plots.app, 0, &text, |outline| set_plot(outline, number, kind, typed)).map(|_| ())
}

/// Quantities of the running program that can be plotted: (name, label).
fn quantities(plots: Plots, with_independent: bool) -> ReadSignal<Vec<(String, Option<String>)>> {
    let app = plots.app;
    memo(move || {
        app.written.track();
        app.read(|play| plottable(play.program(), with_independent))
    })
}

/// List for adding a quantity.
fn adding(plots: Plots, number: usize, name: String, refusal: Signal<Option<String>>) -> HtmlSelect {
    let names = quantities(plots, false);
    let title = plots.app.words().plot_add_curve;
    let add = move |event: web_sys::Event| {
        let chosen = value_of(&event);
        let now = plots.all.with_untracked(|all| {
            let cell = all.get(number).and_then(|part| part.cell(PlotCell::Curves));
            cell.map(|(text, _)| text.to_owned()).unwrap_or_default()
        });
        let list = if now.is_empty() { chosen } else { format!("{now}, {chosen}") };
        refuse(refusal, write(plots, number, PlotCell::Curves, &list).err());
        if let Some(select) = browser::by_id::<web_sys::HtmlSelectElement>(&id(number, "add")) {
            select.set_selected_index(0);
        }
    };
    let choice = |(name, label): (String, Option<String>)| {
        let title = named(&name, label);
        option().value(name).child(title)
    };
    let options = changing(move || each(names.get_clone(), choice));
    select()
        .class("cell")
        .id(id(number, "add"))
        .attr("aria-label", name)
        .child(option().value("").prop("selected", true).prop("disabled", true).child(title))
        .child(options)
        .when(events::change, add)
}

/// Choice of the style.
fn kinds(plots: Plots, number: usize, name: String, refusal: Signal<Option<String>>) -> HtmlSelect {
    let words = plots.app.words();
    let text = text_of(plots, number, PlotCell::Kind);
    let choice = move |(value, title): (&'static str, &'static str)| {
        option().value(value).prop("selected", move || text.with(|text| text == value)).child(title)
    };
    let all = [("", words.plot_as_curves), ("points", words.plot_as_points), ("histogram", words.plot_as_histogram)];
    let own = id(number, "kind");
    let set = move |event: web_sys::Event| {
        refuse(refusal, write(plots, number, PlotCell::Kind, &value_of(&event)).err());
        browser::focus_later(id(number, "kind"));
    };
    select().class("cell").id(own).attr("aria-label", name).each(all, choice).when(events::change, set)
}

/// Buttons that move and remove the plot.
fn order(plots: Plots, number: usize, count: usize) -> HtmlDiv {
    let (app, words) = (plots.app, plots.app.words());
    let title = text_of(plots, number, PlotCell::Title).get_clone_untracked();
    let exchange = move |other: usize, part: &'static str| {
        let text = typing::text(app, 0);
        match typing::act(app, 0, &text, |outline| exchange_plots(outline, number, other)) {
            Ok(_) => browser::focus_later(id(other, part)),
            Err(refusal) => app.complain(refusal),
        }
    };
    let remove = move |_| {
        let text = typing::text(app, 0);
        match typing::act(app, 0, &text, |outline| remove_plot(outline, number).map(|edit| vec![edit])) {
            Ok(_) => browser::focus_later("new-plot".to_owned()),
            Err(refusal) => app.complain(refusal),
        }
    };
    let (is_first, is_last) = (number == 0, number + 1 == count);
    let up = button().class("icon small").id(id(number, "up")).called(format!("{}: {title}", words.move_up));
    let down = button().class("icon small").id(id(number, "down")).called(format!("{}: {title}", words.move_down));
    div()
        .class("order")
        .child(
            up.disabled(is_first)
                .child(icons::up())
                .when(events::click, move |_| exchange(number.saturating_sub(1), "up")),
        )
        .child(down.disabled(is_last).child(icons::down()).when(events::click, move |_| exchange(number + 1, "down")))
        .child(cross(format!("{} {title}", words.remove_statement)).when(events::click, remove))
}

/// Diagnostics of the plot, with remedies.
fn faults(plots: Plots, number: usize) -> HtmlDiv {
    let own = memo(move || {
        plots.faults.with(|all| {
            let own = all.iter().filter(|(of, _)| *of == number);
            own.map(|(_, found)| found.clone()).collect::<Vec<_>>()
        })
    });
    div().class("faults").child(briefs::view(plots.app, own, move |_| id(number, "kind")))
}

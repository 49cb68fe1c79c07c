//! The plots, and which of them are shown.

use super::pins::{self, Pinned};
use super::{gestures, legend, plot, plot_tools, runs};
use crate::app::App;
use crate::views::*;
use session::PlotView;
use web_sys::Element;

/// All plots, and which of them are shown.
pub fn view(app: App) -> View {
    let words = app.words();
    let mut plots = app.read(|session| session.plots());
    plots.retain(|plot| !plot.of_cycles);
    let shown = move |index: usize| is_in_sight(app, index);
    let offered = move |index: usize| now(app, index).is_some_and(|plot| plot.offered);
    let count = plots.len();
    let switch = |plot: &PlotView| {
        let index = plot.index;
        let turn = move |_| {
            let shown = now(app, index).is_some_and(|plot| plot.shown);
            // Where there is room for one plot alone, the buttons choose which.
            let narrow = app.narrow.get_untracked();
            if narrow {
                app.front_plot.set(Some(index));
            }
            app.act(|session| session.show_plot(index, narrow || !shown));
        };
        button()
            .class("chip")
            .attr("aria-pressed", move || shown(index).to_string())
            .hidden(move || !offered(index))
            .when(events::click, turn)
            .child(plot.title.clone())
    };
    let paper = |index: usize| figure(app, index, Box::new(move || shown(index)));
    section()
        .class("plots")
        .attr("aria-labelledby", "plots-title")
        .id("plots")
        .child(
            div()
                .class("plots-bar")
                .child(h2().id("plots-title").class("visually-hidden").child(words.plots))
                .child(div().class("chips").role("group").attr("aria-label", words.plots_shown).each(&plots, switch))
                .child(runs::keep_button(app)),
        )
        .child(runs::list(app))
        .child(div().class("figures").each(&plots, |plot| paper(plot.index)))
        .child(p().id("plot-keys").hidden(true).child(words.plot_keys))
        .child(p().class("empty").hidden(move || (0..count).any(shown)).child(words.no_plots))
        .into()
}

/// Whether a plot is shown. Where there is room for one alone it is the chosen one, or else the first.
fn is_in_sight(app: App, index: usize) -> bool {
    app.changes.plots.track();
    let shown = app.read(|session| session.plots());
    let mut shown = shown.iter().filter(|plot| plot.shown && plot.offered && !plot.of_cycles);
    if !app.narrow.get() {
        return shown.any(|plot| plot.index == index);
    }
    let front = app.front_plot.get().filter(|front| shown.clone().any(|plot| plot.index == *front));
    front.or_else(|| shown.next().map(|plot| plot.index)) == Some(index)
}

/// A plot as the session has it now.
pub fn now(app: App, index: usize) -> Option<PlotView> {
    app.changes.plots.track();
    app.read(|session| session.plots().into_iter().nth(index))
}

/// A plot with its tools.
pub fn figure(app: App, index: usize, shown: Box<dyn Fn() -> bool>) -> HtmlFigure {
    let words = app.words();
    let mut canvas = canvas().id(format!("canvas-{index}"));
    let mut tip = div().class("tip").attr("aria-hidden", "true").attr("popover", "manual");
    let pinned = create_signal(Pinned::default());
    plot::register(app, index, &canvas.node(), &tip.node(), pinned);
    let title = move || now(app, index).map(|plot| plot.title).unwrap_or_default();
    let name = move || format!("{}: {}", words.plot, title());
    let canvas = canvas
        .tabindex("0")
        .role("application")
        .attr("aria-roledescription", words.plot)
        .attr("aria-label", name)
        .attr("aria-describedby", "plot-keys")
        .when(events::pointerdown, move |event| gestures::down(app, index, &event))
        .when(events::pointermove, move |event| gestures::moved(app, index, &event))
        .when(events::pointerup, move |event| gestures::up(app, index, &event))
        .when(events::pointercancel, move |event| gestures::cancelled(app, index, &event))
        .when(events::pointerleave, move |_| gestures::left(app, index))
        .when(events::wheel, move |event| gestures::wheel(app, index, &event))
        .when(events::dblclick, move |_| app.act(|session| session.reset_plot(index)))
        .when(events::keydown, move |event| gestures::key(app, index, &event))
        .when(events::blur, move |_| gestures::blurred(app, index));
    let mut figure = tags::figure();
    let node: Element = figure.node();
    let caption = figcaption()
        .child(h3().id(format!("plot-{index}")).child(text(title)))
        .child(legend::view(app, index))
        .child(plot_tools::view(app, index, node));
    figure
        .class("plot")
        .hidden(move || !shown())
        .attr("aria-labelledby", format!("plot-{index}"))
        .child(caption)
        .child(div().class("paper").child(canvas).child(tip))
        .child(pins::view(app, index, pinned))
}

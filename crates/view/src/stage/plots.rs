//! The plots, with tiles to show and hide them.

use super::pinned::Pinned;
use super::pins;
use super::{gestures, legend, plot, plot_tools, runs, tiles};
use crate::app::App;
use crate::pieces::followed::followed;
use crate::pieces::toolbar::Toolbar;
use crate::views::*;
use play::{PagePart, PlotId, PlotView};
use web_sys::Element;

/// All plots, with buttons to show and hide them.
pub fn view(app: App) -> View {
    let words = app.words();
    let plots = tiles::plots(app);
    let further: Vec<PlotId> = tiles::further(app).iter().map(|plot| plot.id).collect();
    let shown = move |id: PlotId| is_in_sight(app, id);
    let offered = move |id: PlotId| app.plot(id).is_some_and(|plot| plot.offered);
    let count = plots.len();
    let hides = app.host().embedding().hides(PagePart::Plots);
    let bar = Toolbar::new();
    let mut tiled = div().class("chips tiles").role("group").attr("aria-label", words.plots_shown);
    let now = followed(app, &tiled.node(), |play| play.readouts());
    let switch = |plot: &PlotView| {
        let id = plot.id;
        let waits = further.contains(&id);
        // Once it has been shown, a press hides it, and the next one shows it again.
        let mut has_been_shown = false;
        let waits = memo(move || {
            has_been_shown |= shown(id);
            waits && !has_been_shown && !app.narrow.get()
        });
        button()
            .class("chip tile")
            .id(format!("show-plot-{id}"))
            .tabindex(move || bar.stop(id.place()))
            .when(events::focus, move |_| bar.enter(id.place()))
            .attr("aria-pressed", move || shown(id).to_string())
            .hidden(move || !offered(id) || waits.get())
            .when(events::click, move |_| tiles::turn(app, id))
            .child(span().class("title").child(plot.title.clone()))
            .child(tiles::line(app, now, plot))
    };
    let paper = |id: PlotId| figure(app, id, Box::new(move || shown(id)));
    section()
        .class("plots")
        .attr("aria-labelledby", "plots-title")
        .id("plots")
        .hidden(move || hides || !(0..count).map(PlotId::at).any(offered))
        .child(
            div()
                .class("plots-bar")
                .role("toolbar")
                .attr("aria-label", words.plots)
                .when(events::keydown, Toolbar::turn)
                .child(h2().id("plots-title").class("visually-hidden").child(words.plots))
                .child(tiled.each(&plots, switch))
                .child(
                    runs::keep_button(app)
                        .tabindex(move || bar.stop(count))
                        .when(events::focus, move |_| bar.enter(count)),
                ),
        )
        .child(runs::list(app))
        .child(div().class("figures").each(&plots, |plot| paper(plot.id)))
        .child(p().id("plot-keys").hidden(true).child(words.plot_keys))
        .child(p().class("empty").hidden(move || (0..count).map(PlotId::at).any(shown)).child(words.no_plots))
        .child(app.host().door())
        .into()
}

/// True if a plot is shown. In a narrow window only the selected plot, by default the first.
fn is_in_sight(app: App, id: PlotId) -> bool {
    app.changes.plots.track();
    let shown = app.read(|play| play.plots().list());
    let mut shown = shown.iter().filter(|plot| plot.shown && plot.offered && !plot.apart);
    if !app.narrow.get() {
        return shown.any(|plot| plot.id == id);
    }
    let front = app.front_plot.get().filter(|front| shown.clone().any(|plot| plot.id == *front));
    front.or_else(|| shown.next().map(|plot| plot.id)) == Some(id)
}

/// Progress of a sweep plot, which needs a run for each parameter value.
fn progress(app: App, id: PlotId) -> View {
    let runs = memo(move || {
        app.changes.values.track();
        app.changes.plots.track();
        app.read(|play| play.plots().progress(id))
    });
    changing(move || match runs.get() {
        Some((done, all)) => {
            let language = app.language.get_untracked();
            span().class("progress").child(play::words::runs_complete(language, done, all)).into()
        }
        None => View::new(),
    })
}

/// A plot with its tools.
pub fn figure(app: App, id: PlotId, shown: Box<dyn Fn() -> bool>) -> HtmlFigure {
    let words = app.words();
    let mut canvas = canvas().id(format!("canvas-{id}"));
    let mut tip = div().class("tip").attr("aria-hidden", "true").attr("popover", "manual");
    let pinned = create_signal(Pinned::default());
    plot::register(app, id, &canvas.node(), &tip.node(), pinned);
    let title = move || app.plot(id).map(|plot| plot.title).unwrap_or_default();
    let name = move || format!("{}: {}", words.plot, title());
    let canvas = canvas
        .tabindex("0")
        .role("application")
        .attr("aria-roledescription", words.plot)
        .attr("aria-label", name)
        .attr("aria-describedby", "plot-keys")
        .when(events::pointerdown, move |event| gestures::down(app, id, &event))
        .when(events::pointermove, move |event| gestures::moved(app, id, &event))
        .when(events::pointerup, move |event| gestures::up(app, id, &event))
        .when(events::pointercancel, move |event| gestures::cancelled(app, id, &event))
        .when(events::pointerleave, move |_| gestures::left(app, id))
        .when(events::wheel, move |event| gestures::wheel(app, id, &event))
        .when(events::dblclick, move |_| app.act(|play| play.change_plots(|plots, _| plots.reset(id))))
        .when(events::keydown, move |event| gestures::key(app, id, &event))
        .when(events::blur, move |_| gestures::blurred(app, id));
    let mut figure = tags::figure();
    let node: Element = figure.node();
    let caption = figcaption()
        .child(h3().id(format!("plot-{id}")).child(text(title)))
        .child(legend::view(app, id))
        .child(progress(app, id))
        .child(plot_tools::view(app, id, node));
    let equal = app.plot(id).is_some_and(|plot| plot.equal);
    figure
        .class(if equal { "plot equal" } else { "plot" })
        .hidden(move || !shown())
        .attr("aria-labelledby", format!("plot-{id}"))
        .child(caption)
        .child(div().class("paper").child(canvas).child(tip))
        .child(pins::view(app, id, pinned))
}

//! Tiles above the plot: each shows a value as it is now and, pressed, its curve.
//!
//! A plot with a single curve has its value on its tile; the list of values in the panel leaves these out. At most
//! [`IN_SIGHT`] plots of a document have a tile at first, those against the independent variable before others; the others are
//! offered under *More*, and have a tile from then on.

use crate::app::App;
use crate::pieces::steady::steady;
use crate::pieces::toolbar::Toolbar;
use crate::views::*;
use play::{PagePart, PlotId, PlotView, Readout};

/// Maximum number of plots of a document that have a tile before others have been shown.
const IN_SIGHT: usize = 3;

/// Plots beside the scene, in their order.
pub fn plots(app: App) -> Vec<PlotView> {
    let mut plots = app.read(|play| play.plots().list());
    plots.retain(|plot| !plot.apart);
    plots
}

/// Plots of the document without a tile at first.
pub fn further(app: App) -> Vec<PlotView> {
    let own = app.read(|play| play.program().plots.len());
    let all: Vec<PlotView> = plots(app).into_iter().filter(|plot| plot.id.place() < own).collect();
    let (first, others): (Vec<_>, Vec<_>) = all.into_iter().partition(|plot| plot.follows_run || plot.shown);
    let mut further: Vec<PlotView> = first.into_iter().chain(others).skip(IN_SIGHT).collect();
    further.retain(|plot| !plot.shown);
    further.sort_by_key(|plot| plot.id.place());
    further
}

/// Names of the values that stand on tiles.
pub fn values(app: App) -> Vec<String> {
    if app.host().embedding().hides(PagePart::Plots) {
        return Vec::new();
    }
    let further = further(app);
    let tiled = plots(app).into_iter().filter(|plot| !further.iter().any(|other| other.id == plot.id));
    let readouts = app.read(|play| play.readouts());
    let is_listed = |name: &String| readouts.iter().any(|readout| readout.name == *name && can_be_on_tile(readout));
    tiled.map(|plot| plot.quantity).filter(is_listed).collect()
}

/// True if a value needs no more than a tile shows: no choice of a member, and no question asks for it.
fn can_be_on_tile(readout: &Readout) -> bool {
    readout.members.is_none() && !readout.hidden
}

/// Shows or hides a plot. In a narrow window it becomes the only one.
pub fn turn(app: App, id: PlotId) {
    let shown = app.plot(id).is_some_and(|plot| plot.shown);
    let narrow = app.narrow.get_untracked();
    if narrow {
        app.front_plot.set(Some(id));
    }
    app.act(|play| play.change_plots(|plots, _| plots.show(id, narrow || !shown)));
}

/// The line below the title of a tile: the value now, or the symbols of the curves. Screen readers find values in the panel.
pub fn line(app: App, now: ReadSignal<Vec<Readout>>, plot: &PlotView) -> HtmlSpan {
    let place = app.read(|play| {
        play.readouts().iter().position(|readout| readout.name == plot.quantity && can_be_on_tile(readout))
    });
    let line = span().class("now").attr("aria-hidden", "true");
    let Some(place) = place else { return line.child(span().class("symbols").child(plot.symbols.clone())) };
    let get = move |part: fn(&Readout) -> &String| {
        now.with(|list| list.get(place).filter(|readout| !readout.hidden).map(part).cloned().unwrap_or_default())
    };
    line.child(span().class("value").child(steady(move || get(|readout| &readout.value))))
        .child(unit_of(text(move || get(|readout| &readout.unit))))
}

/// The plots without a tile, as chips under *More*; empty if there are none.
pub fn more(app: App) -> View {
    let further = further(app);
    if further.is_empty() || app.host().embedding().hides(PagePart::Plots) {
        return View::new();
    }
    let words = app.words();
    let bar = Toolbar::new();
    let chip = |(place, plot): (usize, PlotView)| {
        let id = plot.id;
        button()
            .class("chip")
            .tabindex(move || bar.stop(place))
            .when(events::focus, move |_| bar.enter(place))
            .attr("aria-pressed", move || {
                app.changes.plots.track();
                app.plot(id).is_some_and(|plot| plot.shown).to_string()
            })
            .when(events::click, move |_| turn(app, id))
            .child(plot.title)
    };
    part("further-plots", "controls card", words.plots)
        .child(h3().child(words.plots))
        .child(
            div()
                .class("chips")
                .role("toolbar")
                .attr("aria-label", words.plots)
                .when(events::keydown, Toolbar::turn)
                .each(further.into_iter().enumerate(), chip),
        )
        .into()
}

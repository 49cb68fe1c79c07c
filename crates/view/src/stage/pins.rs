//! Pinned read-outs: they stay when the pointer leaves, and two of them are compared.

use super::pinned::{LETTERS, Pinned};
use super::plot::with_plot;
use crate::app::App;
use crate::views::*;
use figure::{Point, Readout};
use play::PlotId;

/// Distance from a pin within which another press removes it, in CSS pixels.
const NEAR: f32 = 12.0;

/// Pins the read-out at a pixel, or removes the pin that is there. Where measured points are being left out of fits, takes
/// the nearest one instead.
pub fn press(app: App, id: PlotId, at: Point) {
    if app.host().leaves_points_out() {
        if let Some((column, place)) =
            app.read(|play| play.change_plots(|plots, run| plots.measured_point(run, id, at)))
        {
            app.host().leave_out(column, place);
            app.wake();
        }
        return;
    }
    let near = |pin: &Readout| {
        app.read(|play| {
            let figure = play.plots().figure(id)?;
            let sample = pin.samples.first()?;
            let place = figure.place(sample.axis, sample.x, sample.y)?;
            Some((place.x - at.x).abs() < NEAR)
        })
        .unwrap_or_default()
    };
    let pins = with_plot(app, id, |plot| plot.pins.clone()).unwrap_or_default();
    if let Some(place) = pins.iter().position(near) {
        with_plot(app, id, |plot| plot.pins.remove(place));
        return tell(app, id);
    }
    if let Some(readout) = app.read(|play| play.change_plots(|plots, run| plots.hover(run, id, at))) {
        pin(app, id, readout);
    }
}

/// [`press`] at the place of a read-out by keyboard.
pub fn press_at(app: App, id: PlotId, readout: Readout) {
    let place = |sample: &figure::Sample| {
        app.read(|play| Some(play.plots().figure(id)?.place(sample.axis, sample.x, sample.y))).flatten()
    };
    match readout.samples.last().and_then(place).filter(|_| app.host().leaves_points_out()) {
        Some(at) => press(app, id, at),
        None => pin(app, id, readout),
    }
}

/// Pins a read-out. If the maximum is reached, the oldest pin is removed.
pub fn pin(app: App, id: PlotId, readout: Readout) {
    let Some(readout) = app.read(|play| Some(play.plots().own_samples(id, readout))) else { return };
    if readout.samples.is_empty() {
        return;
    }
    with_plot(app, id, |plot| {
        if plot.pins.len() == LETTERS.len() {
            plot.pins.remove(0);
        }
        plot.pins.push(readout);
    });
    tell(app, id);
}

/// Removes all pins of a plot. Returns true if there were any.
pub fn clear(app: App, id: PlotId) -> bool {
    let any = with_plot(app, id, |plot| !std::mem::take(&mut plot.pins).is_empty()).unwrap_or_default();
    if any {
        tell(app, id);
    }
    any
}

/// All pins, with the place of their plot.
pub fn all(app: App) -> Vec<(usize, Readout)> {
    let mut all = Vec::new();
    app.nodes(|nodes| {
        for (place, plot) in nodes.plots.iter().enumerate() {
            all.extend(plot.iter().flat_map(|plot| plot.pins.iter().map(|pin| (place, pin.clone()))));
        }
    });
    all
}

/// Puts back a pin, without words.
pub fn put_back(app: App, id: PlotId, pin: Readout) {
    with_plot(app, id, |plot| plot.pins.push(pin));
    update(app, id);
}

/// Updates and speaks the texts of the pins.
fn tell(app: App, id: PlotId) {
    let Some(now) = update(app, id) else { return };
    let words = app.words();
    app.say(match (now.readings.last(), now.difference.as_str()) {
        (None, _) => words.unpinned.to_owned(),
        (Some(last), "") => format!("{}: {last}", words.pinned),
        (Some(last), difference) => format!("{}: {last}. {}: {difference}", words.pinned, words.difference),
    });
}

/// Updates the texts of the pins and returns them; `None` if the plot is not shown.
fn update(app: App, id: PlotId) -> Option<Pinned> {
    let (pins, pinned) = with_plot(app, id, |plot| (plot.pins.clone(), plot.pinned))?;
    let lines = |pin: &Readout| {
        let samples = pin.samples.iter().map(|sample| sample.text.clone());
        let lines: Vec<String> =
            std::iter::once(pin.heading.clone()).chain(samples).filter(|line| !line.is_empty()).collect();
        lines.join(", ")
    };
    let difference = match pins.as_slice() {
        [from, to] => app.read(|play| play.plots().difference(id, from, to)),
        _ => Vec::new(),
    };
    let now = Pinned { readings: pins.iter().map(lines).collect(), difference: difference.join(", ") };
    pinned.set(now.clone());
    app.wake();
    Some(now)
}

/// The line below a plot with its pinned read-outs.
pub fn view(app: App, id: PlotId, pinned: Signal<Pinned>) -> View {
    changing(move || {
        let now = pinned.get_clone();
        if now.readings.is_empty() {
            return View::new();
        }
        let words = app.words();
        let reading =
            |(letter, reading): (&'static str, String)| li().child(strong().child(letter)).child(" ").child(reading);
        let difference = (!now.difference.is_empty()).then(|| {
            li().class("difference").child(strong().child(words.difference_sign)).child(" ").child(now.difference)
        });
        let readings = LETTERS.into_iter().zip(now.readings);
        let clear = cross(words.unpin.to_owned()).when(events::click, move |_| {
            clear(app, id);
            crate::browser::focus(&format!("canvas-{id}"));
        });
        div().class("pins").child(ul().each(readings, reading).maybe(difference)).child(clear).into()
    })
}

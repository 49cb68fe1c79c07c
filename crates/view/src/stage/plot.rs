//! Canvas of a plot: redrawn when its content has changed, in the size of its box.

use super::brush::{Brush, Part};
use super::canvas;
use super::gesture::Gesture;
use super::level::{Beside, Lead};
use super::pinned::{LETTERS, Pinned};
use crate::app::App;
use crate::pieces::colours::Colours;
use crate::pieces::sight::Sight;
use crate::scene::SceneNodes;
use crate::views::*;
use figure::{Point, Readout, Settings};
use play::{Play, PlotId};
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement, HtmlElement, ResizeObserver};

/// Canvas of a plot, and overlays of the figure.
pub struct PlotNodes {
    canvas: HtmlCanvasElement,
    context: CanvasRenderingContext2d,
    tip: HtmlElement,
    tip_shown: bool,
    size: (f64, f64),
    scale: f64,
    decimal_comma: bool,
    /// True if it is in sight. A plot out of sight is drawn only once, for printing.
    pub visible: bool,
    /// True if anything outside the simulation has changed.
    stale: bool,
    drawn: Option<play::Revision>,
    /// Selected part of the time axis when it was drawn last.
    part: Option<Part>,
    /// Position of the read-out by pointer.
    pub pointer: Option<Point>,
    /// Read-out of the keyboard cursor.
    pub cursor: Option<Readout>,
    /// Pinned read-outs.
    pub pins: Vec<Readout>,
    /// Texts of the pins.
    pub pinned: Signal<Pinned>,
    /// State of the pointers on the canvas.
    pub gesture: Gesture,
    /// Place beside the scene; `None` until it has been measured.
    beside: Option<Option<Beside>>,
    lead: Option<Lead>,
    /// True once it has needed the height of the scene.
    tall: bool,
    sight: Option<Sight>,
    observer: Option<ResizeObserver>,
    /// Kept alive for the observer.
    _resized: Closure<dyn FnMut(js_sys::Array)>,
}

impl PlotNodes {
    /// Redraws in the next frame, even if the simulation is unchanged.
    pub fn invalidate(&mut self) {
        self.stale = true;
    }

    /// Measures its place beside the scene again, and redraws.
    pub fn measure_again(&mut self) {
        (self.beside, self.stale) = (None, true);
    }

    fn settings(&self, font_size: f64) -> Settings {
        let (width, height) = self.size;
        Settings { width, height, font_size, decimal_comma: self.decimal_comma, level: None }
    }

    /// Adapts to the size of its box.
    fn fit(&mut self) {
        let (width, height) = (f64::from(self.canvas.client_width()), f64::from(self.canvas.client_height()));
        let scale = window().device_pixel_ratio().clamp(1.0, 4.0);
        if (width, height, scale) != (self.size.0, self.size.1, self.scale) {
            (self.size, self.scale) = ((width, height), scale);
            self.canvas.set_width((width * scale).round() as u32);
            self.canvas.set_height((height * scale).round() as u32);
            // Resizing has cleared the canvas.
            self.drawn = None;
        }
        self.beside = None;
    }

    /// The line from the scene to the present point, while the plot is in sight and has the scale of the scene.
    pub fn lead(&self) -> Option<Lead> {
        self.lead.filter(|_| self.visible && self.size.0 >= 40.0)
    }

    /// Draws the figure if its content has changed. Returns true if another frame is needed to complete it.
    pub fn draw(
        &mut self,
        id: PlotId,
        play: &mut Play,
        part: Option<Part>,
        scene: Option<&SceneNodes>,
        colours: &Colours,
        font_size: f64,
    ) -> bool {
        let revision = play.revision();
        self.stale |= std::mem::replace(&mut self.part, part) != part;
        let seen = self.visible || self.drawn.is_none();
        if !seen || self.size.0 < 40.0 || !(self.stale || self.drawn != Some(revision)) {
            return false;
        }
        (self.stale, self.drawn) = (false, Some(revision));
        let level = scene.and_then(|scene| self.level(play.grips().level_of(id)?, scene));
        let settings = Settings { level: level.map(|(level, _)| level), ..self.settings(font_size) };
        let Some(figure) = play.layout_plot(id, &settings) else { return false };
        self.lead = level.and_then(|(_, beside)| Some(beside.lead(figure.level_point()?)));
        canvas::paint(&self.context, figure, colours, self.scale);
        self.stale = figure.is_unfinished();
        if figure.exceeds_level() && !std::mem::replace(&mut self.tall, true) {
            // The scale of the scene needs a plot as high as the scene.
            let plot = self.canvas.closest(".plot").ok().flatten();
            plot.into_iter().for_each(|plot| drop(plot.class_list().add_1("tall")));
        }
        if let Some(brush) = brush(play, id, self.part) {
            brush.paint(&self.context, colours);
        }
        let readout = match self.pointer {
            Some(at) => play.change_plots(|plots, run| plots.hover(run, id, at)),
            None => self.cursor.clone(),
        };
        if let Some((from, to)) = self.gesture.rectangle() {
            canvas::paint_box(&self.context, from, to, colours);
        }
        if let Some(figure) = play.plots().figure(id) {
            for (pin, letter) in self.pins.iter().zip(LETTERS) {
                canvas::paint_pin(&self.context, pin, letter, figure, colours);
            }
        }
        if let (Some(readout), Some(figure)) = (&readout, play.plots().figure(id)) {
            canvas::paint_readout(&self.context, readout, figure, colours);
        }
        self.show_tip(readout.as_ref());
        self.stale
    }

    /// Scale of the scene for the plot beside it.
    fn level(&mut self, level: play::SceneLevel, scene: &SceneNodes) -> Option<(figure::Level, Beside)> {
        let beside = *self.beside.get_or_insert_with(|| Beside::measure(scene, level.handle, &self.canvas));
        beside.map(|beside| (beside.level(level), beside))
    }

    /// Shows the read-out in a tooltip above everything else; inside the card it would be cropped.
    fn show_tip(&mut self, readout: Option<&Readout>) {
        let Some(readout) = readout.filter(|readout| !readout.samples.is_empty()) else {
            if std::mem::take(&mut self.tip_shown) {
                let _ = self.tip.hide_popover();
                // Without popovers, as in Safari 16, an empty tooltip is hidden.
                self.tip.set_text_content(None);
            }
            return;
        };
        let lines =
            std::iter::once(readout.heading.as_str()).chain(readout.samples.iter().map(|sample| sample.text.as_str()));
        self.tip.set_text_content(Some(&lines.filter(|line| !line.is_empty()).collect::<Vec<_>>().join("\n")));
        if !std::mem::replace(&mut self.tip_shown, true) {
            let _ = self.tip.show_popover();
        }
        let at = readout.samples.first().map(|sample| sample.at).unwrap_or_default();
        let canvas = self.canvas.get_bounding_client_rect();
        let (wide, high) = (f64::from(self.tip.offset_width()), f64::from(self.tip.offset_height()));
        let inner = |length: Result<JsValue, JsValue>| length.ok().and_then(|length| length.as_f64()).unwrap_or(0.0);
        // On the side of the point with more room, and within the window.
        let beside = if f64::from(at.x) > self.size.0 / 2.0 { -14.0 - wide } else { 14.0 };
        let left = (canvas.left() + f64::from(at.x) + beside)
            .clamp(4.0, (inner(window().inner_width()) - wide - 4.0).max(4.0));
        let top = (canvas.top() + 8.0).clamp(4.0, (inner(window().inner_height()) - high - 4.0).max(4.0));
        let style = self.tip.style();
        let _ = style.set_property("left", &format!("{left:.0}px"));
        let _ = style.set_property("top", &format!("{top:.0}px"));
    }
}

impl Drop for PlotNodes {
    fn drop(&mut self) {
        if let Some(observer) = &self.observer {
            observer.disconnect();
        }
    }
}

/// Brush of a plot; `None` unless a part is selected and the abscissa is the independent variable.
pub fn brush(play: &Play, id: PlotId, part: Option<Part>) -> Option<Brush<'_>> {
    Some(Brush { part: part?, figure: play.plots().figure(id)?, unit: play.plots().unit_of_time_axis(id)? })
}

/// Reports to the page the time at a pixel of a plot against time.
pub fn look_at(app: App, id: PlotId, at: Point) {
    app.host().look_at(&mut || {
        app.read(|play| {
            let x = play.change_plots(|plots, run| plots.hover(run, id, at))?.samples.first()?.x;
            Some(play.plots().unit_of_time_axis(id)?.to_si(x))
        })
    });
}

/// Registers a canvas that has been added to the page.
pub fn register(app: App, id: PlotId, canvas: &HtmlCanvasElement, tip: &HtmlElement, pinned: Signal<Pinned>) {
    let Some(context) = canvas.get_context("2d").ok().flatten().and_then(|context| context.dyn_into().ok()) else {
        return;
    };
    let resized = Closure::<dyn FnMut(js_sys::Array)>::new(move |_| {
        with_plot(app, id, PlotNodes::fit);
        app.wake();
    });
    let observer = ResizeObserver::new(resized.as_ref().unchecked_ref()).ok();
    let nodes = PlotNodes {
        canvas: canvas.clone(),
        context,
        tip: tip.clone(),
        tip_shown: false,
        size: (0.0, 0.0),
        scale: 1.0,
        decimal_comma: app.language.get_untracked().style().decimal_comma,
        visible: true,
        stale: true,
        drawn: None,
        part: None,
        pointer: None,
        cursor: None,
        pins: Vec::new(),
        pinned,
        gesture: Gesture::default(),
        beside: None,
        lead: None,
        tall: false,
        sight: None,
        observer: observer.clone(),
        _resized: resized,
    };
    // The observer reports the size after layout; reading it now would force an extra layout.
    app.nodes(|all| {
        let plots = &mut all.plots;
        let place = id.place();
        if plots.len() <= place {
            plots.resize_with(place + 1, || None);
        }
        plots[place] = Some(nodes);
    });
    if let Some(observer) = observer {
        observer.observe(canvas);
        // The scene may get another size while the plot keeps its own.
        if let Some(scene) = app.nodes(|nodes| nodes.scene.as_ref().map(SceneNodes::root)).flatten() {
            observer.observe(&scene);
        }
    }
    let sight = Sight::of(canvas, move |visible| {
        with_plot(app, id, |plot| plot.visible = visible);
        app.wake();
    });
    with_plot(app, id, |plot| plot.sight = Some(sight));
    app.wake();
}

/// Calls `work` with the nodes of a plot, which is redrawn afterwards.
pub fn with_plot<T>(app: App, id: PlotId, work: impl FnOnce(&mut PlotNodes) -> T) -> Option<T> {
    app.nodes(|nodes| {
        let plot = nodes.plots.get_mut(id.place())?.as_mut()?;
        plot.stale = true;
        Some(work(plot))
    })
    .flatten()
}

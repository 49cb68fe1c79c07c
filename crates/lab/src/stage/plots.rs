//! The plots: a figure for each, with its canvas, its read-out and its tools.

use crate::app::App;
use crate::canvas;
use crate::gestures::{self, Gesture};
use crate::icons;
use crate::theme::Colours;
use crate::views::*;
use crate::{browser, frame, runs};
use figure::{Point, Readout, Settings};
use session::{PlotView, Session};
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement, HtmlElement, IntersectionObserver, ResizeObserver};

/// The size of a downloaded figure, in CSS pixels.
const SAVED: Settings = Settings { width: 960.0, height: 540.0, font_size: 16.0, decimal_comma: false };
/// How many pixels of a downloaded PNG make one of those.
const SAVED_SCALE: f64 = 2.0;

/// A plot's canvas and what is drawn over the figure.
pub struct PlotNodes {
    canvas: HtmlCanvasElement,
    context: CanvasRenderingContext2d,
    tip: HtmlElement,
    size: (f64, f64),
    scale: f64,
    decimal_comma: bool,
    /// Whether it is in sight; what is not is drawn once, for those who print the page.
    pub visible: bool,
    /// Whether something other than the session has changed.
    stale: bool,
    drawn: Option<session::Revision>,
    /// Where the pointer reads.
    pub pointer: Option<Point>,
    /// What the keyboard's cursor reads.
    pub cursor: Option<Readout>,
    /// What the pointers on the canvas are about.
    pub gesture: Gesture,
    observers: Option<(ResizeObserver, IntersectionObserver)>,
    /// Kept as long as the observers call them.
    _callbacks: [Closure<dyn FnMut(js_sys::Array)>; 2],
}

impl PlotNodes {
    /// Draws again in the next frame, whether or not the session has changed.
    pub fn invalidate(&mut self) {
        self.stale = true;
    }

    fn settings(&self) -> Settings {
        let (width, height) = self.size;
        Settings { width, height, font_size: 13.0, decimal_comma: self.decimal_comma }
    }

    /// Takes the size of its box.
    fn fit(&mut self) {
        let (width, height) = (f64::from(self.canvas.client_width()), f64::from(self.canvas.client_height()));
        let scale = window().device_pixel_ratio().clamp(1.0, 4.0);
        if (width, height, scale) != (self.size.0, self.size.1, self.scale) {
            (self.size, self.scale) = ((width, height), scale);
            self.canvas.set_width((width * scale).round() as u32);
            self.canvas.set_height((height * scale).round() as u32);
            // That has emptied it.
            self.drawn = None;
        }
    }

    /// Draws the figure if anything in it has changed. Whether a further frame is to go on with it.
    pub fn draw(&mut self, index: usize, session: &mut Session, colours: &Colours) -> bool {
        let revision = session.revision();
        let seen = self.visible || self.drawn.is_none();
        if !seen || self.size.0 < 40.0 || !(self.stale || self.drawn != Some(revision)) {
            return false;
        }
        (self.stale, self.drawn) = (false, Some(revision));
        let settings = self.settings();
        let Some(figure) = session.layout_plot(index, &settings) else { return false };
        canvas::paint(&self.context, figure, colours, self.scale);
        self.stale = figure.is_unfinished();
        let readout = match self.pointer {
            Some(at) => session.hover_plot(index, at),
            None => self.cursor.clone(),
        };
        if let Some((from, to)) = self.gesture.rectangle() {
            canvas::paint_box(&self.context, from, to, colours);
        }
        if let (Some(readout), Some(figure)) = (&readout, session.plot_figure(index)) {
            canvas::paint_readout(&self.context, readout, figure, colours);
        }
        self.show_tip(readout.as_ref());
        self.stale
    }

    fn show_tip(&self, readout: Option<&Readout>) {
        let Some(readout) = readout.filter(|readout| !readout.samples.is_empty()) else {
            return self.tip.set_hidden(true);
        };
        let lines =
            std::iter::once(readout.heading.as_str()).chain(readout.samples.iter().map(|sample| sample.text.as_str()));
        self.tip.set_text_content(Some(&lines.filter(|line| !line.is_empty()).collect::<Vec<_>>().join("\n")));
        let at = readout.samples.first().map(|sample| sample.at).unwrap_or_default();
        let style = self.tip.style();
        // On the side of the point where there is more room.
        let right = f64::from(at.x) > self.size.0 / 2.0;
        let offset = if right { self.size.0 - f64::from(at.x) } else { f64::from(at.x) } + 14.0;
        let (used, free) = if right { ("right", "left") } else { ("left", "right") };
        let _ = style.set_property(used, &format!("{offset:.0}px"));
        let _ = style.set_property(free, "auto");
        self.tip.set_hidden(false);
    }
}

impl Drop for PlotNodes {
    fn drop(&mut self) {
        if let Some((resize, intersection)) = &self.observers {
            resize.disconnect();
            intersection.disconnect();
        }
    }
}

/// Takes a canvas that has come into the page.
fn register(app: App, index: usize, canvas: &HtmlCanvasElement, tip: &HtmlElement) {
    let Some(context) = canvas.get_context("2d").ok().flatten().and_then(|context| context.dyn_into().ok()) else {
        return;
    };
    let resized = Closure::<dyn FnMut(js_sys::Array)>::new(move |_| {
        with_plot(app, index, PlotNodes::fit);
        frame::wake(app);
    });
    let seen = Closure::<dyn FnMut(js_sys::Array)>::new(move |entries: js_sys::Array| {
        let entry: Option<web_sys::IntersectionObserverEntry> = entries.pop().dyn_into().ok();
        if let Some(entry) = entry {
            with_plot(app, index, |plot| plot.visible = entry.is_intersecting());
            frame::wake(app);
        }
    });
    let observers = ResizeObserver::new(resized.as_ref().unchecked_ref())
        .and_then(|resize| Ok((resize, IntersectionObserver::new(seen.as_ref().unchecked_ref())?)));
    let nodes = PlotNodes {
        canvas: canvas.clone(),
        context,
        tip: tip.clone(),
        size: (0.0, 0.0),
        scale: 1.0,
        decimal_comma: app.language.get_untracked().style().decimal_comma,
        visible: true,
        stale: true,
        drawn: None,
        pointer: None,
        cursor: None,
        gesture: Gesture::default(),
        observers: None,
        _callbacks: [resized, seen],
    };
    // The observer tells the size when the page has been laid out; asking now would lay it out twice.
    app.with(|lab| {
        let plots = &mut lab.stage.plots;
        if plots.len() <= index {
            plots.resize_with(index + 1, || None);
        }
        plots[index] = Some(nodes);
    });
    if let Ok((resize, intersection)) = observers {
        resize.observe(canvas);
        intersection.observe(canvas);
        with_plot(app, index, |plot| plot.observers = Some((resize, intersection)));
    }
    frame::wake(app);
}

/// Works on a plot's nodes; it is drawn anew afterwards.
pub fn with_plot<T>(app: App, index: usize, work: impl FnOnce(&mut PlotNodes) -> T) -> Option<T> {
    app.with(|lab| {
        let plot = lab.stage.plots.get_mut(index)?.as_mut()?;
        plot.stale = true;
        Some(work(plot))
    })
    .flatten()
}

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
    let mut tip = div().class("tip").attr("aria-hidden", "true").hidden(true);
    register(app, index, &canvas.node(), &tip.node());
    let automatic = move || now(app, index).is_none_or(|plot| plot.automatic);
    let title = move || now(app, index).map(|plot| plot.title).unwrap_or_default();
    let name = move || format!("{}: {}", words.plot, title());
    let zoom = move |factor: f64| app.act(|session| session.zoom_plot(index, None, factor, figure::Direction::Both));
    let tool = |class: &'static str, name: &'static str| button().class(class).called(name);
    let tools = div()
        .class("tools")
        .child(tool("icon", words.zoom_out).when(events::click, move |_| zoom(0.5)).child(icons::minus()))
        .child(tool("icon", words.zoom_in).when(events::click, move |_| zoom(2.0)).child(icons::plus()))
        .child(
            tool("icon", words.fit)
                .attr("aria-disabled", move || automatic().to_string())
                .when(events::click, move |_| app.act(|session| session.reset_plot(index)))
                .child(icons::fit()),
        )
        .child(tool("text", words.save_svg).when(events::click, move |_| save_svg(app, index)).child("SVG"))
        .child(tool("text", words.save_png).when(events::click, move |_| save_png(app, index)).child("PNG"));
    let canvas = canvas
        .tabindex("0")
        .role("application")
        .attr("aria-roledescription", words.plot)
        .attr("aria-label", name)
        .attr("aria-describedby", "plot-keys")
        .when(events::pointerdown, move |event| gestures::down(app, index, &event))
        .when(events::pointermove, move |event| gestures::moved(app, index, &event))
        .when(events::pointerup, move |event| gestures::up(app, index, &event))
        .when(events::pointercancel, move |event| gestures::up(app, index, &event))
        .when(events::pointerleave, move |_| gestures::left(app, index))
        .when(events::wheel, move |event| gestures::wheel(app, index, &event))
        .when(events::dblclick, move |_| app.act(|session| session.reset_plot(index)))
        .when(events::keydown, move |event| gestures::key(app, index, &event))
        .when(events::blur, move |_| gestures::blurred(app, index));
    tags::figure()
        .class("plot")
        .hidden(move || !shown())
        .attr("aria-labelledby", format!("plot-{index}"))
        .child(figcaption().child(h3().id(format!("plot-{index}")).child(text(title))).child(tools))
        .child(div().class("paper").child(canvas).child(tip))
}

fn saved(app: App) -> Settings {
    Settings { decimal_comma: app.language.get_untracked().style().decimal_comma, ..SAVED }
}

/// `Phase portrait` as `phase-portrait`.
fn file_name(app: App, index: usize, ending: &str) -> String {
    let title = now(app, index).map(|plot| plot.title).unwrap_or_default();
    let words: Vec<String> =
        title.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).map(str::to_lowercase).collect();
    format!("{}.{ending}", words.join("-"))
}

fn save_svg(app: App, index: usize) {
    let settings = saved(app);
    // On paper, whatever the theme of the screen is.
    let svg = app.read(|session| session.plot_svg(index, &settings, &figure::Palette::LIGHT));
    browser::save_text(&file_name(app, index, "svg"), "image/svg+xml", &svg);
}

fn save_png(app: App, index: usize) {
    let settings = saved(app);
    let Some(canvas) =
        document().create_element("canvas").ok().and_then(|node| node.dyn_into::<HtmlCanvasElement>().ok())
    else {
        return;
    };
    canvas.set_width((settings.width * SAVED_SCALE) as u32);
    canvas.set_height((settings.height * SAVED_SCALE) as u32);
    let context: Option<CanvasRenderingContext2d> =
        canvas.get_context("2d").ok().flatten().and_then(|context| context.dyn_into().ok());
    let Some(context) = context else { return };
    if let Some(figure) = app.read(|session| session.titled_figure(index, &settings)) {
        canvas::paint(&context, &figure, &Colours::default(), SAVED_SCALE);
    }
    let url = canvas.to_data_url_with_type("image/png").unwrap_or_default();
    browser::save_url(&file_name(app, index, "png"), &url);
}

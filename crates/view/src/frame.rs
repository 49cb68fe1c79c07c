//! The frame: lets the simulation's time pass and redraws what has changed. Frames are asked for only while something
//! moves; a page that stands still costs nothing. The browser asks for none while the page is hidden, and the simulation
//! says what a long pause means; losing the focus does not stop the run.

use crate::app::App;
use crate::colours::Colours;
use crate::scene::SceneNodes;
use crate::sound::Sound;
use crate::stage::brush::Part;
use crate::stage::plot::PlotNodes;
use crate::transport::TransportNodes;
use crate::views::window;
use play::{Play, PlotId};
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;

/// Changing values, clock and time line are shown so many times a second: digits that change faster cannot be read, and each of
/// them costs the browser a layout.
const VALUES_PER_SECOND: f64 = 10.0;

/// Everything that is redrawn in a frame, and the clock of the frames.
#[derive(Default)]
pub struct Nodes {
    /// The scene's nodes.
    pub scene: Option<SceneNodes>,
    /// Each plot's canvas, in the order of the document.
    pub plots: Vec<Option<PlotNodes>>,
    /// Clock and time line.
    pub transport: Option<TransportNodes>,
    /// The size of the figures' texts in CSS pixels.
    pub font_size: f64,
    /// The colours of the theme in use.
    pub colours: Colours,
    /// What is heard.
    pub sound: Sound,
    callback: Option<Closure<dyn FnMut(f64)>>,
    asked: bool,
    /// When the run moved last, in milliseconds; none while it stands still.
    moved: Option<f64>,
    /// When changing values were shown last, in milliseconds.
    shown: f64,
}

impl Nodes {
    /// Asks the browser for a frame, once.
    pub fn ask(&mut self) {
        if !self.asked
            && let Some(callback) = &self.callback
        {
            self.asked = window().request_animation_frame(callback.as_ref().unchecked_ref()).is_ok();
        }
    }

    /// Forgets the nodes, which are about to be replaced.
    pub fn clear(&mut self) {
        self.scene = None;
        self.plots.clear();
        self.transport = None;
    }
}

/// Makes the callback of the frames.
pub fn start(app: App) {
    let callback = Closure::new(move |now| draw(app, now));
    app.nodes(|nodes| nodes.callback = Some(callback));
    app.wake();
}

fn draw(app: App, now: f64) {
    let more = app.host().follow();
    let advanced = app.nodes(|nodes| {
        nodes.asked = false;
        let part = app.host().part();
        app.read(|play| advance(nodes, play, part, now))
    });
    let Some((goes_on, values)) = advanced else { return };
    app.publish(values, false);
    if goes_on || more {
        app.wake();
    }
}

/// One frame. Whether the run or a long figure goes on, and whether it is time to show changing values.
fn advance(nodes: &mut Nodes, play: &mut Play, part: Option<Part>, now: f64) -> (bool, bool) {
    let seconds = nodes.moved.map_or(0.0, |moved| (now - moved) / 1000.0);
    if play.is_playing() && seconds > 0.0 {
        play.tick(seconds);
    }
    let working = play.work_on_plots();
    let playing = play.is_playing();
    nodes.moved = playing.then_some(now);
    let values = !(playing || working) || now - nodes.shown >= 1000.0 / VALUES_PER_SECOND;
    if values {
        nodes.shown = now;
    }
    // Canvases first: where a part of the page has changed, a canvas that sets its font makes the browser work out all styles.
    let mut unfinished = play.advance_checks();
    for (place, plot) in nodes.plots.iter_mut().enumerate() {
        if let Some(plot) = plot {
            unfinished |= plot.draw(PlotId::at(place), play, part, &nodes.colours, nodes.font_size);
        }
    }
    if let Some(transport) = &mut nodes.transport
        && values
    {
        transport.draw(play);
    }
    if let Some(scene) = &mut nodes.scene {
        scene.draw(play, values);
    }
    nodes.sound.follow(play);
    (playing || unfinished || working, values)
}

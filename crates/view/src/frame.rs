//! The animation frame: advances the simulation and redraws what has changed. Frames are requested only while something
//! moves; a paused page costs nothing. While the page is hidden the browser provides no frames; [`play::LONGEST_GAP`]
//! defines the treatment of long gaps. Losing the focus does not stop the run.

use crate::app::App;
use crate::pieces::colours::Colours;
use crate::scene::SceneNodes;
use crate::stage::brush::Part;
use crate::stage::level::LevelNodes;
use crate::stage::plot::PlotNodes;
use crate::stage::sound::Sound;
use crate::stage::transport::TransportNodes;
use crate::views::window;
use play::{Play, PlotId};
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;

/// Update rate of changing values, clock and time line. Faster digits cannot be read, and each update costs the browser
/// a layout.
const VALUES_PER_SECOND: f64 = 10.0;

/// Nodes that are redrawn in each frame, and the time of the frames.
#[derive(Default)]
pub struct Nodes {
    /// Nodes of the scene.
    pub scene: Option<SceneNodes>,
    /// Canvas of each plot, by the place of its [`PlotId`].
    pub plots: Vec<Option<PlotNodes>>,
    /// Line from the scene to the curve, and the ring on what can be dragged.
    pub level: Option<LevelNodes>,
    /// True until something has been dragged once.
    pub invites: bool,
    /// Clock and time line.
    pub transport: Option<TransportNodes>,
    /// Font size of the figures, in CSS pixels.
    pub font_size: f64,
    /// Colours of the present theme.
    pub colours: Colours,
    /// Sound output.
    pub sound: Sound,
    callback: Option<Closure<dyn FnMut(f64)>>,
    /// Frame that is requested from the browser.
    asked: Option<i32>,
    /// Time of the frame in which the run moved last, in milliseconds; `None` while it is paused.
    moved: Option<f64>,
    /// Time at which changing values were updated last, in milliseconds.
    shown: f64,
}

impl Nodes {
    /// Requests a frame from the browser, once.
    pub fn ask(&mut self) {
        if self.asked.is_none()
            && let Some(callback) = &self.callback
        {
            self.asked = window().request_animation_frame(callback.as_ref().unchecked_ref()).ok();
        }
    }

    /// Ends the frames and discards the nodes.
    pub fn end(&mut self) {
        if let Some(frame) = self.asked.take() {
            let _ = window().cancel_animation_frame(frame);
        }
        self.callback = None;
        self.sound.turn(false);
        self.clear();
    }

    /// Time of the frame in which the run moved last, in milliseconds; `None` while it is paused.
    pub fn moved(&self) -> Option<f64> {
        self.moved
    }

    /// Continues from a frame of another page, whose run moved last at this time, in milliseconds.
    pub fn go_on_from(&mut self, moved: Option<f64>) {
        self.moved = moved;
    }

    /// Discards the nodes before they are replaced.
    pub fn clear(&mut self) {
        self.scene = None;
        self.plots.clear();
        self.level = None;
        self.transport = None;
    }
}

/// Creates the callback of the frames.
pub fn start(app: App) {
    let callback = Closure::new(move |now| draw(app, now));
    app.nodes(|nodes| nodes.callback = Some(callback));
    app.wake();
}

fn draw(app: App, now: f64) {
    let more = app.host().follow();
    let advanced = app.nodes(|nodes| {
        nodes.asked = None;
        let part = app.host().part();
        app.read(|play| tick(nodes, play, now));
        let working = app.host().work_on_plots();
        app.read(|play| advance(nodes, play, part, now, working))
    });
    let Some((goes_on, values)) = advanced else { return };
    app.publish(values, false);
    if goes_on || more {
        app.wake();
    }
}

/// Advances the run to the time of the frame.
fn tick(nodes: &Nodes, play: &mut Play, now: f64) {
    let seconds = nodes.moved.map_or(0.0, |moved| (now - moved) / 1000.0);
    if play.time_line().is_playing() && seconds > 0.0 {
        play.change_run(|line, _| line.tick(seconds));
    }
}

/// Draws one frame. `working`: true if runs of plots are missing. Returns (true if the run or other work continues, true if
/// changing values are to be updated).
fn advance(nodes: &mut Nodes, play: &mut Play, part: Option<Part>, now: f64, working: bool) -> (bool, bool) {
    let playing = play.time_line().is_playing();
    nodes.moved = playing.then_some(now);
    let values = !(playing || working) || now - nodes.shown >= 1000.0 / VALUES_PER_SECOND;
    if values {
        nodes.shown = now;
    }
    // Canvases first: after a change of the page, setting the font of a canvas makes the browser recompute all styles.
    let mut unfinished = play.change_claims(|claims, basis| claims.advance(basis));
    for (place, plot) in nodes.plots.iter_mut().enumerate() {
        if let Some(plot) = plot {
            unfinished |=
                plot.draw(PlotId::at(place), play, part, nodes.scene.as_ref(), &nodes.colours, nodes.font_size);
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
    if let Some(level) = &mut nodes.level {
        let lead = nodes.plots.iter().flatten().find_map(PlotNodes::lead);
        level.draw(play, lead, nodes.scene.as_ref(), nodes.invites);
    }
    nodes.sound.follow(play);
    (playing || unfinished || working, values)
}

//! Signals of the film views.

use super::aim::{Aim, Handle, Kind, Pixel, Tool};
use super::sample::Moment;
use super::state::Now;
use desk::{SpaceTimePicture, TrackingProgress, TruthComparison};
use film::tracking::column::Click;
use std::rc::Rc;
use view::views::*;

/// Signals tracked by the film views. Most concern the open film.
#[derive(Clone, Copy)]
pub struct Films {
    /// True while a film is open.
    pub open: Signal<bool>,
    /// True while the film is on the stage instead of the scene.
    pub shown: Signal<bool>,
    /// True while the film has the whole stage: until it is a record and no click is awaited.
    pub whole: Signal<bool>,
    /// Selected frame.
    pub frame: Signal<usize>,
    /// Painted frame. It follows the selected one with a delay.
    pub painted: Signal<Option<usize>>,
    /// Name of the file that is being opened.
    pub opening: Signal<Option<String>>,
    /// Number of filmed frames and their total, while the simulation is filmed.
    pub filming: Signal<Option<[usize; 2]>>,
    /// True while the form of the virtual camera is open.
    pub camera_form: Signal<bool>,
    /// Comparison with the truth, once the user has requested it.
    pub truth: Signal<Vec<TruthComparison>>,
    /// True while the film plays.
    pub playing: Signal<bool>,
    /// State of the film on the desk.
    pub now: Signal<Option<Rc<Now>>>,
    /// Space-time picture of each surface.
    pub pictures: Signal<Vec<Rc<SpaceTimePicture>>>,
    /// Progress of the tracking.
    pub progress: Signal<Option<TrackingProgress>>,
    /// Kind of the subject.
    pub kind: Signal<Kind>,
    /// Index of the body to which the next click belongs.
    pub body: Signal<usize>,
    /// Effect of the next click.
    pub tool: Signal<Tool>,
    /// Points collected for a tool that needs several, px.
    pub points: Signal<Vec<Pixel>>,
    /// Point being placed or moved.
    pub aim: Signal<Option<Aim>>,
    /// Selected point, which can be removed.
    pub selected: Signal<Option<Handle>>,
    /// Last point placed by keys, px.
    pub last: Signal<Option<Pixel>>,
    /// Correction of a surface in progress: index of the surface, and position.
    pub anchor: Signal<Option<(usize, Click)>>,
    /// Clicked marks of the ruler, px.
    pub ruler: Signal<Vec<Pixel>>,
    /// Length between the marks, as typed.
    pub length: Signal<String>,
    /// Number of intervals between the marks, as typed.
    pub intervals: Signal<String>,
    /// Clicked corners of the rectangle, px.
    pub corners: Signal<Vec<Pixel>>,
    /// Width and height of the rectangle, as typed.
    pub sides: Signal<[String; 2]>,
    /// Refusal of the last change of the calibration.
    pub lengths_refused: Signal<Option<String>>,
    /// Reason for which the number of intervals of the ruler was refused.
    pub intervals_refused: Signal<Option<String>>,
    /// Present moment of *See it measured*, `None` while it is not shown.
    pub story: Signal<Option<Moment>>,
    /// Counter, increased when the window changes its size.
    pub resized: Signal<u64>,
}

impl Films {
    /// Signals without a film.
    pub fn new() -> Self {
        Self {
            open: create_signal(false),
            shown: create_signal(false),
            whole: create_signal(false),
            frame: create_signal(0),
            painted: create_signal(None),
            opening: create_signal(None),
            filming: create_signal(None),
            camera_form: create_signal(false),
            truth: create_signal(Vec::new()),
            playing: create_signal(false),
            now: create_signal(None),
            pictures: create_signal(Vec::new()),
            progress: create_signal(None),
            kind: create_signal(Kind::default()),
            body: create_signal(0),
            tool: create_signal(Tool::default()),
            points: create_signal(Vec::new()),
            aim: create_signal(None),
            selected: create_signal(None),
            last: create_signal(None),
            anchor: create_signal(None),
            ruler: create_signal(Vec::new()),
            length: create_signal(String::new()),
            intervals: create_signal("1".to_owned()),
            corners: create_signal(Vec::new()),
            sides: create_signal(Default::default()),
            lengths_refused: create_signal(None),
            intervals_refused: create_signal(None),
            story: create_signal(None),
            resized: create_signal(0),
        }
    }
}

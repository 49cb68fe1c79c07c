//! What the views of the film track.

use super::aim::{Aim, Handle, Kind, Pixel, Tool};
use super::state::Now;
use desk::{SpaceTimePicture, TrackingProgress, TruthComparison};
use film::tracking::column::Click;
use std::rc::Rc;
use view::views::*;

/// What views of the film track; most of it concerns the film that is open.
#[derive(Clone, Copy)]
pub struct Films {
    /// Whether a film is open.
    pub open: Signal<bool>,
    /// Whether it stands on the stage, in the place of the scene.
    pub shown: Signal<bool>,
    /// The frame that is looked at.
    pub frame: Signal<usize>,
    /// The frame that is painted: the other one, a moment later.
    pub painted: Signal<Option<usize>>,
    /// The file that is being opened.
    pub opening: Signal<Option<String>>,
    /// How many frames of the simulation have been filmed, and of how many, while it is filmed.
    pub filming: Signal<Option<[usize; 2]>>,
    /// Whether the form for filming the simulation is open.
    pub camera_form: Signal<bool>,
    /// How far the tracks are from the truth, once a person has asked.
    pub truth: Signal<Vec<TruthComparison>>,
    /// Whether it is playing.
    pub playing: Signal<bool>,
    /// What the desk says of the film.
    pub now: Signal<Option<Rc<Now>>>,
    /// The space-time picture of each surface.
    pub pictures: Signal<Vec<Rc<SpaceTimePicture>>>,
    /// How far the tracking is.
    pub progress: Signal<Option<TrackingProgress>>,
    /// What is to be followed.
    pub kind: Signal<Kind>,
    /// Which body the next click belongs to.
    pub body: Signal<usize>,
    /// What the next click sets.
    pub tool: Signal<Tool>,
    /// Points of a tool that needs several.
    pub points: Signal<Vec<Pixel>>,
    /// The point that is being placed or moved.
    pub aim: Signal<Option<Aim>>,
    /// The point that can be removed.
    pub selected: Signal<Option<Handle>>,
    /// Where a point was placed last by keys.
    pub last: Signal<Option<Pixel>>,
    /// The correction of a surface that is being made.
    pub anchor: Signal<Option<(usize, Click)>>,
    /// The clicked marks of the ruler.
    pub ruler: Signal<Vec<Pixel>>,
    /// The length between them, as typed.
    pub length: Signal<String>,
    /// Into how many parts marks divide it, as typed.
    pub intervals: Signal<String>,
    /// The clicked corners of a rectangle.
    pub corners: Signal<Vec<Pixel>>,
    /// Its sides, as typed.
    pub sides: Signal<[String; 2]>,
    /// Why the last change of lengths was refused.
    pub lengths_refused: Signal<Option<String>>,
    /// Raised when the window has another size.
    pub resized: Signal<u64>,
}

impl Films {
    /// Without a film.
    pub fn new() -> Self {
        Self {
            open: create_signal(false),
            shown: create_signal(false),
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
            resized: create_signal(0),
        }
    }
}

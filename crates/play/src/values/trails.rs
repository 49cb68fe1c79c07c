//! Trails of the scene: past positions of points, read from the rows of the run. Nothing is stored between frames, so a
//! trail is correct after any scrub, and its memory is bounded.

use crate::time::course::Course;
use engine::Readings;
use program::{Model, NodeId, Scene};
use std::fmt::Write;

/// A line has at most twice this number of points; `DOTS` is the maximum number of dots.
const POINTS: usize = 500;
const DOTS: u32 = 500;

/// Evaluates the positions of the trails of a scene: two values per trail.
#[derive(Debug)]
pub(crate) struct Trails {
    places: Readings,
    state: Vec<f64>,
}

impl Trails {
    /// Trails of a scene.
    pub fn new(model: &Model, scene: Option<&Scene>) -> Self {
        let node = |scene: &Scene, index: usize| scene.values.get(index).map(|value| value.node);
        let nodes: Vec<NodeId> = scene.map_or_else(Vec::new, |scene| {
            scene.trails.iter().flat_map(|trail| [node(scene, trail.x), node(scene, trail.y)]).flatten().collect()
        });
        Self { places: Readings::new(model, &nodes), state: vec![0.0; model.states.len()] }
    }
}

/// Position of a trail, from the values of all trails.
fn place(values: &[f64], number: usize) -> (f64, f64) {
    let value = |index: usize| values.get(index).copied().unwrap_or(f64::NAN);
    (value(2 * number), value(2 * number + 1))
}

/// Appends a point to a path; a position that is not finite leaves a gap.
fn write(path: &mut String, command: &mut char, (x, y): (f64, f64)) {
    if x.is_finite() && y.is_finite() {
        // Writing to a string cannot fail. A hundredth of a scene unit is invisible.
        let _ = write!(path, "{command}{x:.2} {y:.2}");
        *command = 'L';
    } else {
        *command = 'M';
    }
}

impl Trails {
    /// Writes the positions at the rows from a time (SI) on, evenly thinned, and at the time shown. The choice of rows
    /// is stable from frame to frame; otherwise the line would flicker.
    pub fn write_line(&mut self, course: &Course, number: usize, from: f64, path: &mut String) {
        let places = &mut self.places;
        let rows = course.rows_until_shown();
        let mut command = 'M';
        if let Some(history) = course.history() {
            let first = history.times().partition_point(|time| *time < from);
            let mut stride = 1;
            while rows.saturating_sub(first) / stride > 2 * POINTS {
                stride *= 2;
            }
            let mut before: Option<(f64, (f64, f64))> = None;
            for row in (first.next_multiple_of(stride)..rows).step_by(stride) {
                let (time, here) = (history.time(row), place(places.at_row(history, row), number));
                // An event that moves the point leaves a gap.
                if before.is_some_and(|(earlier, there)| earlier == time && there != here) {
                    command = 'M';
                }
                write(path, &mut command, here);
                before = Some((time, here));
            }
        }
        let here = places.at(course.parameters(), course.initial(), course.time(), course.state());
        write(path, &mut command, place(here, number));
    }

    /// Writes a dot at each multiple of `every` (SI), only the last ones if there are too many.
    pub fn write_dots(&mut self, course: &mut Course, number: usize, (from, every): (f64, f64), path: &mut String) {
        let time = course.time();
        let (least, most) = ((from / every).ceil(), (time / every + 1e-9).floor());
        if !(every > 0.0 && most.is_finite()) {
            return;
        }
        let first = least.max(most - f64::from(DOTS - 1)).max(0.0);
        // Counts separately, because adding 1 to a very large number does not change it.
        for multiple in (0..DOTS).map(|number| first + f64::from(number)).take_while(|multiple| *multiple <= most) {
            let at = (multiple * every).min(time);
            let Some(parameters) = course.state_at(at, &mut self.state) else { return };
            let values = self.places.at(&parameters, course.initial(), at, &self.state);
            let (x, y) = place(values, number);
            if x.is_finite() && y.is_finite() {
                let _ = write!(path, "M{x:.2} {y:.2}h0");
            }
        }
    }
}

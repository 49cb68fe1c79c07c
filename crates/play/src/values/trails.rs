//! The trails of the scene: where points of it have been, read off the rows of the run. Nothing is kept from frame to frame,
//! so a trail is right after any scrub, and its memory is bounded.

use crate::Play;
use engine::Readings;
use program::{Model, NodeId, Scene};
use std::fmt::Write;

/// A line has at most twice so many points, and no more dots are drawn than this.
const POINTS: usize = 500;
const DOTS: f64 = 500.0;

/// What evaluates the places of the trails of a scene: two values for each.
#[derive(Debug)]
pub(crate) struct Trails {
    places: Readings,
    state: Vec<f64>,
}

impl Trails {
    /// Those of a scene.
    pub fn new(model: &Model, scene: Option<&Scene>) -> Self {
        let node = |scene: &Scene, index: usize| scene.values.get(index).map(|value| value.node);
        let nodes: Vec<NodeId> = scene.map_or_else(Vec::new, |scene| {
            scene.trails.iter().flat_map(|trail| [node(scene, trail.x), node(scene, trail.y)]).flatten().collect()
        });
        Self { places: Readings::new(model, &nodes), state: vec![0.0; model.states.len()] }
    }
}

/// The place of a trail among the values of all.
fn place(values: &[f64], number: usize) -> (f64, f64) {
    let value = |index: usize| values.get(index).copied().unwrap_or(f64::NAN);
    (value(2 * number), value(2 * number + 1))
}

/// Adds a point of a path; what is not a number leaves a gap.
fn write(path: &mut String, command: &mut char, (x, y): (f64, f64)) {
    if x.is_finite() && y.is_finite() {
        // Writing to a string does not fail. A hundredth of a unit of the drawing is not seen.
        let _ = write!(path, "{command}{x:.2} {y:.2}");
        *command = 'L';
    } else {
        *command = 'M';
    }
}

impl Play {
    /// Writes the path of a trail of the scene up to the time shown, in units of the drawing: a line, or dots of no length.
    pub fn scene_trail(&mut self, number: usize, path: &mut String) {
        path.clear();
        self.scene_values();
        let Some(trail) = self.program.scene(&self.tag).and_then(|scene| scene.trails.get(number)) else { return };
        let value = |index: usize| self.evaluators.scene_values.get(index).copied().unwrap_or(f64::NAN);
        let (last, every) = (trail.last.map(value), trail.every.map(value));
        let from = last.map_or(0.0, |last| (self.course.time() - last).max(0.0));
        match every {
            Some(every) => self.write_dots(number, from, every, path),
            None => self.write_line(number, from, path),
        }
    }

    /// The rows from a time on, evenly thinned, and the place at the time shown. The same rows are drawn from frame to
    /// frame: others would make the line tremble.
    fn write_line(&mut self, number: usize, from: f64, path: &mut String) {
        let places = &mut self.evaluators.trails.places;
        let rows = self.course.rows_until_shown();
        let mut command = 'M';
        if let Some(history) = self.course.history() {
            let first = history.times().partition_point(|time| *time < from);
            let mut stride = 1;
            while rows.saturating_sub(first) / stride > 2 * POINTS {
                stride *= 2;
            }
            let mut before: Option<(f64, (f64, f64))> = None;
            for row in (first.next_multiple_of(stride)..rows).step_by(stride) {
                let (time, here) = (history.time(row), place(places.at_row(history, row), number));
                // An event that moves the point itself leaves a gap.
                if before.is_some_and(|(earlier, there)| earlier == time && there != here) {
                    command = 'M';
                }
                write(path, &mut command, here);
                before = Some((time, here));
            }
        }
        let course = &self.course;
        let here = places.at(course.parameters(), course.initial(), course.time(), course.state());
        write(path, &mut command, place(here, number));
    }

    /// A dot at each multiple of `every`, the last ones if there are very many.
    fn write_dots(&mut self, number: usize, from: f64, every: f64, path: &mut String) {
        let time = self.course.time();
        let (least, most) = ((from / every).ceil(), (time / every + 1e-9).floor());
        if !(every > 0.0 && most.is_finite()) {
            return;
        }
        let trails = &mut self.evaluators.trails;
        let mut multiple = least.max(most - (DOTS - 1.0)).max(0.0);
        while multiple <= most {
            let at = (multiple * every).min(time);
            let Some(parameters) = self.course.state_at(at, &mut trails.state) else { return };
            let values = trails.places.at(&parameters, self.course.initial(), at, &trails.state);
            let (x, y) = place(values, number);
            if x.is_finite() && y.is_finite() {
                let _ = write!(path, "M{x:.2} {y:.2}h0");
            }
            multiple += 1.0;
        }
    }
}

//! From pixels of the stored picture to the numbers of the table.

use super::arguments::Track as Arguments;
use super::opened::{Opened, refused};
use crate::failure::Failure;
use film::calibration::{CLICK, Calibration, Lengths, Scale};
use film::tracking::{Point, Track};

/// A quantity of the table.
#[derive(Debug)]
pub struct Measured {
    /// `y`, or `y_2` where there are several.
    pub name: String,
    /// The value in each frame of the track.
    pub values: Vec<f64>,
    /// Their standard errors.
    pub sigmas: Vec<f64>,
}

/// The map that a person asks for.
pub fn calibration(film: &Opened, arguments: &Arguments) -> Result<Calibration, Failure> {
    let [_, high] = film.upright_size();
    let lengths = match &arguments.scale {
        None => Lengths::Pixels,
        Some(ruler) => {
            let marks = ruler.marks.map(|mark| film.stored(mark));
            let scale = Scale::between(marks, ruler.length, CLICK);
            Lengths::Scale(scale.map_err(|refusal| refused(&film.path, refusal.words()))?)
        }
    };
    let origin = film.stored(arguments.origin.unwrap_or([0.0, high]));
    Ok(Calibration { lengths, origin, rotation: film.rotation, ..Calibration::default() })
}

/// What a track shows: the level along its tube, or both coordinates of a body. `suffix` is added to the names.
pub fn measured(track: &Track, calibration: &Calibration, suffix: &str) -> Vec<Measured> {
    let quantity = |name: &str, pick: &dyn Fn(&Point) -> [f64; 2]| {
        let (values, sigmas) = track.points.iter().map(|point| pick(point).into()).unzip();
        Measured { name: format!("{name}{suffix}"), values, sigmas }
    };
    let Some(direction) = track.direction else {
        let coordinate = |k: usize| {
            move |point: &Point| {
                [calibration.apply(point.position)[k], calibration.sigma(point.position, point.sigma)[k]]
            }
        };
        return vec![quantity("x", &coordinate(0)), quantity("y", &coordinate(1))];
    };
    // The tube's axis from its lower end to the upper one.
    let zero = calibration.apply(calibration.origin);
    let end = calibration.apply([0, 1].map(|k| calibration.origin[k] + direction[k]));
    let axis = [end[0] - zero[0], end[1] - zero[1]];
    let length = |[x, y]: [f64; 2]| (x * x + y * y).sqrt();
    let pixel = length(axis);
    let sense = if (axis[1], axis[0]) < (0.0, 0.0) { -1.0 } else { 1.0 };
    let up = axis.map(|part| sense * part / pixel);
    let level = |point: &Point| {
        let [x, y] = calibration.apply(point.position);
        [x * up[0] + y * up[1], pixel * length(point.sigma)]
    };
    vec![quantity("y", &level)]
}

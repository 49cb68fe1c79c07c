//! Conversion of px of the stored picture to the numbers of the table.

use super::arguments::Track as Arguments;
use super::opened::{Opened, refused};
use crate::failure::Failure;
use film::calibration::{CLICK, Calibration, Lengths, Scale};

/// Requested calibration.
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

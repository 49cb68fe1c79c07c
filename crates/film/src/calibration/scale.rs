//! The size of a pixel.

use crate::calibration::refusal::Refusal;

/// The standard error of a click with a loupe, in pixels.
pub const CLICK: f64 = 0.5;
/// Marks closer than this, in pixels, give no scale.
const CLOSEST: f64 = 5.0;

/// How large a pixel is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// Metres.
    pub pixel: f64,
    /// Its relative standard error, which all lengths share.
    pub relative_sigma: f64,
}

impl Scale {
    /// From two marks at a known distance in metres. `click` is the standard error of each coordinate of a click, in pixels.
    ///
    /// # Errors
    ///
    /// Where the marks lie too close together or the length is not positive.
    pub fn between(marks: [[f64; 2]; 2], length: f64, click: f64) -> Result<Scale, Refusal> {
        let distance = distance(marks)?;
        if !(length > 0.0 && length.is_finite()) {
            return Err(Refusal::Length);
        }
        Ok(Scale { pixel: length / distance, relative_sigma: std::f64::consts::SQRT_2 * click / distance })
    }

    /// From several marks of a ruler by least squares along it. The error follows from the scatter of the marks from three on, and
    /// from `click` for two.
    ///
    /// # Errors
    ///
    /// Where all marks lie too close together or have the same number.
    pub fn along(marks: &[Mark], click: f64) -> Result<Scale, Refusal> {
        let count = marks.len() as f64;
        let mean = |values: &mut dyn Iterator<Item = f64>| values.sum::<f64>() / count;
        let middle = [0, 1].map(|k| mean(&mut marks.iter().map(|mark| mark.position[k])));
        let zero = mean(&mut marks.iter().map(|mark| mark.number));
        let (mut u, mut v, mut spread) = (0.0, 0.0, 0.0);
        for mark in marks {
            let number = mark.number - zero;
            u += (mark.position[0] - middle[0]) * number;
            v += (mark.position[1] - middle[1]) * number;
            spread += number * number;
        }
        if !(spread > 0.0 && spread.is_finite()) {
            return Err(Refusal::Length);
        }
        // Pixels a metre, in both coordinates.
        let (u, v) = (u / spread, v / spread);
        let metre = libm::hypot(u, v);
        let first = marks.iter().map(|mark| mark.number).fold(f64::INFINITY, f64::min);
        let last = marks.iter().map(|mark| mark.number).fold(f64::NEG_INFINITY, f64::max);
        let long = metre * (last - first);
        if long.is_nan() || long < CLOSEST {
            return Err(Refusal::Close);
        }
        let squares: f64 = marks
            .iter()
            .map(|mark| {
                let along = ((mark.position[0] - middle[0]) * u + (mark.position[1] - middle[1]) * v) / metre;
                along - metre * (mark.number - zero)
            })
            .map(|deviation| deviation * deviation)
            .sum();
        let scatter = if marks.len() > 2 { (squares / (count - 2.0)).sqrt() } else { click };
        Ok(Scale { pixel: 1.0 / metre, relative_sigma: scatter / spread.sqrt() / metre })
    }
}

/// A clicked mark of a ruler.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// Where it is, in pixels.
    pub position: [f64; 2],
    /// The number that stands at it, in metres.
    pub number: f64,
}

/// The distance of two marks in pixels.
pub(crate) fn distance([[x, y], [u, v]]: [[f64; 2]; 2]) -> Result<f64, Refusal> {
    let distance = libm::hypot(u - x, v - y);
    if distance.is_finite() && distance >= CLOSEST { Ok(distance) } else { Err(Refusal::Close) }
}

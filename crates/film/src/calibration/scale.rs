//! Size of a pixel.

use crate::calibration::refusal::Refusal;

/// Standard error of a coordinate of a click with the loupe, px.
pub const CLICK: f64 = 0.5;
/// Minimum distance between marks, px.
const CLOSEST: f64 = 5.0;

/// Size of a pixel with its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// Size of a pixel, m.
    pub pixel: f64,
    /// Relative standard error, shared by all lengths.
    pub relative_sigma: f64,
}

impl Scale {
    /// Scale from two marks in px at the distance `length` in m. `click`: standard error of each coordinate of a click,
    /// px.
    ///
    /// # Errors
    ///
    /// [`Refusal::Close`] if the marks are too close together, [`Refusal::Length`] if the length is not positive.
    pub fn between(marks: [[f64; 2]; 2], length: f64, click: f64) -> Result<Scale, Refusal> {
        let distance = distance(marks)?;
        if !(length > 0.0 && length.is_finite()) {
            return Err(Refusal::Length);
        }
        Ok(Scale { pixel: length / distance, relative_sigma: std::f64::consts::SQRT_2 * click / distance })
    }

    /// Scale from several marks of a ruler by linear regression along it. With three marks or more the error follows
    /// from their scatter, with two from `click` (px).
    ///
    /// # Errors
    ///
    /// [`Refusal::Close`] if all marks are too close together, [`Refusal::Length`] if all have the same number.
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
        // Pixels per metre in both coordinates.
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

/// Clicked mark of a ruler.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// Position, px.
    pub position: [f64; 2],
    /// Number on the ruler, m.
    pub number: f64,
}

/// Distance between two marks, px.
///
/// # Errors
///
/// [`Refusal::Close`] if they are too close together.
pub(crate) fn distance([[x, y], [u, v]]: [[f64; 2]; 2]) -> Result<f64, Refusal> {
    let distance = libm::hypot(u - x, v - y);
    if distance.is_finite() && distance >= CLOSEST { Ok(distance) } else { Err(Refusal::Close) }
}

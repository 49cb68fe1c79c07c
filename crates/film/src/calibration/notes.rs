//! Notes on the calibration, as text.

use crate::calibration::{Calibration, Lengths};
use units::number::plain;
use units::{Words, words};

impl Calibration {
    /// Notes for the user: size of a pixel, error of the scale and correction for the place of the ruler.
    pub fn notes(&self) -> Vec<Words> {
        let sigma = self.relative_sigma().map(|sigma| significant(100.0 * sigma, 2));
        let scale = match (&self.lengths, sigma) {
            (Lengths::Scale(scale), Some(sigma)) => words!(
                "scale: a pixel is {pixel} mm, with a standard error of {sigma} % that all lengths share",
                pixel = significant(1e3 * scale.pixel, 4),
            ),
            (Lengths::Rectangle(_), Some(sigma)) => {
                words!("scale by a rectangle, with a standard error of {sigma} % that all lengths share")
            }
            _ => words("no scale: positions are in pixels. Mark a length to compare them with the model"),
        };
        let parallax = self.parallax.filter(|_| self.relative_sigma().is_some()).map(|parallax| {
            words!(
                "lengths are multiplied by {factor}: the ruler is not where the motion is",
                factor = significant(parallax.factor(), 5)
            )
        });
        std::iter::once(scale).chain(parallax).collect()
    }
}

fn significant(value: f64, digits: usize) -> Words {
    Words::each(move |language| plain(value, digits, language.style()))
}

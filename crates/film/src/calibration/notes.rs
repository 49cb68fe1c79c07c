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
                "escala: un píxel mide {pixel} mm, con un error estándar del {sigma} % común a todas las longitudes",
                pixel = significant(1e3 * scale.pixel, 4),
                sigma = sigma
            ),
            (Lengths::Rectangle(_), Some(sigma)) => words!(
                "scale by a rectangle, with a standard error of {sigma} % that all lengths share",
                "escala por un rectángulo, con un error estándar del {sigma} % común a todas las longitudes",
                sigma = sigma
            ),
            _ => words(
                "no scale: positions are in pixels. Mark a length to compare them with the model",
                "sin escala: las posiciones están en píxeles. Marca una longitud para compararlas con el modelo",
            ),
        };
        let parallax = self.parallax.filter(|_| self.relative_sigma().is_some()).map(|parallax| {
            words!(
                "lengths are multiplied by {factor}: the ruler is not where the motion is",
                "las longitudes se multiplican por {factor}: la regla no está donde el movimiento",
                factor = significant(parallax.factor(), 5)
            )
        });
        std::iter::once(scale).chain(parallax).collect()
    }
}

fn significant(value: f64, digits: usize) -> Words {
    Words::each(|language| plain(value, digits, language.style()))
}

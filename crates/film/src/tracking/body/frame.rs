//! Frame of a film.

use crate::plane::Plane;
use crate::tracking::similarity::Similarity;

/// Frame of a film. Time in s.
#[derive(Clone, Copy)]
pub(super) struct Frame<'a> {
    pub number: usize,
    pub time: f64,
    pub plane: &'a Plane,
    pub camera: Similarity,
}

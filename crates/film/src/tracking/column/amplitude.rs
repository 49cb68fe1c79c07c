//! Amplitude of a small motion.
//!
//! To first order of the motion, a multiple of it with a fainter pattern gives the same picture. The iteration of pattern and positions therefore
//! hardly changes the amplitude that it began with, if the surface moves by a few rows only. Here pattern and background are fitted together for
//! several multiples of the motion, and the one with the least residual is chosen.

use crate::tracking::column::pattern::{Pattern, Pose};
use crate::tracking::column::strip::Strip;
use crate::tracking::column::together::{Explained, Together};
use units::order::{sort_by, sort_numbers};

/// Maximum range of the middle 90 % of the positions in rows. Wider motions determine their amplitude in the iteration.
pub(crate) const WIDEST: f64 = 16.0;
/// Multiples of the first trials.
const COARSE: [f64; 3] = [0.85, 1.0, 1.15];
/// Number of further trials, each at the vertex of the parabola through the best one and its neighbours.
const FINE: usize = 3;

/// Search for the multiple of the motion with the least residual.
pub(crate) struct Amplitude {
    /// Mean position, rows.
    middle: f64,
    /// Multiples and their sums of squared residuals.
    tried: Vec<(f64, f64)>,
    best: Option<Amplified>,
    trial: Option<(f64, Together)>,
    /// Index of the next frame of the trial.
    at: usize,
}

/// Best multiple of the motion.
#[derive(Clone, Debug)]
pub(crate) struct Amplified {
    pub multiple: f64,
    /// Position that keeps its row.
    pub middle: f64,
    /// Sum of the squared residuals, and the background.
    pub explained: Explained,
}

impl Amplitude {
    /// `None` if the motion is wide, or too few frames show the surface.
    pub(crate) fn new(poses: &[Pose]) -> Option<Amplitude> {
        let mut rows: Vec<f64> = poses.iter().filter(|pose| pose.trusted).map(|pose| pose.row).collect();
        sort_numbers(&mut rows);
        let margin = rows.len() / 20;
        let [first, .., last] = rows.get(margin..rows.len() - margin)? else { return None };
        let middle = rows.iter().sum::<f64>() / rows.len() as f64;
        (last - first < WIDEST).then_some(Amplitude { middle, tried: Vec::new(), best: None, trial: None, at: 0 })
    }

    /// Does the work of one frame. Returns true after the last trial.
    pub(crate) fn step(&mut self, pattern: &Pattern, strips: &[Strip], poses: &[Pose]) -> bool {
        let Some((multiple, mut together)) = self.trial.take() else {
            let multiple = match COARSE.get(self.tried.len()) {
                Some(multiple) => *multiple,
                None if self.tried.len() < COARSE.len() + FINE => self.vertex(),
                None => return true,
            };
            self.at = 0;
            self.trial = Some((multiple, Together::new(pattern)));
            return false;
        };
        let Some((strip, pose)) = strips.get(self.at).zip(poses.get(self.at)) else {
            let explained = together.explained();
            self.tried.push((multiple, explained.as_ref().map_or(f64::INFINITY, |explained| explained.left)));
            if let Some(explained) =
                explained.filter(|one| self.best.as_ref().is_none_or(|best| one.left < best.explained.left))
            {
                self.best = Some(Amplified { multiple, middle: self.middle, explained });
            }
            return false;
        };
        if pose.trusted {
            together.take(strip, &Pose { row: self.middle + multiple * (pose.row - self.middle), ..pose.clone() });
        }
        self.at += 1;
        self.trial = Some((multiple, together));
        false
    }

    /// Result after the last trial; `None` if no trial has a solution.
    pub(crate) fn result(self) -> Option<Amplified> {
        self.best
    }

    /// Vertex of the parabola through the best trial and its neighbours.
    fn vertex(&self) -> f64 {
        let mut sorted = self.tried.clone();
        sort_by(&mut sorted, |a, b| a.0.total_cmp(&b.0));
        let best = self.best.as_ref().map_or(1.0, |best| best.multiple);
        let at = sorted.iter().position(|one| one.0 == best).unwrap_or(0).clamp(1, sorted.len() - 2);
        let [(x, p), (y, q), (z, r)] = [sorted[at - 1], sorted[at], sorted[at + 1]];
        let (left, right) = ((q - p) / (y - x), (r - q) / (z - y));
        let curvature = (right - left) / (z - x);
        if curvature > 0.0 { ((x + y) / 2.0 - left / (2.0 * curvature)).clamp(x, z) } else { best }
    }
}

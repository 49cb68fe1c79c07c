//! Exposure time with the least residual.

use crate::tracking::column::align::align;
use crate::tracking::column::pattern::{Fitting, Pattern, Pose};
use crate::tracking::column::strip::Strip;
use crate::tracking::motion::{motion, smear};
use crate::tracking::track::Exposure;
use units::order::sort_by;

/// Number of intervals between trial exposure times in the first search, from 0 to the frame interval.
const COARSE: usize = 8;
/// Number of further trials, each at the vertex of the parabola through the three best.
const FINE: usize = 5;
/// Maximum number of compared frames.
const FRAMES: usize = 60;

/// Minimum number of frames.
const FEWEST: usize = 12;
/// Number of iterations of pattern and positions.
const ROUNDS: usize = 2;
/// Maximum change of a position by a trial, rows.
const REACH: f64 = 2.0;

/// Search for the exposure time.
pub(crate) struct Candidates {
    /// Maximum exposure time, s.
    longest: f64,
    /// Indices of the compared frames.
    chosen: Vec<usize>,
    /// Trial exposure times (s) and their mean squared residuals.
    tried: Vec<(f64, f64)>,
    /// Largest speed, rows per s.
    fastest: f64,
    trial: Option<Trial>,
}

/// Fit of pattern and positions with one trial exposure time, one frame per step.
struct Trial {
    exposure: f64,
    pattern: Pattern,
    poses: Vec<Pose>,
    /// Present while the pattern is fitted, absent while the positions are.
    fitting: Option<Fitting>,
    /// Index among the compared frames.
    at: usize,
    round: usize,
    squares: f64,
    count: f64,
}

impl Candidates {
    pub(crate) fn new(times: &[f64], poses: &[Pose], shortest: f64) -> Candidates {
        let rows: Vec<f64> = poses.iter().map(|pose| pose.row).collect();
        let speed = |at: &usize| motion(times, &rows, *at).0.abs();
        let mut chosen: Vec<usize> = (0..poses.len()).filter(|at| poses[*at].trusted).collect();
        sort_by(&mut chosen, |a, b| speed(a).total_cmp(&speed(b)));
        // Fast frames show the smear, slow ones the pattern.
        let fastest = chosen.iter().rev().nth(chosen.len() / 50).map_or(0.0, speed);
        let stride = chosen.len().div_ceil(FRAMES).max(1);
        let chosen: Vec<usize> = chosen.into_iter().rev().step_by(stride).collect();
        Candidates { longest: shortest, chosen, tried: Vec::new(), fastest, trial: None }
    }

    /// Does the work of one frame. Returns the exposure time after the last trial.
    pub(crate) fn advance(&mut self, start: &Pattern, strips: &[Strip], poses: &[Pose]) -> Option<Exposure> {
        if self.fastest * self.longest < 1.0 || self.chosen.len() < FEWEST {
            return Some(Exposure::Under(self.longest));
        }
        if let Some(mut trial) = self.trial.take() {
            match trial.step(&self.chosen, strips, poses) {
                Some(residual) => self.tried.push((trial.exposure, residual)),
                None => self.trial = Some(trial),
            }
            return None;
        }
        let step = self.tried.len();
        let exposure = if step <= COARSE {
            self.longest * step as f64 / COARSE as f64
        } else if step <= COARSE + FINE {
            self.vertex()
        } else {
            let best = self.best();
            // Smear of less than a pixel cannot be distinguished from the blur of the lens.
            let limit = 1.0 / self.fastest;
            return Some(if best < limit { Exposure::Under(limit) } else { Exposure::Seconds(best) });
        };
        let times: Vec<f64> = strips.iter().map(|strip| strip.time).collect();
        let rows: Vec<f64> = poses.iter().map(|pose| pose.row).collect();
        let pose = |at: &usize| Pose { smear: smear(motion(&times, &rows, *at), exposure), ..poses[*at].clone() };
        let mut pattern = Pattern::new(start.window, self.fastest * self.longest);
        pattern.background.clone_from(&start.background);
        self.trial = Some(Trial {
            exposure,
            fitting: Some(Fitting::new(&pattern)),
            pattern,
            poses: self.chosen.iter().map(pose).collect(),
            at: 0,
            round: 0,
            squares: 0.0,
            count: 0.0,
        });
        None
    }

    fn best(&self) -> f64 {
        self.tried.iter().min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0.0, |best| best.0)
    }

    /// Vertex of the parabola through the best trial and its neighbours.
    fn vertex(&self) -> f64 {
        let mut sorted = self.tried.clone();
        sort_by(&mut sorted, |a, b| a.0.total_cmp(&b.0));
        let best = self.best();
        let at = sorted.iter().position(|one| one.0 == best).unwrap_or(0).clamp(1, sorted.len() - 2);
        let [(x, p), (y, q), (z, r)] = [sorted[at - 1], sorted[at], sorted[at + 1]];
        let (left, right) = ((q - p) / (y - x), (r - q) / (z - y));
        let curvature = (right - left) / (z - x);
        let vertex = (x + y) / 2.0 - left / (2.0 * curvature);
        // Between the neighbours, at a distance from earlier trials.
        let close = 1e-3 * self.longest;
        let vertex = if curvature > 0.0 { vertex.clamp(x, z) } else { best };
        if [x, y, z].iter().any(|known| (known - vertex).abs() < close) {
            let (low, high) = if z - y > y - x { (y, z) } else { (x, y) };
            return (low + high) / 2.0;
        }
        vertex
    }
}

impl Trial {
    /// Does the work of one frame. Returns the mean squared residual at the end.
    fn step(&mut self, chosen: &[usize], strips: &[Strip], before: &[Pose]) -> Option<f64> {
        let next = chosen.get(self.at).zip(self.poses.get_mut(self.at));
        self.at += 1;
        match (next, self.fitting.as_mut()) {
            (Some((at, pose)), Some(fitting)) => fitting.take(&self.pattern, &strips[*at], pose),
            (Some((at, pose)), None) => {
                let row = before[*at].row;
                let agreement = align(&self.pattern, &strips[*at], pose, (row - REACH, row + REACH));
                self.squares += agreement.squares;
                self.count += agreement.count;
            }
            (None, Some(_)) => {
                if let Some(fitting) = self.fitting.take() {
                    fitting.finish(&mut self.pattern);
                }
                (self.squares, self.count, self.at) = (0.0, 0.0, 0);
            }
            (None, None) => {
                self.round += 1;
                if self.round == ROUNDS {
                    return Some(self.squares / self.count);
                }
                (self.fitting, self.at) = (Some(Fitting::new(&self.pattern)), 0);
            }
        }
        None
    }
}

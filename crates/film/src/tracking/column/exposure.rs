//! The exposure time by the least residual.

use crate::tracking::column::align::align;
use crate::tracking::column::pattern::{Fitting, Pattern, Pose};
use crate::tracking::column::strip::Strip;
use crate::tracking::motion::{motion, smear};
use crate::tracking::track::Exposure;

/// Exposure times of the first search, as parts of the time between frames.
const COARSE: usize = 8;
/// Evaluations that follow, each at the vertex of the parabola through the three best.
const FINE: usize = 5;
/// Frames that are compared.
const FRAMES: usize = 60;

/// The fewest frames that tell anything.
const FEWEST: usize = 12;
/// Times that pattern and positions are fitted.
const ROUNDS: usize = 2;
/// Rows by which a candidate may move a position.
const REACH: f64 = 2.0;

/// The search for the exposure time.
pub(crate) struct Candidates {
    /// The longest that a frame can be exposed.
    longest: f64,
    /// The frames that are compared.
    chosen: Vec<usize>,
    /// Candidates and their residuals.
    tried: Vec<(f64, f64)>,
    /// The greatest speed.
    fastest: f64,
    trial: Option<Trial>,
}

/// One candidate: pattern and positions are fitted twice, frame by frame.
struct Trial {
    exposure: f64,
    pattern: Pattern,
    poses: Vec<Pose>,
    /// While the pattern is fitted; then the positions are.
    fitting: Option<Fitting>,
    /// The next of the chosen frames.
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
        chosen.sort_by(|a, b| speed(a).total_cmp(&speed(b)));
        // The fast frames show the smear, and slow ones the pattern.
        let fastest = chosen.iter().rev().nth(chosen.len() / 50).map_or(0.0, speed);
        let stride = chosen.len().div_ceil(FRAMES).max(1);
        let chosen: Vec<usize> = chosen.into_iter().rev().step_by(stride).collect();
        Candidates { longest: shortest, chosen, tried: Vec::new(), fastest, trial: None }
    }

    /// Does the work of one frame; the exposure once all candidates are tried.
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
            // A smear of less than a pixel disappears in the blur of the lens.
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

    /// The vertex of the parabola through the best candidate and its neighbours.
    fn vertex(&self) -> f64 {
        let mut sorted = self.tried.clone();
        sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
        let best = self.best();
        let at = sorted.iter().position(|one| one.0 == best).unwrap_or(0).clamp(1, sorted.len() - 2);
        let [(x, p), (y, q), (z, r)] = [sorted[at - 1], sorted[at], sorted[at + 1]];
        let (left, right) = ((q - p) / (y - x), (r - q) / (z - y));
        let curvature = (right - left) / (z - x);
        let vertex = (x + y) / 2.0 - left / (2.0 * curvature);
        // Between the neighbours, and away from what is tried already.
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
    /// Does the work of one frame; the mean squared residual of the chosen frames after the last one.
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

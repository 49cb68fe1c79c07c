//! Computation of a track from the strips, in steps.

use crate::tracking::column::align::{Agreement, align, residuals};
use crate::tracking::column::amplitude::{Amplified, Amplitude};
use crate::tracking::column::certainty::Certainty;
use crate::tracking::column::contrast::contrast;
use crate::tracking::column::exposure::Candidates;
use crate::tracking::column::path::{Template, strengths};
use crate::tracking::column::pattern::{Fitting, Pattern, Pose, Residuals, Window};
use crate::tracking::column::regions::Shape;
use crate::tracking::column::removing::Removing;
use crate::tracking::column::seeking::{ELSEWHERE, Sought};
use crate::tracking::column::separating::Separating;
use crate::tracking::column::strip::{Grid, Strip, with_differences};
use crate::tracking::motion::{motion, smear};
use crate::tracking::refusal::Refusal;
use crate::tracking::track::{Exposure, Known};
use units::order::sort_numbers;

/// Maximum number of iterations of pattern and positions before the search for the exposure time, and after it.
const ROUNDS: usize = 3;
/// Root mean square change of positions in rows at which the iteration ends.
const SETTLED: f64 = 0.005;
/// Maximum number of searches for the amplitude, and change of the amplitude after which no further one follows.
const SEARCHES: usize = 3;
const SAME: f64 = 0.002;
/// Number of iterations after a search for the amplitude.
const AFTER: usize = 2;
/// Maximum distance of the surface from the path, and from an anchor, rows.
const REACH: f64 = 4.0;

/// Number of parts across the bore for the search of the path.
const CHANNELS: usize = 2;
/// Maximum number of rows on each side of the surface with the moving pattern, for the search of the path.
const WINDOW: usize = 12;

/// Lead below which the clicked frame shows the surface elsewhere.
const LEFT: f32 = -0.7;

/// Minimum signal-to-noise ratio of the clicked profile. Noise reaches it in one of a million profiles of 15 rows, the
/// shortest: chi squared with 13 degrees of freedom above 52.
const CONTRAST: f64 = 2.0;

/// Input of the tracking.
#[derive(Clone, Debug)]
pub(crate) struct Task {
    pub grid: Grid,
    pub bins: (usize, usize),
    /// Index of the clicked strip, and the row.
    pub clicked: (usize, f64),
    /// Index of the strip and row of each anchor.
    pub anchors: Vec<(usize, f64)>,
    /// Maximum motion of the surface within the median frame interval, rows.
    pub reach: f64,
    pub exposure: Known,
}

impl Task {
    /// Window around the surface with 0.8 bore widths on each side, within 7 to 40 rows.
    fn window(&self) -> Window {
        let width = (self.bins.1 - self.bins.0) as f64 * self.grid.width;
        Window { grid: self.grid, bins: self.bins, half: (0.8 * width).clamp(7.0, 40.0) }
    }

    /// Number of parts across the bore.
    fn channels(&self) -> usize {
        (self.bins.1 - self.bins.0).clamp(1, CHANNELS)
    }

    fn fixed(&self, at: usize) -> Option<(usize, usize)> {
        let clicked = (self.clicked.0 == at).then_some(self.clicked.1);
        let anchor = self.anchors.iter().rev().find(|anchor| anchor.0 == at).map(|anchor| anchor.1);
        let row = anchor.or(clicked)?;
        Some(((row - REACH).max(0.0) as usize, (row + REACH).max(0.0) as usize))
    }
}

enum Stage {
    Profiles,
    Path(Box<Separating>),
    Removing(Box<Removing>),
    Fitting(Fitting, usize),
    Aligning(Residuals, usize),
    Exposure(Box<Candidates>),
    Amplitude(Box<Amplitude>),
    Finished,
}

/// State of the computation.
pub(crate) struct Solving {
    pub task: Task,
    times: Vec<f64>,
    /// Median and shortest frame interval, s.
    intervals: (f64, f64),
    profiles: Vec<Vec<f32>>,
    strongest: Vec<f64>,
    /// Grey values of the bore in channels, until the path is found.
    signals: Vec<Vec<f32>>,
    /// Strips without the reflection; empty if there is none.
    cleaned: Vec<Strip>,
    stage: Stage,
    round: usize,
    /// Number of further searches for the amplitude.
    searches: usize,
    /// Sum of the squared changes of positions in this iteration.
    change: f64,
    pattern: Pattern,
    pub poses: Vec<Pose>,
    pub agreements: Vec<Agreement>,
    path: Vec<usize>,
    pub certainties: Vec<Certainty>,
    /// True if the two regions confirm the clicked row.
    is_favoured: bool,
    pub exposure: Option<Exposure>,
}

impl Solving {
    pub(crate) fn new(task: Task, strips: &[Strip]) -> Solving {
        let times: Vec<f64> = strips.iter().map(|strip| strip.time).collect();
        let mut intervals: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
        sort_numbers(&mut intervals);
        let at = |k: usize| intervals.get(k).copied().unwrap_or(1.0);
        Solving {
            intervals: (at(intervals.len() / 2), at(0)),
            pattern: Pattern::new(task.window(), 0.0),
            exposure: match task.exposure {
                Known::Seconds(seconds) => Some(Exposure::Seconds(seconds)),
                Known::Estimated => None,
            },
            task,
            times,
            profiles: Vec::new(),
            strongest: Vec::new(),
            signals: Vec::new(),
            cleaned: Vec::new(),
            stage: Stage::Profiles,
            round: 0,
            searches: SEARCHES,
            change: 0.0,
            poses: Vec::new(),
            agreements: Vec::new(),
            path: Vec::new(),
            certainties: Vec::new(),
            is_favoured: false,
        }
    }

    /// Grey values of the space-time picture: mean over the bore, for each frame and row.
    pub(crate) fn profiles(&self) -> &[Vec<f32>] {
        &self.profiles
    }

    /// Repeats the search after a change of the anchors.
    pub(crate) fn again(&mut self, anchors: Vec<(usize, f64)>) {
        self.task.anchors = anchors;
        (self.round, self.searches) = (0, SEARCHES);
        self.pattern = Pattern::new(self.task.window(), 0.0);
        if self.task.exposure == Known::Estimated {
            self.exposure = None;
        }
        (self.profiles, self.strongest, self.signals, self.cleaned) = Default::default();
        self.stage = Stage::Profiles;
    }

    /// Does the work of one frame. Returns true at the end.
    ///
    /// # Errors
    ///
    /// A [`Refusal`] if the click cannot be tracked.
    pub(crate) fn step(&mut self, strips: &[Strip]) -> Result<bool, Refusal> {
        let cleaned = std::mem::take(&mut self.cleaned);
        let strips = if cleaned.is_empty() { strips } else { &cleaned };
        self.stage = match std::mem::replace(&mut self.stage, Stage::Finished) {
            Stage::Removing(mut removing) => match removing.step(strips) {
                Some(strips) => {
                    self.cleaned = strips;
                    self.begin_round()
                }
                None => Stage::Removing(removing),
            },
            Stage::Profiles => self.profile(strips)?,
            Stage::Path(seeking) => self.follow(seeking, strips)?,
            Stage::Fitting(fitting, at) => self.fit(fitting, at, strips),
            Stage::Aligning(sums, at) => self.align(sums, at, strips)?,
            Stage::Exposure(mut candidates) => match candidates.advance(&self.pattern, strips, &self.poses) {
                Some(exposure) => {
                    self.exposure = Some(exposure);
                    self.begin_round()
                }
                None => Stage::Exposure(candidates),
            },
            Stage::Amplitude(mut amplitude) => {
                if amplitude.step(&self.pattern, strips, &self.poses) {
                    self.amplify(*amplitude)
                } else {
                    Stage::Amplitude(amplitude)
                }
            }
            Stage::Finished => Stage::Finished,
        };
        if self.cleaned.is_empty() {
            self.cleaned = cleaned;
        }
        Ok(matches!(self.stage, Stage::Finished))
    }

    fn profile(&mut self, strips: &[Strip]) -> Result<Stage, Refusal> {
        let half = self.task.window().half as usize;
        let grid = self.task.grid;
        if let Some(strip) = strips.get(self.signals.len()) {
            let profile = strip.profile(grid, self.task.bins);
            self.strongest.push(strengths(&profile, half).into_iter().fold(0.0, f64::max));
            self.profiles.push(profile);
            let channels = strip.channels(grid, self.task.bins, self.task.channels());
            self.signals.push(with_differences(channels, grid.rows));
            return Ok(Stage::Profiles);
        }
        let (at, row) = self.task.clicked;
        let profile = self.profiles.get(at).ok_or(Refusal::Plain)?;
        let template = Template::new(profile, row, half, &self.strongest).ok_or(Refusal::Plain)?;
        if contrast(&self.profiles, at, row, half) < CONTRAST {
            return Err(Refusal::Noise { frame: self.frame(strips) });
        }
        let shape = Shape { rows: grid.rows, channels: 2 * self.task.channels(), half: half.min(WINDOW) };
        let limit = |at: usize| {
            let late = if at == 0 { 0.0 } else { (self.times[at] - self.times[at - 1]) / self.intervals.0 };
            let reach = (self.task.reach * late.max(1.0)).ceil().min(grid.rows as f64) as usize;
            (reach, self.task.fixed(at))
        };
        let limits = (0..self.times.len()).map(limit).collect();
        let sought = Sought { shape, clicked: (at, row), half, limits };
        Ok(Stage::Path(Box::new(Separating::new(sought, template, std::mem::take(&mut self.strongest)))))
    }

    /// True if the pixels of the clicked frame, or the two regions, confirm the click.
    fn shows_clicked(&self) -> bool {
        let at = self.task.clicked.0;
        self.is_favoured || self.poses.get(at).is_some_and(|pose| pose.trusted)
    }

    /// Number of the clicked frame.
    fn frame(&self, strips: &[Strip]) -> usize {
        strips.get(self.task.clicked.0).map_or(0, |strip| strip.frame)
    }

    fn follow(&mut self, mut seeking: Box<Separating>, strips: &[Strip]) -> Result<Stage, Refusal> {
        let Some((found, reflection)) = seeking.step(&self.profiles, &self.signals) else {
            return Ok(Stage::Path(seeking));
        };
        self.signals.clear();
        self.path = found.path;
        self.certainties = found.certainties;
        let (clicked, row) = self.task.clicked;
        self.is_favoured = found.favourite.abs_diff(row as usize) <= ELSEWHERE;
        let certainty = self.certainties.get(clicked).copied().unwrap_or_default();
        if certainty.lead < LEFT && found.favourite.abs_diff(row as usize) > 3 * ELSEWHERE {
            return Err(Refusal::Left { frame: self.frame(strips) });
        }
        let pose =
            |row: &usize| Pose { row: *row as f64, gain: 1.0, offset: f64::NAN, smear: vec![0.0], trusted: true };
        self.poses = self.path.iter().map(pose).collect();
        self.agreements = vec![Agreement::default(); self.poses.len()];
        Ok(match reflection {
            Some(reflection) => Stage::Removing(Box::new(Removing::new(reflection, self.task.grid, self.task.bins))),
            None => self.begin_round(),
        })
    }

    /// Continues with the best multiple of the motion.
    fn amplify(&mut self, amplitude: Amplitude) -> Stage {
        self.searches -= 1;
        if let Some(Amplified { multiple, middle, explained }) = amplitude.result() {
            self.poses.iter_mut().for_each(|pose| pose.row = middle + multiple * (pose.row - middle));
            self.pattern.background = explained.background;
            if (multiple - 1.0).abs() < SAME {
                self.searches = 0;
            }
        }
        self.round = 2 * ROUNDS - AFTER;
        self.begin_round()
    }

    fn begin_round(&mut self) -> Stage {
        let rows: Vec<f64> = self.poses.iter().map(|pose| pose.row).collect();
        let exposure = match self.exposure {
            Some(Exposure::Seconds(seconds)) => seconds,
            _ => 0.0,
        };
        let mut widest = 0.0_f64;
        for (at, pose) in self.poses.iter_mut().enumerate() {
            // The path has whole rows, too coarse for accelerations.
            if self.round > 0 {
                pose.smear = smear(motion(&self.times, &rows, at), exposure);
            }
            widest = pose.smear.iter().filter(|_| pose.trusted).fold(widest, |widest, shift| widest.max(shift.abs()));
        }
        let background = std::mem::take(&mut self.pattern.background);
        self.pattern = Pattern::new(self.task.window(), (2.0 * widest).min(self.task.grid.rows as f64));
        self.pattern.background = background;
        Stage::Fitting(Fitting::new(&self.pattern), 0)
    }

    fn fit(&mut self, mut fitting: Fitting, at: usize, strips: &[Strip]) -> Stage {
        let Some((strip, pose)) = strips.get(at).zip(self.poses.get_mut(at)) else {
            let gain = fitting.finish(&mut self.pattern);
            self.poses.iter_mut().for_each(|pose| pose.gain /= gain);
            return Stage::Aligning(Residuals::new(&self.pattern), 0);
        };
        if pose.offset.is_nan() {
            let window = self.pattern.window;
            let (mut sum, mut count) = (0.0, 0.0);
            for value in window.rows(pose.row).flat_map(|row| strip.values(window.grid, row, window.bins)) {
                sum += value;
                count += 1.0;
            }
            pose.offset = sum / f64::max(count, 1.0);
        }
        if pose.trusted {
            fitting.take(&self.pattern, strip, pose);
        }
        Stage::Fitting(fitting, at + 1)
    }

    fn align(&mut self, mut sums: Residuals, at: usize, strips: &[Strip]) -> Result<Stage, Refusal> {
        let Some((strip, pose)) = strips.get(at).zip(self.poses.get_mut(at)) else {
            sums.finish(&mut self.pattern);
            let settled = self.change < SETTLED * SETTLED * at as f64;
            let last = if self.round < ROUNDS { ROUNDS } else { 2 * ROUNDS };
            self.round = if settled { last } else { self.round + 1 };
            self.change = 0.0;
            let next = if self.round == ROUNDS && self.exposure.is_none() {
                Stage::Exposure(Box::new(Candidates::new(&self.times, &self.poses, self.intervals.1)))
            } else if self.round < 2 * ROUNDS {
                self.begin_round()
            } else if let Some(amplitude) = Amplitude::new(&self.poses).filter(|_| self.searches > 0) {
                Stage::Amplitude(Box::new(amplitude))
            } else if self.shows_clicked() {
                Stage::Finished
            } else {
                return Err(Refusal::Left { frame: self.frame(strips) });
            };
            return Ok(next);
        };
        let (path, before) = (self.path[at] as f64, pose.row);
        let agreement = align(&self.pattern, strip, pose, (path - REACH, path + REACH));
        self.change += (pose.row - before) * (pose.row - before);
        pose.trusted = agreement.settled && agreement.score > 0.6 && pose.gain > 0.3;
        if pose.trusted {
            residuals(&self.pattern, strip, pose, &mut sums);
        }
        self.agreements[at] = agreement;
        Ok(Stage::Aligning(sums, at + 1))
    }
}

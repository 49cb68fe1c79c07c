//! How the rows of a measurement follow each other in time.

use crate::order::median;

/// Frames a second of cameras whose step is no short decimal.
const RATES: [f64; 17] = [
    30.0,
    60.0,
    30000.0 / 1001.0,
    60000.0 / 1001.0,
    24.0,
    24000.0 / 1001.0,
    15.0,
    120.0,
    120000.0 / 1001.0,
    240.0,
    240000.0 / 1001.0,
    480.0,
    960.0,
    90.0,
    48.0,
    300.0,
    600.0,
];

/// The steps in which a record was taken.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sampling {
    /// The usual distance of two rows: the slope of the times over the frames, or the mean distance of uneven rows. 0 for
    /// fewer than three rows.
    pub interval: f64,
    /// The frame of each row, counted from time 0 if the frames agree with that, else from the first row; `None` without
    /// a time. Empty where the rows keep no step.
    pub frames: Vec<Option<i64>>,
    /// Frames that are missing.
    pub missing: Vec<Gap>,
    /// Rows, from 0, with the time of the row before.
    pub doubled: Vec<usize>,
    /// Rows, from 0, that are earlier than the row before.
    pub backwards: Vec<usize>,
    /// The standard deviation of the distances from the step, in steps.
    pub jitter: f64,
    /// What every time is rounded to, if that explains the jitter.
    pub rounded_to: Option<f64>,
    /// The frames a second that the step comes from, if it was rounded itself.
    pub rate: Option<f64>,
}

/// Frames that are missing between two rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// The first missing frame, counted as [`Sampling::frames`].
    pub first: u64,
    /// The last one.
    pub last: u64,
    /// The time of the row before the gap.
    pub after: f64,
    /// The time of the row behind it.
    pub before: f64,
}

/// Beyond this part of a step the distances are uneven, and missing frames cannot be found.
const UNEVEN: f64 = 0.2;

/// Beyond so many frames doubles do not count them one by one, and no clock has run so long.
const MOST_FRAMES: f64 = 9_007_199_254_740_992.0;

/// Finds the step of `times` (in seconds, NaN where there is none) and where it is not kept.
pub fn examine(times: &[f64]) -> Sampling {
    let mut examination = Examination::default();
    while !examination.advance(times) {}
    examination.sampling
}

/// The same in a few slices, each once or twice through all times: a million rows are no pause then.
#[derive(Clone, Debug, Default)]
pub struct Examination {
    stage: Stage,
    /// The rows that have a time, with their numbers.
    rows: Vec<(usize, f64)>,
    steps: Vec<f64>,
    typical: f64,
    /// The steps in whole frames.
    whole: Vec<f64>,
    /// The frame of each of the rows, counted from the first.
    frames: Vec<f64>,
    /// The time of that frame, by the straight line through all.
    start: f64,
    interval: f64,
    /// What has been found.
    pub sampling: Sampling,
}

/// What an examination does next.
#[derive(Clone, Copy, Debug, Default)]
enum Stage {
    #[default]
    Steps,
    Typical,
    Whole,
    Line,
    Order,
    Frames,
    Rounding,
}

impl Examination {
    /// Goes on with the times that it began with. Whether it has come to the end.
    pub fn advance(&mut self, times: &[f64]) -> bool {
        let next = match self.stage {
            Stage::Steps => {
                self.rows = times.iter().copied().enumerate().filter(|(_, time)| time.is_finite()).collect();
                self.steps = self.rows.windows(2).map(|pair| pair[1].1 - pair[0].1).collect();
                Some(Stage::Typical)
            }
            Stage::Typical => {
                self.typical = median(self.steps.iter().copied().filter(|step| *step > 0.0).collect());
                (self.rows.len() >= 3 && self.typical.is_finite()).then_some(Stage::Whole)
            }
            Stage::Whole => {
                let typical = self.typical;
                self.whole = self.steps.iter().map(|step| (step / typical).round()).collect();
                let mut at = 0.0;
                self.frames = std::iter::once(0.0)
                    .chain(self.whole.iter().map(|count| {
                        at += count;
                        at
                    }))
                    .collect();
                Some(Stage::Line)
            }
            Stage::Line => {
                let (start, interval) = line(&self.frames, &self.rows);
                self.start = start;
                let usual = interval > 0.5 * self.typical && interval < 2.0 * self.typical;
                self.interval = if usual { interval } else { self.typical };
                // By how much each step is off whole frames.
                let interval = self.interval;
                let off = |(step, count): (&f64, &f64)| step / interval - count;
                let sum: f64 = self.steps.iter().zip(&self.whole).map(off).map(|off| off * off).sum();
                self.sampling.jitter = (sum / self.steps.len() as f64).sqrt();
                Some(Stage::Order)
            }
            Stage::Order => {
                self.order();
                let countable = self.frames.iter().all(|frame| frame.abs() <= MOST_FRAMES);
                if self.sampling.jitter > UNEVEN || !countable {
                    self.uneven();
                    None
                } else {
                    Some(Stage::Frames)
                }
            }
            Stage::Frames => {
                self.count_frames(times.len());
                Some(Stage::Rounding)
            }
            Stage::Rounding => {
                let off = |((_, time), frame): (&(usize, f64), &f64)| (time - self.start - frame * self.interval).abs();
                let furthest = self.rows.iter().zip(&self.frames).map(off).fold(0.0, f64::max);
                let explains = |unit: &f64| furthest > 0.05 * unit && furthest < 0.75 * unit;
                self.sampling.rounded_to = last_decimal(&self.rows).filter(explains);
                self.sampling.rate = if self.sampling.jitter < 1e-6 { rounded_rate(self.interval) } else { None };
                None
            }
        };
        self.stage = next.unwrap_or_default();
        next.is_none()
    }

    /// Rows at the time of the row before, or earlier.
    fn order(&mut self) {
        for (pair, step) in self.rows.windows(2).zip(&self.steps) {
            if step.abs() < 1e-6 * self.typical {
                self.sampling.doubled.push(pair[1].0);
            } else if *step < 0.0 {
                self.sampling.backwards.push(pair[1].0);
            }
        }
    }

    /// What is known of rows that keep no step.
    fn uneven(&mut self) {
        let forward: Vec<f64> = self.steps.iter().copied().filter(|step| *step > 0.0).collect();
        let mean = forward.iter().sum::<f64>() / forward.len() as f64;
        let variance = forward.iter().map(|step| (step - mean) * (step - mean)).sum::<f64>() / forward.len() as f64;
        self.sampling.interval = mean;
        self.sampling.jitter = variance.sqrt() / mean;
    }

    /// The frame of each row, and the frames that are missing.
    fn count_frames(&mut self, length: usize) {
        let (sampling, interval) = (&mut self.sampling, self.interval);
        sampling.interval = interval;
        // Frames count from time 0 if the first row lies on one.
        let first = self.start / interval;
        let base = if (first - first.round()).abs() < 0.05 && first.abs() < 1e9 { first.round() } else { 0.0 };
        sampling.frames = vec![None; length];
        for ((row, _), frame) in self.rows.iter().zip(&self.frames) {
            sampling.frames[*row] = Some((frame + base) as i64);
        }
        for ((pair, count), frame) in self.rows.windows(2).zip(&self.whole).zip(&self.frames) {
            if *count > 1.0 {
                let (first, last) = (frame + base + 1.0, frame + base + count - 1.0);
                sampling.missing.push(Gap {
                    first: first.max(0.0) as u64,
                    last: last.max(0.0) as u64,
                    after: pair[0].1,
                    before: pair[1].1,
                });
            }
        }
    }
}

/// The straight line through times over frames.
fn line(frames: &[f64], rows: &[(usize, f64)]) -> (f64, f64) {
    let count = rows.len() as f64;
    let mean_frame = frames.iter().sum::<f64>() / count;
    let mean_time = rows.iter().map(|(_, time)| time).sum::<f64>() / count;
    let (mut product, mut square) = (0.0, 0.0);
    for (frame, (_, time)) in frames.iter().zip(rows) {
        product += (frame - mean_frame) * (time - mean_time);
        square += (frame - mean_frame) * (frame - mean_frame);
    }
    let slope = product / square;
    (mean_time - slope * mean_frame, slope)
}

/// The coarsest decimal unit, down to a nanosecond, of which all times are multiples.
fn last_decimal(rows: &[(usize, f64)]) -> Option<f64> {
    const UNITS: [f64; 10] = [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9];
    let stride = rows.len().div_ceil(500);
    let is_multiple = |time: f64, inverse: f64| {
        let units = time * inverse;
        (units - units.round()).abs() <= 1e-12 * units.abs().max(1.0)
    };
    let fits = |inverse: &&f64| rows.iter().step_by(stride).all(|(_, time)| is_multiple(*time, **inverse));
    UNITS.iter().find(fits).map(|inverse| 1.0 / inverse)
}

/// The camera's rate, if the step is its inverse rounded (or cut off) to at least three decimals.
fn rounded_rate(interval: f64) -> Option<f64> {
    RATES.into_iter().find(|rate| {
        let exact = 1.0 / rate;
        let off = (interval / exact - 1.0).abs();
        let decimals = [1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9];
        off > 1e-9
            && off < 0.011
            && decimals.iter().any(|unit| {
                let cases = [(exact * unit).round(), (exact * unit).floor()];
                cases.iter().any(|case| (interval * unit - case).abs() < 1e-6 * case)
            })
    })
}

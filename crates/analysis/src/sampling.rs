//! Sampling of a measurement: the time steps between its rows.

use units::order::median;

/// Frame rates of cameras whose step is not a short decimal, 1/s.
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

/// Sampling of a record. Times are in the unit passed to [`examine`]: s for a clock.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sampling {
    /// Typical time between two rows: the slope of the times over the frames, or the mean step of uneven rows. 0 for fewer
    /// than three rows.
    pub interval: f64,
    /// Frame of each row, counted from time 0 if the first row is not before it and the frames agree with that, else from
    /// the first row; `None` without a time. Empty if the rows are not evenly spaced.
    pub frames: Vec<Option<i64>>,
    /// Missing frames.
    pub missing: Vec<Gap>,
    /// Rows, from 0, with the same time as the row before.
    pub doubled: Vec<usize>,
    /// Rows, from 0, with an earlier time than the row before.
    pub backwards: Vec<usize>,
    /// Standard deviation of the steps from whole multiples of the interval, or from their mean for uneven rows, in
    /// intervals.
    pub jitter: f64,
    /// Rounding unit of all times, if it explains the jitter.
    pub rounded_to: Option<f64>,
    /// Frame rate, 1/s, of which the step is the rounded inverse; `None` if it is not.
    pub rate: Option<f64>,
}

/// Missing frames between two rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// First missing frame, counted as in [`Sampling::frames`].
    pub first: u64,
    /// Last missing frame.
    pub last: u64,
    /// Time of the row before the gap.
    pub after: f64,
    /// Time of the row after the gap.
    pub before: f64,
}

/// Jitter, in intervals, beyond which rows are uneven and missing frames cannot be found.
const UNEVEN: f64 = 0.2;

/// Largest frame number that a double counts exactly.
const MOST_FRAMES: f64 = 9_007_199_254_740_992.0;

/// Determines the sampling of `times`, s, with NaN for gaps.
pub fn examine(times: &[f64]) -> Sampling {
    let mut examination = Examination::default();
    while !examination.advance(times) {}
    examination.sampling
}

/// Examination in a few slices, each with one or two passes over all times, so that a million rows do not block the page.
#[derive(Clone, Debug, Default)]
pub struct Examination {
    stage: Stage,
    /// Rows with a time: (index, time).
    rows: Vec<(usize, f64)>,
    steps: Vec<f64>,
    typical: f64,
    /// Steps in whole frames.
    whole: Vec<f64>,
    /// Frame of each of the rows, counted from the first.
    frames: Vec<f64>,
    /// Time of the first frame, from the straight line through all rows.
    start: f64,
    interval: f64,
    /// Result.
    pub sampling: Sampling,
}

/// Next step of an examination.
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
    /// Continues with the times given at the start. Returns true at the end.
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
                // Deviation of each step from whole frames.
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

    /// Finds rows with the time of the row before, or an earlier one.
    fn order(&mut self) {
        for (pair, step) in self.rows.windows(2).zip(&self.steps) {
            if step.abs() < 1e-6 * self.typical {
                self.sampling.doubled.push(pair[1].0);
            } else if *step < 0.0 {
                self.sampling.backwards.push(pair[1].0);
            }
        }
    }

    /// Interval and jitter of rows that are not evenly spaced.
    fn uneven(&mut self) {
        let forward: Vec<f64> = self.steps.iter().copied().filter(|step| *step > 0.0).collect();
        let mean = forward.iter().sum::<f64>() / forward.len() as f64;
        let variance = forward.iter().map(|step| (step - mean) * (step - mean)).sum::<f64>() / forward.len() as f64;
        self.sampling.interval = mean;
        self.sampling.jitter = variance.sqrt() / mean;
    }

    /// Numbers the frames of all rows, and finds the missing frames.
    fn count_frames(&mut self, length: usize) {
        let (sampling, interval) = (&mut self.sampling, self.interval);
        sampling.interval = interval;
        // Frames count from time 0 if that is a whole number of frames before the first row.
        let first = self.start / interval;
        let base =
            if (first - first.round()).abs() < 0.05 && (0.0..1e9).contains(&first) { first.round() } else { 0.0 };
        sampling.frames = vec![None; length];
        for ((row, _), frame) in self.rows.iter().zip(&self.frames) {
            sampling.frames[*row] = Some((frame + base) as i64);
        }
        for ((pair, count), frame) in self.rows.windows(2).zip(&self.whole).zip(&self.frames) {
            if *count > 1.0 {
                let before = frame + base;
                sampling.missing.push(Gap {
                    first: (before + 1.0) as u64,
                    last: (before + count - 1.0) as u64,
                    after: pair[0].1,
                    before: pair[1].1,
                });
            }
        }
    }
}

/// Intercept and slope of the straight line through times over frames.
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

/// Coarsest decimal unit, down to a nanosecond, of which all times are multiples.
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

/// Frame rate of a camera, 1/s, if the step is its inverse rounded or truncated to at least three decimals.
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

//! Statistics of the intervals between frames.

use super::finding::Finding;
use units::order::middle;

/// Minimum length of a gap, relative to the larger median of the intervals before and after.
const GAP: f64 = 1.5;
/// Number of intervals on each side for that median.
const AROUND: usize = 5;
/// Above this share of gaps, the film counts as irregular and has none.
const MOST_GAPS: f64 = 0.2;
/// Times closer than this, relative to the median interval, are equal.
const SAME: f64 = 0.02;
/// Minimum spread of a variable rate, relative to the mean interval; and in s, beyond the effect of rounding to
/// milliseconds.
const VARIABLE: f64 = 0.05;
const ROUNDING: f64 = 0.6e-3;
/// Number of gaps that are listed one by one.
const LISTED_GAPS: usize = 5;

/// Gap: missing frames.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// Index of the frame before the gap, in order of presentation.
    pub after: usize,
    /// Time of that frame, s.
    pub time: f64,
    /// Number of missing frames, by the intervals around.
    pub missing: usize,
}

/// Statistics of the frame times of a film.
#[derive(Clone, Debug, PartialEq)]
pub struct Intervals {
    /// Frames per second: reciprocal of the mean interval, without gaps and doubled times.
    pub rate: f64,
    /// Standard deviation of these intervals, s.
    pub spread: f64,
    /// Shortest and longest of these intervals, s.
    pub range: [f64; 2],
    /// Gaps, in order.
    pub gaps: Vec<Gap>,
    /// Indices of frames with the same time as the frame before.
    pub doubled: Vec<usize>,
    /// Time of the first doubled frame, s; 0 without one.
    doubled_at: f64,
    /// True if all times are whole milliseconds and the intervals differ only because of that.
    pub rounded: bool,
}

impl Intervals {
    /// Examines ascending times in s. `None` if fewer than two of them differ.
    pub fn of(times: &[f64]) -> Option<Self> {
        let all: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let positive: Vec<f64> = all.iter().copied().filter(|&interval| interval > 0.0).collect();
        if positive.is_empty() {
            return None;
        }
        let usual = middle(positive);
        let doubled: Vec<usize> = (1..times.len()).filter(|&at| all[at - 1] <= SAME * usual).collect();
        // Index of the frame and duration, without doubled times.
        let lasting: Vec<(usize, f64)> =
            all.iter().copied().enumerate().filter(|&(_, interval)| interval > SAME * usual).collect();
        let gaps = gaps(&lasting, times);
        let is_gap = |at: usize| gaps.binary_search_by_key(&at, |gap| gap.after).is_ok();
        let regular: Vec<f64> = lasting.iter().filter(|&&(at, _)| !is_gap(at)).map(|&(_, interval)| interval).collect();
        let count = regular.len() as f64;
        let mean = regular.iter().sum::<f64>() / count;
        if !(mean.is_finite() && mean > 0.0) {
            return None;
        }
        let squares: f64 = regular.iter().map(|interval| (interval - mean) * (interval - mean)).sum();
        let range = regular
            .iter()
            .fold([f64::INFINITY, 0.0_f64], |[low, high], &interval| [low.min(interval), high.max(interval)]);
        let whole = times.iter().all(|time| (time * 1e3 - (time * 1e3).round()).abs() < 1e-4);
        Some(Self {
            rate: 1.0 / mean,
            spread: if regular.len() < 2 { 0.0 } else { (squares / (count - 1.0)).sqrt() },
            range,
            gaps,
            doubled_at: doubled.first().map_or(0.0, |&at| times[at]),
            doubled,
            rounded: whole && range[1] - range[0] > 0.5e-3 && range[1] - range[0] < 1.5e-3,
        })
    }

    /// True if the frame rate changes during the film.
    pub fn is_variable(&self) -> bool {
        self.spread > VARIABLE / self.rate && self.spread > ROUNDING
    }

    /// Findings for the user. `stated_rate`: frames per second stated by the container, if any.
    pub fn findings(&self, stated_rate: Option<f64>) -> Vec<Finding> {
        let mut findings = vec![if self.is_variable() {
            Finding::Variable { rate: self.rate, slowest: 1.0 / self.range[1], fastest: 1.0 / self.range[0] }
        } else {
            Finding::Rate { rate: self.rate, spread: self.spread }
        }];
        if self.rounded {
            findings.push(Finding::Rounded);
        }
        findings.extend(
            self.gaps.iter().take(LISTED_GAPS).map(|gap| Finding::Gap { missing: gap.missing, time: gap.time }),
        );
        if let Some(more) = self.gaps.get(LISTED_GAPS..).filter(|more| !more.is_empty()) {
            findings.push(Finding::MoreGaps { gaps: more.len(), missing: more.iter().map(|gap| gap.missing).sum() });
        }
        if !self.doubled.is_empty() {
            findings.push(Finding::Doubled { count: self.doubled.len(), time: self.doubled_at });
        }
        // Converted films often state another rate than their times have.
        if let Some(stated) = stated_rate.filter(|stated| (stated / self.rate - 1.0).abs() > 0.01) {
            findings.push(Finding::Stated { stated, measured: self.rate });
        }
        findings
    }
}

/// Gaps among intervals, which are pairs of the index of the frame before and the duration in s.
fn gaps(intervals: &[(usize, f64)], times: &[f64]) -> Vec<Gap> {
    let usual = |part: &[(usize, f64)]| middle(part.iter().map(|&(_, interval)| interval).collect());
    let found: Vec<Gap> = (0..intervals.len())
        .filter_map(|at| {
            let before = usual(&intervals[at.saturating_sub(AROUND)..at]);
            let behind = usual(&intervals[at + 1..intervals.len().min(at + 1 + AROUND)]);
            // The greater one, of which one is not a number at an end.
            let usual = before.max(behind);
            let (after, interval) = intervals[at];
            let missing = (interval / usual).round() - 1.0;
            (interval > GAP * usual).then_some(Gap { after, time: times[after], missing: missing as usize })
        })
        .collect();
    if found.len() as f64 > MOST_GAPS * intervals.len() as f64 { Vec::new() } else { found }
}

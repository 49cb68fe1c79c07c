//! Histograms of the members of a family at the moment shown, or of a quantity over the run so far. The bin width
//! follows the rule of D. Freedman and P. Diaconis, *On the histogram as a density estimator: L2 theory*, Z.
//! Wahrscheinlichkeitstheorie verw. Gebiete 57 (1981) 453: twice the interquartile range divided by the cube root of
//! the number of values. If that range is 0, the number of bins is the square root of the number of values. Widths are
//! rounded to 1, 2 or 5 times a power of ten, and the edges are multiples of the width, so that bins seldom change.

use super::members::Snapshot;
use crate::time::course::Course;
use figure::Interval;
use program::{Model, NodeId, Plot};
use units::Unit;
use units::number::{leading_exponent, scaled_by};
use units::order::sort_numbers;

/// Maximum number of bins.
const MOST_BINS: f64 = 200.0;
/// The quartiles are computed from about this many values, evenly thinned.
const FOR_QUARTILES: usize = 50_000;
/// Minimum of the upper end of the vertical axis, a count.
const LEAST_COUNT: f64 = 5.0;

/// Bars of one plot.
#[derive(Debug)]
pub(crate) struct Histogram {
    members: Option<Snapshot>,
    /// True if the values are integers.
    whole: bool,
    bins: Bins,
    /// Horizontal extent of the bars of the run so far, and the height of the highest bar shown so far.
    reached: Interval,
    highest: f64,
    /// Number of rows up to the moment shown and number of all rows, at the last update.
    counted: (usize, usize),
}

/// Bins of equal width.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Bins {
    /// Centres of the bins, ascending.
    pub middles: Vec<f64>,
    /// Number of values in each bin.
    pub counts: Vec<f64>,
    /// Width of a bin.
    pub width: f64,
}

impl Histogram {
    /// Histogram of these members at the moment shown, or, if `members` is empty, of the plot's curve over the run.
    pub fn new(model: &Model, plot: &Plot, members: &[NodeId]) -> Self {
        let unit: &Unit = &plot.x.value.unit;
        let whole =
            unit.factor == 1.0 && model.whole_numbers().get(plot.x.value.node.0 as usize).copied().unwrap_or(false);
        Self {
            members: (!members.is_empty()).then(|| Snapshot::of_values(model, members, unit)),
            whole,
            bins: Bins::default(),
            reached: Interval { low: 0.0, high: 1.0 },
            highest: LEAST_COUNT,
            counted: (0, 0),
        }
    }

    /// Present bins.
    pub fn bins(&self) -> &Bins {
        &self.bins
    }

    /// Interval shown on the horizontal axis.
    pub fn across(&self) -> Interval {
        self.reached
    }

    /// Interval shown on the vertical axis.
    pub fn along(&self) -> Interval {
        Interval { low: 0.0, high: self.highest }
    }

    /// Discards all counts.
    pub fn forget(&mut self) {
        (self.counted, self.highest) = ((0, 0), LEAST_COUNT);
        self.members.iter_mut().for_each(Snapshot::forget);
    }

    /// Updates the bins to the moment shown. `traces` are the values of the curve, one per row of the run.
    pub fn follow(&mut self, course: &Course, traces: &[f64]) {
        if course.rows() < 2 {
            self.highest = LEAST_COUNT;
        }
        let ends = match &mut self.members {
            Some(members) => {
                members.follow(course);
                self.bins = Bins::of(members.column(0), self.whole);
                members.reached(0)
            }
            None => {
                let shown = course.rows_until_shown().min(traces.len());
                if self.counted == (shown, traces.len()) && shown > 1 {
                    return;
                }
                self.counted = (shown, traces.len());
                self.bins = Bins::of(traces.get(..shown).unwrap_or_default(), self.whole);
                let finite = traces.iter().copied().filter(|value| value.is_finite());
                finite.fold(None, |ends: Option<Interval>, value| {
                    let ends = ends.unwrap_or(Interval { low: value, high: value });
                    Some(Interval { low: ends.low.min(value), high: ends.high.max(value) })
                })
            }
        };
        self.highest = self.bins.counts.iter().copied().fold(self.highest, f64::max);
        let edges = self.bins.edges();
        let ends = [ends, edges].into_iter().flatten();
        let both =
            |one: Interval, other: Interval| Interval { low: one.low.min(other.low), high: one.high.max(other.high) };
        self.reached = ends.reduce(both).unwrap_or(Interval { low: 0.0, high: 1.0 });
    }
}

impl Bins {
    /// Bins for these values; integers lie at the centres of their bins.
    pub fn of(values: &[f64], whole: bool) -> Self {
        let finite = || values.iter().copied().filter(|value| value.is_finite());
        let count = finite().count();
        let (low, high) =
            finite().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        let range = high - low;
        if count == 0 || !range.is_finite() {
            return Self::default();
        }
        let number = count as f64;
        let spread = quartiles(finite().step_by(1 + count / FOR_QUARTILES).collect());
        let mut width = 2.0 * spread / libm::cbrt(number);
        if width <= 0.0 {
            width = range / number.sqrt().ceil();
        }
        // Narrower bins could be distinguished neither by eye nor in double precision.
        let magnitude = low.abs().max(high.abs());
        width = width.max(range / MOST_BINS).max(1e-9 * magnitude);
        width = if width > 0.0 { rounded(width) } else { 1.0 };
        if whole {
            width = width.max(1.0);
        }
        while range / width > MOST_BINS {
            width = rounded(2.0 * width);
        }
        let offset = if whole { -0.5 } else { 0.0 };
        let first = ((low - offset) / width).floor();
        let bin = |value: f64| (((value - offset) / width).floor() - first) as usize;
        let mut counts = vec![0.0; bin(high) + 1];
        for value in finite() {
            if let Some(count) = counts.get_mut(bin(value)) {
                *count += 1.0;
            }
        }
        let middles = (0..counts.len()).map(|number| offset + (first + number as f64 + 0.5) * width).collect();
        Self { middles, counts, width }
    }

    /// Lower edge of the first and upper edge of the last bin; `None` without bins.
    fn edges(&self) -> Option<Interval> {
        let (first, last) = (self.middles.first()?, self.middles.last()?);
        Some(Interval { low: first - self.width / 2.0, high: last + self.width / 2.0 })
    }
}

/// Interquartile range; each quartile is interpolated linearly between adjacent values.
fn quartiles(mut values: Vec<f64>) -> f64 {
    sort_numbers(&mut values);
    let last = values.len().saturating_sub(1) as f64;
    let at = |part: f64| {
        let place = part * last;
        let (before, fraction) = (place.floor(), place - place.floor());
        let value = |place: f64| values.get(place as usize).copied().unwrap_or(f64::NAN);
        value(before) + if fraction > 0.0 { fraction * (value(before + 1.0) - value(before)) } else { 0.0 }
    };
    at(0.75) - at(0.25)
}

/// Rounds to the nearest of 1, 2 and 5 times a power of ten, by ratio.
fn rounded(width: f64) -> f64 {
    let power = scaled_by(1.0, leading_exponent(width));
    let mantissa = width / power;
    // The boundary between two candidates is the square root of their product.
    let round = [(1.0, 2.0), (2.0, 10.0), (5.0, 50.0)].into_iter().find(|(_, product)| mantissa * mantissa < *product);
    round.map_or(10.0, |(round, _)| round) * power
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bins_are_as_wide_as_freedman_and_diaconis_say() {
        // 1000 values evenly from 0 to 1: the interquartile range is 1/2, the rule gives 2 (1/2)/10 = 0.1.
        let even: Vec<f64> = (0..1000).map(|number| (f64::from(number) + 0.5) / 1000.0).collect();
        let bins = Bins::of(&even, false);
        assert!((bins.width - 0.1).abs() < 1e-12);
        assert_eq!(bins.counts, [100.0; 10]);
        assert!((bins.middles[0] - 0.05).abs() < 1e-12 && (bins.middles[9] - 0.95).abs() < 1e-12);
        // A single value far away changes the number of bins, not their width; all values are counted.
        let mut outlier = even.clone();
        outlier.push(3.0);
        let bins = Bins::of(&outlier, false);
        assert!((bins.width - 0.1).abs() < 1e-12);
        assert_eq!((bins.counts.len(), bins.counts.iter().sum::<f64>()), (31, 1001.0));
    }

    #[test]
    fn equal_values_and_whole_numbers_have_bins() {
        assert_eq!(Bins::of(&[], false), Bins::default());
        assert_eq!(Bins::of(&[f64::NAN, f64::INFINITY], false), Bins::default());
        let bins = Bins::of(&[2.5, 2.5, 2.5], false);
        assert_eq!(bins.counts, [3.0]);
        assert_eq!(Bins::of(&[0.0], false).counts, [1.0]);
        // Half of the values are equal, so the quartiles are: the square root of 9 gives 3 bins on a range of 6.
        let bins = Bins::of(&[0.0, 3.0, 3.0, 3.0, 3.0, 3.0, 3.0, 3.0, 6.0], false);
        assert_eq!((bins.width, bins.counts.iter().sum::<f64>()), (2.0, 9.0));
        let dice = Bins::of(&[1.0, 2.0, 2.0, 3.0, 6.0], true);
        assert_eq!(
            dice.middles.iter().map(|middle| middle.fract()).sum::<f64>(),
            if dice.width == 1.0 { 0.0 } else { 0.5 }
        );
        let wide = Bins::of(&[0.0, 1e-30, 1e30], false);
        assert!(wide.counts.len() <= 202 && wide.counts.iter().sum::<f64>() == 3.0);
    }

    #[test]
    fn widths_are_round() {
        for (width, expected) in
            [(1.0, 1.0), (1.3, 1.0), (1.5, 2.0), (3.0, 2.0), (3.3, 5.0), (7.0, 5.0), (7.2, 10.0), (0.03, 0.02)]
        {
            assert!((rounded(width) / expected - 1.0).abs() < 1e-12, "{width}: {}", rounded(width));
        }
    }
}

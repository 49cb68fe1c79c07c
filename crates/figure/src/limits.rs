//! Automatic limits: round numbers that contain the data and change only in steps while the data grow.

use crate::plot::Interval;
use crate::ticks::Step;
use units::number::{leading_exponent, scaled_by};

/// Greatest magnitude that is drawn; sums and differences of smaller values stay finite.
const LARGEST: f64 = 1e300;

/// Minimum length of an interval: `SMALLEST`, or `FINEST` times the magnitude of its values, where double precision ends.
const SMALLEST: f64 = 1e-290;
const FINEST: f64 = 1e-11;

/// True if a value can be drawn: finite and not too large.
pub(crate) fn drawable(value: f64) -> bool {
    value.abs() <= LARGEST
}

/// Range of a set of values, and whether they oscillate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Extent {
    pub(crate) low: f64,
    pub(crate) high: f64,
    /// True if the values both rise and fall; only determined where it matters for [`Extent::close_up`].
    pub(crate) turned: bool,
}

impl Extent {
    /// Extent of an empty set.
    pub(crate) const EMPTY: Extent = Extent { low: f64::INFINITY, high: f64::NEG_INFINITY, turned: false };

    /// Extent of the drawable values of a column.
    pub(crate) fn of(column: &[f64]) -> Extent {
        // Runs over every row in every frame, so it uses only comparisons; they are false for NaN.
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for &value in column {
            low = if value < low && value >= -LARGEST { value } else { low };
            high = if value > high && value <= LARGEST { value } else { high };
        }
        // Values too large on one side must not count on the other.
        low = if low > LARGEST { f64::INFINITY } else { low };
        high = if high < -LARGEST { f64::NEG_INFINITY } else { high };
        let mut extent = Extent { low, high, turned: true };
        extent.turned = extent.close_up() && turns(column);
        extent
    }

    /// Extent of an ascending column, from its first and last drawable value.
    pub(crate) fn of_ordered(column: &[f64]) -> Extent {
        let first = column.iter().copied().find(|value| drawable(*value));
        let last = column.iter().rev().copied().find(|value| drawable(*value));
        match (first, last) {
            (Some(low), Some(high)) => Extent { low: low.min(high), high: high.max(low), turned: false },
            _ => Extent::EMPTY,
        }
    }

    /// Extent of both sets together.
    pub(crate) fn union(self, other: Extent) -> Extent {
        Extent { low: self.low.min(other.low), high: self.high.max(other.high), turned: self.turned || other.turned }
    }

    /// Extent of the set and an interval.
    pub(crate) fn with(self, interval: Option<Interval>) -> Extent {
        match interval {
            Some(Interval { low, high }) if drawable(low) && drawable(high) => {
                self.union(Extent { low: low.min(high), high: high.max(low), turned: false })
            }
            _ => self,
        }
    }

    /// True if an interval contains all values.
    pub(crate) fn is_within(self, interval: Interval) -> bool {
        self.low >= interval.low && self.high <= interval.high
    }

    fn is_empty(self) -> bool {
        self.low > self.high
    }

    /// True if the axis should show the values without zero: an oscillation about a value far from zero. A run that has
    /// just begun (not yet oscillating) and rounding errors of a constant do not count.
    fn close_up(self) -> bool {
        let (length, magnitude) = (self.high - self.low, self.high.abs().max(self.low.abs()));
        (self.low > 0.0 || self.high < 0.0) && self.turned && length < 0.3 * magnitude && length > 1e-4 * magnitude
    }
}

/// Extent of a growing column; each value is examined only once.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Progressive {
    seen: usize,
    low: f64,
    high: f64,
    rises: bool,
    falls: bool,
    previous: f64,
}

impl Default for Progressive {
    fn default() -> Self {
        Self { seen: 0, low: f64::INFINITY, high: f64::NEG_INFINITY, rises: false, falls: false, previous: f64::NAN }
    }
}

impl Progressive {
    /// Extent of the column, which must begin with the values of the last call.
    pub(crate) fn of(&mut self, column: &[f64]) -> Extent {
        for &value in column.get(self.seen..).unwrap_or_default() {
            if drawable(value) {
                if value < self.low {
                    self.low = value;
                }
                if value > self.high {
                    self.high = value;
                }
                self.rises |= value > self.previous;
                self.falls |= value < self.previous;
                self.previous = value;
            }
        }
        self.seen = self.seen.max(column.len());
        let mut extent = Extent { low: self.low, high: self.high, turned: true };
        extent.turned = extent.close_up() && self.rises && self.falls;
        extent
    }
}

/// True if the drawable values of a column both rise and fall.
fn turns(column: &[f64]) -> bool {
    let (mut rises, mut falls) = (false, false);
    let mut previous = f64::NAN;
    for &value in column.iter().filter(|value| drawable(**value)) {
        rises |= value > previous;
        falls |= value < previous;
        previous = value;
        if rises && falls {
            return true;
        }
    }
    false
}

/// The nearest drawable interval: finite, and long enough for double precision to separate its pixels.
pub(crate) fn sane(interval: Interval) -> Interval {
    let clamp = |value: f64| {
        if value.is_nan() { 0.0 } else { value.clamp(-LARGEST, LARGEST) }
    };
    let Interval { low, high } = Interval::new(clamp(interval.low), clamp(interval.high));
    let shortest = SMALLEST.max(FINEST * low.abs().max(high.abs()));
    if high - low >= shortest {
        return Interval { low, high };
    }
    let middle = (low / 2.0 + high / 2.0).clamp(-LARGEST + shortest, LARGEST - shortest);
    Interval { low: middle - shortest, high: middle + shortest }
}

/// Limits of an axis with ascending data, such as time: from the start of the data (or zero if that is near) to the next
/// round number, so that they change only a few times while the data grow tenfold.
pub(crate) fn growing(extent: Extent) -> Interval {
    const ROUND: [f64; 9] = [1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0];
    if extent.is_empty() {
        return Interval { low: 0.0, high: 1.0 };
    }
    let Extent { low, high, .. } = extent;
    if low >= 0.0 && low <= 0.25 * high && high > SMALLEST {
        let power = scaled_by(1.0, leading_exponent(high));
        let mantissa = high / power;
        let round = ROUND.iter().copied().find(|round| *round >= mantissa * (1.0 - 1e-9)).unwrap_or(10.0);
        return sane(Interval { low: 0.0, high: round * power });
    }
    if high - low <= SMALLEST.max(FINEST * high.abs().max(low.abs())) {
        return around(low, high);
    }
    let step = Step::at_least((high - low) / 10.0);
    sane(Interval { low: step.multiple(step.floor(low)), high: step.multiple(step.ceil(high)) })
}

/// Automatic limits with the step between ticks from which they were made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Limits {
    pub(crate) values: Interval,
    pub(crate) step: Step,
}

/// Limits of the vertical axes of a panel, with at most `intervals` intervals between ticks. If all show zero, it is at the
/// same height, and one grid fits all.
pub(crate) fn shared_limits(extents: &[Extent], intervals: usize) -> Vec<Limits> {
    let intervals = intervals.max(2);
    if extents.iter().any(|extent| extent.close_up()) {
        let alone = |extent: &Extent| {
            if extent.close_up() {
                vec![close_up_limits(*extent, intervals)]
            } else {
                about_zero(&[need(*extent)], intervals)
            }
        };
        return extents.iter().flat_map(alone).collect();
    }
    let needs: Vec<(f64, f64)> = extents.iter().map(|extent| need(*extent)).collect();
    about_zero(&needs, intervals)
}

/// Limits that include zero, at the same height for all axes.
fn about_zero(needs: &[(f64, f64)], intervals: usize) -> Vec<Limits> {
    let (below, above) = split(needs, intervals);
    let limits = |need: &(f64, f64)| {
        let step = step_for(*need, below, above);
        let low = step.multiple(-(below as i64));
        let high = step.multiple(above as i64);
        Limits { values: sane(Interval { low, high }), step }
    };
    needs.iter().map(limits).collect()
}

/// Limits close to values far from zero.
fn close_up_limits(extent: Extent, intervals: usize) -> Limits {
    let mut step = Step::at_least((extent.high - extent.low) / intervals as f64);
    while step.ceil(extent.high) - step.floor(extent.low) > intervals as i64 {
        step = step.larger();
    }
    let low = step.multiple(step.floor(extent.low));
    let high = step.multiple(step.ceil(extent.high));
    Limits { values: sane(Interval { low, high }), step }
}

/// Distances that an axis must extend below and above zero.
fn need(extent: Extent) -> (f64, f64) {
    if extent.is_empty() || extent.low.abs().max(extent.high.abs()) < SMALLEST {
        return (1.0, 1.0);
    }
    ((-extent.low).max(0.0), extent.high.max(0.0))
}

/// Smallest step with which `below` and `above` intervals reach far enough.
fn step_for((low, high): (f64, f64), below: usize, above: usize) -> Step {
    let down = if below == 0 { 0.0 } else { low / below as f64 };
    let up = if above == 0 { 0.0 } else { high / above as f64 };
    Step::at_least(down.max(up).max(SMALLEST))
}

/// Numbers of intervals below and above zero that fill the panel best for all axes together.
fn split(needs: &[(f64, f64)], intervals: usize) -> (usize, usize) {
    let (any_below, any_above) = (needs.iter().any(|need| need.0 > 0.0), needs.iter().any(|need| need.1 > 0.0));
    let mut best = (usize::from(any_below), usize::from(any_above));
    let mut best_score = f64::NEG_INFINITY;
    for count in 2..=intervals {
        for below in usize::from(any_below)..=count - usize::from(any_above) {
            let above = count - below;
            if (below > 0 && !any_below) || (above > 0 && !any_above) {
                continue;
            }
            let fill: f64 = needs
                .iter()
                .map(|need| (need.0 + need.1) / (step_for(*need, below, above).multiple(1) * count as f64))
                .sum::<f64>()
                / needs.len() as f64;
            // Two intervals are hard to read; beyond four, more are no better.
            let score = fill * [1.0, 1.0, 0.8, 0.95][if count < 4 { count } else { 0 }];
            if score > best_score {
                (best, best_score) = ((below, above), score);
            }
        }
    }
    best
}

/// Limits for values that are nearly equal: from zero to twice the value, or from 0 to 1 for values near zero.
fn around(low: f64, high: f64) -> Interval {
    if high > SMALLEST {
        sane(Interval { low: 0.0, high: 2.0 * high })
    } else if low < -SMALLEST {
        sane(Interval { low: 2.0 * low, high: 0.0 })
    } else {
        Interval { low: 0.0, high: 1.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn extent(low: f64, high: f64, turned: bool) -> Extent {
        Extent { low, high, turned }
    }

    #[test]
    fn limits_are_round_and_share_their_zero() {
        // Extents of the axes, expected limits.
        type Case<'a> = (&'a [(f64, f64, bool)], &'a [(f64, f64)]);
        let cases: [Case<'_>; 11] = [
            (&[(-0.43, 0.5, true)], &[(-0.6, 0.6)]),
            (&[(-0.43, 0.5, true), (-0.8, 0.72, true)], &[(-0.5, 0.5), (-1.0, 1.0)]),
            (&[(0.0, 1715.0, true)], &[(0.0, 2000.0)]),
            (&[(9.8, 9.8, false)], &[(0.0, 10.0)]),
            (&[(-3.0, -3.0, false)], &[(-3.0, 0.0)]),
            (&[(0.0, 0.0, false)], &[(-1.0, 1.0)]),
            (&[(f64::INFINITY, f64::NEG_INFINITY, false)], &[(-1.0, 1.0)]),
            // An oscillation about a distance, and the same run just after its start.
            (&[(0.78, 0.82, true)], &[(0.78, 0.82)]),
            (&[(0.80, 0.82, false)], &[(0.0, 1.0)]),
            // Rounding errors of a constant are not shown close up.
            (&[(999.999_999, 1000.0, true)], &[(0.0, 1000.0)]),
            (&[(1.0, 1e300, true)], &[(0.0, 1e300)]),
        ];
        for (extents, expected) in cases {
            let extents: Vec<Extent> = extents.iter().map(|(low, high, turned)| extent(*low, *high, *turned)).collect();
            let found: Vec<(f64, f64)> =
                shared_limits(&extents, 6).iter().map(|limits| (limits.values.low, limits.values.high)).collect();
            assert_eq!(found, expected, "{extents:?}");
        }
    }

    #[test]
    fn time_grows_in_steps() {
        let cases = [
            ((0.0, 0.0), (0.0, 1.0)),
            ((0.0, 0.05), (0.0, 0.05)),
            ((0.0, 0.051), (0.0, 0.06)),
            ((0.0, 9.99), (0.0, 10.0)),
            ((0.0, 10.0), (0.0, 10.0)),
            ((0.0, 10.05), (0.0, 15.0)),
            ((0.0, 61.0), (0.0, 80.0)),
            ((0.34, 10.0), (0.0, 10.0)),
            ((100.2, 109.7), (100.0, 110.0)),
            ((-3.0, 4.2), (-3.0, 5.0)),
            ((7.0, 7.0), (0.0, 14.0)),
            ((0.0, 1e-300), (0.0, 1.0)),
            ((0.0, 9e299), (0.0, 1e300)),
        ];
        for ((low, high), expected) in cases {
            let limits = growing(extent(low, high, false));
            assert!(
                (limits.low - expected.0).abs() <= 1e-9 && (limits.high / expected.1 - 1.0).abs() < 1e-9,
                "{low}..{high} gives {limits:?}"
            );
        }
        assert_eq!(growing(Extent::EMPTY), Interval { low: 0.0, high: 1.0 });
    }

    #[test]
    fn a_growing_run_changes_its_limits_rarely() {
        let mut changes = 0;
        let mut before = growing(extent(0.0, 1.0, false));
        for step in 1000..100_000 {
            let limits = growing(extent(0.0, f64::from(step) * 0.001, false));
            assert!(limits.high * (1.0 + 1e-9) >= f64::from(step) * 0.001);
            assert!(limits.high >= before.high);
            changes += i32::from(limits != before);
            before = limits;
        }
        assert!(changes <= 17, "{changes} changes from 1 s to 100 s");
    }

    #[test]
    fn extents_leave_out_what_cannot_be_drawn() {
        let cases: [(&[f64], (f64, f64), bool); 5] = [
            (&[f64::NAN, 1.0, f64::INFINITY, 3.0, 2.0, -1e301], (1.0, 3.0), false),
            (&[2e300, -2e300, 7.0], (7.0, 7.0), false),
            (&[10.0, 10.4, f64::NAN, 10.1], (10.0, 10.4), true),
            (&[10.0, 10.2, 10.4], (10.0, 10.4), false),
            (&[2e300, f64::NAN], (f64::INFINITY, f64::NEG_INFINITY), false),
        ];
        for (column, (low, high), turned) in cases {
            assert_eq!(Extent::of(column), Extent { low, high, turned }, "{column:?}");
            let mut progressive = Progressive::default();
            for end in 0..=column.len() {
                assert_eq!(progressive.of(&column[..end]), Extent::of(&column[..end]), "{end} of {column:?}");
            }
        }
        assert_eq!(Extent::of(&[]), Extent::EMPTY);
        assert_eq!(Extent::of_ordered(&[f64::NAN, 1.0, 5.0, f64::NAN]), Extent { low: 1.0, high: 5.0, turned: false });
    }

    #[test]
    fn sane_intervals_are_long_enough() {
        for (low, high) in
            [(1.0, 1.0), (f64::NAN, 1.0), (f64::NEG_INFINITY, f64::INFINITY), (1e300, 1e300), (0.0, 0.0), (5.0, -5.0)]
        {
            let interval = sane(Interval { low, high });
            assert!(interval.length() > 0.0 && interval.length().is_finite(), "{low} {high} {interval:?}");
        }
    }
}

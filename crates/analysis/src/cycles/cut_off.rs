//! Values cut off at an end of the range of an instrument (clipping).

/// Values at an end of the range of the instrument; the true values lie beyond it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutOff {
    /// Number of rows left out.
    pub rows: usize,
    /// Lower end of the range, in the unit of the values; `None` if nothing was cut off there.
    pub low: Option<f64>,
    /// Upper end of the range, in the unit of the values; `None` if nothing was cut off there.
    pub high: Option<f64>,
}

/// Least number of consecutive rows, and of all rows, with the extreme value.
const LONGEST: usize = 3;
const FEWEST: usize = 5;
/// Least ratio of the rows at the end of the range to those of the next values inwards. At the extreme of a rounded
/// sinusoid, the greatest value has at most 1/(sqrt 2 - 1) = 2.4 times as many rows as the next one.
const CROWDED: usize = 4;
/// A signal with more than this part of its rows at its ends switches between two levels and is not cut off.
const SWITCHING: f64 = 0.6;

/// Rows that are not cut off, and the description of the others; `None` if nothing is cut off.
pub(super) fn without_limits(rows: Vec<(f64, f64)>) -> (Vec<(f64, f64)>, Option<CutOff>) {
    let values: Vec<f64> = rows.iter().map(|row| row.1).collect();
    let high = limit(&values);
    let low = limit(&values.iter().map(|value| -value).collect::<Vec<f64>>()).map(|value| -value);
    let is_cut = |value: f64| Some(value) == high || Some(value) == low;
    let count = values.iter().filter(|value| is_cut(**value)).count();
    if count == 0 || count as f64 > SWITCHING * values.len() as f64 {
        return (rows, None);
    }
    let left = rows.into_iter().filter(|row| !is_cut(row.1)).collect();
    (left, Some(CutOff { rows: count, low, high }))
}

/// Greatest value, if values beyond it were cut off.
fn limit(values: &[f64]) -> Option<f64> {
    let top = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let (mut count, mut run, mut longest) = (0, 0, 0);
    for value in values {
        run = if *value == top { run + 1 } else { 0 };
        count += usize::from(run > 0);
        longest = longest.max(run);
    }
    if longest < LONGEST || count < FEWEST {
        return None;
    }
    // The distance from the top to the next value is the step of rounding, if the values are rounded.
    let next = values.iter().copied().filter(|value| *value < top).fold(f64::NEG_INFINITY, f64::max);
    let beside = values.iter().filter(|value| **value < top && **value >= next - 0.5 * (top - next)).count();
    (count >= CROWDED * beside.max(1)).then_some(top)
}

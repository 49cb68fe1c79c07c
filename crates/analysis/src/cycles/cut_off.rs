//! Values cut off at an end of the range of an instrument.

/// Values that stand at an end of the range of the instrument. The true ones lie beyond it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutOff {
    /// How many rows were left out.
    pub rows: usize,
    /// The lower end of the range, in the unit of the values.
    pub low: Option<f64>,
    /// The upper end of the range.
    pub high: Option<f64>,
}

/// So many rows in a row have the same extreme value at least, and so many altogether.
const LONGEST: usize = 3;
const FEWEST: usize = 5;
/// The rows at the end of the range over those of the next values inwards. At the extreme of a rounded sinusoid, the greatest
/// value has at most 1/(sqrt 2 - 1) = 2.4 times as many rows as the next one.
const CROWDED: usize = 4;
/// A signal that is at its ends for a greater part of its rows switches between two levels.
const SWITCHING: f64 = 0.6;

/// The rows that are not cut off, and those that are; all rows where nothing is cut off.
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

/// The greatest value, if values beyond it were cut off.
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
    // The least step between values near the top: that of the rounding, if they are rounded.
    let next = values.iter().copied().filter(|value| *value < top).fold(f64::NEG_INFINITY, f64::max);
    let beside = values.iter().filter(|value| **value < top && **value >= next - 0.5 * (top - next)).count();
    (count >= CROWDED * beside.max(1)).then_some(top)
}

//! Roles indicated by the numbers of a column.

use crate::table::Column;

/// True if every number is greater than the one before, and there are at least two.
pub(super) fn increase(values: &[f64]) -> bool {
    in_order(values, |before, after| after > before)
}

/// True if the numbers strictly increase or strictly decrease.
pub(super) fn are_monotone(values: &[f64]) -> bool {
    increase(values) || in_order(values, |before, after| after < before)
}

/// True if the numbers are whole and each is one more than the one before.
pub(super) fn count(values: &[f64]) -> bool {
    in_order(values, |before, after| after == before + 1.0 && before.fract() == 0.0)
}

fn in_order(values: &[f64], holds: impl Fn(f64, f64) -> bool) -> bool {
    let mut finite = values.iter().copied().filter(|value| value.is_finite());
    let Some(mut before) = finite.next() else { return false };
    let mut steps = 0_usize;
    for value in finite {
        if !holds(before, value) {
            return false;
        }
        (before, steps) = (value, steps + 1);
    }
    steps > 0
}

/// True if there are several numbers, all equal.
pub(super) fn are_constant(values: &[f64]) -> bool {
    let mut finite = values.iter().copied().filter(|value| value.is_finite());
    let Some(first) = finite.next() else { return false };
    let mut others = 0_usize;
    finite.all(|value| {
        others += 1;
        value == first
    }) && others > 0
}

/// True if the numbers are whole, and at least half of them equal the one before, as those that count the starts of a
/// logger do.
pub(super) fn are_stairs(values: &[f64]) -> bool {
    let steps = || values.iter().zip(values.iter().skip(1)).filter(|(one, next)| one.is_finite() && next.is_finite());
    let level = steps().filter(|(one, next)| one == next).count();
    level > 0 && 2 * level >= steps().count() && are_whole(values)
}

/// True if all numbers are whole.
pub(super) fn are_whole(values: &[f64]) -> bool {
    values.iter().all(|value| value.is_nan() || value.fract() == 0.0)
}

/// True if there are at least five numbers, evenly spaced and increasing, like those of a clock.
pub(super) fn are_even(values: &[f64]) -> bool {
    const FEWEST: usize = 5;
    // Tolerance for rounded times, as a part of their step.
    const ROUNDED: f64 = 0.02;
    let filled = values.iter().rposition(|value| value.is_finite()).map_or(0, |last| last + 1);
    let Some((&first, &last)) = values.first().zip(filled.checked_sub(1).and_then(|last| values.get(last))) else {
        return false;
    };
    let step = (last - first) / (filled.max(2) - 1) as f64;
    let even = |(row, value): (usize, &f64)| (value - first - step * row as f64).abs() <= ROUNDED * step;
    filled >= FEWEST && step > 0.0 && values.iter().take(filled).enumerate().all(even)
}

/// True if a clock has a time in every row with a value.
pub(super) fn covers(clock: &[f64], values: &[f64]) -> bool {
    clock.iter().zip(values).all(|(time, value)| value.is_nan() || time.is_finite())
}

/// True if two columns have equal values in SI and the same gaps. A column without a unit has the unit of the other one.
pub(super) fn are_equal(one: &Column, other: &Column) -> bool {
    differ_by(one, other, |_| 0.0)
}

/// True if two columns differ by a constant in SI.
pub(super) fn are_parallel(one: &Column, other: &Column) -> bool {
    differ_by(one, other, |first| first)
}

/// True if the difference of two columns in SI is everywhere `expected` of the first difference.
fn differ_by(one: &Column, other: &Column, expected: impl Fn(f64) -> f64) -> bool {
    let (own, its) = (one.unit.as_ref().or(other.unit.as_ref()), other.unit.as_ref().or(one.unit.as_ref()));
    let si = |unit: Option<&units::Unit>, value: f64| match (unit, own) {
        (Some(unit), Some(own)) => unit.to_si_of(value, own),
        _ => value,
    };
    let mut first = None;
    one.values.iter().zip(&other.values).all(|(a, b)| {
        let (a, b) = (si(own, *a), si(its, *b));
        let off = a - b - expected(*first.get_or_insert(a - b));
        a.is_nan() && b.is_nan() || off.abs() <= 1e-9 * a.abs().max(b.abs())
    })
}

//! Columns of times that programs count: serial days of spreadsheets, and counters that overflow.

use super::head::Head;
use super::rows::Rows;
use crate::origin::UnitOrigin;
use crate::roles;
use units::{Dimension, Unit};

/// Serial days of this century in a spreadsheet: 1954 to 2064.
const DAYS: std::ops::Range<f64> = 20_000.0..60_000.0;

/// True if a name is that of a date or a time stamp.
fn is_date(name: &str) -> bool {
    let name = name.to_lowercase();
    ["date", "datum", "fecha", "timestamp", "time stamp", "zeitstempel"].iter().any(|word| name.contains(word))
        || ["data", "data/hora", "data hora"].contains(&name.as_str())
}

/// Converts serial days of a spreadsheet to seconds from the first row. Returns the columns.
pub(super) fn serial_days(rows: &mut Rows, heads: &mut [Head]) -> Vec<usize> {
    let mut found = Vec::new();
    for (column, (head, values)) in heads.iter_mut().zip(&mut rows.columns).enumerate() {
        let numbers = || values.iter().copied().filter(|value| value.is_finite());
        let open = head.unit.is_none() && head.origin == UnitOrigin::default();
        let steps = || numbers().zip(numbers().skip(1)).map(|(before, after)| after - before);
        let increase = steps().all(|step| step >= 0.0) && steps().any(|step| step > 0.0 && step < 1.0);
        if !open || !is_date(&head.name) || !numbers().all(|value| DAYS.contains(&value)) || !increase {
            continue;
        }
        let Some(first) = numbers().next() else { continue };
        // Programs write days to nine decimals, 0.1 ms.
        values.iter_mut().for_each(|value| *value = ((*value - first) * 86_400.0 * 1e3).round() / 1e3);
        (head.unit, head.origin) = (Unit::parse("s").ok(), UnitOrigin::Clock);
        found.push(column);
    }
    found
}

/// Undoes the overflow of whole-numbered clocks at 2^16 or 2^32. Returns the columns, with the number of bits.
///
/// The clock falls from just below the power to just above zero, and the step across it is as small as the others.
pub(super) fn unwrap(rows: &mut Rows, heads: &[Head]) -> Vec<(usize, u32)> {
    let mut found = Vec::new();
    for (column, (head, values)) in heads.iter().zip(&mut rows.columns).enumerate() {
        let of_time = head.unit.as_ref().is_some_and(|unit| unit.dimension == Dimension::TIME);
        if !(of_time || roles::is_time(&head.name)) {
            continue;
        }
        let numbers: Vec<f64> = values.iter().copied().filter(|value| value.is_finite()).collect();
        let whole = numbers.iter().all(|value| value.fract() == 0.0 && *value >= 0.0);
        let (mut rises, mut falls): (Vec<f64>, Vec<(f64, f64)>) = (Vec::new(), Vec::new());
        for pair in numbers.windows(2) {
            if pair[1] >= pair[0] { rises.push(pair[1] - pair[0]) } else { falls.push((pair[0], pair[1])) }
        }
        rises.sort_by(f64::total_cmp);
        let Some(median) = rises.get(rises.len() / 2).copied().filter(|_| whole && !falls.is_empty()) else { continue };
        let crosses = |bits: &u32| {
            let turn = (1_u64 << *bits) as f64;
            falls.iter().all(|(before, after)| *before < turn && after + turn - before <= 3.0 * median.max(1.0))
        };
        let Some(bits) = [16, 32].into_iter().find(crosses) else { continue };
        let (mut added, mut before) = (0.0, f64::NEG_INFINITY);
        for value in values.iter_mut().filter(|value| value.is_finite()) {
            if *value < before {
                added += (1_u64 << bits) as f64;
            }
            before = *value;
            *value += added;
        }
        found.push((column, bits));
    }
    found
}

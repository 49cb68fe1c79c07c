//! Columns of serial days of spreadsheets.

use crate::import::head::Head;
use crate::import::rows::Rows;
use crate::origin::UnitOrigin;
use units::Unit;

/// Serial days of this century in a spreadsheet: 1954 to 2064.
const DAYS: std::ops::Range<f64> = 20_000.0..60_000.0;

/// True if a name is that of a date or a time stamp.
fn is_date(name: &str) -> bool {
    let name = name.to_lowercase();
    ["date", "datum", "fecha", "timestamp", "time stamp", "zeitstempel"].iter().any(|word| name.contains(word))
        || ["data", "data/hora", "data hora"].contains(&name.as_str())
}

/// Converts serial days of a spreadsheet to seconds from the first row. Returns the columns.
pub(in crate::import) fn to_seconds(rows: &mut Rows, heads: &mut [Head]) -> Vec<usize> {
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

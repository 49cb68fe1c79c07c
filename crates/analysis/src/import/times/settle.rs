//! Columns of times of day, or of numbers followed by a unit.

use super::clock::{self, Form, Reading, Times};
use super::date::Order;
use crate::finding::{Finding, Heading};
use crate::import::head::{self, Head, Meant};
use crate::import::rows::Rows;
use crate::origin::UnitOrigin;
use units::Unit;

/// Column of clock times, and their notation.
#[derive(Debug)]
pub(in crate::import) struct ClockColumn {
    pub column: usize,
    /// Notation of the first time.
    pub form: Form,
    pub times: Times,
}

/// Converts times and numbers with units to numbers, in columns that hold more of them than of plain numbers; elsewhere
/// they count as words. The unit is that of the cells, not that of the header.
pub(in crate::import) fn columns(rows: &mut Rows, heads: &mut [Head], findings: &mut Vec<Finding>) -> Vec<ClockColumn> {
    let mut clocks = Vec::new();
    for (column, head) in heads.iter_mut().enumerate().take(rows.columns.len()) {
        let Some(others) = rows.others_mut(column) else { continue };
        let (readings, with_units) = (std::mem::take(&mut others.clocks), std::mem::take(&mut others.with_units));
        let unit = others.unit.take();
        if readings.is_empty() && with_units.is_empty() {
            continue;
        }
        let numbers = rows.columns[column].iter().filter(|value| value.is_finite()).count();
        if readings.len() >= numbers.max(with_units.len()).max(1) {
            clocks.extend(take_clocks(rows, column, readings, head));
        } else if let Some((meant, text)) =
            common(unit, &head.name).filter(|(meant, _)| with_units.len() >= numbers || head.is_in(meant))
        {
            take_units(head, column, (meant, text), numbers, findings);
            rows.accept(column, with_units.into_iter(), false);
        } else if let Some(others) = rows.others_mut(column) {
            (others.clocks, others.with_units) = (readings, with_units);
        }
        rows.reject(column);
    }
    drop_dates(rows, &mut clocks);
    clocks
}

/// Unit common to all cells, and its text.
fn common(unit: Option<(String, bool)>, name: &str) -> Option<(Meant, String)> {
    unit.filter(|(_, same)| *same).and_then(|(text, _)| Some((head::meant_unit(&text, name)?, text)))
}

/// Gives a column the unit of its cells, and reports a different unit in the header or cells without a unit.
fn take_units(head: &mut Head, index: usize, (meant, text): (Meant, String), bare: usize, findings: &mut Vec<Finding>) {
    let column = if head.name.is_empty() { (index + 1).to_string() } else { head.name.clone() };
    let same = head.is_in(&meant);
    if !same && let Some(header) = head.unit.as_ref().map(|unit| unit.text.clone()).filter(|text| !text.is_empty()) {
        findings.push(Finding::Heading(Heading::CellUnit { column, header, cells: text.clone() }));
    } else if !same && bare > 0 {
        findings.push(Finding::Heading(Heading::BareNumbers { column, unit: text.clone(), count: bare }));
    }
    if !same && let Some(reading) = meant.reading {
        let column = if head.name.is_empty() { (index + 1).to_string() } else { head.name.clone() };
        findings.push(Finding::Heading(Heading::Unit { column, written: text.clone(), reading }));
    }
    head.take(meant, text, UnitOrigin::Cells);
}

fn take_clocks(
    rows: &mut Rows,
    column: usize,
    mut readings: Vec<(usize, Reading)>,
    head: &mut Head,
) -> Option<ClockColumn> {
    let form = readings.first()?.1.form;
    // A stopwatch shows `59.9` before `1:00.0`. Beside times of day a plain number is ignored.
    let stopwatch = readings.iter().all(|(_, reading)| matches!(reading.form, Form::Two | Form::Minutes));
    for (row, value) in rows.columns[column].iter_mut().enumerate() {
        if value.is_finite() {
            if stopwatch {
                readings.push((row, Reading { days: 0.0, seconds: *value, form: Form::Minutes, order: Order::Stated }));
            }
            *value = f64::NAN;
        }
    }
    readings.sort_by_key(|(row, _)| *row);
    let plain: Vec<Reading> = readings.iter().map(|(_, reading)| *reading).collect();
    let times = clock::times(&plain, head.clock);
    rows.accept(column, readings.iter().map(|(row, _)| *row).zip(times.seconds.iter().copied()), true);
    head.unit = Unit::parse("s").ok();
    head.origin = UnitOrigin::Clock;
    Some(ClockColumn { column, form, times })
}

/// Leaves out columns of dates beside a column of times of day; midnight is recognised from the times alone.
fn drop_dates(rows: &mut Rows, clocks: &mut Vec<ClockColumn>) {
    if !clocks.iter().any(|clock| clock.form == Form::Hours) {
        return;
    }
    for clock in clocks.iter().filter(|clock| clock.form == Form::Date) {
        rows.leave_out(clock.column);
    }
    clocks.retain(|clock| clock.form != Form::Date);
}

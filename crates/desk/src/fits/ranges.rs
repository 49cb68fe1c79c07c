//! Comparison of the period of a record with the periods that the open document has within the ranges of its parameters.

use crate::records::measurement::{recorded, value_at};
use crate::records::recognise::observed;
use crate::records::record::Record;
use crate::{Desk, number};
use analysis::cycles::{NoCycles, cycles};
use engine::{Method, Setup};
use program::{Model, NodeId};
use units::order::median;

/// Maximum work of all runs together, in floating-point operations: some milliseconds.
const MOST_WORK: u64 = 4_000_000;
/// Length of a run, in periods of the record.
const PERIODS: f64 = 24.0;
/// Rows of a run per period of the record.
const ROWS: usize = 24;
/// Maximum number of rows of the record that are read: the beginning of a long one.
const MOST_ROWS: usize = 4000;
/// Relative change of a period below which a parameter does not change it.
const UNCHANGED: f64 = 0.05;
/// Ratio of periods up to which a fit can find the one from the other: the ends of the ranges are tried, and not what lies between.
const NEAR: f64 = 1.3;

impl Desk {
    /// Reason why the open document cannot hold the chosen record: the record oscillates, and all periods that the document
    /// has at the ends of the range of each varied parameter are much longer or all much shorter. `None` if it can, or if
    /// that is not known.
    pub fn cannot_hold(&self) -> Option<String> {
        let record = self.record(self.chosen_record()?)?;
        let column = record.uses.iter().position(|used| used.fitted)?;
        let own = self.period_of(record, column)?;
        let quantity = observed(self.play.model(), &record.uses.get(column)?.meaning.quantity)?;
        let periods = self.periods_within_ranges(quantity.node, own)?;
        let (shortest, longest) =
            periods.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), one| (low.min(*one), high.max(*one)));
        if shortest <= own * NEAR && longest >= own / NEAR {
            return None;
        }
        let unit = &self.play.model().independent.unit;
        let shown = |period: f64| {
            [&number::plain(unit.from_si(period), 3, self.play.style()), " ", &number::unit_text(&unit.text)].concat()
        };
        let language = self.play.language();
        let ends = [shown(shortest), shown(longest)];
        Some(language.pick(
            format!(
                "The open document cannot hold this record: within the ranges of its parameters it has periods from {} to {}, and \
                 the record has one of {}. Choose a theory.",
                ends[0],
                ends[1],
                shown(own)
            ),
            format!(
                "El documento abierto no puede describir este registro: dentro de los rangos de sus parámetros tiene periodos de {} a {}, \
                 y el registro tiene uno de {}. Elige una teoría.",
                ends[0],
                ends[1],
                shown(own)
            ),
        ))
    }

    /// Period of a column of a record, SI. `None` if it does not oscillate.
    fn period_of(&self, record: &Record, column: usize) -> Option<f64> {
        let (mut times, mut values) = record.series(column, &self.play.model().independent.name)?;
        times.truncate(MOST_ROWS);
        values.truncate(MOST_ROWS);
        period(&times, &values).filter(|period| *period > 0.0 && period.is_finite())
    }

    /// Periods of a quantity, SI, at the present values and with each varied parameter at either end of its range.
    /// `own`: period of the record. `None` if a period is not known: a varied parameter has no range, or it changes the period
    /// and there is no oscillation at one of its ends within [`PERIODS`] periods of the record.
    fn periods_within_ranges(&self, quantity: NodeId, own: f64) -> Option<Vec<f64>> {
        let (model, values) = (self.play.model(), self.play.course().parameters());
        let varied = self.fits.setup.varied.iter().zip(&model.parameters).enumerate();
        let varied = varied.filter(|(_, (varied, parameter))| **varied && parameter.is_shown());
        let ranges: Option<Vec<_>> = varied.map(|(index, (_, parameter))| Some((index, parameter.range?))).collect();
        let ranges = ranges?;
        let most_work = MOST_WORK / (1 + 2 * ranges.len() as u64);
        let present = period_at(model, quantity, values, own, most_work)?;
        let mut found = vec![present];
        for (index, (low, high)) in ranges {
            let at = |end: f64| {
                let mut changed = values.to_vec();
                changed.iter_mut().skip(index).take(1).for_each(|value| *value = end);
                period_at(model, quantity, &changed, own, most_work)
            };
            match (at(low), at(high)) {
                (Some(one), Some(other)) => found.extend([one, other]),
                // Damping, for example: strong damping ends the oscillation.
                (Some(one), None) | (None, Some(one)) if (one / present - 1.0).abs() < UNCHANGED => {}
                _ => return None,
            }
        }
        Some(found)
    }
}

/// Period of a quantity with these parameters, SI; 0 if it is too short for the rows. `own`: period of the record. `None` if it does
/// not oscillate, or if the run needs more than `most_work` floating-point operations.
fn period_at(model: &Model, quantity: NodeId, parameters: &[f64], own: f64, most_work: u64) -> Option<f64> {
    let step = own / ROWS as f64;
    let setup = Setup {
        parameters: parameters.to_vec(),
        method: Method::DormandPrince,
        tolerance: 1e-4,
        step,
        ..Setup::defaults(model)
    };
    let mut run = recorded(model, setup, PERIODS * own, most_work).ok()?;
    let times: Vec<f64> = (0..ROWS * PERIODS as usize).map(|row| row as f64 * step).collect();
    let values: Vec<f64> = times.iter().copied().map(value_at(model, &mut run, quantity, parameters)).collect();
    period(&times, &values)
}

/// Median period of values over times, in the unit of the times; 0 if the rows are too sparse for it. `None` if the values do not
/// oscillate.
fn period(times: &[f64], values: &[f64]) -> Option<f64> {
    match cycles(times, values) {
        Ok(found) => Some(median(found.cycles.iter().map(|cycle| cycle.period.value).collect())),
        Err(NoCycles::Sparse(_)) => Some(0.0),
        Err(NoCycles::Unclear) => None,
    }
}

//! Comparison of the period of a record with the periods that the open document has within the ranges of its parameters.

use crate::fits::ShownFits;
use crate::records::measurement::{recorded, value_at};
use crate::records::recognise::observed;
use crate::{Revision, number};
use analysis::cycles::{NoCycles, cycles};
use engine::{Method, Setup};
use program::{Model, NodeId};
use units::order::median;
use units::say;

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

/// Everything on which the answer of a comparison depends.
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodQuestion {
    /// Id of the record and index of its fitted column.
    series: (u32, usize),
    quantity: NodeId,
    /// Counter of the changes of records and programs.
    records: u64,
    /// Values of the parameters, SI.
    values: Vec<f64>,
    /// One per parameter: true if it is varied.
    varied: Vec<bool>,
}

/// Comparison of the period of a record with the periods that the document has at the present values and with each varied
/// parameter at either end of its range. It is computed in portions of some milliseconds.
#[derive(Debug)]
pub struct PeriodComparison {
    question: PeriodQuestion,
    model: Model,
    /// Index and range of each varied parameter.
    ranges: Vec<(usize, (f64, f64))>,
    /// Times and values of the record, SI.
    series: (Vec<f64>, Vec<f64>),
    /// Period of the record, SI, once it is known.
    own: Option<f64>,
    /// Periods so far: at the present values, then at the lower and the upper end of each range. `None` without oscillation.
    found: Vec<Option<f64>>,
    ended: bool,
}

impl ShownFits<'_> {
    /// Question whether the open document can hold the chosen record; `None` if no column is fitted. `revision`: that of the
    /// desk.
    pub fn period_question(self, revision: Revision) -> Option<PeriodQuestion> {
        let record = self.records.get(self.chosen_record()?)?;
        let column = record.uses().iter().position(|used| used.fitted)?;
        let observed = observed(self.play.model(), &record.uses().get(column)?.meaning.quantity)?;
        Some(PeriodQuestion {
            series: (record.id(), column),
            quantity: observed.node,
            records: revision.records,
            values: self.play.course().parameters().to_vec(),
            varied: self.fits.setup.varied.clone(),
        })
    }

    /// Begins a comparison. `None` if a varied parameter has no range, or the record no rows.
    pub fn compare_periods(self, question: PeriodQuestion) -> Option<PeriodComparison> {
        let model = self.play.model();
        let (record, column) = question.series;
        let (mut times, mut values) = self.records.get(record)?.series(column, &model.independent)?;
        times.truncate(MOST_ROWS);
        values.truncate(MOST_ROWS);
        let varied = question.varied.iter().zip(&model.parameters).enumerate();
        let varied = varied.filter(|(_, (varied, parameter))| **varied && parameter.is_shown());
        let ranges: Option<Vec<_>> = varied.map(|(index, (_, parameter))| Some((index, parameter.range?))).collect();
        Some(PeriodComparison {
            question,
            model: model.clone(),
            ranges: ranges?,
            series: (times, values),
            own: None,
            found: Vec::new(),
            ended: false,
        })
    }

    /// Reason why the open document cannot hold the record of a finished comparison: the record oscillates, and all periods that
    /// the document has are much longer or all much shorter. `None` if it can, or if that is not known.
    pub fn cannot_hold(self, comparison: &PeriodComparison) -> Option<String> {
        let own = comparison.own.filter(|_| comparison.ended)?;
        let (shortest, longest) = comparison.periods()?;
        if shortest <= own * NEAR && longest >= own / NEAR {
            return None;
        }
        let unit = &self.play.model().independent.unit;
        let shown = |period: f64| {
            [&number::plain(unit.from_si(period), 3, self.play.basis().style()), " ", &number::unit_text(&unit.text)]
                .concat()
        };
        let language = self.play.basis().language();
        let ends = [shown(shortest), shown(longest)];
        Some(say!(
            language,
            "The open document cannot hold this record: within the ranges of its parameters it has periods from {} to {}, and \
                 the record has one of {}. Choose a theory.",
            ends[0],
            ends[1],
            shown(own)
        ))
    }
}

impl PeriodComparison {
    /// The question that it answers.
    pub fn question(&self) -> &PeriodQuestion {
        &self.question
    }

    /// Computes one period more. Returns true at the end.
    pub fn advance(&mut self) -> bool {
        if self.ended {
            return true;
        }
        let Some(own) = self.own else {
            self.own = period(&self.series.0, &self.series.1).filter(|period| *period > 0.0 && period.is_finite());
            self.ended = self.own.is_none();
            return self.ended;
        };
        let mut values = self.question.values.clone();
        if let Some(end) = self.found.len().checked_sub(1)
            && let Some(&(index, (low, high))) = self.ranges.get(end / 2)
            && let Some(value) = values.get_mut(index)
        {
            *value = if end.is_multiple_of(2) { low } else { high };
        }
        let all = 1 + 2 * self.ranges.len();
        self.found.push(period_at(&self.model, self.question.quantity, &values, own, MOST_WORK / all as u64));
        self.ended = self.found.len() == all || self.found.first() == Some(&None);
        self.ended
    }

    /// Shortest and longest period, SI. `None` if one is not known: a varied parameter changes it, and there is no oscillation at
    /// one of the ends within [`PERIODS`] periods of the record.
    fn periods(&self) -> Option<(f64, f64)> {
        let (present, ends) = self.found.split_first()?;
        let present = (*present)?;
        let mut found = (present, present);
        for pair in ends.chunks(2) {
            match pair {
                [Some(low), Some(high)] => found = (found.0.min(*low).min(*high), found.1.max(*low).max(*high)),
                // Damping, for example: strong damping ends the oscillation.
                [Some(one), None] | [None, Some(one)] if (one / present - 1.0).abs() < UNCHANGED => {}
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

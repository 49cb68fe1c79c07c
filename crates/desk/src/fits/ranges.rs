//! Comparison of the period of a record with the periods that the open document has within the ranges of its parameters.

use crate::records::measurement::recorded;
use crate::records::recognise::observed;
use crate::records::record::Record;
use crate::{Desk, number};
use analysis::cycles::cycles;
use engine::{Method, Readings, Setup};
use units::order::median;

/// Maximum number of varied parameters whose ranges are tried, at both ends each.
const MOST_VARIED: usize = 3;
/// Maximum work of all runs together, in floating-point operations: some milliseconds.
const MOST_WORK: u64 = 4_000_000;
/// Length of a run, in periods of the record.
const PERIODS: f64 = 12.0;
/// Rows of a run per period of the record.
const ROWS: usize = 24;
/// Maximum number of rows of the record that are read: the beginning of a long one.
const MOST_ROWS: usize = 4000;
/// Ratio of periods up to which a fit can find the one from the other: the ends of the ranges are tried, and not what lies between.
const NEAR: f64 = 1.3;

impl Desk {
    /// Reason why the open document cannot hold the chosen record: the record oscillates, and all periods that the document
    /// has at the ends of the ranges of its varied parameters are much longer or all much shorter. `None` if it can, or if
    /// that is not known.
    pub fn cannot_hold(&self) -> Option<String> {
        let own = self.period_of_record()?;
        let periods = self.periods_within_ranges(own);
        let (shortest, longest) =
            periods.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), one| (low.min(*one), high.max(*one)));
        if periods.is_empty() || shortest <= own * NEAR && longest >= own / NEAR {
            return None;
        }
        let unit = &self.play.model().independent.unit;
        let shown = |period: f64| {
            [&number::plain(unit.from_si(period), 3, self.play.style()), " ", &number::unit_text(&unit.text)].concat()
        };
        let language = self.play.language();
        let ends = if longest.is_finite() {
            language.pick(
                format!("from {} to {}", shown(shortest), shown(longest)),
                format!("de {} a {}", shown(shortest), shown(longest)),
            )
        } else {
            language.pick(format!("of {} and longer", shown(shortest)), format!("de {} y más largos", shown(shortest)))
        };
        Some(language.pick(
            format!(
                "The open document cannot hold this record: within the ranges of its parameters it has periods {ends}, and the \
                 record has one of {}. Choose a theory.",
                shown(own)
            ),
            format!(
                "El documento abierto no puede describir este registro: dentro de los rangos de sus parámetros tiene periodos {ends}, \
                 y el registro tiene uno de {}. Elige una teoría.",
                shown(own)
            ),
        ))
    }

    /// The chosen record and the index of its first fitted column.
    fn fitted_column(&self) -> Option<(&Record, usize)> {
        let record = self.record(self.chosen_record()?)?;
        Some((record, record.uses.iter().position(|used| used.fitted)?))
    }

    /// Period of the fitted column of the chosen record, SI. `None` if it does not oscillate.
    fn period_of_record(&self) -> Option<f64> {
        let (record, column) = self.fitted_column()?;
        let (mut times, mut values) = record.series(column, &self.play.model().independent.name)?;
        times.truncate(MOST_ROWS);
        values.truncate(MOST_ROWS);
        period(&times, &values)
    }

    /// The quantity of the fitted column of the chosen record.
    fn fitted_quantity(&self) -> Option<program::Compiled> {
        let (record, column) = self.fitted_column()?;
        observed(self.play.model(), &record.uses.get(column)?.meaning.quantity)
    }

    /// Periods of the fitted quantity, SI, at the present values and at the ends of the ranges of varied parameters;
    /// infinite where it does not oscillate within [`PERIODS`] periods of the record, `own`. Runs that need too much work
    /// are left out.
    fn periods_within_ranges(&self, own: f64) -> Vec<f64> {
        let (model, course) = (self.play.model(), self.play.course());
        let Some(observed) = self.fitted_quantity() else { return Vec::new() };
        let ranges = self.fits.setup.varied.iter().zip(&model.parameters).enumerate();
        let ranges = ranges.filter(|(_, (varied, parameter))| **varied && parameter.is_shown());
        let ranges = ranges.filter_map(|(index, (_, parameter))| Some((index, parameter.range?)));
        let mut settings = vec![course.parameters().to_vec()];
        for (index, ends) in ranges.take(MOST_VARIED) {
            for mut before in settings.clone() {
                for end in [ends.0, ends.1] {
                    before.iter_mut().skip(index).take(1).for_each(|value| *value = end);
                    settings.push(before.clone());
                }
            }
        }
        let step = own / ROWS as f64;
        let times: Vec<f64> = (0..ROWS * PERIODS as usize).map(|row| row as f64 * step).collect();
        let most_work = MOST_WORK / settings.len() as u64;
        let mut state = vec![0.0; model.states.len()];
        let mut found = Vec::new();
        for parameters in settings {
            let setup = Setup {
                parameters: parameters.clone(),
                method: Method::DormandPrince,
                tolerance: 1e-4,
                step,
                ..Setup::defaults(model)
            };
            let Ok(mut run) = recorded(model, setup, PERIODS * own, most_work) else { continue };
            let mut readings = Readings::new(model, &[observed.node]);
            let mut read = |time: &f64| {
                run.interpolate(*time, &mut state);
                readings.at(&parameters, run.initial(), *time, &state).first().copied().unwrap_or(f64::NAN)
            };
            let values: Vec<f64> = times.iter().map(&mut read).collect();
            found.push(period(&times, &values).unwrap_or(f64::INFINITY));
        }
        found
    }
}

/// Median period of values over times, in the unit of the times. `None` if they do not oscillate.
fn period(times: &[f64], values: &[f64]) -> Option<f64> {
    let period = median(cycles(times, values).ok()?.cycles.iter().map(|cycle| cycle.period.value).collect());
    (period > 0.0 && period.is_finite()).then_some(period)
}

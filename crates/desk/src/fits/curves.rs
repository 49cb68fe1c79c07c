//! Fitted columns as data for others: the curves of a class.

use crate::fits::ShownFits;
use crate::measured::{CurveAxis, axis, clock};
use report::size;
use serde::{Deserialize, Serialize};

/// A fitted column, in the units of the theory.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FittedCurve {
    /// Title of the theory.
    pub theory: String,
    /// Name of the record.
    pub record: String,
    /// The independent variable; the theory begins at 0.
    pub across: CurveAxis,
    /// The fitted quantity.
    pub quantity: CurveAxis,
    /// Times of the measured values in the fitted part.
    pub times: Vec<f64>,
    /// Measured minus fitted value at these times.
    pub residuals: Vec<f64>,
    /// Times of the fitted curve, evenly spaced.
    pub curve_times: Vec<f64>,
    /// Values of the fitted curve.
    pub curve_values: Vec<f64>,
    /// True if the data determine every varied parameter.
    pub determined: bool,
}

impl ShownFits<'_> {
    /// The fitted columns of the finished fits, in the order of the fits.
    pub fn fitted_curves(self) -> Vec<FittedCurve> {
        let mut curves = Vec::new();
        for fit in &self.fits.finished {
            let model = &fit.document.program.model;
            for own in &fit.outcome.observations {
                let part = fit.definition.parts.get(own.record);
                let record = part.and_then(|part| self.records.get(part.record));
                let begins = record.map(|record| record.origin(&model.independent, model.is_autonomous()));
                let origin = fit.outcome.origins.get(own.record).copied().or(begins).unwrap_or(0.0);
                let time = |time: &f64| model.independent.unit.from_si(time - origin);
                let rows = own.times.iter().zip(&own.measured).zip(&own.fitted).zip(&own.inside);
                let rows =
                    rows.filter(|(((_, measured), fitted), inside)| **inside && (*measured - *fitted).is_finite());
                let (times, residuals) =
                    rows.map(|(((at, measured), fitted), _)| (time(at), size(&own.unit, measured - fitted))).unzip();
                let trace =
                    fit.traces.iter().find(|trace| (trace.record, trace.observation) == (own.record, own.observation));
                curves.push(FittedCurve {
                    theory: fit.document.program.title.clone(),
                    record: part.map_or_else(String::new, |part| part.name.clone()),
                    across: clock(model),
                    quantity: axis(&own.name, &own.unit),
                    times,
                    residuals,
                    curve_times: trace.map_or_else(Vec::new, |trace| trace.times.iter().map(time).collect()),
                    curve_values: trace.map_or_else(Vec::new, |trace| {
                        trace.values.iter().map(|value| own.unit.from_si(*value)).collect()
                    }),
                    determined: fit.outcome.undetermined.is_empty(),
                });
            }
        }
        curves
    }
}

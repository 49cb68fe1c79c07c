//! Measured columns as data for others: the curves of a class.

use crate::measured::MeasuredData;
use crate::measured::data::Measured;
use play::Play;
use program::Model;
use serde::{Deserialize, Serialize};
use units::Unit;

/// Horizontal quantity of a curve, and its unit as text.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct CurveAxis {
    /// Name of the quantity.
    pub name: String,
    /// Unit; empty for a pure number.
    pub unit: String,
}

/// A measured column in use, in the units of the document.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct MeasuredCurve {
    /// Name of the record.
    pub record: String,
    /// The independent variable; the model begins at 0.
    pub across: CurveAxis,
    /// The quantity of the document that the column measures.
    pub quantity: CurveAxis,
    /// Ascending times, one per value.
    pub times: Vec<f64>,
    /// Measured values.
    pub values: Vec<f64>,
}

pub(crate) fn axis(name: &str, unit: &Unit) -> CurveAxis {
    CurveAxis { name: name.to_owned(), unit: unit.text.clone() }
}

pub(crate) fn clock(model: &Model) -> CurveAxis {
    axis(&model.independent.name, &model.independent.unit)
}

impl MeasuredData {
    /// The measured columns in use.
    pub fn curves(&self, play: &Play) -> Vec<MeasuredCurve> {
        let model = play.model();
        let curve = |measured: &Measured| {
            let (clock_unit, unit) = (&model.independent.unit, &measured.observed.unit);
            MeasuredCurve {
                record: measured.record_name.clone(),
                across: clock(model),
                quantity: axis(&measured.name, unit),
                times: measured.times.iter().map(|time| clock_unit.from_si(*time)).collect(),
                values: measured.values.iter().map(|value| unit.from_si(*value)).collect(),
            }
        };
        self.columns.iter().map(curve).collect()
    }
}

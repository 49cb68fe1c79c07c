//! What is known of each cycle, one quantity at a time: for tables and figures.

use super::cycle::{Cycle, Measured};
use units::Language::{self, English, Spanish};

/// What is known of each cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// The envelope at the turning point.
    Amplitude,
    /// From one maximum to the next.
    Period,
    /// The logarithmic decrement.
    Decrement,
    /// The local angular frequency.
    AngularFrequency,
    /// The local damping.
    Damping,
}

impl Quantity {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Amplitude, Self::Period, Self::Decrement, Self::AngularFrequency, Self::Damping];

    /// Its value in a cycle.
    pub fn of(self, cycle: &Cycle) -> Measured {
        match self {
            Self::Amplitude => cycle.amplitude,
            Self::Period => cycle.period,
            Self::Decrement => cycle.decrement,
            Self::AngularFrequency => cycle.angular_frequency,
            Self::Damping => cycle.damping,
        }
    }

    /// Its symbol; the decrement has none that everybody uses.
    pub fn symbol(self, language: Language) -> &'static str {
        match self {
            Self::Amplitude => "A",
            Self::Period => "T",
            Self::Decrement if language == Spanish => "decremento",
            Self::Decrement => "decrement",
            Self::AngularFrequency => "ω",
            Self::Damping => "γ",
        }
    }

    /// What it is called, with a small letter.
    pub fn name(self, language: Language) -> &'static str {
        match (self, language) {
            (Self::Amplitude, English) => "amplitude",
            (Self::Amplitude, Spanish) => "amplitud",
            (Self::Period, English) => "period",
            (Self::Period, Spanish) => "periodo",
            (Self::Decrement, English) => "logarithmic decrement",
            (Self::Decrement, Spanish) => "decremento logarítmico",
            (Self::AngularFrequency, English) => "angular frequency",
            (Self::AngularFrequency, Spanish) => "frecuencia angular",
            (Self::Damping, English) => "damping",
            (Self::Damping, Spanish) => "amortiguamiento",
        }
    }

    /// Its unit, where the values have the unit `own` (perhaps none) and the times `time`.
    pub fn unit(self, own: &str, time: &str) -> String {
        match self {
            Self::Amplitude => own.to_owned(),
            Self::Period => time.to_owned(),
            Self::Decrement => String::new(),
            Self::AngularFrequency => format!("rad/{time}"),
            Self::Damping => format!("1/{time}"),
        }
    }
}

/// The columns of a table of cycles: heads with units, and numbers, each quantity followed by its standard error.
pub fn columns(cycles: &[Cycle], own: &str, time: &str) -> Vec<(String, Vec<f64>)> {
    type Of = fn(&Cycle) -> Measured;
    let quantities: [(&str, &str, Of); 7] = [
        ("t", time, |cycle| cycle.time),
        ("amplitude", own, |cycle| cycle.amplitude),
        ("period", time, |cycle| cycle.period),
        ("decrement", "", |cycle| cycle.decrement),
        ("omega", &Quantity::AngularFrequency.unit(own, time), |cycle| cycle.angular_frequency),
        ("gamma", &Quantity::Damping.unit(own, time), |cycle| cycle.damping),
        ("offset", own, |cycle| cycle.offset),
    ];
    let mut columns = Vec::new();
    for (name, unit, of) in quantities {
        let unit = if unit.is_empty() { String::new() } else { format!(" [{unit}]") };
        columns.push((format!("{name}{unit}"), cycles.iter().map(|cycle| of(cycle).value).collect()));
        columns.push((format!("{name}_stderr{unit}"), cycles.iter().map(|cycle| of(cycle).error).collect()));
    }
    columns
}

/// The least interval about all values, with their errors, that are known to within four times the usual error: what a
/// figure is to show. The last cycles, of which little is known, must not make the others a line. `None` where they are
/// all the same and exact.
pub fn well_known(values: &[Measured]) -> Option<(f64, f64)> {
    let mut errors: Vec<f64> = values.iter().map(|one| one.error).collect();
    errors.sort_by(f64::total_cmp);
    let usual = errors.get(errors.len() / 2).copied().unwrap_or(0.0);
    let known = values.iter().filter(|one| one.error <= 4.0 * usual);
    let (low, high) = known.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), one| {
        (low.min(one.value - one.error), high.max(one.value + one.error))
    });
    (high > low).then_some((low, high))
}

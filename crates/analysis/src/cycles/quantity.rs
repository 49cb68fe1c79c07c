//! Quantities of a cycle, for tables and figures.

use super::cycle::{Cycle, Measured};
use units::Language;
use units::order::median;

/// Quantity measured in each cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Envelope at the turning point.
    Amplitude,
    /// Time from one maximum to the next.
    Period,
    /// Logarithmic decrement.
    Decrement,
    /// Local angular frequency.
    AngularFrequency,
    /// Local damping.
    Damping,
}

impl Quantity {
    /// All quantities.
    pub const ALL: [Self; 5] = [Self::Amplitude, Self::Period, Self::Decrement, Self::AngularFrequency, Self::Damping];

    /// Value of the quantity in a cycle.
    pub fn of(self, cycle: &Cycle) -> Measured {
        match self {
            Self::Amplitude => cycle.amplitude,
            Self::Period => cycle.period,
            Self::Decrement => cycle.decrement,
            Self::AngularFrequency => cycle.angular_frequency,
            Self::Damping => cycle.damping,
        }
    }

    /// Symbol; a word for the decrement, which has no common symbol.
    pub fn symbol(self, language: Language) -> &'static str {
        match self {
            Self::Amplitude => "A",
            Self::Period => "T",
            Self::Decrement => language.say("decrement"),
            Self::AngularFrequency => "ω",
            Self::Damping => "γ",
        }
    }

    /// Name in lower case.
    pub fn name(self, language: Language) -> &'static str {
        match self {
            Self::Amplitude => language.say("amplitude"),
            Self::Period => language.say("period"),
            Self::Decrement => language.say("logarithmic decrement"),
            Self::AngularFrequency => language.say("angular frequency"),
            Self::Damping => language.say("damping"),
        }
    }

    /// Name with its article, at the beginning of a sentence.
    pub(super) fn with_article(self, language: Language) -> &'static str {
        match self {
            Self::Amplitude => language.say("The amplitude"),
            Self::Period => language.say("The period"),
            Self::Decrement => language.say("The logarithmic decrement"),
            Self::AngularFrequency => language.say("The angular frequency"),
            Self::Damping => language.say("The damping"),
        }
    }

    /// Unit, for values in the unit `own` (may be empty) and times in the unit `time`.
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

/// Columns of a table of cycles, as (heading with unit, numbers); each quantity is followed by its standard error.
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

/// Range for a figure: the smallest interval that contains all values with their errors, without values whose error exceeds
/// four times the median error. Otherwise the uncertain last cycles would set the scale. `None` if all values are equal and
/// exact.
pub fn well_known(values: &[Measured]) -> Option<(f64, f64)> {
    let usual = median(values.iter().map(|one| one.error).collect());
    let known = values.iter().filter(|one| one.error <= 4.0 * usual);
    let (low, high) = known.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), one| {
        (low.min(one.value - one.error), high.max(one.value + one.error))
    });
    (high > low).then_some((low, high))
}

//! What people type: a number, perhaps with a unit, or an expression.

use super::calculator::calculate;
use super::typed::{Candidate, candidates, stated_units};
use crate::{Play, Refusal, number};
use engine::Readings;
use units::Unit;

/// Significant digits of a value that stands still.
pub const DIGITS: usize = 6;

/// How a unit of 1/s counts turns.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Turns {
    /// Whole ones: hertz.
    Whole,
    /// By their angle: `rad/s`, `deg/s`.
    Angle,
    /// It does not say.
    Unsaid,
}

impl Turns {
    fn of(unit: &Unit) -> Self {
        let symbols = || unit.text.split(|c: char| !c.is_alphabetic() && c != '°');
        if unit.dimension != Unit::parse("Hz").map_or(unit.dimension, |hertz| hertz.dimension) {
            Self::Unsaid
        } else if symbols().any(|symbol| symbol.ends_with("Hz")) {
            Self::Whole
        } else if symbols().any(|symbol| symbol.ends_with("rad") || matches!(symbol, "deg" | "°")) {
            Self::Angle
        } else {
            Self::Unsaid
        }
    }
}

/// What was typed, for a message.
pub(crate) fn shortened(typed: &str) -> String {
    typed.trim().chars().take(40).collect()
}

impl Play {
    /// Reads a value, SI: a number in `unit`, or with a unit of its own of the same dimension. Hertz are no unit of an angular
    /// frequency, nor radians per second of a frequency, although their dimension is the same.
    pub fn read_value(&self, typed: &str, unit: &Unit) -> Result<f64, Refusal> {
        let no_number = || Refusal::NotANumber { typed: shortened(typed) };
        let (value, rest) = number::parse(typed, self.style).ok_or_else(no_number)?;
        let value = if rest.is_empty() {
            unit.to_si(value)
        } else {
            let unknown =
                || match rest.starts_with(|c: char| c.is_ascii_punctuation() && c != '%' || "×·÷−±".contains(c)) {
                    true => no_number(),
                    false => Refusal::UnknownUnit { typed: shortened(rest) },
                };
            let own = Unit::parse(rest).map_err(|_| unknown())?;
            if own.dimension != unit.dimension {
                return Err(Refusal::WrongUnit { typed: shortened(rest), expected: number::unit_text(&unit.text) });
            }
            let si = own.to_si(value);
            self.refuse_other_frequency(value, &own, si, unit)?;
            si
        };
        if value.is_finite() { Ok(value) } else { Err(no_number()) }
    }

    /// Refuses `value` of the unit `own` (`si` in SI) where `unit` counts turns in another way.
    fn refuse_other_frequency(&self, value: f64, own: &Unit, si: f64, unit: &Unit) -> Result<(), Refusal> {
        let turn = std::f64::consts::TAU;
        let (angular, meant) = match (Turns::of(own), Turns::of(unit)) {
            (Turns::Whole, Turns::Angle) => (true, si * turn),
            (Turns::Angle, Turns::Whole) => (false, si / turn),
            _ => return Ok(()),
        };
        Err(Refusal::OtherFrequency {
            typed: self.with_unit(number::plain(value, DIGITS, self.style), own),
            meant: self.with_unit(number::plain(unit.from_si(meant), 3, self.style), unit),
            angular,
        })
    }

    /// What was typed into a field that shows `shown`: nothing new if that stands there still, although it may be
    /// rounded; else a value as [`Play::read_value`] takes it, or what an expression in the parameters gives now.
    pub fn read_field(&self, typed: &str, shown: &str, unit: &Unit) -> Result<Option<f64>, Refusal> {
        if typed.trim() == shown {
            return Ok(None);
        }
        match self.read_value(typed, unit) {
            Ok(value) => Ok(Some(value)),
            Err(refusal @ Refusal::OtherFrequency { .. }) => Err(refusal),
            Err(refusal) => self.read_expression(typed, unit).map(Some).map_err(|why| why.unwrap_or(refusal)),
        }
    }

    /// The value, SI, of an expression as presets have them, `2*m*omega_0`, `y(0)/2`, or of arithmetic with units as people
    /// type them, `15/4 s`. A pure number is one in `unit`.
    ///
    /// # Errors
    /// Why it cannot be taken, if there is more to say than that it is no number.
    pub(crate) fn read_expression(&self, typed: &str, unit: &Unit) -> Result<f64, Option<Refusal>> {
        let mut why = None;
        for candidate in candidates(typed, self.style) {
            match self.evaluate(&candidate, unit) {
                Ok(value) => return Ok(value),
                Err(refusal) => why = why.or(refusal),
            }
        }
        Err(why)
    }

    fn evaluate(&self, candidate: &Candidate, unit: &Unit) -> Result<f64, Option<Refusal>> {
        let text = &candidate.expression;
        // What is typed once leaves nothing behind in the graph.
        let mut model = self.model().clone();
        let calculation = calculate(&mut model, text).ok_or(None)?;
        if model.depends(calculation.node).varies() {
            return Err(None);
        }
        let (parameters, initial) = (self.course.parameters(), self.course.initial());
        let mut readings = Readings::new(&model, &[calculation.node]);
        let value = readings.at(parameters, initial, 0.0, initial).first().copied().unwrap_or(f64::NAN);
        let (pure, fits) = (calculation.dimension.is_none(), calculation.dimension == unit.dimension);
        let names = &calculation.names;
        let si = match &candidate.unit {
            Some(own) if pure && own.dimension == unit.dimension => {
                self.refuse_other_frequency(value, own, own.to_si(value), unit)?;
                own.to_si(value)
            }
            Some(own) if pure => {
                let (typed, expected) = (number::unit_text(&own.text), number::unit_text(&unit.text));
                return Err(Some(Refusal::WrongUnit { typed, expected }));
            }
            Some(_) => return Err(None),
            // `60/2` is 30 degrees where degrees are asked for, but `pi/6` and `theta_0/2` are angles themselves.
            None if pure && (!fits || (names.is_empty() && !text.contains('['))) => unit.to_si(value),
            None if fits => {
                // `2*pi*(0.27 Hz)` is an angular frequency, `0.54/2 Hz` is none.
                let unconverted = stated_units(text).filter(|_| names.is_empty());
                for own in unconverted {
                    self.refuse_other_frequency(own.from_si(value), &own, value, unit)?;
                }
                value
            }
            None => return Err(None),
        };
        if si.is_finite() { Ok(si) } else { Err(None) }
    }

    /// A value with its unit, for people: `0,05 m²`.
    pub fn quantity_text(&self, value: f64, unit: &Unit) -> String {
        self.with_unit(number::plain(unit.from_si(value), DIGITS, self.style), unit)
    }

    /// A number with its unit; a dash alone.
    pub(crate) fn with_unit(&self, number: String, unit: &Unit) -> String {
        number::with_unit(&number, unit)
    }
}

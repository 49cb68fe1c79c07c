//! What people type: a number, perhaps with a unit.

use crate::{Refusal, Session, number};
use units::Unit;

/// Significant digits of a value that stands still.
pub(crate) const DIGITS: usize = 6;

impl Session {
    /// Reads a value, SI: a number in `unit`, or with a unit of its own of the same dimension.
    pub(crate) fn read_value(&self, typed: &str, unit: &Unit) -> Result<f64, Refusal> {
        let (value, rest) = number::parse(typed, self.style)
            .ok_or_else(|| Refusal::NotANumber { typed: typed.trim().chars().take(40).collect() })?;
        let value = if rest.is_empty() {
            unit.to_si(value)
        } else {
            let typed = rest.chars().take(40).collect();
            let own = Unit::parse(&number::unit_source(rest))
                .map_err(|_| Refusal::UnknownUnit { typed: rest.chars().take(40).collect() })?;
            if own.dimension != unit.dimension {
                return Err(Refusal::WrongUnit { typed, expected: number::unit_text(&unit.text) });
            }
            own.to_si(value)
        };
        if value.is_finite() {
            Ok(value)
        } else {
            Err(Refusal::NotANumber { typed: typed.trim().chars().take(40).collect() })
        }
    }

    /// A value with its unit, for people: `0,05 m²`.
    pub(crate) fn quantity_text(&self, value: f64, unit: &Unit) -> String {
        self.with_unit(number::plain(unit.from_si(value), DIGITS, self.style), unit)
    }

    /// A number with its unit; a dash alone.
    pub(crate) fn with_unit(&self, number: String, unit: &Unit) -> String {
        if unit.text.is_empty() || number == number::DASH {
            return number;
        }
        match number::unit_text(&unit.text).as_str() {
            "°" => format!("{number}°"),
            text => format!("{number} {text}"),
        }
    }
}

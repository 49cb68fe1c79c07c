//! What people type: a number, perhaps with a unit, or an expression.

use crate::{Refusal, Session, number};
use engine::Readings;
use model::Kind;
use units::Unit;

/// Significant digits of a value that stands still.
pub(crate) const DIGITS: usize = 6;

/// No expression that is typed is longer.
const LONGEST: usize = 300;

impl Session {
    /// Reads a value, SI: a number in `unit`, or with a unit of its own of the same dimension.
    pub(crate) fn read_value(&self, typed: &str, unit: &Unit) -> Result<f64, Refusal> {
        let (value, rest) = number::parse(typed, self.style)
            .ok_or_else(|| Refusal::NotANumber { typed: typed.trim().chars().take(40).collect() })?;
        let value = if rest.is_empty() {
            unit.to_si(value)
        } else {
            let typed = rest.chars().take(40).collect();
            let own = Unit::parse(rest).map_err(|_| Refusal::UnknownUnit { typed: rest.chars().take(40).collect() })?;
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

    /// What was typed into a field that shows `shown`: nothing new if that stands there still, although it may be
    /// rounded; else a value as [`Session::read_value`] takes it, or what an expression in the parameters gives now.
    pub(crate) fn read_field(&self, typed: &str, shown: &str, unit: &Unit) -> Result<Option<f64>, Refusal> {
        if typed.trim() == shown {
            return Ok(None);
        }
        match self.read_value(typed, unit) {
            Ok(value) => Ok(Some(value)),
            Err(refusal) => self.read_expression(typed, unit).map(Some).ok_or(refusal),
        }
    }

    /// The value, SI, of an expression as presets have them: `2*m*omega_0`, `y(0)/2`. A pure number is one in `unit`.
    fn read_expression(&self, typed: &str, unit: &Unit) -> Option<f64> {
        if typed.len() > LONGEST {
            return None;
        }
        let typed = if self.style.decimal_comma { typed.replace(',', ".") } else { typed.to_owned() };
        let (expression, stated, diagnostics) = model::parse_expression(&typed, 0..typed.len());
        if model::has_errors(&diagnostics) {
            return None;
        }
        // What is typed once leaves nothing behind in the graph.
        let mut model = self.model().clone();
        let compiled = model.compile_expression(&expression, stated.as_ref()).ok()?;
        let fits = compiled.dimension() == unit.dimension || compiled.dimension().is_none();
        if compiled.kind != Kind::Number || !fits || model.depends(compiled.node).varies() {
            return None;
        }
        let (parameters, initial) = (self.course.parameters(), self.course.initial());
        let value = *Readings::new(&model, &[compiled.node]).at(parameters, initial, 0.0, initial).first()?;
        let value = if compiled.dimension() == unit.dimension { value } else { unit.to_si(value) };
        value.is_finite().then_some(value)
    }

    /// A value with its unit, for people: `0,05 m²`.
    pub(crate) fn quantity_text(&self, value: f64, unit: &Unit) -> String {
        self.with_unit(number::plain(unit.from_si(value), DIGITS, self.style), unit)
    }

    /// A number with its unit; a dash alone.
    pub(crate) fn with_unit(&self, number: String, unit: &Unit) -> String {
        number::with_unit(&number, unit)
    }
}

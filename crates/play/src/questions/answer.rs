//! Parsing of answers: a number or arithmetic with units, optionally with an error.

use crate::basis::calculator::names;
use crate::basis::typed::candidates;
use crate::{Basis, Refusal, number};
use units::Unit;
use units::number::Style;
use units::number::typed::shortened;

/// A parsed answer, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Answer {
    pub value: f64,
    /// Stated error, SI, never negative.
    pub error: Option<f64>,
}

/// Separators between a value and its error.
const PLUS_MINUS: [&str; 4] = ["±", "+/-", "+-", "+−"];

impl Basis {
    /// Parses an answer: `3.76`, `15/4 s`, `2*pi/(1.672 1/s)`, `3.76 ± 0.02 s`, `(3.76 ± 0.02) s`, `3.76 s ± 1 %`.
    /// Names of the document are refused; otherwise `T_d` would answer the question for T_d.
    pub(crate) fn read_answer(&self, typed: &str, unit: &Unit, style: Style) -> Result<Answer, Refusal> {
        let parts = PLUS_MINUS.iter().find_map(|sign| typed.split_once(sign));
        let Some((value, error)) = parts else {
            return Ok(Answer { value: self.read_number(typed, unit, style)?, error: None });
        };
        let (mut value, mut error) = (value.trim().to_owned(), error.trim().to_owned());
        // `(3.76 ± 0.02) s`: the unit applies to both.
        if let (Some(inner), Some((amount, after))) = (value.strip_prefix('('), error.split_once(')'))
            && !inner.contains(')')
        {
            let [own, its] = [inner, amount].map(|part| [part.trim(), " ", after.trim()].concat());
            (value, error) = (own, its);
        } else if let Some((_, after)) = number::parse(&error, style).filter(|(_, after)| !after.is_empty()) {
            // `3.76 ± 0.02 s`, but not `3.76 s ± 0.02 s`.
            let bare = number::parse(&value, style).is_some_and(|(_, after)| after.is_empty());
            if bare && (after != "%" || unit.text == "%") {
                value = [&value, " ", after].concat();
            }
        }
        let value = self.read_number(&value, unit, style)?;
        let percent = error.strip_suffix('%').filter(|_| unit.text != "%").and_then(|amount| {
            number::parse(amount, style).filter(|(_, after)| after.is_empty()).map(|(amount, _)| amount)
        });
        let error = match percent {
            Some(percent) => value.abs() * percent / 100.0,
            None => self.read_number(&error, unit, style)?,
        };
        Ok(Answer { value, error: Some(error.abs()) })
    }

    /// Parses a number or arithmetic and returns its value, SI.
    fn read_number(&self, typed: &str, unit: &Unit, style: Style) -> Result<f64, Refusal> {
        let refusal = match self.read_value_as(typed, unit, style) {
            Ok(value) => return Ok(value),
            Err(refusal) => refusal,
        };
        for candidate in candidates(typed, style) {
            let names = names(self.model(), &candidate.expression);
            if let Some(name) = names.iter().find(|name| self.model().lookup(name, 0).is_some()) {
                return Err(Refusal::NameInAnswer { name: shortened(name) });
            }
        }
        self.read_constant(typed, unit, style).map_err(|why| why.unwrap_or(refusal))
    }
}

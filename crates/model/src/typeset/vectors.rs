//! Vectors: names with an arrow, components with a subscript, |r| for the magnitude, and the two products.

use super::expression::{Level, Place, Typesetter, fenced, level, parenthesised};
use crate::components::AXES;
use crate::{Expression, ExpressionKind, Name};
use units::Unit;
use units::mathml::{indexed, unit_after_number, vector};

impl Typesetter<'_> {
    /// A name with primes and exponent; a vector gets an arrow.
    pub(super) fn name(&self, name: &str, order: u32, exponent: Option<String>) -> String {
        self.indexed(name, &[], order, exponent)
    }

    /// A name with subscripts, which are MathML, primes and exponent; a vector gets an arrow.
    pub(super) fn indexed(&self, name: &str, indices: &[String], order: u32, exponent: Option<String>) -> String {
        if self.vectors.dimension(name).is_some() {
            return vector(name, indices, order, exponent);
        }
        indexed(name, indices, order, exponent)
    }

    /// Binding strength of the outermost operation of an expression.
    pub(super) fn level(&self, expression: &Expression, place: Place) -> Level {
        match &expression.kind {
            ExpressionKind::Call { function, arguments }
                if self.vectors.is_operation(&function.text) && arguments.len() == 2 =>
            {
                Level::Product
            }
            ExpressionKind::Tuple { unit: Some(_), .. } => Level::Product,
            _ => level(expression, place),
        }
    }

    /// `(1, 0) au`
    pub(super) fn tuple(&self, parts: &[Expression], unit: Option<&Unit>) -> String {
        let parts: Vec<String> = parts.iter().map(|part| self.expression(part)).collect();
        let inside = parenthesised(&format!("<mrow>{}</mrow>", parts.join("<mo separator=\"true\">,</mo>")));
        unit.map_or_else(|| inside.clone(), |unit| format!("<mrow>{inside}{}</mrow>", unit_after_number(unit)))
    }

    /// Name of a vector with the axis as a subscript, after the indices of a member of a family.
    pub(super) fn component(
        &self,
        name: &str,
        indices: &[Expression],
        axis: usize,
        order: u32,
        exponent: Option<String>,
    ) -> String {
        let mut below = self.indices(indices);
        below.extend(AXES.get(axis).map(|axis| format!("<mi>{axis}</mi>")));
        indexed(name, &below, order, exponent)
    }

    /// Component of a vector expression, with the axis as a subscript.
    pub(super) fn component_of(&self, of: &Expression, axis: usize, exponent: Option<String>) -> String {
        match &of.kind {
            ExpressionKind::Member { name, indices, order, at_start: false } => {
                self.component(name, indices, axis, *order, exponent)
            }
            ExpressionKind::Name { name, order } => self.component(name, &[], axis, *order, exponent),
            _ => {
                let base = match &of.kind {
                    ExpressionKind::Member { .. }
                    | ExpressionKind::InitialValue { .. }
                    | ExpressionKind::Tuple { .. } => self.expression(of),
                    _ => parenthesised(&self.expression(of)),
                };
                let below = format!("<mi>{}</mi>", AXES.get(axis).copied().unwrap_or_default());
                match exponent {
                    Some(above) => format!("<msubsup>{base}{below}{above}</msubsup>"),
                    None => format!("<msub>{base}{below}</msub>"),
                }
            }
        }
    }

    /// |r|, a · b, a × b
    pub(super) fn operation(&self, function: &Name, arguments: &[Expression]) -> String {
        match arguments {
            [one, other] => {
                let sign = if function.text == "dot" { "·" } else { "×" };
                let [one, other] = [one, other].map(|side| self.at_least(side, Level::Operand, Place::Line));
                format!("<mrow>{one}<mo>{sign}</mo>{other}</mrow>")
            }
            _ => {
                let inside: Vec<String> = arguments.iter().map(|argument| self.expression(argument)).collect();
                fenced("|", &inside.join("<mo>,</mo>"), "|")
            }
        }
    }

    /// The operation as the base of a power.
    pub(super) fn operation_as_base(&self, function: &Name, arguments: &[Expression]) -> String {
        let inside = self.operation(function, arguments);
        if arguments.len() == 2 { parenthesised(&inside) } else { inside }
    }
}

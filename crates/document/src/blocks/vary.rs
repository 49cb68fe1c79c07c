//! `vary: b, v_0`: parameters that a fit of the document varies by default.

use super::front_matter::Value;
use crate::expressions::Expressions;
use model::{ExpressionKind, Name, Span};
use units::words;

/// Indices of the named parameters, which are separated by commas. Other names are reported and left out.
pub fn read(expressions: &mut Expressions, value: &Value) -> Vec<usize> {
    let source = expressions.source;
    let text = &source[value.span.range()];
    let inside = text.trim_matches(['"', '\'']);
    let mut start = value.span.start + text.find(inside).unwrap_or(0);
    let mut varied = Vec::new();
    for piece in inside.split(',') {
        let range = crate::text::source::trim(source, start..start + piece.len());
        start += piece.len() + 1;
        let span = Span::new(range.start, range.end);
        if range.is_empty() {
            expressions.error(
                "vary",
                words(
                    "`vary` names parameters, with a comma between them",
                    "`vary` nombra parámetros separados por comas",
                ),
                value.span,
            );
            continue;
        }
        // Parsed as in the model, so that `ω₀` and `omega_0` are the same name.
        let (expression, unit, found) = model::parse_expression(source, range);
        let ExpressionKind::Name { name, order: 0 } = expression.kind else {
            let message = words!(
                "`{}` is not the name of a parameter",
                "`{}` no es el nombre de un parámetro",
                &source[span.range()]
            );
            expressions.error("vary", message, span);
            continue;
        };
        if unit.is_some() || !found.is_empty() {
            expressions.error(
                "vary",
                words(
                    "only names stand in `vary`; values and units are the model's",
                    "en `vary` solo van nombres; los valores y las unidades son los del modelo",
                ),
                span,
            );
            continue;
        }
        let Some(parameter) = expressions.parameter(&Name { text: name, span }) else {
            continue;
        };
        if expressions.model().parameters[parameter].choices != program::Choices::Numbers {
            let message = words!(
                "`{}` cannot be varied: it is no number",
                "`{}` no se puede variar: no es un número",
                expressions.model().parameters[parameter].name
            );
            expressions.error("vary", message, span);
            continue;
        }
        if varied.contains(&parameter) {
            let message = words!(
                "`{}` is named twice",
                "`{}` se nombra dos veces",
                expressions.model().parameters[parameter].name
            );
            expressions.error("duplicate-name", message, span);
        } else {
            varied.push(parameter);
        }
    }
    varied
}

#[cfg(test)]
mod tests {
    fn open(vary: &str) -> (Vec<usize>, Vec<String>) {
        let source = format!(
            "---\nvary: {vary}\n---\n```model\nparameter ω₀ = 2 [1/s]\nparameter a = 1 [m]\ny' = -omega_0*y\ny(0) = a\n```\n"
        );
        let opened = crate::open(&source, &[]);
        let said = opened
            .diagnostics
            .iter()
            .map(|(_, found)| format!("{}: {}", &source[found.span().range()], found.message.english));
        (opened.document.map_or_else(Vec::new, |document| document.program.vary), said.collect())
    }

    #[test]
    fn names_are_those_of_the_model() {
        assert_eq!(open("a, omega_0"), (vec![1, 0], Vec::new()));
        assert_eq!(open("\"ω₀\""), (vec![0], Vec::new()));
    }

    #[test]
    fn what_is_no_parameter_is_left_out() {
        let (vary, said) = open("a, a, y, y', 3, b [m],, a b");
        assert_eq!(vary, [1]);
        assert_eq!(
            said,
            [
                "a, a, y, y', 3, b [m],, a b: `vary` names parameters, with a comma between them",
                "a: `a` is named twice",
                "y: `y` is not a parameter of the model",
                "y': `y'` is not the name of a parameter",
                "3: `3` is not the name of a parameter",
                "b [m]: only names stand in `vary`; values and units are the model's",
                "a b: `a b` is not the name of a parameter",
            ]
        );
    }
}

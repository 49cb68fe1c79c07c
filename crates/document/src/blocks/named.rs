//! Lists of parameters in the front matter: `vary: b, v_0`, which a fit varies by default, and `main: b, h_l`, which the page
//! shows first.

use super::front_matter::{FrontMatter, Value};
use crate::expressions::Expressions;
use model::{Diagnostic, ExpressionKind, Grammar, Name, Span, sentence};
use program::Program;
use units::words;

/// Indices of the parameters in `vary`; none without the key. Parameters that are not numbers are reported and left out.
pub fn vary(expressions: &mut Expressions, matter: &FrontMatter) -> Vec<usize> {
    let mut varied = Vec::new();
    for (parameter, span) in names(expressions, matter, "vary") {
        let own = &expressions.model().parameters[parameter];
        if own.choices == program::Choices::Numbers {
            varied.push(parameter);
        } else {
            let message = words!("`{}` cannot be varied: it is no number", own.name);
            expressions.error("vary", message, span);
        }
    }
    varied
}

/// Indices of the parameters in `main`; none without the key. Hidden parameters and those beyond [`Program::MOST_MAIN`] are
/// reported and left out.
pub fn main(expressions: &mut Expressions, matter: &FrontMatter) -> Vec<usize> {
    let mut main = Vec::new();
    for (parameter, span) in names(expressions, matter, "main") {
        if main.len() == Program::MOST_MAIN {
            let message = words!("`main` names more than {} parameters", Program::MOST_MAIN);
            let hint = words("keep those that a reader changes first; the page shows the others under *More*");
            expressions.diagnostics.push(Diagnostic::error("main", message, span).with_hint(hint));
            break;
        }
        if expressions.is_shown(parameter, span) {
            main.push(parameter);
        }
    }
    main
}

/// Parameters named by `key`, separated by commas, with their places. Other names are reported and left out.
fn names(expressions: &mut Expressions, matter: &FrontMatter, key: &'static str) -> Vec<(usize, Span)> {
    matter.get(key).map_or_else(Vec::new, |value| read(expressions, key, value))
}

fn read(expressions: &mut Expressions, key: &'static str, value: &Value) -> Vec<(usize, Span)> {
    let source = expressions.source;
    let text = &source[value.span.range()];
    let inside = text.trim_matches(['"', '\'']);
    let start = value.span.start + text.find(inside).unwrap_or(0);
    let mut named: Vec<(usize, Span)> = Vec::new();
    for phrase in sentence(source, start..start + inside.len(), &Grammar::LIST).phrases() {
        let span = phrase.span();
        if phrase.is_empty() {
            let message = words!("`{key}` names parameters, with a comma between them");
            expressions.error(key, message, value.span);
            continue;
        }
        // Parsed as in the model, so that `ω₀` and `omega_0` are the same name.
        let (expression, unit, found) = model::parse_expression(source, span.range());
        let ExpressionKind::Name { name, order: 0 } = expression.kind else {
            let message = words!("`{}` is not the name of a parameter", &source[span.range()]);
            expressions.error(key, message, span);
            continue;
        };
        if unit.is_some() || !found.is_empty() {
            let message = words!("only names stand in `{key}`; values and units are the model's");
            expressions.error(key, message, span);
            continue;
        }
        let Some(parameter) = expressions.parameter(&Name { text: name, span }) else {
            continue;
        };
        if named.iter().any(|(other, _)| *other == parameter) {
            let message = words!("`{}` is named twice", expressions.model().parameters[parameter].name);
            expressions.error("duplicate-name", message, span);
        } else {
            named.push((parameter, span));
        }
    }
    named
}

#[cfg(test)]
mod tests {
    use program::Program;

    fn open_with(line: &str, list: fn(Program) -> Vec<usize>) -> (Vec<usize>, Vec<String>) {
        let source = format!(
            "---\n{line}\n---\n```model\nparameter ω₀ = 2 [1/s]\nparameter a = 1 [m]\n{}hidden parameter h = 1\n\
             y' = -omega_0*y\ny(0) = a\n```\n",
            ["c", "d", "e", "f"].map(|name| format!("parameter {name} = 1\n")).concat()
        );
        let opened = crate::open(&source, &[]);
        let said = opened
            .diagnostics
            .iter()
            .map(|(_, found)| format!("{}: {}", &source[found.span().range()], found.message.english()));
        (opened.document.map_or_else(Vec::new, |document| list(document.program)), said.collect())
    }

    fn open(vary: &str) -> (Vec<usize>, Vec<String>) {
        open_with(&format!("vary: {vary}"), |program| program.vary)
    }

    #[test]
    fn the_main_parameters_are_at_most_five_that_readers_see() {
        let main = |names: &str| open_with(&format!("main: {names}"), |program| program.main);
        assert_eq!(main("c, omega_0, a"), (vec![2, 0, 1], Vec::new()));
        assert_eq!(
            main("a, b, h, c, d, e, f, omega_0"),
            (
                vec![1, 2, 3, 4, 5],
                vec![
                    "b: `b` is not a parameter of the model".to_owned(),
                    "h: `h` is hidden from readers".to_owned(),
                    "omega_0: `main` names more than 5 parameters".to_owned(),
                ]
            )
        );
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

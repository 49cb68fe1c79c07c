//! Properties of the parser for all texts: it returns, its places lie in the text, and it reports errors.

use model::{Diagnostic, Expression, ExpressionKind, Span, Statement, StatementKind};
use model::{parse, parse_assignments, parse_expression, typeset_expression};
use proptest::prelude::*;

/// Pieces of models, and some that are invalid.
const PIECES: &[&str] = &[
    "a",
    "y",
    "y'",
    "y''",
    "omega_0",
    "γ",
    "ω₀",
    "rho",
    "1",
    "0",
    "2.5",
    "1e3",
    "9.8 [m/s^2]",
    "[m]",
    "[",
    "]",
    "(",
    ")",
    "(0)",
    "{",
    "}",
    "+",
    "-",
    "−",
    "*",
    "·",
    "/",
    "^",
    "²",
    "√",
    "=",
    "==",
    "<",
    "≤",
    "!=",
    ",",
    ";",
    "..",
    "\n",
    "\r\n",
    "# c\n",
    "\"text\"",
    "\"",
    "“x”",
    "'",
    " ",
    "  ",
    "parameter ",
    "independent ",
    "when ",
    "function ",
    "choice ",
    "switch ",
    "group ",
    ":",
    " in ",
    "step ",
    "if ",
    " then ",
    " else ",
    " and ",
    " or ",
    "not ",
    "sin(",
    "log(",
    "$",
    "%",
    "é",
    "\u{307}",
    "\u{0}",
    "1.2.3",
];

pub(super) fn text() -> impl Strategy<Value = String> {
    prop_oneof![
        3 => prop::collection::vec(prop::sample::select(PIECES), 0..40).prop_map(|pieces| pieces.concat()),
        1 => "\\PC{0,60}",
        1 => any::<String>(),
    ]
}

fn lies_in(span: Span, source: &str) -> bool {
    source.get(span.range()).is_some()
}

fn all_lie_in(diagnostics: &[Diagnostic], source: &str) -> bool {
    diagnostics.iter().flat_map(|diagnostic| &diagnostic.labels).all(|label| lies_in(label.span, source))
}

/// All expressions of a statement.
fn expressions(statement: &Statement) -> Vec<&Expression> {
    match &statement.kind {
        StatementKind::Parameter(_)
        | StatementKind::Size(_)
        | StatementKind::Table(_)
        | StatementKind::Group(_)
        | StatementKind::Independent { .. } => Vec::new(),
        StatementKind::Members { left, value, .. } => vec![left, value],
        StatementKind::Definition { value, .. }
        | StatementKind::InitialValue { value, .. }
        | StatementKind::Discrete { value, .. } => vec![value],
        StatementKind::Function(function) => vec![&function.body],
        StatementKind::Choice(choice) => {
            let values = choice.alternatives.iter().flat_map(|alternative| &alternative.values);
            values.map(|value| &value.value).collect()
        }
        StatementKind::Equation { left, right } => vec![left, right],
        StatementKind::Event { condition, actions, extras } => {
            let values = extras.names.iter().chain(actions).map(|action| &action.value);
            std::iter::once(condition).chain(values).collect()
        }
    }
}

/// An expression and all its subexpressions.
fn parts(expression: &Expression) -> Vec<&Expression> {
    std::iter::once(expression).chain(expression.operands().into_iter().flat_map(parts)).collect()
}

/// The expression with all its parentheses; `None` if it is unreadable.
fn written(expression: &Expression) -> Option<String> {
    use model::{BinaryOperator as B, UnaryOperator};
    let primed = |name: &str, order: &u32| format!("{name}{}", "'".repeat(*order as usize));
    Some(match &expression.kind {
        ExpressionKind::Number { value, unit } if *value >= 0.0 => match unit {
            Some(unit) => format!("{value:?} [{unit}]"),
            None => format!("{value:?}"),
        },
        ExpressionKind::Number { .. } | ExpressionKind::Error | ExpressionKind::Expansion(_) => return None,
        ExpressionKind::Text(text) => format!("\"{text}\""),
        ExpressionKind::Name { name, order } => primed(name, order),
        ExpressionKind::InitialValue { name, order } => primed(name, order) + "(0)",
        ExpressionKind::Member { name, indices, order, at_start } => {
            let indices: Option<Vec<String>> = indices.iter().map(written).collect();
            let member = format!("{name}[{}]", indices?.join(", "));
            primed(&member, order) + if *at_start { "(0)" } else { "" }
        }
        ExpressionKind::Reduction { function, body, over } => {
            let range = |over: &model::Over| {
                Some(format!("{} in {}..{}", over.index.text, written(&over.low)?, written(&over.high)?))
            };
            let ranges: Option<Vec<String>> = over.iter().map(range).collect();
            format!("{}({} for {})", function.text, written(body)?, ranges?.join(", "))
        }
        ExpressionKind::Tuple { parts, unit } => {
            let parts: Option<Vec<String>> = parts.iter().map(written).collect();
            let unit = unit.as_ref().map(|unit| format!(" [{unit}]")).unwrap_or_default();
            format!("({}){unit}", parts?.join(", "))
        }
        ExpressionKind::Component { of, axis } => format!("{}.{}", written(of)?, ["x", "y", "z"][*axis]),
        ExpressionKind::Unary(UnaryOperator::Negate, operand) => format!("(-{})", written(operand)?),
        ExpressionKind::Unary(UnaryOperator::Not, operand) => format!("(not {})", written(operand)?),
        ExpressionKind::Binary(operator, left, right) => {
            let sign = match operator {
                B::Add => "+",
                B::Subtract => "-",
                B::Multiply => "*",
                B::Divide => "/",
                B::Power => "^",
                B::Less => "<",
                B::LessOrEqual => "<=",
                B::Greater => ">",
                B::GreaterOrEqual => ">=",
                B::Equal => "==",
                B::NotEqual => "!=",
                B::And => " and ",
                B::Or => " or ",
            };
            format!("({}{sign}{})", written(left)?, written(right)?)
        }
        ExpressionKind::Call { function, arguments } => {
            let arguments: Option<Vec<String>> = arguments.iter().map(written).collect();
            format!("{}({})", function.text, arguments?.join(", "))
        }
        ExpressionKind::If(condition, yes, no) => {
            format!("(if {} then {} else {})", written(condition)?, written(yes)?, written(no)?)
        }
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn every_text_is_a_model_or_told_why_not(source in text()) {
        let (statements, diagnostics) = parse(&source, std::slice::from_ref(&(0..source.len())));
        prop_assert!(all_lie_in(&diagnostics, &source));
        for statement in &statements {
            prop_assert!(lies_in(statement.span, &source));
            for part in expressions(statement).into_iter().flat_map(parts) {
                prop_assert!(lies_in(part.span, &source));
                prop_assert!(part.kind != ExpressionKind::Error || !diagnostics.is_empty());
            }
        }
    }

    #[test]
    fn any_range_may_be_asked_for(source in text(), start in 0_usize..80, length in 0_usize..80) {
        let range = start..start + length;
        let (_, diagnostics) = parse(&source, std::slice::from_ref(&range));
        prop_assert!(all_lie_in(&diagnostics, &source));
        let (expression, _, diagnostics) = parse_expression(&source, range.clone());
        prop_assert!(lies_in(expression.span, &source) && all_lie_in(&diagnostics, &source));
        prop_assert!(typeset_expression(&expression).starts_with("<math>"));
        let (assignments, diagnostics) = parse_assignments(&source, range);
        prop_assert!(assignments.iter().all(|one| lies_in(one.value.span, &source) && lies_in(one.name.span, &source)));
        prop_assert!(all_lie_in(&diagnostics, &source));
    }

    #[test]
    fn what_was_read_can_be_written_and_read_again(source in text()) {
        let (expression, _, diagnostics) = parse_expression(&source, 0..source.len());
        if diagnostics.is_empty() && let Some(text) = written(&expression) {
            let (again, _, diagnostics) = parse_expression(&text, 0..text.len());
            prop_assert!(diagnostics.is_empty(), "{text}: {diagnostics:?}");
            prop_assert_eq!(written(&again), Some(text));
        }
    }
}

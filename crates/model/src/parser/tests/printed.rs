//! Syntax trees as one line of text.

use crate::{
    BinaryOperator, Expression, ExpressionKind, Over, ParameterForm, StatedUnit, Statement, StatementKind,
    UnaryOperator,
};

/// The tree with all parentheses.
pub(super) fn shown(expression: &Expression) -> String {
    let primed = |name: &str, order: u32| format!("{name}{}", "'".repeat(order as usize));
    match &expression.kind {
        ExpressionKind::Number { value, unit: None } => value.to_string(),
        ExpressionKind::Number { value, unit: Some(unit) } => format!("{value}[{unit}]"),
        ExpressionKind::Text(text) => format!("{text:?}"),
        ExpressionKind::Name { name, order } => primed(name, *order),
        ExpressionKind::InitialValue { name, order } => primed(name, *order) + "@0",
        ExpressionKind::Member { name, indices, order, at_start } => {
            let indices = indices.iter().map(shown).collect::<Vec<_>>().join(", ");
            primed(&format!("{name}[{indices}]"), *order) + if *at_start { "@0" } else { "" }
        }
        ExpressionKind::Reduction { function, body, over } => {
            format!("{}({}{})", function.text, shown(body), shown_over(over))
        }
        ExpressionKind::Unary(UnaryOperator::Negate, operand) => format!("(-{})", shown(operand)),
        ExpressionKind::Unary(UnaryOperator::Not, operand) => format!("(not {})", shown(operand)),
        ExpressionKind::Binary(operator, left, right) => {
            let sign = match operator {
                BinaryOperator::Add => "+",
                BinaryOperator::Subtract => "-",
                BinaryOperator::Multiply => "*",
                BinaryOperator::Divide => "/",
                BinaryOperator::Power => "^",
                BinaryOperator::Less => "<",
                BinaryOperator::LessOrEqual => "<=",
                BinaryOperator::Greater => ">",
                BinaryOperator::GreaterOrEqual => ">=",
                BinaryOperator::Equal => "==",
                BinaryOperator::NotEqual => "!=",
                BinaryOperator::And => " and ",
                BinaryOperator::Or => " or ",
            };
            format!("({}{sign}{})", shown(left), shown(right))
        }
        ExpressionKind::Call { function, arguments } => {
            format!("{}({})", function.text, arguments.iter().map(shown).collect::<Vec<_>>().join(", "))
        }
        ExpressionKind::If(condition, yes, no) => {
            format!("(if {} then {} else {})", shown(condition), shown(yes), shown(no))
        }
        ExpressionKind::Tuple { parts, unit } => {
            let parts: Vec<String> = parts.iter().map(shown).collect();
            format!("({}){}", parts.join(", "), unit.as_ref().map(|unit| format!("[{unit}]")).unwrap_or_default())
        }
        ExpressionKind::Component { of, axis } => format!("{}.{}", shown(of), ["x", "y", "z"][*axis]),
        ExpressionKind::Error | ExpressionKind::Expansion(_) => "?".to_owned(),
    }
}

fn shown_over(over: &[Over]) -> String {
    let range = |over: &Over| format!(" for {} in {}..{}", over.index.text, shown(&over.low), shown(&over.high));
    over.iter().map(range).collect()
}

pub(super) fn in_unit(unit: &Option<StatedUnit>) -> String {
    unit.as_ref().map_or(String::new(), |stated| format!(" in [{}]", stated.unit))
}

pub(super) fn shown_statement(statement: &Statement) -> String {
    let text = match &statement.kind {
        StatementKind::Parameter(switch) if switch.form == ParameterForm::Switch => {
            format!("switch {}={}", switch.name.text, switch.value)
        }
        StatementKind::Parameter(parameter) => {
            let range = parameter.range.as_ref().map_or(String::new(), |r| format!(" {}..{}", r.low, r.high));
            let step = parameter.step.map_or(String::new(), |step| format!(" step {step}"));
            format!("parameter {}={}{}{range}{step}", parameter.name.text, parameter.value, in_unit(&parameter.unit))
        }
        StatementKind::Group(name) => format!("group {:?}", name.text),
        StatementKind::Size(size) => {
            let range = size.range.as_ref().map_or(String::new(), |r| format!(" {}..{}", r.low, r.high));
            format!("size {}={}{range}", size.name.text, size.value)
        }
        StatementKind::Members { what, left, value, unit } => {
            format!("{what:?} {} := {}{}", shown(left), shown(value), in_unit(unit))
        }
        StatementKind::Independent { name, unit, .. } => format!("independent {}{}", name.text, in_unit(unit)),
        StatementKind::Definition { name, value, unit } => {
            format!("{} := {}{}", name.text, shown(value), in_unit(unit))
        }
        StatementKind::InitialValue { name, order, value, unit } => {
            format!("{}{}@0 := {}{}", name.text, "'".repeat(*order as usize), shown(value), in_unit(unit))
        }
        StatementKind::Discrete { name, value, unit, .. } => {
            format!("discrete {} := {}{}", name.text, shown(value), in_unit(unit))
        }
        StatementKind::Choice(choice) => {
            let value = |value: &crate::ChosenValue| {
                let hidden = if value.hidden { "hidden " } else { "" };
                let label = value.label.as_ref().map_or(String::new(), |label| format!(" {:?}", label.text));
                format!("{hidden}{} := {}{label}", value.name.text, shown(&value.value))
            };
            let alternative = |one: &crate::Alternative| {
                format!("{:?}: {}", one.text.text, one.values.iter().map(value).collect::<Vec<_>>().join(", "))
            };
            let alternatives: Vec<String> = choice.alternatives.iter().map(alternative).collect();
            let label = choice.label.as_ref().map_or(String::new(), |label| format!(" {:?}", label.text));
            format!("choice {}{label} {{{}}}", choice.name.text, alternatives.join("; "))
        }
        StatementKind::Function(function) => {
            let parameters: Vec<&str> = function.parameters.iter().map(|parameter| parameter.text.as_str()).collect();
            let (name, body) = (&function.name.text, shown(&function.body));
            format!("function {name}({}) := {body}{}", parameters.join(", "), in_unit(&function.unit))
        }
        StatementKind::Table(table) => {
            let points: Vec<String> = table.points.iter().map(|point| format!("{} {}", point.x, point.y)).collect();
            let (name, argument) = (&table.name.text, &table.argument.text);
            let argument = format!("{argument}{}", in_unit(&table.argument_unit));
            format!("{:?} {name}({argument}){} {{{}}}", table.course, in_unit(&table.unit), points.join(", "))
        }
        StatementKind::Equation { left, right } => format!("{} = {}", shown(left), shown(right)),
        StatementKind::Event { condition, actions, .. } => {
            let actions: Vec<String> = actions
                .iter()
                .map(|a| {
                    let indices: Vec<String> = a.indices.iter().map(|index| format!("[{}]", shown(index))).collect();
                    let target = format!("{}{}{}", a.name.text, indices.concat(), "'".repeat(a.order as usize));
                    format!("{target} := {}{}", shown(&a.value), shown_over(&a.over))
                })
                .collect();
            format!("when {} {{{}}}", shown(condition), actions.join("; "))
        }
    };
    let label = statement.label.as_ref().map_or(String::new(), |label| format!(" {:?}", label.text));
    text + &shown_over(&statement.over) + &label
}

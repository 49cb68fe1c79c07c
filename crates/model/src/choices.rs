//! Choices: a parameter whose value is a text. Each name that the alternatives define becomes one definition that selects
//! by the parameter.

use crate::{
    BinaryOperator, ChoiceStatement, ChosenValue, Diagnostic, Expression, ExpressionKind, ParameterForm,
    ParameterStatement, Quoted, Statement, StatementKind, limits,
};
use std::collections::BTreeMap;
use units::words;

/// Replaces each choice by its parameter and definitions. `None` if there are no choices.
pub(crate) fn spread(statements: &[Statement], diagnostics: &mut Vec<Diagnostic>) -> Option<Vec<Statement>> {
    if !statements.iter().any(|statement| matches!(statement.kind, StatementKind::Choice(_))) {
        return None;
    }
    let mut spread = Vec::new();
    for statement in statements {
        match &statement.kind {
            StatementKind::Choice(choice) if check(choice, diagnostics) => {
                let parameter = StatementKind::Parameter(parameter(choice));
                spread.push(Statement { label: choice.label.clone(), ..Statement::of(parameter, statement.span) });
                spread.extend(definitions(choice).map(|definition| Statement { span: statement.span, ..definition }));
            }
            StatementKind::Choice(_) => {}
            _ => spread.push(statement.clone()),
        }
    }
    Some(spread)
}

fn parameter(choice: &ChoiceStatement) -> ParameterStatement {
    let texts = choice.alternatives.iter().map(|alternative| alternative.text.text.clone()).collect();
    ParameterStatement { value: 0.0, ..ParameterStatement::bare(choice.name.clone(), ParameterForm::Choice(texts)) }
}

/// The definitions of a choice: `rho = if liquid == "Water" then ... else ...`. The unit stated in the first alternative,
/// or else the unit of its number, holds for all alternatives.
pub(crate) fn definitions(choice: &ChoiceStatement) -> impl Iterator<Item = Statement> {
    let first = choice.alternatives.first().into_iter();
    first.flat_map(|first| &first.values).map(|value| definition(choice, value))
}

fn definition(choice: &ChoiceStatement, first: &ChosenValue) -> Statement {
    let name = &first.name;
    let unit = first.unit.clone().or_else(|| match &first.value.kind {
        ExpressionKind::Number { unit: Some(unit), .. } => {
            Some(crate::StatedUnit { unit: unit.clone(), span: first.value.span })
        }
        _ => None,
    });
    let mut value: Option<Expression> = None;
    for alternative in choice.alternatives.iter().rev() {
        let own = alternative.values.iter().find(|value| value.name.text == name.text).unwrap_or(first);
        let span = own.value.span;
        let mut own = own.value.clone();
        if let (ExpressionKind::Number { value, unit: Some(of_number) }, Some(stated)) = (&mut own.kind, &unit)
            && of_number.turning(&stated.unit) != 1.0
        {
            *value = stated.unit.from_si(of_number.to_si_of(*value, &stated.unit));
            *of_number = stated.unit.clone();
        }
        value = Some(match value {
            None => own,
            Some(others) => {
                let chosen = Expression::named(&choice.name.text, span);
                let text = Expression { kind: ExpressionKind::Text(alternative.text.text.clone()), span };
                let condition = Expression::binary(BinaryOperator::Equal, chosen, text, span);
                Expression::conditional(condition, own, others, span)
            }
        });
    }
    let value = value.unwrap_or_else(|| first.value.clone());
    let all = || choice.alternatives.iter().flat_map(|one| &one.values).filter(|one| one.name.text == name.text);
    Statement {
        label: all().find_map(|one| one.label.clone()),
        hidden: all().any(|one| one.hidden),
        ..Statement::of(StatementKind::Definition { name: name.clone(), value, unit }, name.span)
    }
}

/// Pairs of a label that differs from an earlier label of the same quantity, and that earlier label.
fn differing_labels(choice: &ChoiceStatement) -> Vec<(&Quoted, &Quoted)> {
    let mut labels: BTreeMap<&str, &Quoted> = BTreeMap::new();
    let mut differing = Vec::new();
    for value in choice.alternatives.iter().flat_map(|alternative| &alternative.values) {
        if let Some(label) = &value.label {
            let first = *labels.entry(&value.name.text).or_insert(label);
            if first.text != label.text {
                differing.push((label, first));
            }
        }
    }
    differing
}

/// True if every alternative defines the same names, each once. Reports errors.
fn check(choice: &ChoiceStatement, diagnostics: &mut Vec<Diagnostic>) -> bool {
    let before = diagnostics.len();
    let Some((first, others)) = choice.alternatives.split_first() else { return false };
    if let Some(beyond) = choice.alternatives.get(limits::ALTERNATIVES) {
        let message = words!("`{}` has more than {} alternatives", choice.name.text, limits::ALTERNATIVES);
        diagnostics.push(Diagnostic::error("model-too-large", message, beyond.text.span));
        return false;
    }
    for (index, alternative) in choice.alternatives.iter().enumerate() {
        let text = &alternative.text.text;
        if let Some(same) = choice.alternatives[..index].iter().find(|earlier| earlier.text.text == *text) {
            let message = words!("there are two alternatives \"{text}\"");
            let diagnostic = Diagnostic::error("duplicate-name", message, alternative.text.span);
            diagnostics.push(diagnostic.with_label(same.text.span, words("the first is here")));
        }
        for (place, value) in alternative.values.iter().enumerate() {
            let name = &value.name.text;
            if let Some(earlier) = alternative.values[..place].iter().find(|earlier| earlier.name.text == *name) {
                let message = words!("`{name}` is set twice");
                let diagnostic = Diagnostic::error("duplicate-name", message, value.name.span);
                diagnostics.push(diagnostic.with_label(earlier.name.span, words("first here")));
            }
        }
    }
    for (label, first) in differing_labels(choice) {
        let message = words("this quantity has two labels");
        diagnostics.push(
            Diagnostic::error("duplicate-name", message, label.span)
                .with_label(first.span, words("the first is here"))
                .with_hint(words("a label in one of the alternatives holds for all")),
        );
    }
    for other in others {
        let defines = |values: &[ChosenValue], name: &str| values.iter().any(|value| value.name.text == name);
        for (has, lacks) in [(first, other), (other, first)] {
            for value in has.values.iter().filter(|value| !defines(&lacks.values, &value.name.text)) {
                let (name, text) = (&value.name.text, &lacks.text.text);
                let message = words!("\"{text}\" does not define `{name}`");
                diagnostics.push(
                    Diagnostic::error("choice-incomplete", message, lacks.text.span)
                        .with_label(value.name.span, words("it is defined here"))
                        .with_hint(words("every alternative defines the same names")),
                );
            }
        }
    }
    diagnostics.len() == before
}

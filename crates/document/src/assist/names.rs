//! Names of a model with their descriptions.

use super::place::word_at;
use super::suggestion::{Suggestion, SuggestionKind};
use crate::Outline;
use model::{ExpressionKind, Name, Span, Statement, StatementKind};
use program::{Model, Program};
use units::{Dimension, Language, Unit, Words, words};

/// Names declared in a document, each once, in text order, and the names that every document has.
pub fn names(outline: &Outline, program: Option<&Program>) -> Vec<Suggestion> {
    let mut names: Vec<Suggestion> = Vec::new();
    let mut add = |name: Suggestion| {
        if !names.iter().any(|known| known.text == name.text) {
            names.push(name);
        }
    };
    for Declared { name, what, label, .. } in declared(outline) {
        let kind = if what == FUNCTION { SuggestionKind::Function } else { SuggestionKind::Name };
        let meaning = described(name, label, what, program);
        add(Suggestion { kind, text: name.to_owned(), meaning });
    }
    let independent = program.map_or("t", |program| &program.model.independent.name);
    for (text, meaning) in
        [(independent, words("independent variable")), ("pi", words("3.14159..., half a turn in radians"))]
    {
        add(Suggestion { kind: SuggestionKind::Name, text: text.to_owned(), meaning });
    }
    names
}

/// Name of the independent variable and its unit; the unit is empty for a number.
pub fn independent(outline: &Outline) -> (String, String) {
    let statements = outline.blocks().iter().flat_map(|block| &block.statements);
    let mut declared = statements.filter_map(|statement| match &statement.kind {
        StatementKind::Independent { name, unit, .. } => {
            Some((name.text.clone(), unit.as_ref().map(|unit| unit.unit.text.clone()).unwrap_or_default()))
        }
        _ => None,
    });
    declared.next().unwrap_or_else(|| ("t".to_owned(), "s".to_owned()))
}

/// Description of a function of the document.
pub const FUNCTION: Words = words("function of this document");

/// A name that a statement declares.
pub struct Declared<'a> {
    /// The name in ASCII letters.
    pub name: &'a str,
    /// Its place, without primes and indices.
    pub span: Span,
    /// Description in words.
    pub what: Words,
    /// Label of the statement.
    pub label: Option<&'a str>,
}

/// The names that a document declares, in text order. A state is declared once for each initial value.
pub fn declared<'a>(outline: &'a Outline) -> Vec<Declared<'a>> {
    let statements = outline.blocks().iter().flat_map(|block| &block.statements);
    statements.flat_map(|statement| declared_by(outline, statement)).collect()
}

/// The names that a statement of the document declares.
pub fn declared_by<'a>(outline: &Outline, statement: &'a Statement) -> Vec<Declared<'a>> {
    let label = statement.label.as_ref().map(|label| label.text.as_str());
    let named = given(statement).into_iter();
    let declared = named.map(|(name, place, what)| {
        let span = word_at(outline.source(), place.start).unwrap_or(place);
        Declared { name, span, what, label }
    });
    declared.collect()
}

fn one(name: &Name, what: Words) -> Vec<(&str, Span, Words)> {
    vec![(&name.text, name.span, what)]
}

/// Names that a statement declares, with the places where they begin and their kinds.
fn given(statement: &Statement) -> Vec<(&str, Span, Words)> {
    match &statement.kind {
        StatementKind::Parameter(parameter) => one(&parameter.name, words("parameter")),
        StatementKind::Size(size) => one(&size.name, words("size of families")),
        StatementKind::Choice(choice) => {
            let values = choice.alternatives.iter().flat_map(|alternative| &alternative.values);
            let chosen = values.flat_map(|value| one(&value.name, words("decided by a choice")));
            one(&choice.name, words("choice")).into_iter().chain(chosen).collect()
        }
        StatementKind::Definition { name, .. } => one(name, words("quantity")),
        StatementKind::InitialValue { name, .. } => one(name, words("state")),
        StatementKind::Discrete { name, .. } => one(name, words("changes at events only")),
        StatementKind::Members { left, .. } => match &left.kind {
            ExpressionKind::Member { name, .. } => vec![(name, left.span, words("family"))],
            _ => Vec::new(),
        },
        StatementKind::Function(function) => one(&function.name, FUNCTION),
        StatementKind::Table(table) => one(&table.name, words("table")),
        StatementKind::Event { extras, .. } => extras.name.iter().flat_map(|name| one(name, words("event"))).collect(),
        _ => Vec::new(),
    }
}

/// Description of a name: `Damping, parameter in kg/s`.
fn described(name: &str, label: Option<&str>, what: Words, program: Option<&Program>) -> Words {
    let unit = program.and_then(|program| unit(&program.model, name)).filter(|unit| !unit.text.is_empty());
    let what = match unit {
        Some(unit) => {
            words!("{what} in {unit}", unit = Words::same(unit.text.clone()))
        }
        None => what,
    };
    match label {
        Some(label) => words!("{label}, {what}", label = translated(label, program)),
        None => what,
    }
}

/// A label in all languages of the document.
fn translated(label: &str, program: Option<&Program>) -> Words {
    let text = |language: Language| program.map_or(label, |program| program.text(language.tag(), label)).to_owned();
    let texts = Language::ALL.map(text);
    Words::each(move |language| texts[language as usize].clone())
}

/// Dimension of a name with `order` primes.
pub fn dimension(model: &Model, name: &str, order: usize) -> Option<Dimension> {
    let time = model.independent.unit.dimension;
    let mut dimension = unit(model, name)?.dimension;
    for _ in 0..order {
        dimension = dimension.per(time)?;
    }
    Some(dimension)
}

fn unit<'a>(model: &'a Model, name: &str) -> Option<&'a Unit> {
    let parameter = model.parameters.iter().find(|parameter| parameter.name == name).map(|parameter| &parameter.unit);
    let state =
        || model.states.iter().find(|state| state.order == 0 && state.variable == name).map(|state| &state.unit);
    let quantity =
        || model.quantities.iter().find(|quantity| quantity.name == name).map(|quantity| &quantity.value.unit);
    parameter.or_else(state).or_else(quantity)
}

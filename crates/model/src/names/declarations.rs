//! The statements of a model by kind, and the checks that need only the statements: duplicate names, reserved names, ranges
//! of parameters.

use super::assigned::check_assigned;
use super::scope::{Meaning, PI, Scope};
use crate::notation::primed;
use crate::{
    Action, Diagnostic, Expression, ExpressionKind, FunctionStatement, Name, ParameterForm, ParameterStatement, Quoted,
    Span, StatedUnit, Statement, StatementKind, TableStatement,
};
use program::functions::Function;
use std::collections::HashMap;
use units::order::sort;
use units::{Unit, words};

/// Statements of a model by kind, each kind in text order.
#[derive(Debug)]
pub(crate) struct Declarations<'a> {
    pub independent: (String, Unit),
    /// True if the independent variable is discrete.
    pub counts: bool,
    pub parameters: Vec<ParameterEntry<'a>>,
    pub definitions: Vec<Definition<'a>>,
    pub initial_values: Vec<InitialEntry<'a>>,
    pub equations: Vec<Equation<'a>>,
    pub events: Vec<EventEntry<'a>>,
    pub functions: Vec<&'a FunctionStatement>,
    pub tables: Vec<TableEntry<'a>>,
    pub scope: Scope,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct ParameterEntry<'a> {
    pub statement: &'a ParameterStatement,
    pub label: Option<&'a str>,
    /// Group of its control.
    pub group: Option<&'a str>,
    /// True if readers do not see it.
    pub hidden: bool,
    pub span: Span,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct TableEntry<'a> {
    pub statement: &'a TableStatement,
    pub label: Option<&'a str>,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Definition<'a> {
    pub name: &'a Name,
    pub value: &'a Expression,
    pub unit: Option<&'a StatedUnit>,
    pub label: Option<&'a str>,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct InitialEntry<'a> {
    pub name: &'a Name,
    pub order: u32,
    pub value: &'a Expression,
    pub unit: Option<&'a StatedUnit>,
    pub label: Option<&'a str>,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Equation<'a> {
    pub left: &'a Expression,
    pub right: &'a Expression,
    pub span: Span,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct EventEntry<'a> {
    pub condition: &'a Expression,
    pub actions: &'a [Action],
    /// Its label or the title of its button, or else its name.
    pub title: Option<&'a str>,
    pub is_labelled: bool,
    /// Title of its button.
    pub button: Option<&'a Quoted>,
    pub name: Option<&'a Name>,
    pub stops: bool,
    pub span: Span,
}

impl<'a> Declarations<'a> {
    /// Sorts the statements by kind and declares parameters, definitions and the independent variable.
    pub fn collect(statements: &'a [Statement], diagnostics: &mut Vec<Diagnostic>) -> Self {
        let independent = independent(statements, diagnostics);
        let mut declared: HashMap<&str, Span> = HashMap::new();
        let mut declarations = Self {
            scope: Scope::new(&independent.0),
            independent,
            counts: crate::maps::counts(statements),
            parameters: Vec::new(),
            definitions: Vec::new(),
            initial_values: Vec::new(),
            equations: Vec::new(),
            events: Vec::new(),
            functions: Vec::new(),
            tables: Vec::new(),
        };
        let mut group = None;
        for statement in statements {
            let span = statement.span;
            let label = statement.label.as_ref().map(|label| label.text.as_str());
            match &statement.kind {
                StatementKind::Parameter(parameter) => {
                    check_parameter(parameter, diagnostics);
                    check_assigned(parameter, diagnostics);
                    if declarations.may_declare(&parameter.name, &mut declared, diagnostics) {
                        let meaning = Meaning::Parameter(declarations.parameters.len());
                        declarations.scope.declare(&parameter.name.text, meaning);
                        declarations.scope.declare_label(&parameter.name.text, label);
                        if let ParameterForm::Choice(texts) = &parameter.form {
                            declarations.scope.declare_choice(&parameter.name.text, texts.clone());
                        }
                        let hidden = statement.hidden;
                        let entry = ParameterEntry { statement: parameter, label, group, hidden, span };
                        declarations.parameters.push(entry);
                    }
                }
                StatementKind::Group(name) => group = Some(name.text.as_str()),
                StatementKind::Definition { name, value, unit } => {
                    if declarations.may_declare(name, &mut declared, diagnostics) {
                        let meaning = Meaning::Definition(declarations.definitions.len());
                        declarations.scope.declare(&name.text, meaning);
                        declarations.scope.declare_label(&name.text, label);
                        if let Some(texts) = texts(value) {
                            declarations.scope.declare_choice(&name.text, texts);
                        }
                        declarations.definitions.push(Definition { name, value, unit: unit.as_ref(), label });
                    }
                }
                StatementKind::InitialValue { name, order, value, unit } => {
                    let order = *order;
                    declarations.scope.declare_label(&primed(&name.text, order), label);
                    declarations.initial_values.push(InitialEntry { name, order, value, unit: unit.as_ref(), label });
                }
                StatementKind::Discrete { name, value, unit, rate } => {
                    let [left, right] = &**rate;
                    if declarations.may_declare(name, &mut declared, diagnostics) {
                        let entry = InitialEntry { name, order: 0, value, unit: unit.as_ref(), label };
                        declarations.initial_values.push(entry);
                        declarations.equations.push(Equation { left, right, span });
                    }
                }
                StatementKind::Function(function) => {
                    if declarations.may_declare(&function.name, &mut declared, diagnostics) {
                        declarations.scope.declare_functions([function.name.text.as_str()]);
                        declarations.functions.push(function);
                    }
                }
                StatementKind::Table(table) => {
                    if declarations.may_declare(&table.name, &mut declared, diagnostics) {
                        let label = label.or(table.label.as_ref().map(|label| label.text.as_str()));
                        match table.checked(declarations.tables.len(), diagnostics) {
                            Some(function) => declarations.scope.declare_table(&table.name.text, function),
                            // Declared nevertheless, so that calls of an invalid table are not reported as well.
                            None => declarations.scope.declare_functions([table.name.text.as_str()]),
                        }
                        declarations.tables.push(TableEntry { statement: table, label });
                    }
                }
                StatementKind::Equation { left, right } => declarations.equations.push(Equation { left, right, span }),
                StatementKind::Event { condition, actions, extras } => {
                    let (button, name) = (extras.button.as_ref(), extras.name.as_ref());
                    let label = label.or(button.map(|button| button.text.as_str()));
                    declarations.events.push(EventEntry {
                        condition,
                        actions,
                        title: label.or(name.map(|name| name.text.as_str())),
                        is_labelled: label.is_some(),
                        button,
                        name,
                        stops: extras.stop.is_some(),
                        span,
                    });
                }
                // Choices, families and sizes have been expanded before.
                StatementKind::Independent { .. }
                | StatementKind::Choice(_)
                | StatementKind::Size(_)
                | StatementKind::Members { .. } => {}
            }
        }
        declarations.check_buttons(diagnostics);
        declarations
    }

    /// Reports buttons with the same title.
    fn check_buttons(&self, diagnostics: &mut Vec<Diagnostic>) {
        let mut titles: HashMap<&str, Span> = HashMap::new();
        for title in self.events.iter().filter_map(|event| event.button) {
            let Some(first) = titles.insert(title.text.trim(), title.span) else { continue };
            let message = words!("two buttons have the title \"{}\"", title.text.trim());
            diagnostics.push(
                Diagnostic::error("duplicate-name", message, title.span)
                    .with_label(first, words("the first is here"))
                    .with_hint(words("give one of them another title")),
            );
        }
    }

    /// True if a name can be declared; reports the reason if not.
    fn may_declare<'b>(
        &self,
        name: &'b Name,
        declared: &mut HashMap<&'b str, Span>,
        diagnostics: &mut Vec<Diagnostic>,
    ) -> bool {
        let text = name.text.as_str();
        if let Some(&first) = declared.get(text) {
            let message = words!("`{text}` is declared twice");
            diagnostics.push(
                Diagnostic::error("duplicate-name", message, name.span)
                    .saying(words("declared again here"))
                    .with_label(first, words("first declared here"))
                    .with_hint(words("give one of them another name")),
            );
            return false;
        }
        declared.insert(text, name.span);
        let reason = if text == PI {
            words("it is the number 3.14159")
        } else if text == self.independent.0 {
            words("it is the independent variable")
        } else if Function::reserving(text).is_some() {
            words("it is a function")
        } else {
            return true;
        };
        let mut diagnostic =
            Diagnostic::error("reserved-name", words!("`{text}` cannot be declared: {reason}"), name.span)
                .with_hint(words!("choose another name, such as `{text}_1`"));
        if text == self.independent.0 {
            let hint = words("or name another independent variable: `independent x in [m]`");
            diagnostic = diagnostic.with_hint(hint);
        }
        diagnostics.push(diagnostic);
        false
    }
}

/// Name and unit of the independent variable: `t` in seconds unless a statement gives another.
fn independent(statements: &[Statement], diagnostics: &mut Vec<Diagnostic>) -> (String, Unit) {
    let mut stated: Option<(&Name, Unit)> = None;
    for statement in statements {
        let StatementKind::Independent { name, unit, .. } = &statement.kind else {
            continue;
        };
        if let Some((first, _)) = &stated {
            diagnostics.push(
                Diagnostic::error(
                    "duplicate-independent",
                    words("there is more than one independent variable"),
                    name.span,
                )
                .with_label(first.span, words("the first is named here"))
                .with_hint(words("partial differential equations are not solved here; keep one of them")),
            );
            continue;
        }
        if name.text == PI || Function::reserving(&name.text).is_some() {
            let message = words!("`{}` cannot be the independent variable: the name is reserved", name.text);
            diagnostics.push(Diagnostic::error("reserved-name", message, name.span));
        }
        let unit = unit.as_ref().map_or_else(Unit::dimensionless, |stated| stated.unit.clone());
        stated = Some((name, unit));
    }
    match stated {
        Some((name, unit)) => (name.text.clone(), unit),
        None => ("t".to_owned(), Unit::si(units::Dimension::TIME)),
    }
}

fn check_parameter(parameter: &ParameterStatement, diagnostics: &mut Vec<Diagnostic>) {
    let name = &parameter.name.text;
    let unit = parameter.unit.as_ref().map(|stated| format!(" {}", stated.unit)).unwrap_or_default();
    let value = parameter.value;
    if !value.is_finite() {
        let message = words!("the value of `{name}` is too large for a number");
        diagnostics.push(Diagnostic::error("number-too-large", message, parameter.value_span));
    }
    if let Some(bounds) = &parameter.range {
        let (low, high) = (bounds.low, bounds.high);
        if low > high {
            diagnostics.push(
                Diagnostic::error(
                    "empty-range",
                    words!("the range of `{name}` is empty: {low} is greater than {high}"),
                    bounds.span,
                )
                .with_hint(words!("write `in {high}..{low}`")),
            );
        } else if !(low..=high).contains(&value) {
            diagnostics.push(
                Diagnostic::error(
                    "default-out-of-range",
                    words!("the value of `{name}`, {value}{unit}, lies outside its range {low}..{high}{unit}"),
                    parameter.value_span,
                )
                .with_label(bounds.span, words("the range, in the unit of the value"))
                .with_hint(words("widen the range or change the value")),
            );
        }
    }
    if let Some(step) = parameter.step
        && !(step > 0.0 && step.is_finite())
    {
        let message = words!("the step of `{name}` is {step}: it must be greater than 0");
        diagnostics.push(Diagnostic::error("step-not-positive", message, parameter.name.span));
    }
}

/// Texts among which an expression selects; `None` if its value can be anything else.
fn texts(value: &Expression) -> Option<Vec<String>> {
    let mut texts = Vec::new();
    let mut waiting = vec![value];
    while let Some(next) = waiting.pop() {
        match &next.kind {
            ExpressionKind::Text(text) => texts.push(text.clone()),
            ExpressionKind::If(_, chosen, other) => waiting.extend([&**other, &**chosen]),
            _ => return None,
        }
    }
    sort(&mut texts);
    texts.dedup();
    Some(texts)
}

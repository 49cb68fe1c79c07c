//! Controls and values of the model, in the order in which the page shows them.

use crate::Outline;
use crate::text::source::trim;
use model::{Expression, Members, Quoted, Span, Statement, StatementKind};
use program::{Kind, Program, Role};

/// List in which a control or value is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Place {
    /// Sizes of families, before the parameters.
    Size,
    /// Parameters, switches, random seeds, choices and groups of controls, in text order.
    Parameter,
    /// Unknowns and discrete quantities, in the order of their first mention in the equations.
    Unknown,
    /// Definitions, in text order, after the unknowns.
    Computed,
}

impl Place {
    /// True if the page shows this list in the order of the statements.
    pub fn is_ordered(self) -> bool {
        self != Self::Unknown
    }
}

/// A control or a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shown {
    /// Index of its statement in the [form](super::Form).
    pub number: usize,
    /// List in which it is shown.
    pub place: Place,
    /// Name, with primes and indices; empty for a group of controls.
    pub name: String,
    /// Label, or name of the group; empty without one.
    pub label: String,
    /// Place of the label with its quotation marks, or place of its insertion.
    pub label_at: Span,
    /// True if its value is left out of the readouts.
    pub is_hidden: bool,
    /// True for a group: the heading of the controls after it.
    pub is_group: bool,
}

/// Controls and values of a document, in text order. Unreadable statements are left out.
pub fn shown(outline: &Outline) -> Vec<Shown> {
    let source = outline.source();
    let models = outline.blocks().iter().flat_map(|block| {
        let is_model = block.kind == crate::BlockKind::Model;
        block.statements.iter().map(move |statement| (is_model, statement))
    });
    let one = |(number, (is_model, statement)): (usize, (bool, &Statement))| {
        let (place, name) = named(source, statement).filter(|_| is_model)?;
        let end = source[..trim(source, statement.span.range()).end].trim_end().len();
        let label = match &statement.kind {
            StatementKind::Choice(choice) => choice.label.as_ref(),
            StatementKind::Group(name) => Some(name),
            _ => statement.label.as_ref(),
        };
        let behind = match &statement.kind {
            StatementKind::Choice(choice) => choice.name.span.end,
            _ => end,
        };
        Some(Shown {
            number,
            place,
            name,
            label: label.map(|label| label.text.clone()).unwrap_or_default(),
            label_at: label.map_or(Span::new(behind, behind), |label: &Quoted| label.span),
            is_hidden: statement.hidden,
            is_group: matches!(statement.kind, StatementKind::Group(_)),
        })
    };
    models.enumerate().filter_map(one).collect()
}

/// Quantities that can be plotted, with their labels: those that vary during a run, after the independent variable if
/// `with_independent`.
pub fn plottable(program: &Program, with_independent: bool) -> Vec<(String, Option<String>)> {
    let model = &program.model;
    let independent = with_independent.then(|| (model.independent.name.clone(), None));
    let states = model.states.iter().filter(|state| matches!(state.role, Role::Own | Role::Hidden));
    let states = states.map(|state| (state.name(), state.label.clone()));
    let quantities = model.quantities.iter().filter(|quantity| !quantity.remembered && quantity.varies);
    let numbers = quantities.filter(|quantity| quantity.value.kind == Kind::Number);
    let quantities = numbers.map(|quantity| (quantity.name.clone(), quantity.label.clone()));
    independent.into_iter().chain(states).chain(quantities).collect()
}

fn named(source: &str, statement: &Statement) -> Option<(Place, String)> {
    let of = |expression: &Expression| source[expression.span.range()].to_owned();
    Some(match &statement.kind {
        StatementKind::Parameter(parameter) => (Place::Parameter, parameter.name.text.clone()),
        StatementKind::Choice(choice) => (Place::Parameter, choice.name.text.clone()),
        StatementKind::Group(_) => (Place::Parameter, String::new()),
        StatementKind::Size(size) => (Place::Size, size.name.text.clone()),
        StatementKind::Definition { name, .. } => (Place::Computed, name.text.clone()),
        StatementKind::InitialValue { name, order, .. } => {
            let primes = "'".repeat(usize::try_from(*order).unwrap_or_default());
            (Place::Unknown, format!("{}{primes}", name.text))
        }
        StatementKind::Discrete { name, .. } => (Place::Unknown, name.text.clone()),
        StatementKind::Members { what: Members::Definitions, left, .. } => (Place::Computed, of(left)),
        StatementKind::Members { left, .. } => (Place::Unknown, of(left)),
        _ => return None,
    })
}

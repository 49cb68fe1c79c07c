//! From text to a checked model: syntax, names, dimensions, and then the graph.

use crate::components::vector_or_family;
use crate::dimensions::check_dimensions;
use crate::families::{declared, sizes, without_families};
use crate::functions::{Functions, written_out};
use crate::groups::warn_of_empty;
use crate::lowering::{TurnUnits, assemble, remark_on_degrees, warn};
use crate::names::{Declarations, NameCheck, Unknown, check_event, definition_order, find_unknowns, quotients};
use crate::vectors::Vectors;
use crate::{
    Diagnostic, Expression, ExpressionKind, Places, Span, Statement, StatementKind, has_errors, limits, parse,
};
use crate::{bare_numbers, chance, choices, discrete_kinds, maps, moments, so_far, ticks};
use program::{Model, NodeId, Size};
use std::borrow::Cow;
use std::collections::HashSet;
use std::ops::Range;
use units::order::sort_by_key;
use units::words;

/// A model without errors, together with its source statements.
#[derive(Clone, Debug)]
pub struct Checked {
    /// The model.
    pub model: Model,
    /// The statements of the source, for typesetting.
    pub statements: Vec<Statement>,
    /// Source places of the parts of the model.
    pub places: Places,
    /// User-defined functions, for the expressions of the document.
    pub functions: Functions,
}

/// Replaces one form of statement by simpler ones.
type Pass = for<'a> fn(Cow<'a, [Statement]>, &Vectors, &mut Vec<Diagnostic>) -> Cow<'a, [Statement]>;

/// The passes over the statements of a model, in their order. Families and vectors have been replaced by their members and
/// components before, so that each pass sees single numbers; functions are expanded and choices replaced after them, because
/// the passes add no calls of the author's functions and no choices.
const PASSES: [Pass; 7] = [
    // First, while each number that an action assigns is still as written.
    |statements, _, diagnostics| bare_numbers::write_out(statements, diagnostics),
    // Maps become events; all passes after it know events only.
    |statements, _, diagnostics| maps::write_out(statements, diagnostics),
    // A draw may be in the event of a map. The name of its stream is that of the quantity as written, also of one with texts.
    |statements, _, diagnostics| chance::write_out(statements, diagnostics),
    // Texts and truth values become numbers; a draw may choose one of them.
    |statements, _, diagnostics| discrete_kinds::write_out(statements, diagnostics),
    // Periodic events become events with conditions; the next pass keeps what a periodic event remembers as well.
    |statements, _, diagnostics| ticks::write_out(statements, diagnostics),
    // What an event remembers becomes discrete quantities.
    moments::write_out,
    // Last: an aggregate of the run so far may be of what an event remembers.
    |statements, _, _| so_far::write_out(statements),
];

/// Compiles the model in `parts` of a document's `source`: one range of bytes per fence. Spans of diagnostics are byte
/// ranges of `source`. The model is `None` if there are errors; warnings do not prevent one.
pub fn compile(source: &str, parts: &[Range<usize>]) -> (Option<Checked>, Vec<Diagnostic>) {
    if let Some(refusal) = refuse_length(parts) {
        return (None, vec![refusal]);
    }
    let (statements, diagnostics) = parse(source, parts);
    check(statements, diagnostics)
}

/// Error for a model that is too long to be parsed, or `None`. `parts` are the byte ranges of the model in the document.
pub fn refuse_length(parts: &[Range<usize>]) -> Option<Diagnostic> {
    let length: usize = parts.iter().map(Range::len).sum();
    if length <= limits::SOURCE {
        return None;
    }
    let start = parts.first().map_or(0, |part| part.start);
    let message = words!("the model has {length} bytes; {} are the most", limits::SOURCE);
    Some(Diagnostic::error("model-too-large", message, Span::new(start, start)))
}

/// Checks and compiles the statements of a model. `diagnostics` are the findings of [`parse`]. Returns all diagnostics in
/// source order, and no model if there are errors.
pub fn check(statements: Vec<Statement>, mut diagnostics: Vec<Diagnostic>) -> (Option<Checked>, Vec<Diagnostic>) {
    // Unreadable text leaves gaps; errors that follow from them would hide the cause.
    let model = if has_errors(&diagnostics) {
        None
    } else {
        let vectors = Vectors::of(&statements);
        let model = checked(statements, &vectors, &mut diagnostics);
        if !vectors.is_empty() {
            // A fault of a vector is found once for each component; keep one.
            let mut places = HashSet::new();
            diagnostics.retain(|diagnostic| places.insert((diagnostic.code, diagnostic.span())));
        }
        model
    };
    sort_by_key(&mut diagnostics, |diagnostic| diagnostic.span().start);
    (model, diagnostics)
}

fn checked(statements: Vec<Statement>, vectors: &Vectors, diagnostics: &mut Vec<Diagnostic>) -> Option<Checked> {
    if let Some(beyond) = statements.get(limits::STATEMENTS) {
        let message = words!("the model has more than {} statements", limits::STATEMENTS);
        diagnostics.push(Diagnostic::error("model-too-large", message, beyond.span));
        return None;
    }
    let sizes = sizes(&statements, diagnostics);
    let single = without_families(&statements, &sizes, diagnostics);
    let (single, functions) = if vectors.is_empty() {
        (single, None)
    } else {
        let (single, functions) = without_vectors(&single, vectors, &sizes, diagnostics)?;
        (Cow::Owned(single), Some(functions))
    };
    let remembered = PASSES.iter().fold(single, |statements, pass| pass(statements, vectors, diagnostics));
    let (functions, called) = match functions {
        Some(functions) => (functions, None),
        None => written_out(&remembered, diagnostics),
    };
    if has_errors(diagnostics) {
        return None;
    }
    // Bodies of functions may contain members of families.
    let single = match &called {
        Some(called) => without_families(called, &sizes, diagnostics),
        None => Cow::Borrowed(&*remembered),
    };
    let spread = choices::spread(&single, diagnostics);
    if has_errors(diagnostics) {
        return None;
    }
    let mut declarations = Declarations::collect(spread.as_deref().unwrap_or(&single), diagnostics);
    let written = declarations.equations.iter().flat_map(|equation| [equation.left, equation.right]);
    let written = written.chain(declarations.definitions.iter().map(|definition| definition.value));
    let foreign: Vec<Diagnostic> = written.flat_map(|one| quotients(&declarations.scope, one)).collect();
    if !foreign.is_empty() {
        diagnostics.extend(foreign);
        return None;
    }
    let order = definition_order(&declarations, diagnostics);
    let unknowns = find_unknowns(&mut declarations, &order, diagnostics);
    let states: u32 = unknowns.iter().map(|unknown| unknown.highest).sum();
    if states as usize > limits::STATES {
        let span = unknowns.last().map(|unknown| unknown.span).unwrap_or_default();
        let message = words!("the model has {states} states; {} are the most", limits::STATES);
        diagnostics.push(Diagnostic::error("model-too-large", message, span));
    }
    check_names(&declarations, &unknowns, &sizes, diagnostics);
    let types = check_dimensions(&declarations, &order, &unknowns, diagnostics);
    if has_errors(diagnostics) {
        return None;
    }
    let turn_units = TurnUnits::new(&declarations, &order, &types);
    match assemble(&declarations, &order, &unknowns, (&types, &turn_units)) {
        Ok((mut model, places)) => {
            model.sizes = sizes;
            hide(&mut model, &statements, vectors);
            warn(&model, &places, &declarations, diagnostics);
            remark_on_degrees(&declarations, diagnostics);
            turn_units.remark_on_sines(diagnostics);
            warn_of_empty(&statements, diagnostics);
            Some(Checked { model, places, statements, functions })
        }
        Err(mut found) => {
            diagnostics.append(&mut found);
            None
        }
    }
}

/// Expands user-defined functions, then replaces vectors by components: arguments of functions can be vectors.
fn without_vectors(
    single: &[Statement],
    vectors: &Vectors,
    sizes: &[Size],
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<(Vec<Statement>, Functions)> {
    let (functions, called) = written_out(single, diagnostics);
    let called = called.as_deref().unwrap_or(single);
    let single = without_families(called, sizes, diagnostics);
    if has_errors(diagnostics) {
        return None;
    }
    Some((vectors.write_out(&single, diagnostics), functions))
}

/// Marks hidden quantities and states: those that the author hides, with all members of a family or components of a vector,
/// and those that the compiler has added, which have names that cannot occur in source text.
fn hide(model: &mut Model, statements: &[Statement], vectors: &Vectors) {
    let mut hidden: HashSet<(&str, u32)> = HashSet::new();
    for statement in statements {
        if let StatementKind::Choice(choice) = &statement.kind {
            let values = choice.alternatives.iter().flat_map(|one| &one.values).filter(|value| value.hidden);
            hidden.extend(values.map(|value| (value.name.text.as_str(), 0)));
        }
        if !statement.hidden {
            continue;
        }
        match &statement.kind {
            StatementKind::Event { actions, .. } => {
                hidden.extend(actions.iter().map(|action| (action.name.text.as_str(), 0)));
            }
            StatementKind::InitialValue { order, .. }
            | StatementKind::Members { left: Expression { kind: ExpressionKind::Member { order, .. }, .. }, .. } => {
                hidden.extend(declared(statement).map(|name| (name, *order)));
            }
            _ => hidden.extend(declared(statement).map(|name| (name, 0))),
        }
    }
    // A quantity that follows from hidden parameters alone would give them away.
    let hides = model.parameters.iter().any(|parameter| parameter.hidden);
    let values = model.quantities.iter().map(|quantity| quantity.value.node).filter(|_| hides);
    let secret: HashSet<NodeId> = values.filter(|&node| model.is_secret(node)).collect();
    let is_hidden = |name: &str, order: u32| hidden.contains(&(vector_or_family(name).unwrap_or(name), order));
    for quantity in &mut model.quantities {
        quantity.hidden = is_hidden(&quantity.name, 0) || secret.contains(&quantity.value.node);
        let has_point = quantity.name.contains('.') && !vectors.is_component(&quantity.name);
        quantity.remembered = has_point || quantity.name.contains(['(', ' ']);
    }
    for state in &mut model.states {
        if is_hidden(&state.variable, state.order) {
            state.role = program::Role::Hidden;
        }
    }
}

fn check_names(declarations: &Declarations, unknowns: &[Unknown], sizes: &[Size], diagnostics: &mut Vec<Diagnostic>) {
    let initial = declarations.initial_values.iter().map(|entry| entry.name.text.as_str());
    let reported = initial.filter(|name| declarations.scope.meaning(name).is_none()).collect();
    let mut check = NameCheck::new(&declarations.scope, reported);
    for function in &declarations.functions {
        check.function(function, sizes);
    }
    for definition in &declarations.definitions {
        check.expression(definition.value);
    }
    for entry in &declarations.initial_values {
        check.expression(entry.value);
    }
    for equation in &declarations.equations {
        check.expression(equation.left);
        check.expression(equation.right);
    }
    for event in &declarations.events {
        check.expression(event.condition);
        for action in event.actions {
            check.expression(&action.value);
        }
        check_event(declarations, unknowns, event, diagnostics);
    }
    diagnostics.append(&mut check.finish());
}

//! The unknown functions: names with primes that are not defined. The equations are solved for their highest derivatives.
//! The lower derivatives are the states and need initial values.

use super::counts::check_counts;
use super::declarations::Declarations;
use super::list;
use super::scope::Meaning;
use super::traverse::for_each_name;
use super::unknown::{Orders, Unknown};
use crate::notation::primed;
use crate::{Diagnostic, Expression, limits};
use program::functions::Function;
use std::collections::HashMap;
use units::order::sort_by_key;
use units::{Words, words};

/// Finds and declares the unknowns. Reports a mismatch between the numbers of unknowns and equations, and missing or
/// surplus initial values. `order` is the evaluation order of the definitions.
pub(crate) fn find_unknowns<'a>(
    declarations: &mut Declarations<'a>,
    order: &[usize],
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<Unknown<'a>> {
    let in_definitions = orders_in_definitions(declarations, order);
    let in_equations: Vec<Orders> = declarations
        .equations
        .iter()
        .map(|equation| {
            let mut orders = Orders::new();
            add_orders(declarations, &in_definitions, equation.left, &mut orders);
            add_orders(declarations, &in_definitions, equation.right, &mut orders);
            orders
        })
        .collect();
    let mut unknowns: Vec<Unknown> = Vec::new();
    let mut places: HashMap<&str, usize> = HashMap::new();
    for (&name, &(highest, span)) in in_equations.iter().flatten() {
        let place = *places.entry(name).or_insert(unknowns.len());
        match unknowns.get_mut(place) {
            Some(unknown) if unknown.highest < highest => (unknown.highest, unknown.span) = (highest, span),
            Some(_) => {}
            None => unknowns.push(Unknown { name, highest, first_state: 0, span, initial: Vec::new() }),
        }
    }
    unknowns.retain(|unknown| unknown.highest > 0);
    let too_high = unknowns.iter().find(|unknown| unknown.highest > limits::ORDER);
    if let Some(Unknown { name, span, .. }) = too_high {
        let message = words!("`{name}` is differentiated too often; {} times are the most", limits::ORDER);
        diagnostics.push(Diagnostic::error("too-many-primes", message, *span));
        unknowns.retain(|unknown| unknown.highest <= limits::ORDER);
    }
    for unknown in &mut unknowns {
        unknown.initial = vec![None; unknown.highest as usize];
    }
    for (index, unknown) in unknowns.iter().enumerate() {
        declarations.scope.declare(unknown.name, Meaning::Variable(index));
    }
    if let Some(Unknown { name, span, .. }) =
        unknowns.iter().find(|unknown| Function::reserving(unknown.name).is_some())
    {
        let message = words!("`{name}` cannot be an unknown: it is a function");
        diagnostics.push(Diagnostic::error("reserved-name", message, *span).with_hint(words("choose another name")));
        // Its initial value was parsed as a call, so the counts below would be wrong.
        return unknowns;
    }
    let solvable = check_counts(declarations, &in_equations, &unknowns, diagnostics);
    assign_initial_values(declarations, &mut unknowns, diagnostics);
    order_states(declarations, &mut unknowns);
    for (unknown, solvable) in unknowns.iter().zip(solvable) {
        if solvable {
            check_initial_values(declarations, unknown, diagnostics);
        }
    }
    unknowns
}

/// Adds the undefined names in an expression with their derivative orders. A prime of a definition raises the orders of the
/// names in it.
fn add_orders<'a>(
    declarations: &Declarations,
    definitions: &[Orders<'a>],
    expression: &'a Expression,
    orders: &mut Orders<'a>,
) {
    for_each_name(expression, |name, order, part| {
        let mut raise = |name: &'a str, order: u32| {
            let known = orders.entry(name).or_insert((order, part.span));
            if known.0 < order {
                *known = (order, part.span);
            }
        };
        match declarations.scope.meaning(name) {
            None | Some(Meaning::Variable(_)) => raise(name, order),
            Some(Meaning::Definition(index)) => {
                for (inner, &(inner_order, _)) in &definitions[index] {
                    raise(inner, inner_order.saturating_add(order).min(limits::ORDER + 1));
                }
            }
            Some(Meaning::Parameter(_) | Meaning::Independent | Meaning::Pi) => {}
        }
    });
}

fn orders_in_definitions<'a>(declarations: &Declarations<'a>, order: &[usize]) -> Vec<Orders<'a>> {
    let mut all = vec![Orders::new(); declarations.definitions.len()];
    for &index in order {
        let mut orders = Orders::new();
        add_orders(declarations, &all, declarations.definitions[index].value, &mut orders);
        all[index] = orders;
    }
    all
}

/// Assigns the initial values to the unknowns. Reports initial values of other names.
fn assign_initial_values<'a>(
    declarations: &Declarations<'a>,
    unknowns: &mut [Unknown<'a>],
    diagnostics: &mut Vec<Diagnostic>,
) {
    for entry in &declarations.initial_values {
        let name = entry.name.text.as_str();
        let written = format!("{}(0)", primed(name, entry.order));
        let error = |code, message: Words| Diagnostic::error(code, message, entry.name.span);
        let diagnostic = match declarations.scope.meaning(name) {
            Some(Meaning::Variable(index)) => {
                let unknown = &mut unknowns[index];
                let highest = primed(name, unknown.highest);
                match unknown.initial.get_mut(entry.order as usize) {
                    Some(slot @ None) => {
                        *slot = Some(*entry);
                        continue;
                    }
                    Some(Some(first)) => error("duplicate-initial-value", words!("`{written}` is given twice"))
                        .saying(words("given again here"))
                        .with_label(first.name.span, words("first given here")),
                    None => error(
                        "initial-value-of-highest",
                        words!("`{written}` cannot be given: the equation determines `{highest}`"),
                    )
                    .with_label(unknown.span, words("by this equation"))
                    .with_hint(words("leave it out")),
                }
            }
            Some(Meaning::Definition(index)) => {
                let defined = declarations.definitions[index].name;
                error(
                    "initial-value-of-definition",
                    words!("`{name}` is defined, so it has no initial value to be given"),
                )
                .with_label(defined.span, words("defined here"))
            }
            Some(Meaning::Parameter(_) | Meaning::Independent | Meaning::Pi) => error(
                "initial-value-of-constant",
                words!("`{name}` is not an unknown of the equations, so it has no initial value"),
            ),
            None => {
                let diagnostic =
                    error("initial-value-without-equation", words!("no equation contains a derivative of `{name}`"))
                        .saying(words!("`{written}` is the initial value of nothing"));
                match declarations.scope.near(name) {
                    Some(near) => diagnostic.meaning(near),
                    None if entry.order == 0 && is_set_by_event(declarations, name) => diagnostic.with_hint(words!(
                        "what only events change is declared with its value: `discrete {name} = ...`"
                    )),
                    None => diagnostic.with_hint(words!("write an equation with `{name}'`, or define `{name} = ...`")),
                }
            }
        };
        diagnostics.push(diagnostic);
    }
}

fn is_set_by_event(declarations: &Declarations, name: &str) -> bool {
    let mut actions = declarations.events.iter().flat_map(|event| event.actions);
    actions.any(|action| action.name.text == name && action.order == 0)
}

/// Numbers the states in the order of the given initial values, or else in the order of first mention in the equations.
fn order_states(declarations: &Declarations, unknowns: &mut [Unknown]) {
    let mut first: HashMap<&str, usize> = HashMap::new();
    for (number, entry) in declarations.initial_values.iter().enumerate() {
        first.entry(&entry.name.text).or_insert(number);
    }
    let place = |unknown: &Unknown| {
        let given = first.get(unknown.name).copied();
        (given.unwrap_or(usize::MAX), unknown.span.start)
    };
    let mut by_place: Vec<usize> = (0..unknowns.len()).collect();
    sort_by_key(&mut by_place, |&index| place(&unknowns[index]));
    let mut next = 0;
    for index in by_place {
        unknowns[index].first_state = next;
        next += unknowns[index].highest as usize;
    }
}

fn check_initial_values(declarations: &Declarations, unknown: &Unknown, diagnostics: &mut Vec<Diagnostic>) {
    let missing: Vec<String> = (0_u32..)
        .zip(&unknown.initial)
        .filter(|(_, entry)| entry.is_none())
        .map(|(order, _)| format!("`{}(0)`", primed(unknown.name, order)))
        .collect();
    if missing.is_empty() {
        return;
    }
    let highest = primed(unknown.name, unknown.highest);
    let names = list(&missing);
    let (message, needs) = if missing.len() == 1 {
        (words!("{names} is not given"), words!("`{highest}` here needs its initial value"))
    } else {
        (words!("{names} are not given"), words!("`{highest}` here needs their initial values"))
    };
    let given: Vec<String> = missing.iter().map(|written| format!("{} = 0", written.trim_matches('`'))).collect();
    let mut diagnostic = Diagnostic::error("missing-initial-value", message, unknown.span)
        .saying(needs)
        .with_hint(Words::same(given.join(", ")));
    // Members of a family have no lines of their own in the text.
    let equation = declarations.equations.iter().find(|equation| equation.span.contains(unknown.span));
    if let Some(equation) = equation.filter(|_| !unknown.name.contains(['[', '.'])) {
        let end = equation.span.after();
        diagnostic = diagnostic.with_fix(end, format!("\n{}", given.join("\n")));
    }
    diagnostics.push(diagnostic);
}

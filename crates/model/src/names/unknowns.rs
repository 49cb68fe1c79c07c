//! The unknown functions: names with primes that nothing defines. Their highest derivatives are what the equations are
//! solved for; the lower ones are the states and need initial values.

use super::declarations::{Declarations, InitialEntry};
use super::scope::Meaning;
use super::traverse::for_each_name;
use super::{Scope, list};
use crate::matching::match_equations;
use crate::notation::primed;
use crate::{Diagnostic, Expression, Span, limits};
use program::functions::Function;
use std::collections::BTreeMap;
use units::{Words, words};

/// An unknown function of the independent variable.
#[derive(Clone, Debug)]
pub(crate) struct Unknown<'a> {
    /// Its name.
    pub name: &'a str,
    /// How many primes its highest derivative has; as many states belong to it.
    pub highest: u32,
    /// The index of the first of its states.
    pub first_state: usize,
    /// Where its highest derivative stands in an equation.
    pub span: Span,
    /// Its initial values, by their primes.
    pub initial: Vec<Option<InitialEntry<'a>>>,
}

/// How often each unknown is primed at most.
type Orders<'a> = BTreeMap<&'a str, (u32, Span)>;

/// Finds the unknowns, declares them, and tells where there are more of them than equations or fewer, and which initial
/// values are missing or pointless. `order` is that of the definitions.
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
    for (&name, &(highest, span)) in in_equations.iter().flatten() {
        match unknowns.iter_mut().find(|unknown| unknown.name == name) {
            Some(unknown) if unknown.highest < highest => (unknown.highest, unknown.span) = (highest, span),
            Some(_) => {}
            None => unknowns.push(Unknown { name, highest, first_state: 0, span, initial: Vec::new() }),
        }
    }
    unknowns.retain(|unknown| unknown.highest > 0);
    let too_high = unknowns.iter().find(|unknown| unknown.highest > limits::ORDER);
    if let Some(Unknown { name, span, .. }) = too_high {
        let message = words!(
            "`{name}` is differentiated too often; {} times are the most",
            "`{name}` se deriva demasiadas veces; el máximo son {}",
            limits::ORDER
        );
        diagnostics.push(Diagnostic::error("too-many-primes", message, *span));
        unknowns.retain(|unknown| unknown.highest <= limits::ORDER);
    }
    for unknown in &mut unknowns {
        unknown.initial = vec![None; unknown.highest as usize];
    }
    for (index, unknown) in unknowns.iter().enumerate() {
        declarations.scope.declare(unknown.name, Meaning::Variable(index));
    }
    if let Some(Unknown { name, span, .. }) = unknowns.iter().find(|unknown| Function::named(unknown.name).is_some()) {
        let message = words!(
            "`{name}` cannot be an unknown: it is a function",
            "`{name}` no puede ser una incógnita: es una función"
        );
        diagnostics.push(
            Diagnostic::error("reserved-name", message, *span)
                .with_hint(words("choose another name", "elige otro nombre")),
        );
        // Its initial value was read as a call, so the counts below would be wrong.
        return unknowns;
    }
    let solvable = check_counts(declarations, &in_equations, &unknowns, diagnostics);
    assign_initial_values(declarations, &mut unknowns, diagnostics);
    order_states(declarations, &mut unknowns);
    for (unknown, solvable) in unknowns.iter().zip(solvable) {
        if solvable {
            check_initial_values(unknown, diagnostics);
        }
    }
    unknowns
}

/// The undefined names in an expression, with their primes. The prime of a definition counts for what is inside it.
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

/// For each unknown, whether there is an equation to determine it.
fn check_counts(
    declarations: &Declarations,
    in_equations: &[Orders],
    unknowns: &[Unknown],
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<bool> {
    let contains: Vec<Vec<usize>> = in_equations
        .iter()
        .map(|orders| {
            let is_highest =
                |unknown: &Unknown| orders.get(unknown.name).is_some_and(|&(order, _)| order == unknown.highest);
            (0..unknowns.len()).filter(|&index| is_highest(&unknowns[index])).collect()
        })
        .collect();
    let equation_of = match_equations(&contains, unknowns.len());
    let highest: Vec<String> =
        unknowns.iter().map(|unknown| format!("`{}`", primed(unknown.name, unknown.highest))).collect();
    for (index, equation) in declarations.equations.iter().enumerate() {
        if equation_of.contains(&Some(index)) {
            continue;
        }
        diagnostics.push(if contains[index].is_empty() {
            nothing_to_solve_for(declarations, equation, &in_equations[index], unknowns)
        } else {
            let solved: Vec<String> = contains[index].iter().map(|&unknown| highest[unknown].clone()).collect();
            let count = declarations.equations.len();
            let message = words!(
                "there are more equations than unknowns: {count} for {highest}",
                "hay más ecuaciones que incógnitas: {count} para {highest}",
                highest = list(&highest)
            );
            let mut diagnostic = Diagnostic::error("too-many-equations", message, equation.span).saying(words!(
                "{solved} is already determined without this one",
                "{solved} ya se determina sin esta",
                solved = list(&solved)
            ));
            let shares = |other: &usize| contains[*other].iter().any(|unknown| contains[index].contains(unknown));
            let others = (0..declarations.equations.len()).filter(|other| *other != index && shares(other));
            for other in others.take(limits::PLACES) {
                diagnostic =
                    diagnostic.with_label(declarations.equations[other].span, words("by this one", "por esta"));
            }
            diagnostic.with_hint(words("leave one of them out", "omite una de ellas"))
        });
    }
    // If an equation is left over and the number is right, that equation was meant for the unknown and has been reported.
    let paired = equation_of.iter().flatten().count();
    let too_few = unknowns.len() > declarations.equations.len() || paired == declarations.equations.len();
    for (index, unknown) in unknowns.iter().enumerate() {
        if equation_of[index].is_none() && too_few {
            diagnostics.push(no_equation_for(declarations, unknown, &highest, unknowns));
        }
    }
    equation_of.iter().map(Option::is_some).collect()
}

fn nothing_to_solve_for(
    declarations: &Declarations,
    equation: &super::Equation,
    orders: &Orders,
    unknowns: &[Unknown],
) -> Diagnostic {
    let message =
        words("there is nothing that this equation could be solved for", "esta ecuación no tiene nada que despejar");
    let mut diagnostic = Diagnostic::error("nothing-to-solve-for", message, equation.span);
    let lower: Vec<&Unknown> = unknowns.iter().filter(|unknown| orders.contains_key(unknown.name)).collect();
    if let Some(unknown) = lower.first() {
        let highest = primed(unknown.name, unknown.highest);
        diagnostic = diagnostic.saying(words!("contains no `{highest}`", "no contiene `{highest}`")).with_label(
            unknown.span,
            words!(
                "`{highest}`, the highest derivative, is here",
                "`{highest}`, la derivada de mayor orden, está aquí"
            ),
        );
    } else {
        diagnostic = diagnostic
            .saying(words("contains no derivative of an unknown", "no contiene ninguna derivada de una incógnita"));
    }
    let mut defined = None;
    for side in [equation.left, equation.right] {
        for_each_name(side, |name, order, _| {
            if order > 0
                && let Some(Meaning::Definition(index)) = declarations.scope.meaning(name)
            {
                defined = defined.or(Some(index));
            }
        });
    }
    if let Some(index) = defined {
        let name = declarations.definitions[index].name;
        diagnostic = diagnostic.with_label(
            name.span,
            words!(
                "`{}` is defined here, and so is no unknown",
                "`{}` se define aquí, así que no es una incógnita",
                name.text
            ),
        );
    }
    diagnostic.with_hint(words(
        "to define a quantity, write its name alone on the left: `v = y'`",
        "para definir una magnitud, escribe solo su nombre a la izquierda: `v = y'`",
    ))
}

fn no_equation_for(
    declarations: &Declarations,
    unknown: &Unknown,
    highest: &[String],
    unknowns: &[Unknown],
) -> Diagnostic {
    let equations = match declarations.equations.len() {
        1 => words("1 equation", "1 ecuación"),
        count => words!("{count} equations", "{count} ecuaciones"),
    };
    let missing = primed(unknown.name, unknown.highest);
    let message = words!(
        "there are more unknowns than equations: {highest} and {equations}",
        "hay más incógnitas que ecuaciones: {highest} frente a {equations}",
        highest = list(highest),
        equations = equations
    );
    let diagnostic = Diagnostic::error("too-few-equations", message, unknown.span).saying(words!(
        "no equation is left to determine `{missing}`",
        "no queda ninguna ecuación que determine `{missing}`"
    ));
    let mut known = Scope::new(&declarations.independent.0);
    for other in unknowns.iter().filter(|other| other.name != unknown.name) {
        known.declare(other.name, Meaning::Pi);
    }
    for entry in &declarations.definitions {
        known.declare(&entry.name.text, Meaning::Pi);
    }
    match known.near(unknown.name) {
        Some(near) => {
            diagnostic.with_hint(words!("did you mean `{}`?", "¿querías decir `{}`?", primed(near, unknown.highest)))
        }
        None => diagnostic.with_hint(words!(
            "write an equation for `{missing}`, or define it: `{} = ...`",
            "escribe una ecuación para `{missing}`, o define `{} = ...`",
            unknown.name
        )),
    }
}

/// Gives each unknown its initial values; tells those that belong to nothing.
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
                    Some(Some(first)) => error(
                        "duplicate-initial-value",
                        words!("`{written}` is given twice", "`{written}` se da dos veces"),
                    )
                    .saying(words("given again here", "se da de nuevo aquí"))
                    .with_label(first.name.span, words("first given here", "se da primero aquí")),
                    None => error(
                        "initial-value-of-highest",
                        words!(
                            "`{written}` cannot be given: the equation determines `{highest}`",
                            "`{written}` no se puede dar: la ecuación determina `{highest}`"
                        ),
                    )
                    .with_label(unknown.span, words("by this equation", "por esta ecuación"))
                    .with_hint(words("leave it out", "omítelo")),
                }
            }
            Some(Meaning::Definition(index)) => {
                let defined = declarations.definitions[index].name;
                error(
                    "initial-value-of-definition",
                    words!(
                        "`{name}` is defined, so it has no initial value to be given",
                        "`{name}` está definida, así que no se le puede dar un valor inicial"
                    ),
                )
                .with_label(defined.span, words("defined here", "se define aquí"))
            }
            Some(Meaning::Parameter(_) | Meaning::Independent | Meaning::Pi) => error(
                "initial-value-of-constant",
                words!(
                    "`{name}` is not an unknown of the equations, so it has no initial value",
                    "`{name}` no es una incógnita de las ecuaciones, así que no tiene valor inicial"
                ),
            ),
            None => {
                let diagnostic = error(
                    "initial-value-without-equation",
                    words!(
                        "no equation contains a derivative of `{name}`",
                        "ninguna ecuación contiene una derivada de `{name}`"
                    ),
                )
                .saying(words!(
                    "`{written}` is the initial value of nothing",
                    "`{written}` no es el valor inicial de nada"
                ));
                match declarations.scope.near(name) {
                    Some(near) => diagnostic.with_hint(words!("did you mean `{near}`?", "¿querías decir `{near}`?")),
                    None => diagnostic.with_hint(words!(
                        "write an equation with `{name}'`, or define `{name} = ...`",
                        "escribe una ecuación con `{name}'`, o define `{name} = ...`"
                    )),
                }
            }
        };
        diagnostics.push(diagnostic);
    }
}

/// Sorts the unknowns' states as the author gives their initial values, else as the equations mention them.
fn order_states(declarations: &Declarations, unknowns: &mut [Unknown]) {
    let place = |unknown: &Unknown| {
        let given = declarations.initial_values.iter().position(|entry| entry.name.text == unknown.name);
        (given.unwrap_or(usize::MAX), unknown.span.start)
    };
    let mut by_place: Vec<usize> = (0..unknowns.len()).collect();
    by_place.sort_by_key(|&index| place(&unknowns[index]));
    let mut next = 0;
    for index in by_place {
        unknowns[index].first_state = next;
        next += unknowns[index].highest as usize;
    }
}

fn check_initial_values(unknown: &Unknown, diagnostics: &mut Vec<Diagnostic>) {
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
        (
            words!("{names} is not given", "falta {names}", names = names),
            words!("`{highest}` here needs its initial value", "`{highest}` necesita aquí su valor inicial"),
        )
    } else {
        (
            words!("{names} are not given", "faltan {names}", names = names),
            words!("`{highest}` here needs their initial values", "`{highest}` necesita aquí sus valores iniciales"),
        )
    };
    let given: Vec<String> = missing.iter().map(|written| format!("{} = 0", written.trim_matches('`'))).collect();
    diagnostics.push(
        Diagnostic::error("missing-initial-value", message, unknown.span)
            .saying(needs)
            .with_hint(Words::same(given.join(", "))),
    );
}

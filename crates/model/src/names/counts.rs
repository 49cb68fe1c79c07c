//! Compares the number of equations with the number of unknowns, and pairs them.

use super::declarations::Declarations;
use super::foreign;
use super::scope::Meaning;
use super::traverse::for_each_name;
use super::unknown::{Orders, Unknown};
use super::{Scope, list};
use crate::matching::match_equations;
use crate::notation::primed;
use crate::{Diagnostic, ExpressionKind, Span, limits};
use program::functions::Function;
use units::order::sort;
use units::words;

/// Pairs equations and unknowns, and reports those left over. Returns one value per unknown: true if an equation determines
/// it.
pub(super) fn check_counts(
    declarations: &Declarations,
    in_equations: &[Orders],
    unknowns: &[Unknown],
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<bool> {
    let contains: Vec<Vec<usize>> = in_equations
        .iter()
        .map(|orders| {
            let highest = |(name, &(order, _)): (&&str, &(u32, Span))| match declarations.scope.meaning(name) {
                Some(Meaning::Variable(index)) if unknowns[index].highest == order => Some(index),
                _ => None,
            };
            let mut found: Vec<usize> = orders.iter().filter_map(highest).collect();
            sort(&mut found);
            found
        })
        .collect();
    let equation_of = match_equations(&contains, unknowns.len());
    let mut pairs = vec![false; declarations.equations.len()];
    equation_of.iter().flatten().for_each(|&equation| pairs[equation] = true);
    let highest: Vec<String> =
        unknowns.iter().map(|unknown| format!("`{}`", primed(unknown.name, unknown.highest))).collect();
    let mut told = 0;
    for (index, equation) in declarations.equations.iter().enumerate() {
        let meant = match &equation.left.kind {
            ExpressionKind::Call { function, arguments } => {
                foreign::instead_of(&declarations.scope, function, arguments)
            }
            _ => None,
        };
        // Calls of functions that do not exist are reported by another check.
        if pairs[index] || meant.is_some() {
            continue;
        }
        told += 1;
        if told > limits::TOLD {
            break;
        }
        diagnostics.push(if contains[index].is_empty() {
            nothing_to_solve_for(declarations, equation, &in_equations[index], unknowns)
        } else {
            let solved: Vec<String> = contains[index].iter().map(|&unknown| highest[unknown].clone()).collect();
            let count = declarations.equations.len();
            let message =
                words!("there are more equations than unknowns: {count} for {highest}", highest = list(&highest));
            let mut diagnostic = Diagnostic::error("too-many-equations", message, equation.span)
                .saying(words!("{solved} is already determined without this one", solved = list(&solved)));
            let shares = |other: &usize| contains[*other].iter().any(|unknown| contains[index].contains(unknown));
            let others = (0..declarations.equations.len()).filter(|other| *other != index && shares(other));
            for other in others.take(limits::PLACES) {
                diagnostic = diagnostic.with_label(declarations.equations[other].span, words("by this one"));
            }
            diagnostic.with_hint(words("leave one of them out"))
        });
    }
    // If the numbers agree, an equation left over was meant for the unknown left over, and has been reported.
    let paired = equation_of.iter().flatten().count();
    let too_few = unknowns.len() > declarations.equations.len() || paired == declarations.equations.len();
    let unpaired = unknowns.iter().zip(&equation_of).filter(|(_, equation)| equation.is_none() && too_few);
    for (unknown, _) in unpaired.take(limits::TOLD) {
        diagnostics.push(no_equation_for(declarations, unknown, &highest, unknowns));
    }
    equation_of.iter().map(Option::is_some).collect()
}

fn nothing_to_solve_for(
    declarations: &Declarations,
    equation: &super::Equation,
    orders: &Orders,
    unknowns: &[Unknown],
) -> Diagnostic {
    let message = words("there is nothing that this equation could be solved for");
    let mut diagnostic = Diagnostic::error("nothing-to-solve-for", message, equation.span);
    let lower: Vec<&Unknown> = unknowns.iter().filter(|unknown| orders.contains_key(unknown.name)).collect();
    if let Some(unknown) = lower.first() {
        let highest = primed(unknown.name, unknown.highest);
        diagnostic = diagnostic
            .saying(words!("contains no `{highest}`"))
            .with_label(unknown.span, words!("`{highest}`, the highest derivative, is here"));
    } else {
        diagnostic = diagnostic.saying(words("contains no derivative of an unknown"));
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
        diagnostic = diagnostic.with_label(name.span, words!("`{}` is defined here, and so is no unknown", name.text));
    }
    if let ExpressionKind::Call { function, .. } = &equation.left.kind
        && Function::named(&function.text).is_none()
    {
        return diagnostic.with_hint(words("a function of one's own is declared: `function f(x) = ...`"));
    }
    diagnostic.with_hint(words("to define a quantity, write its name alone on the left: `v = y'`"))
}

fn no_equation_for(
    declarations: &Declarations,
    unknown: &Unknown,
    highest: &[String],
    unknowns: &[Unknown],
) -> Diagnostic {
    let equations = match declarations.equations.len() {
        1 => words("1 equation"),
        count => words!("{count} equations"),
    };
    let missing = primed(unknown.name, unknown.highest);
    let message = words!("there are more unknowns than equations: {highest} and {equations}", highest = list(highest),);
    let diagnostic = Diagnostic::error("too-few-equations", message, unknown.span)
        .saying(words!("no equation is left to determine `{missing}`"));
    let mut known = Scope::new(&declarations.independent.0);
    for other in unknowns.iter().filter(|other| other.name != unknown.name) {
        known.declare(other.name, Meaning::Pi);
    }
    for entry in &declarations.definitions {
        known.declare(&entry.name.text, Meaning::Pi);
    }
    match known.near(unknown.name) {
        Some(near) => diagnostic.with_hint(words!("did you mean `{}`?", primed(near, unknown.highest))),
        None => {
            diagnostic.with_hint(words!("write an equation for `{missing}`, or define it: `{} = ...`", unknown.name))
        }
    }
}

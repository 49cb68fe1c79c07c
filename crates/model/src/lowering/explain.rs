//! Explanations why equations cannot be solved for their highest derivatives.

use super::affine::{Shape, Shapes};
use super::expression::{Lowering, TooManyNodes};
use crate::names::{Declarations, Equation, Meaning, Unknown, list};
use crate::notation::{primed, quote};
use crate::{BinaryOperator, Diagnostic, Expression, ExpressionKind, Span};
use program::Node;
use units::{Words, words};

/// Finds the innermost part of an equation that is not linear in the highest derivatives, through definitions.
pub(crate) fn nonlinear(
    declarations: &Declarations,
    equation: &Equation,
    lowering: &mut Lowering,
    shapes: &mut Shapes,
    unknown: impl Fn(Node) -> Option<u32>,
) -> Result<Diagnostic, TooManyNodes> {
    let mut is_nonlinear = |expression: &Expression| {
        let node = lowering.expression(expression)?;
        Ok(shapes.of(lowering.graph, node, &unknown)? == Shape::Nonlinear)
    };
    let mut at = if is_nonlinear(equation.left)? { equation.left } else { equation.right };
    let mut through: Vec<usize> = Vec::new();
    loop {
        let mut inner = None;
        if let ExpressionKind::Name { name, order: 0 } = &at.kind
            && let Some(Meaning::Definition(index)) = declarations.scope.meaning(name)
        {
            through.push(index);
            inner = Some(declarations.definitions[index].value);
        } else {
            for child in at.operands() {
                if is_nonlinear(child)? {
                    inner = Some(child);
                    break;
                }
            }
        }
        match inner {
            Some(next) => at = next,
            None => break,
        }
    }
    let message = words!("the equation is not linear in its highest derivatives: {reason}", reason = reason(at));
    let mut diagnostic = Diagnostic::error("nonlinear-highest-derivative", message, at.span)
        .with_label(equation.span, words("in this equation"));
    for index in through {
        let name = declarations.definitions[index].name;
        diagnostic = diagnostic.with_label(name.span, words!("through `{}`", name.text));
    }
    Ok(diagnostic.with_hint(words(
        "equations are solved for their highest derivatives, which may be added and multiplied by what contains none: \
         rewrite the equation so",
    )))
}

fn reason(expression: &Expression) -> Words {
    let quoted = quote(expression);
    match &expression.kind {
        ExpressionKind::Binary(BinaryOperator::Multiply, ..) => {
            words!("`{quoted}` multiplies them with each other")
        }
        ExpressionKind::Binary(BinaryOperator::Divide, ..) => {
            words!("`{quoted}` divides by one")
        }
        ExpressionKind::Binary(BinaryOperator::Power, ..) => {
            words!("`{quoted}` is a power of one")
        }
        ExpressionKind::Binary(..) => words!("`{quoted}` compares one"),
        ExpressionKind::Call { function, .. } => {
            words!("one stands inside `{}`", function.text)
        }
        ExpressionKind::Expansion(expansion) => {
            words!("one stands inside `{}`", expansion.function)
        }
        ExpressionKind::If(..) => words!("one decides `{quoted}`"),
        _ => words!("`{quoted}` depends on them in another way"),
    }
}

/// Reports the unknowns that have no equation left with a nonzero coefficient.
pub(crate) fn not_solvable(
    declarations: &Declarations,
    unknowns: &[Unknown],
    contains: &[Vec<usize>],
    equation_of: &[Option<usize>],
) -> Vec<Diagnostic> {
    let mut diagnostics = Vec::new();
    for (index, unknown) in unknowns.iter().enumerate().filter(|(index, _)| equation_of[*index].is_none()) {
        let highest = highest_names(unknowns, &[index]);
        let diagnostic = if contains.iter().any(|members| members.contains(&index)) {
            let message = words!("the equations do not determine {highest}");
            Diagnostic::error("equations-dependent", message, unknown.span)
        } else {
            let message = words!("the coefficient of {highest} is 0, so no equation can be solved for it");
            Diagnostic::error("coefficient-zero", message, unknown.span)
        };
        diagnostics.push(diagnostic);
    }
    for (index, equation) in declarations.equations.iter().enumerate() {
        if contains[index].is_empty()
            && let Some(first) = diagnostics.first_mut()
            && !first.labels.iter().any(|label| label.span == equation.span)
        {
            *first = first.clone().with_label(equation.span, words("nothing is left here to solve for"));
        }
    }
    diagnostics
}

/// Reports unknowns whose system of equations is always singular.
pub(crate) fn dependent(unknowns: &[Unknown], members: &[usize], equations: &[Span]) -> Diagnostic {
    let highest = highest_names(unknowns, members);
    let (&first, rest) = equations.split_first().unwrap_or((const { &Span { start: 0, end: 0 } }, &[]));
    if members.len() == 1 {
        let message = words!("the coefficient of {highest} is 0, so the equation cannot be solved for it");
        return Diagnostic::error("coefficient-zero", message, first);
    }
    let message =
        words!("these equations do not determine {highest}: in these, one of them says no more than the others",);
    let mut diagnostic = Diagnostic::error("equations-dependent", message, first);
    for &span in rest {
        diagnostic = diagnostic.with_label(span, words("depends on the others"));
    }
    diagnostic.with_hint(words("replace one of them by an equation that says something else"))
}

/// `y''`, `x''` and so on, each quoted.
fn highest_names(unknowns: &[Unknown], members: &[usize]) -> Words {
    let quoted = |&member: &usize| format!("`{}`", primed(unknowns[member].name, unknowns[member].highest));
    list(&members.iter().map(quoted).collect::<Vec<_>>())
}

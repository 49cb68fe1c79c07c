//! Solves the equations for their highest derivatives.

use super::affine::{Affine, Shape, Shapes};
use super::collect::Collector;
use super::explain::{dependent, nonlinear, not_solvable};
use super::expression::{Chain, Lowered, Lowering, TooManyNodes};
use super::rank::is_singular;
use crate::matching::{blocks, match_equations};
use crate::names::{Declarations, Equation, Meaning, Unknown, for_each_name};
use crate::{Diagnostic, Span, limits};
use program::{Graph, LinearSystem, Node, NodeId};
use std::collections::HashMap;
use units::words;

/// Highest derivative of each unknown as a node in `graph`. Text values are indices into `texts`. `order` is the evaluation
/// order of the definitions.
pub(crate) fn solve(
    declarations: &Declarations,
    order: &[usize],
    unknowns: &[Unknown],
    (graph, texts): (&mut Graph, &mut Vec<String>),
) -> Result<Vec<NodeId>, Vec<Diagnostic>> {
    // The equations are built in a separate graph, in which the highest derivatives are extra states.
    let mut scratch = Graph::default();
    let states: u32 = unknowns.iter().map(|unknown| unknown.highest).sum();
    let chains: Vec<Chain> = (states..)
        .zip(unknowns)
        .map(|(number, Unknown { highest, first_state, .. })| Chain {
            first_state: *first_state,
            highest: *highest,
            rate: scratch.insert(Node::State(number)),
        })
        .collect();
    let affine = linear_equations(declarations, order, (states, &chains), (&mut scratch, texts))?;
    let affine = copied(&affine, &scratch, graph);
    let contains: Vec<Vec<usize>> =
        affine.iter().map(|form| form.coefficients.keys().map(|&unknown| unknown as usize).collect()).collect();
    let equation_of = match_equations(&contains, unknowns.len());
    let paired: Vec<usize> = equation_of.iter().copied().flatten().collect();
    if paired.len() < unknowns.len() {
        return Err(not_solvable(declarations, unknowns, &contains, &equation_of));
    }
    let needs: Vec<Vec<usize>> = (0..unknowns.len())
        .map(|unknown| contains[paired[unknown]].iter().copied().filter(|&other| other != unknown).collect())
        .collect();
    let mut solved = Solved { graph, rates: vec![None; unknowns.len()], collector: Collector::default() };
    let mut numbers = 0;
    for block in blocks(&needs) {
        let regular = match block.as_slice() {
            &[unknown] => solved.alone(&affine[paired[unknown]], unknown),
            members => {
                let forms: Vec<&Affine> = members.iter().map(|&member| &affine[paired[member]]).collect();
                let system = solved.together(&forms, members);
                numbers += system.numbers().unwrap_or(usize::MAX / 2);
                if numbers > LinearSystem::MOST_NUMBERS {
                    return Err(vec![too_coupled(members, unknowns)]);
                }
                solved.enter(system, members)
            }
        };
        if !regular {
            let equations: Vec<Span> =
                block.iter().map(|&member| declarations.equations[paired[member]].span).collect();
            return Err(vec![dependent(unknowns, &block, &equations)]);
        }
    }
    Ok(solved.rates.into_iter().flatten().collect())
}

fn too_coupled(members: &[usize], unknowns: &[Unknown]) -> Diagnostic {
    let message = words!(
        "{} equations are coupled through their highest derivatives, each with many others; {} are the most",
        members.len(),
        LinearSystem::MOST_DENSE
    );
    let hint =
        words("more can be solved where each contains highest derivatives of few neighbours only, as in a chain");
    let span = members.first().map(|&member| unknowns[member].span).unwrap_or_default();
    Diagnostic::error("too-many-coupled-equations", message, span).with_hint(hint)
}

/// Each equation as left side minus right side, affine in the highest derivatives.
fn linear_equations(
    declarations: &Declarations,
    order: &[usize],
    (states, chains): (u32, &[Chain]),
    (scratch, texts): (&mut Graph, &mut Vec<String>),
) -> Result<Vec<Affine>, Vec<Diagnostic>> {
    let mut known = Lowered::of(vec![None; declarations.definitions.len()]);
    let mut lowering = Lowering { graph: scratch, texts, scope: &declarations.scope, chains, known: &mut known };
    let too_many = |span: Span| vec![too_many_nodes(span)];
    for index in used_definitions(declarations, order) {
        let definition = &declarations.definitions[index];
        let value = lowering.expression(definition.value).map_err(|TooManyNodes| too_many(definition.name.span))?;
        lowering.known.definitions[index] = Some(value);
    }
    let mut shapes = Shapes::default();
    let unknown = |node: Node| match node {
        Node::State(number) if number >= states => Some(number - states),
        _ => None,
    };
    let mut forms = Vec::new();
    let mut diagnostics = Vec::new();
    for equation in &declarations.equations {
        let too_many = |TooManyNodes| too_many(equation.span);
        let left = lowering.expression(equation.left).map_err(too_many)?;
        let right = lowering.expression(equation.right).map_err(too_many)?;
        let difference = lowering.graph.subtract(left, right);
        if uses_initial_highest(lowering.graph, difference, states) {
            diagnostics.push(initial_highest(equation));
            continue;
        }
        match shapes.of(lowering.graph, difference, unknown).map_err(too_many)? {
            Shape::Affine(form) => forms.push(form),
            Shape::Free => forms.push(Affine { rest: Some(difference), ..Affine::default() }),
            Shape::Nonlinear => {
                let reported = nonlinear(declarations, equation, &mut lowering, &mut shapes, unknown);
                diagnostics.push(reported.map_err(too_many)?);
            }
        }
    }
    if diagnostics.is_empty() { Ok(forms) } else { Err(diagnostics) }
}

/// Error for a model with too many nodes.
pub(crate) fn too_many_nodes(span: Span) -> Diagnostic {
    let most = limits::NODES;
    let message = words!(
        "the model becomes too large here: the expressions it stands for have too many operations, more than {most}"
    );
    Diagnostic::error("model-too-large", message, span)
        .with_hint(words("make families smaller, or define what their members share as a quantity of its own"))
}

/// Definitions that the equations use, in evaluation order.
fn used_definitions(declarations: &Declarations, order: &[usize]) -> Vec<usize> {
    let mut used = vec![false; declarations.definitions.len()];
    let mark = |expression, used: &mut Vec<bool>| {
        for_each_name(expression, |name, _, _| {
            if let Some(Meaning::Definition(index)) = declarations.scope.meaning(name) {
                used[index] = true;
            }
        });
    };
    for equation in &declarations.equations {
        mark(equation.left, &mut used);
        mark(equation.right, &mut used);
    }
    for &index in order.iter().rev() {
        if used[index] {
            mark(declarations.definitions[index].value, &mut used);
        }
    }
    order.iter().copied().filter(|&index| used[index]).collect()
}

fn uses_initial_highest(graph: &Graph, root: NodeId, states: u32) -> bool {
    graph.reachable(&[root]).into_iter().any(|id| matches!(graph.node(id), Node::Initial(number) if number >= states))
}

fn initial_highest(equation: &Equation) -> Diagnostic {
    let message = words("the equation uses the initial value of a highest derivative, which only its solution gives");
    Diagnostic::error("initial-value-of-highest", message, equation.span)
}

/// The affine forms with their nodes rebuilt in another graph. Their nodes contain no highest derivatives, so nothing
/// changes.
fn copied(forms: &[Affine], from: &Graph, to: &mut Graph) -> Vec<Affine> {
    let nodes = |form: &Affine| form.coefficients.values().copied().chain(form.rest).collect::<Vec<_>>();
    let roots: Vec<NodeId> = forms.iter().flat_map(nodes).collect();
    let mut rebuilt = from.rebuild_into(to, &roots, |_, _| None).into_iter();
    forms
        .iter()
        .map(|form| Affine {
            coefficients: form.coefficients.keys().copied().zip(rebuilt.by_ref()).collect(),
            rest: form.rest.and_then(|_| rebuilt.next()),
        })
        .collect()
}

/// Partial solution.
struct Solved<'a> {
    graph: &'a mut Graph,
    rates: Vec<Option<NodeId>>,
    collector: Collector,
}

impl Solved<'_> {
    fn or_zero(&mut self, id: Option<NodeId>) -> NodeId {
        id.unwrap_or_else(|| self.graph.constant(0.0))
    }

    /// Right side: minus all terms of the equation except those of `members`.
    fn right(&mut self, form: &Affine, members: &[usize]) -> NodeId {
        let mut sum = self.or_zero(form.rest);
        for (&unknown, &coefficient) in &form.coefficients {
            if let (false, Some(rate)) = (members.contains(&(unknown as usize)), self.rates[unknown as usize]) {
                let term = self.graph.multiply(coefficient, rate);
                sum = self.graph.add(sum, term);
            }
        }
        self.graph.negate(sum)
    }

    /// Solves one equation for one unknown by a division. Returns false if the coefficient is always 0.
    fn alone(&mut self, form: &Affine, unknown: usize) -> bool {
        let right = self.right(form, &[unknown]);
        let coefficient = self.or_zero(form.coefficients.get(&(unknown as u32)).copied());
        self.rates[unknown] = Some(self.collector.quotient(self.graph, right, coefficient));
        !is_singular(self.graph, &LinearSystem::new([((0, 0), coefficient)], vec![right]))
    }

    /// Coupled equations as a linear system.
    fn together(&mut self, forms: &[&Affine], members: &[usize]) -> LinearSystem {
        let one = self.graph.constant(1.0);
        let place: HashMap<usize, usize> = members.iter().enumerate().map(|(place, &member)| (member, place)).collect();
        let mut entries = Vec::new();
        let mut right = Vec::with_capacity(members.len());
        for (row, form) in forms.iter().enumerate() {
            for (&unknown, &coefficient) in &form.coefficients {
                if let Some(&column) = place.get(&(unknown as usize)) {
                    entries.push(((row, column), coefficient));
                }
            }
            let value = self.right(form, members);
            right.push(self.collector.quotient(self.graph, value, one));
        }
        LinearSystem::new(entries, right)
    }

    /// Defines the unknowns as the solution of a system. Returns false if the system is always singular.
    fn enter(&mut self, system: LinearSystem, members: &[usize]) -> bool {
        let regular = !is_singular(self.graph, &system);
        let system = self.graph.insert_system(system);
        for (row, &member) in members.iter().enumerate() {
            self.rates[member] = Some(self.graph.insert(Node::Solution { system, row: row as u32 }));
        }
        regular
    }
}

//! From checked expressions to nodes of the graph.

use super::friction::Calls;
use crate::names::{Meaning, Scope};
use crate::notation::quote;
use crate::{BinaryOperator, Expression, ExpressionKind, UnaryOperator, limits};
use program::along;
use program::functions::Function;
use program::{Binary, Graph, Node, NodeId, Unary};
use rustc_hash::FxHashMap;

/// States of an unknown function in the graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Chain {
    /// Index of its first state, the function itself.
    pub first_state: usize,
    /// Number of its states: the order of its highest derivative.
    pub highest: u32,
    /// Node of its highest derivative.
    pub rate: NodeId,
}

impl Chain {
    /// Node of the derivative of the given order; `None` beyond the highest derivative.
    pub fn node(&self, graph: &mut Graph, order: u32) -> Option<NodeId> {
        match order.cmp(&self.highest) {
            std::cmp::Ordering::Less => Some(graph.insert(Node::State((self.first_state as u32) + order))),
            std::cmp::Ordering::Equal => Some(self.rate),
            std::cmp::Ordering::Greater => None,
        }
    }
}

/// The graph has more nodes than [`limits::NODES`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct TooManyNodes;

/// Converts expressions to nodes. The expressions have passed the checks of names and dimensions; anything those refuse
/// becomes NaN here.
#[derive(Debug)]
pub(crate) struct Lowering<'a> {
    pub graph: &'a mut Graph,
    pub texts: &'a mut Vec<String>,
    pub scope: &'a Scope,
    pub chains: &'a [Chain],
    pub known: &'a mut Lowered,
}

/// Nodes that were already built.
#[derive(Debug, Default)]
pub(crate) struct Lowered {
    /// Values of the definitions, set before they are used.
    pub definitions: Vec<Option<NodeId>>,
    /// Derivatives requested so far, by name and order.
    derivatives: FxHashMap<(Meaning, u32), NodeId>,
    /// Rate of change of each state, by state number; empty until the first request.
    rates: FxHashMap<u32, NodeId>,
    /// Values at the start requested so far.
    starts: FxHashMap<NodeId, NodeId>,
    /// Calls of dry friction.
    pub frictions: Calls,
}

impl Lowered {
    /// Only these definitions are known.
    pub fn of(definitions: Vec<Option<NodeId>>) -> Self {
        Self { definitions, ..Self::default() }
    }
}

impl Lowering<'_> {
    /// The node of an expression.
    pub fn expression(&mut self, expression: &Expression) -> Result<NodeId, TooManyNodes> {
        if self.graph.len() > limits::NODES {
            return Err(TooManyNodes);
        }
        let node = match &expression.kind {
            ExpressionKind::Number { value, unit } => {
                let value = unit.as_ref().map_or(*value, |unit| unit.to_si(*value));
                self.graph.constant(value)
            }
            ExpressionKind::Text(text) => self.text(text),
            ExpressionKind::Name { name, order } => self.name(name, *order)?,
            ExpressionKind::InitialValue { name, .. } if self.scope.table(name).is_some() => {
                let start = self.graph.constant(0.0);
                self.table(name, start)
            }
            ExpressionKind::InitialValue { name, order } => {
                let node = self.name(name, *order)?;
                *self.known.starts.entry(node).or_insert_with(|| at_start(self.graph, node))
            }
            ExpressionKind::Unary(operator, operand) => {
                let operand = self.expression(operand)?;
                let function = match operator {
                    UnaryOperator::Negate => Unary::Negate,
                    UnaryOperator::Not => Unary::Not,
                };
                self.graph.unary(function, operand)
            }
            ExpressionKind::Binary(..) => self.chain(expression)?,
            ExpressionKind::Call { function, arguments } => {
                let nodes =
                    arguments.iter().map(|argument| self.expression(argument)).collect::<Result<Vec<_>, _>>()?;
                match Function::named(&function.text) {
                    Some(known) => {
                        let node = known.build(self.graph, &nodes);
                        if let (Node::Friction(..), [speed, ..]) = (self.graph.node(node), arguments.as_slice()) {
                            self.known.frictions.entry(node).or_insert_with(|| (expression.span, quote(speed)));
                        }
                        node
                    }
                    None => match nodes.first() {
                        Some(&argument) => self.table(&function.text, argument),
                        None => self.undefined(),
                    },
                }
            }
            ExpressionKind::If(condition, chosen, other) => {
                let condition = self.expression(condition)?;
                let (chosen, other) = (self.expression(chosen)?, self.expression(other)?);
                self.graph.select(condition, chosen, other)
            }
            ExpressionKind::Expansion(expansion) => self.expression(&expansion.body)?,
            // Vectors have been replaced by components.
            ExpressionKind::Component { of, axis } => match &of.kind {
                ExpressionKind::Tuple { parts, .. } if *axis < parts.len() => self.expression(&parts[*axis])?,
                _ => self.undefined(),
            },
            // Families have been expanded.
            ExpressionKind::Tuple { .. }
            | ExpressionKind::Member { .. }
            | ExpressionKind::Reduction { .. }
            | ExpressionKind::Error => self.undefined(),
        };
        Ok(node)
    }

    /// `a*b*c*d`: operator chains are nested to the left, one level per operator. A loop avoids deep recursion.
    fn chain(&mut self, expression: &Expression) -> Result<NodeId, TooManyNodes> {
        let mut chain = Vec::new();
        let mut first = expression;
        while let ExpressionKind::Binary(operator, left, right) = &first.kind {
            chain.push((*operator, right));
            first = left;
        }
        let mut node = self.expression(first)?;
        for (operator, right) in chain.into_iter().rev() {
            let right = self.expression(right)?;
            node = self.binary(operator, node, right);
        }
        Ok(node)
    }

    fn binary(&mut self, operator: BinaryOperator, left: NodeId, right: NodeId) -> NodeId {
        let function = match operator {
            BinaryOperator::Add => Binary::Add,
            BinaryOperator::Subtract => Binary::Subtract,
            BinaryOperator::Multiply => Binary::Multiply,
            BinaryOperator::Divide => Binary::Divide,
            BinaryOperator::Power => Binary::Power,
            BinaryOperator::Less => Binary::Less,
            BinaryOperator::LessOrEqual => Binary::LessOrEqual,
            BinaryOperator::Greater => return self.graph.binary(Binary::Less, right, left),
            BinaryOperator::GreaterOrEqual => return self.graph.binary(Binary::LessOrEqual, right, left),
            BinaryOperator::Equal => Binary::Equal,
            BinaryOperator::NotEqual => Binary::NotEqual,
            BinaryOperator::And => Binary::And,
            BinaryOperator::Or => Binary::Or,
        };
        self.graph.binary(function, left, right)
    }

    /// Value of a table; NaN if there is no table of that name.
    fn table(&mut self, name: &str, argument: NodeId) -> NodeId {
        let Some(table) = self.scope.table(name) else { return self.undefined() };
        let interpolation = self.graph.insert_interpolation(&table.interpolation);
        self.graph.interpolate(interpolation, argument)
    }

    fn undefined(&mut self) -> NodeId {
        self.graph.constant(f64::NAN)
    }

    fn text(&mut self, text: &str) -> NodeId {
        let known = self.texts.iter().position(|known| known == text);
        let index = known.unwrap_or_else(|| {
            self.texts.push(text.to_owned());
            self.texts.len() - 1
        });
        self.graph.constant(index as f64)
    }

    /// Value of a name with `order` primes.
    pub fn name(&mut self, name: &str, order: u32) -> Result<NodeId, TooManyNodes> {
        let Some(meaning) = self.scope.meaning(name) else {
            return Ok(self.undefined());
        };
        let node = match meaning {
            Meaning::Parameter(index) => self.graph.insert(Node::Parameter(index as u32)),
            Meaning::Independent => self.graph.insert(Node::Independent),
            Meaning::Pi => self.graph.constant(std::f64::consts::PI),
            Meaning::Variable(index) => {
                let chain = self.chains[index];
                let available = order.min(chain.highest);
                let node = chain.node(self.graph, available).unwrap_or(chain.rate);
                return self.derivative(meaning, node, available, order);
            }
            Meaning::Definition(index) => {
                let value = self.known.definitions.get(index).copied().flatten();
                value.unwrap_or_else(|| self.undefined())
            }
        };
        self.derivative(meaning, node, 0, order)
    }

    /// Differentiates `node`, the derivative of order `order`, up to order `wanted`.
    fn derivative(
        &mut self,
        meaning: Meaning,
        mut node: NodeId,
        order: u32,
        wanted: u32,
    ) -> Result<NodeId, TooManyNodes> {
        for order in order..wanted {
            node = match self.known.derivatives.get(&(meaning, order)) {
                Some(&known) => known,
                None => {
                    let derivative = total_derivative(self.graph, self.chains, &mut self.known.rates, node);
                    self.known.derivatives.insert((meaning, order), derivative);
                    derivative
                }
            };
            if self.graph.len() > limits::NODES {
                return Err(TooManyNodes);
            }
        }
        Ok(node)
    }
}

/// Total derivative along a solution of the equations. `rates` are the rates of the states by number, filled on first use.
fn total_derivative(graph: &mut Graph, chains: &[Chain], rates: &mut FxHashMap<u32, NodeId>, node: NodeId) -> NodeId {
    let (one, unknown) = (graph.constant(1.0), graph.constant(f64::NAN));
    let unset = if rates.is_empty() { chains } else { &[] };
    for chain in unset {
        for order in 0..chain.highest {
            if let Some(rate) = chain.node(graph, order + 1) {
                rates.insert(chain.first_state as u32 + order, rate);
            }
        }
    }
    let derivatives = along(graph, &[node], |input| match input {
        Node::Independent => Some(one),
        Node::State(index) => rates.get(&index).copied(),
        // The force jumps, and its rate in between is not known.
        Node::Friction(..) => Some(unknown),
        _ => None,
    });
    derivatives.first().copied().unwrap_or(node)
}

/// Value of `node` at the start of the run, where the independent variable is 0.
fn at_start(graph: &mut Graph, node: NodeId) -> NodeId {
    let values = graph.substitute(&[node], |graph, input| match input {
        Node::State(index) => Some(graph.insert(Node::Initial(index))),
        Node::Independent => Some(graph.constant(0.0)),
        _ => None,
    });
    values.first().copied().unwrap_or(node)
}

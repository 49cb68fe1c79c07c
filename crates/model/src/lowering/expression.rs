//! From checked expressions to nodes of the graph.

use super::friction::Calls;
use crate::names::{Meaning, Scope};
use crate::notation::quote;
use crate::{BinaryOperator, Expression, ExpressionKind, UnaryOperator, limits};
use program::along;
use program::functions::Function;
use program::{Binary, Graph, Node, NodeId, Unary};
use rustc_hash::FxHashMap;

/// An unknown function as the graph sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Chain {
    /// The index of its first state, the function itself.
    pub first_state: usize,
    /// How many states it has: the number of primes of its highest derivative.
    pub highest: u32,
    /// Its highest derivative.
    pub rate: NodeId,
}

impl Chain {
    /// The state with `order` primes, or the highest derivative; nothing beyond.
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

/// Turns expressions into nodes. The expressions have passed all checks of names and dimensions; what those have refused
/// becomes an undefined number here.
#[derive(Debug)]
pub(crate) struct Lowering<'a> {
    pub graph: &'a mut Graph,
    pub texts: &'a mut Vec<String>,
    pub scope: &'a Scope,
    pub chains: &'a [Chain],
    pub known: &'a mut Lowered,
}

/// What has a node already.
#[derive(Debug, Default)]
pub(crate) struct Lowered {
    /// The values of definitions; each is there before it is used.
    pub definitions: Vec<Option<NodeId>>,
    /// Derivatives that were already asked for.
    derivatives: FxHashMap<(Meaning, u32), NodeId>,
    /// How each state changes, once it was asked for.
    rates: FxHashMap<u32, NodeId>,
    /// Values at the start that were already asked for.
    starts: FxHashMap<NodeId, NodeId>,
    /// Where dry friction stands.
    pub frictions: Calls,
}

impl Lowered {
    /// These definitions and nothing else.
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
            // Vectors have been written out into components.
            ExpressionKind::Component { of, axis } => match &of.kind {
                ExpressionKind::Tuple { parts, .. } if *axis < parts.len() => self.expression(&parts[*axis])?,
                _ => self.undefined(),
            },
            // What belongs to families has been written out.
            ExpressionKind::Tuple { .. }
            | ExpressionKind::Member { .. }
            | ExpressionKind::Reduction { .. }
            | ExpressionKind::Error => self.undefined(),
        };
        Ok(node)
    }

    /// `a*b*c*d`, which is nested to the left as often as it has operators: a loop spares the stack.
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

    /// The value of a table; undefined if there is none of that name.
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

    /// The value of a name with `order` primes.
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

    /// Differentiates `node`, which has `order` primes, until it has `wanted`.
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

/// The rate of change along a solution of the equations. `rates` are those of the states, once they were asked for.
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
        // It jumps, and nothing says how it changes in between.
        Node::Friction(..) => Some(unknown),
        _ => None,
    });
    derivatives.first().copied().unwrap_or(node)
}

/// The value that `node` had at the start of the run, where the independent variable is 0.
fn at_start(graph: &mut Graph, node: NodeId) -> NodeId {
    let values = graph.substitute(&[node], |graph, input| match input {
        Node::State(index) => Some(graph.insert(Node::Initial(index))),
        Node::Independent => Some(graph.constant(0.0)),
        _ => None,
    });
    values.first().copied().unwrap_or(node)
}

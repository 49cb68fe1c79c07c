//! Dependence of expressions on the highest derivatives: an affine form (coefficients times highest derivatives, plus a
//! rest), or nonlinear.

use super::expression::TooManyNodes;
use crate::limits;
use program::{Binary, Graph, Node, NodeId, Unary};
use std::collections::{BTreeMap, BTreeSet};

/// `sum of coefficient*unknown + rest`; an absent coefficient or rest is 0. Coefficients are keyed by the number of the
/// unknown.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Affine {
    pub coefficients: BTreeMap<u32, NodeId>,
    pub rest: Option<NodeId>,
}

/// Dependence of a node on the unknowns.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Shape {
    /// Independent of the unknowns.
    Free,
    /// Affine in the unknowns.
    Affine(Affine),
    /// Any other dependence.
    Nonlinear,
}

/// Shapes of the nodes of one graph.
#[derive(Debug, Default)]
pub(crate) struct Shapes {
    known: Vec<Option<Shape>>,
    /// Number of coefficients in all known shapes.
    coefficients: usize,
}

impl Shapes {
    /// Shape of `root`. `unknown` returns the number of the unknown that a node represents, or `None`.
    pub fn of(
        &mut self,
        graph: &mut Graph,
        root: NodeId,
        unknown: impl Fn(Node) -> Option<u32>,
    ) -> Result<Shape, TooManyNodes> {
        for id in graph.reachable(&[root]) {
            if self.get(id).is_none() {
                let shape = self.compute(graph, id, &unknown);
                if let Shape::Affine(affine) = &shape {
                    self.coefficients += affine.coefficients.len();
                }
                if graph.len() > 2 * limits::NODES || self.coefficients > limits::COEFFICIENTS {
                    return Err(TooManyNodes);
                }
                self.known.resize(self.known.len().max(id.0 as usize + 1), None);
                self.known[id.0 as usize] = Some(shape);
            }
        }
        Ok(self.shape(root))
    }

    fn get(&self, id: NodeId) -> Option<&Shape> {
        self.known.get(id.0 as usize).and_then(Option::as_ref)
    }

    fn shape(&self, id: NodeId) -> Shape {
        self.get(id).cloned().unwrap_or(Shape::Free)
    }

    /// Shape of a node; the shapes of its operands are known.
    fn compute(&self, graph: &mut Graph, id: NodeId, unknown: &impl Fn(Node) -> Option<u32>) -> Shape {
        let node = graph.node(id);
        if let Some(number) = unknown(node) {
            let one = graph.constant(1.0);
            return Shape::Affine(Affine { coefficients: BTreeMap::from([(number, one)]), rest: None });
        }
        let mut free = true;
        let mut nonlinear = false;
        graph.for_each_operand(id, |operand| match self.get(operand) {
            None | Some(Shape::Free) => {}
            Some(Shape::Affine(_)) => free = false,
            Some(Shape::Nonlinear) => nonlinear = true,
        });
        if nonlinear {
            return Shape::Nonlinear;
        }
        if free {
            return Shape::Free;
        }
        let affine = match node {
            Node::Unary(Unary::Negate, x) => Some(self.affine(x).map(|part| graph.negate(part))),
            Node::Binary(Binary::Add, a, b) => Some(combine(graph, self.affine(a), self.affine(b), Binary::Add)),
            Node::Binary(Binary::Subtract, a, b) => {
                Some(combine(graph, self.affine(a), self.affine(b), Binary::Subtract))
            }
            Node::Binary(Binary::Multiply, a, b) if self.is_free(a) => {
                Some(self.affine(b).map(|part| graph.multiply(a, part)))
            }
            Node::Binary(Binary::Multiply, a, b) if self.is_free(b) => {
                Some(self.affine(a).map(|part| graph.multiply(part, b)))
            }
            Node::Binary(Binary::Divide, a, b) if self.is_free(b) => {
                Some(self.affine(a).map(|part| graph.divide(part, b)))
            }
            Node::Select(condition, chosen, other) if self.is_free(condition) => {
                Some(choose(graph, condition, &self.affine(chosen), &self.affine(other)))
            }
            _ => None,
        };
        affine.map_or(Shape::Nonlinear, Shape::Affine)
    }

    fn is_free(&self, id: NodeId) -> bool {
        matches!(self.get(id), None | Some(Shape::Free))
    }

    /// Affine form of a node that is not nonlinear.
    fn affine(&self, id: NodeId) -> Affine {
        match self.get(id) {
            Some(Shape::Affine(affine)) => affine.clone(),
            _ => Affine { coefficients: BTreeMap::new(), rest: Some(id) },
        }
    }
}

impl Affine {
    fn map(self, mut change: impl FnMut(NodeId) -> NodeId) -> Self {
        let coefficients = self.coefficients.into_iter().map(|(unknown, part)| (unknown, change(part))).collect();
        Self { coefficients, rest: self.rest.map(change) }
    }

    fn drop_zeros(mut self, graph: &Graph) -> Self {
        let is_zero = |id: NodeId| graph.as_constant(id) == Some(0.0);
        self.coefficients.retain(|_, &mut part| !is_zero(part));
        self.rest = self.rest.filter(|&part| !is_zero(part));
        self
    }
}

/// Sum or difference. Equal coefficients cancel, because the unknowns are finite.
fn combine(graph: &mut Graph, a: Affine, b: Affine, function: Binary) -> Affine {
    let mut join = |left: Option<NodeId>, right: Option<NodeId>| match (left, right) {
        (Some(left), Some(right)) if left == right && function == Binary::Subtract => None,
        (Some(left), Some(right)) => Some(graph.binary(function, left, right)),
        (None, Some(right)) if function == Binary::Subtract => Some(graph.negate(right)),
        (left, right) => left.or(right),
    };
    let rest = join(a.rest, b.rest);
    let unknowns: BTreeSet<u32> = a.coefficients.keys().chain(b.coefficients.keys()).copied().collect();
    let mut coefficient = |unknown: u32| {
        let joined = join(a.coefficients.get(&unknown).copied(), b.coefficients.get(&unknown).copied());
        joined.map(|part| (unknown, part))
    };
    let coefficients = unknowns.into_iter().filter_map(&mut coefficient).collect();
    Affine { coefficients, rest }.drop_zeros(graph)
}

fn choose(graph: &mut Graph, condition: NodeId, chosen: &Affine, other: &Affine) -> Affine {
    let zero = graph.constant(0.0);
    let mut join = |chosen: Option<NodeId>, other: Option<NodeId>| {
        (chosen.is_some() || other.is_some())
            .then(|| graph.select(condition, chosen.unwrap_or(zero), other.unwrap_or(zero)))
    };
    let rest = join(chosen.rest, other.rest);
    let unknowns: BTreeSet<u32> = chosen.coefficients.keys().chain(other.coefficients.keys()).copied().collect();
    let mut coefficient = |unknown: u32| {
        let joined = join(chosen.coefficients.get(&unknown).copied(), other.coefficients.get(&unknown).copied());
        joined.map(|part| (unknown, part))
    };
    let coefficients = unknowns.into_iter().filter_map(&mut coefficient).collect();
    Affine { coefficients, rest }.drop_zeros(graph)
}

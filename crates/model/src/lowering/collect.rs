//! Rewrites sums to reduce the work of each time step. Factors that depend on parameters alone are combined into one
//! coefficient per term, and the divisor is moved into the coefficients: -(b*y' + 2*rho*S*g*y)/(rho*S*L) becomes c_1*y' +
//! c_2*y. Results change only by rounding.

use crate::limits;
use program::{Binary, Graph, Node, NodeId, Unary};
use std::collections::HashMap;

/// Nodes that vary during a run with constant parameters.
#[derive(Debug, Default)]
pub(crate) struct Variation {
    known: Vec<bool>,
}

impl Variation {
    /// True if `id` is computed from states or the independent variable.
    pub fn of(&mut self, graph: &Graph, id: NodeId) -> bool {
        for number in self.known.len()..=id.0 as usize {
            let id = NodeId(number as u32);
            let mut varies = matches!(graph.node(id), Node::State(_) | Node::Independent);
            graph.for_each_operand(id, |operand| varies |= self.known[operand.0 as usize]);
            self.known.push(varies);
        }
        self.known[id.0 as usize]
    }
}

/// Maximum depth to which nested products are split.
const DEEPEST_PRODUCT: usize = 24;

/// A factor that depends on parameters alone, and one that varies; an absent factor is 1.
#[derive(Clone, Copy, Debug, Default)]
struct Product {
    coefficient: Option<NodeId>,
    part: Option<NodeId>,
}

/// Rewrites sums inside one graph.
#[derive(Debug, Default)]
pub(crate) struct Collector {
    pub variation: Variation,
    products: HashMap<NodeId, Product>,
}

impl Collector {
    /// `sum/divisor`
    pub fn quotient(&mut self, graph: &mut Graph, sum: NodeId, divisor: NodeId) -> NodeId {
        let Some(terms) = terms(graph, sum) else {
            return graph.divide(sum, divisor);
        };
        let into_coefficients = !self.variation.of(graph, divisor);
        let mut collected: Vec<(Product, NodeId)> = Vec::new();
        for (negative, term) in terms {
            let mut product = self.product(graph, term, DEEPEST_PRODUCT);
            if negative {
                product.coefficient = Some(self.opposite(graph, product.coefficient));
            }
            let coefficient = product.coefficient.unwrap_or_else(|| graph.constant(1.0));
            match collected.iter_mut().find(|(known, _)| known.part == product.part) {
                Some((_, sum)) => *sum = graph.add(*sum, coefficient),
                None => collected.push((product, coefficient)),
            }
        }
        let products: Vec<(NodeId, Option<NodeId>)> = collected
            .into_iter()
            .map(|(product, coefficient)| {
                let coefficient = if into_coefficients { graph.divide(coefficient, divisor) } else { coefficient };
                (coefficient, product.part)
            })
            .collect();
        let sum = written(graph, products);
        if into_coefficients { sum } else { graph.divide(sum, divisor) }
    }

    fn opposite(&mut self, graph: &mut Graph, coefficient: Option<NodeId>) -> NodeId {
        let coefficient = coefficient.unwrap_or_else(|| graph.constant(1.0));
        graph.negate(coefficient)
    }

    /// Separates the constant factors of a product.
    fn product(&mut self, graph: &mut Graph, id: NodeId, depth: usize) -> Product {
        if !self.variation.of(graph, id) {
            return Product { coefficient: Some(id), part: None };
        }
        if let Some(&known) = self.products.get(&id) {
            return known;
        }
        let whole = Product { coefficient: None, part: Some(id) };
        if depth == 0 {
            return whole;
        }
        let product = match graph.node(id) {
            Node::Unary(Unary::Negate, inner) => {
                let inner = self.product(graph, inner, depth - 1);
                Product { coefficient: Some(self.opposite(graph, inner.coefficient)), part: inner.part }
            }
            Node::Binary(Binary::Multiply, a, b) => {
                let (a, b) = (self.product(graph, a, depth - 1), self.product(graph, b, depth - 1));
                if a.coefficient.is_none() && b.coefficient.is_none() {
                    whole
                } else {
                    Product {
                        coefficient: multiplied(graph, a.coefficient, b.coefficient),
                        part: multiplied(graph, a.part, b.part),
                    }
                }
            }
            Node::Binary(Binary::Divide, a, b) => {
                let numerator = self.product(graph, a, depth - 1);
                match (numerator, self.variation.of(graph, b)) {
                    (_, false) => {
                        let coefficient = numerator.coefficient.unwrap_or_else(|| graph.constant(1.0));
                        Product { coefficient: Some(graph.divide(coefficient, b)), part: numerator.part }
                    }
                    (Product { coefficient: Some(coefficient), part: Some(part) }, true) => {
                        Product { coefficient: Some(coefficient), part: Some(graph.divide(part, b)) }
                    }
                    _ => whole,
                }
            }
            _ => whole,
        };
        self.products.insert(id, product);
        product
    }
}

fn multiplied(graph: &mut Graph, a: Option<NodeId>, b: Option<NodeId>) -> Option<NodeId> {
    match (a, b) {
        (Some(a), Some(b)) => Some(graph.multiply(a, b)),
        (one, other) => one.or(other),
    }
}

/// Terms of a sum, each with true if it is subtracted; `None` if there are more than [`limits::TERMS`].
fn terms(graph: &Graph, sum: NodeId) -> Option<Vec<(bool, NodeId)>> {
    let mut terms = Vec::new();
    let mut waiting = vec![(false, sum)];
    while let Some((negative, id)) = waiting.pop() {
        match graph.node(id) {
            Node::Unary(Unary::Negate, inner) => waiting.push((!negative, inner)),
            Node::Binary(Binary::Add, a, b) => waiting.extend([(negative, b), (negative, a)]),
            Node::Binary(Binary::Subtract, a, b) => waiting.extend([(!negative, b), (negative, a)]),
            _ => terms.push((negative, id)),
        }
        if terms.len() + waiting.len() > limits::TERMS {
            return None;
        }
    }
    Some(terms)
}

/// The sum of coefficients times parts. Unlike the simplifying constructors, this keeps signs in the coefficients, which
/// are computed once and not in each step.
fn written(graph: &mut Graph, mut products: Vec<(NodeId, Option<NodeId>)>) -> NodeId {
    let is_minus_one = |graph: &Graph, id: NodeId| graph.as_constant(id) == Some(-1.0);
    // Start with a term that needs no sign of its own.
    if let Some(first) = products.iter().position(|&(coefficient, _)| !is_minus_one(graph, coefficient)) {
        products[..=first].rotate_right(1);
    }
    let mut sum: Option<NodeId> = None;
    for (coefficient, part) in products {
        let Some(part) = part else {
            sum = Some(sum.map_or(coefficient, |sum| graph.add(sum, coefficient)));
            continue;
        };
        if is_minus_one(graph, coefficient) {
            sum = Some(match sum {
                Some(sum) => graph.subtract(sum, part),
                None => graph.negate(part),
            });
            continue;
        }
        let term = if graph.as_constant(coefficient) == Some(1.0) {
            part
        } else {
            graph.insert(Node::Binary(Binary::Multiply, coefficient.min(part), coefficient.max(part)))
        };
        sum = Some(sum.map_or(term, |sum| graph.insert(Node::Binary(Binary::Add, sum.min(term), sum.max(term)))));
    }
    sum.unwrap_or_else(|| graph.constant(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Number of nodes that vary, which must be evaluated in each step.
    fn work(graph: &Graph, root: NodeId) -> usize {
        let mut variation = Variation::default();
        let operations = graph
            .reachable(&[root])
            .into_iter()
            .filter(|&id| variation.of(graph, id) && !matches!(graph.node(id), Node::State(_) | Node::Independent));
        operations.count()
    }

    #[test]
    fn the_u_tube_needs_two_products_and_a_sum() {
        let mut graph = Graph::default();
        let [rho, s, l, b, g] = [0, 1, 2, 3, 4].map(|index| graph.insert(Node::Parameter(index)));
        let (y, v) = (graph.insert(Node::State(0)), graph.insert(Node::State(1)));
        let two = graph.constant(2.0);
        let damping = graph.multiply(b, v);
        let weight = [rho, s, g, y].into_iter().fold(two, |product, factor| graph.multiply(product, factor));
        let sum = graph.add(damping, weight);
        let force = graph.negate(sum);
        let mass = [s, l].into_iter().fold(rho, |product, factor| graph.multiply(product, factor));
        let acceleration = Collector::default().quotient(&mut graph, force, mass);
        assert_eq!(work(&graph, acceleration), 3);
    }

    #[test]
    fn equal_parts_are_joined() {
        let mut graph = Graph::default();
        let (a, b) = (graph.insert(Node::Parameter(0)), graph.insert(Node::Parameter(1)));
        let y = graph.insert(Node::State(0));
        let (first, second) = (graph.multiply(a, y), graph.multiply(y, b));
        let sum = graph.add(first, second);
        let one = graph.constant(1.0);
        let joined = Collector::default().quotient(&mut graph, sum, one);
        assert_eq!(work(&graph, joined), 1);
    }

    #[test]
    fn a_sum_that_doubles_itself_is_left_alone() {
        let mut graph = Graph::default();
        let mut sum = graph.insert(Node::State(0));
        for _ in 0..200 {
            sum = graph.add(sum, sum);
        }
        let one = graph.constant(1.0);
        assert_eq!(Collector::default().quotient(&mut graph, sum, one), sum);
    }
}

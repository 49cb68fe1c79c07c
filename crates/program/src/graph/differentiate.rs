//! Symbolic derivatives of expressions: for the Jacobian of a stiff method, derivatives of defined quantities, and
//! sensitivities to parameters.

use super::{Binary, Graph, LinearSystem, Node, NodeId, Unary};
use std::collections::{HashMap, HashSet};

/// Variable of differentiation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Variable {
    /// [`Node::State`]
    State(u32),
    /// [`Node::Parameter`]
    Parameter(u32),
    /// [`Node::Initial`]
    Initial(u32),
    /// [`Node::Independent`]
    Independent,
}

/// The partial derivative of `node` with respect to `variable`.
///
/// At a corner or jump of a function (`abs`, `min`, `floor`, `if`), it is the derivative of the branch taken.
pub fn differentiate(graph: &mut Graph, node: NodeId, variable: Variable) -> NodeId {
    let derivatives = differentiate_all(graph, &[node], variable);
    derivatives.first().copied().unwrap_or(node)
}

/// Partial derivatives of several nodes in one pass, one per node.
pub fn differentiate_all(graph: &mut Graph, nodes: &[NodeId], variable: Variable) -> Vec<NodeId> {
    let wanted = input(variable);
    let one = graph.constant(1.0);
    along(graph, nodes, |node| (node == wanted).then_some(one))
}

/// Partial derivatives by node; those that are identically 0 are left out. `nodes` must be in the order of their operands
/// and contain everything that depends on the variable.
pub(crate) fn differentiate_through(
    graph: &mut Graph,
    nodes: &[NodeId],
    variable: Variable,
) -> HashMap<NodeId, NodeId> {
    let wanted = input(variable);
    let one = graph.constant(1.0);
    let derivatives = rates_through(graph, nodes, |node| (node == wanted).then_some(one));
    graph.constant(0.0);
    derivatives
}

fn input(variable: Variable) -> Node {
    match variable {
        Variable::State(index) => Node::State(index),
        Variable::Parameter(index) => Node::Parameter(index),
        Variable::Initial(index) => Node::Initial(index),
        Variable::Independent => Node::Independent,
    }
}

/// Directional derivatives of `nodes`, one per node: `rate` gives the rate of change of each input, `None` for 0.
pub fn along(graph: &mut Graph, nodes: &[NodeId], rate: impl FnMut(Node) -> Option<NodeId>) -> Vec<NodeId> {
    let reachable = graph.reachable(nodes);
    let rates = rates_through(graph, &reachable, rate);
    let zero = graph.constant(0.0);
    nodes.iter().map(|node| rates.get(node).copied().unwrap_or(zero)).collect()
}

/// Directional derivatives by node; those that are identically 0 are left out. `nodes` must be in the order of their
/// operands.
fn rates_through(
    graph: &mut Graph,
    nodes: &[NodeId],
    mut rate: impl FnMut(Node) -> Option<NodeId>,
) -> HashMap<NodeId, NodeId> {
    let mut rates: HashMap<NodeId, NodeId> = HashMap::new();
    let mut systems: HashMap<u32, Option<u32>> = HashMap::new();
    let mut slopes: HashMap<u32, u32> = HashMap::new();
    // Nodes that depend on a switch.
    let mut bent: HashSet<NodeId> = HashSet::new();
    for &id in nodes {
        let mut bends = graph.node(id).is_switch() || matches!(graph.node(id), Node::Select(..));
        graph.for_each_operand(id, |operand| bends |= bent.contains(&operand));
        if bends {
            bent.insert(id);
        }
        let derivative = match graph.node(id) {
            Node::Constant(_) => None,
            input @ (Node::Parameter(_)
            | Node::Initial(_)
            | Node::Independent
            | Node::State(_)
            | Node::Friction(..)) => rate(input),
            Node::Unary(function, x) => {
                let derivative = rates.get(&x).copied().and_then(|dx| of_unary(graph, function, id, x, dx));
                derivative.map(|derivative| if bends { without_pole(graph, id, derivative) } else { derivative })
            }
            Node::Binary(function, a, b) => {
                let (da, db) = (rates.get(&a).copied(), rates.get(&b).copied());
                let derivative = of_binary(graph, function, id, (a, b), (da, db));
                derivative.map(|derivative| if bends { without_pole(graph, id, derivative) } else { derivative })
            }
            Node::Select(condition, chosen, other) => {
                let (chosen, other) = (rates.get(&chosen).copied(), rates.get(&other).copied());
                if chosen.is_none() && other.is_none() {
                    None
                } else {
                    let zero = graph.constant(0.0);
                    Some(graph.select(condition, chosen.unwrap_or(zero), other.unwrap_or(zero)))
                }
            }
            Node::Piece(..) => None,
            Node::Interpolated(interpolation, x, piece) => rates.get(&x).copied().map(|dx| {
                let derivative =
                    *slopes.entry(interpolation).or_insert_with(|| graph.derivative_of_table(interpolation));
                let slope = graph.interpolated(derivative, x, piece);
                graph.multiply(slope, dx)
            }),
            // Draws have no derivative; only actions and initial values depend on draws.
            Node::Binomial(..) => None,
            Node::Solution { system, row } => {
                let rate_system = match systems.get(&system) {
                    Some(&known) => known,
                    None => {
                        let derived = of_system(graph, system, &rates);
                        systems.insert(system, derived);
                        derived
                    }
                };
                rate_system.map(|system| graph.insert(Node::Solution { system, row }))
            }
        };
        if let Some(derivative) = derivative
            && graph.as_constant(derivative) != Some(0.0)
        {
            rates.insert(id, derivative);
        }
    }
    rates
}

/// The derivative of `node`, 0 where the slope of a root or of an inverse function is infinite. There a switch limits its argument, as
/// in `sqrt(max(h, 0))`, and the derivative of that is 0 on one side.
fn without_pole(graph: &mut Graph, node: NodeId, derivative: NodeId) -> NodeId {
    let zero = graph.constant(0.0);
    let steep = match graph.node(node) {
        Node::Unary(Unary::SquareRoot | Unary::CubeRoot, x) | Node::Binary(Binary::Power, x, _) => {
            graph.binary(Binary::Equal, x, zero)
        }
        Node::Unary(Unary::Asin | Unary::Acos, x) => {
            let (one, size) = (graph.constant(1.0), graph.unary(Unary::Absolute, x));
            graph.binary(Binary::Equal, size, one)
        }
        _ => return derivative,
    };
    graph.select(steep, zero, derivative)
}

/// Derivative of `value = function(x)`, where `x` has the rate `dx`.
fn of_unary(graph: &mut Graph, function: Unary, value: NodeId, x: NodeId, dx: NodeId) -> Option<NodeId> {
    let one = graph.constant(1.0);
    let x_squared = |graph: &mut Graph| graph.multiply(x, x);
    let derivative = match function {
        Unary::Negate => graph.negate(dx),
        Unary::Not | Unary::Sign | Unary::Floor | Unary::Ceil | Unary::Round => return None,
        // Draws have no derivative; only actions and initial values depend on draws.
        Unary::Uniform | Unary::Normal | Unary::Exponential => return None,
        Unary::Absolute => {
            let sign = graph.unary(Unary::Sign, x);
            graph.multiply(sign, dx)
        }
        Unary::SquareRoot => {
            let twice = graph.add(value, value);
            graph.divide(dx, twice)
        }
        Unary::CubeRoot => {
            let three = graph.constant(3.0);
            let square = graph.multiply(value, value);
            let divisor = graph.multiply(three, square);
            graph.divide(dx, divisor)
        }
        Unary::Exp => graph.multiply(value, dx),
        Unary::Ln => graph.divide(dx, x),
        Unary::Log10 => {
            let ln_10 = graph.constant(std::f64::consts::LN_10);
            let divisor = graph.multiply(ln_10, x);
            graph.divide(dx, divisor)
        }
        Unary::Sin => {
            let cosine = graph.unary(Unary::Cos, x);
            graph.multiply(cosine, dx)
        }
        Unary::Cos => {
            let sine = graph.unary(Unary::Sin, x);
            let product = graph.multiply(sine, dx);
            graph.negate(product)
        }
        Unary::Tan => {
            let square = graph.multiply(value, value);
            let factor = graph.add(one, square);
            graph.multiply(factor, dx)
        }
        Unary::Asin | Unary::Acos => {
            let square = x_squared(graph);
            let inside = graph.subtract(one, square);
            let root = graph.unary(Unary::SquareRoot, inside);
            let quotient = graph.divide(dx, root);
            if function == Unary::Asin { quotient } else { graph.negate(quotient) }
        }
        Unary::Atan => {
            let square = x_squared(graph);
            let divisor = graph.add(one, square);
            graph.divide(dx, divisor)
        }
        Unary::Sinh => {
            let cosine = graph.unary(Unary::Cosh, x);
            graph.multiply(cosine, dx)
        }
        Unary::Cosh => {
            let sine = graph.unary(Unary::Sinh, x);
            graph.multiply(sine, dx)
        }
        Unary::Tanh => {
            let square = graph.multiply(value, value);
            let factor = graph.subtract(one, square);
            graph.multiply(factor, dx)
        }
        Unary::Asinh | Unary::Acosh => {
            let square = x_squared(graph);
            let inside = if function == Unary::Asinh { graph.add(square, one) } else { graph.subtract(square, one) };
            let root = graph.unary(Unary::SquareRoot, inside);
            graph.divide(dx, root)
        }
        Unary::Atanh => {
            let square = x_squared(graph);
            let divisor = graph.subtract(one, square);
            graph.divide(dx, divisor)
        }
    };
    Some(derivative)
}

/// Derivative of `value = function(a, b)`, where `a` and `b` have the rates `da` and `db`; `None` for 0.
fn of_binary(
    graph: &mut Graph,
    function: Binary,
    value: NodeId,
    (a, b): (NodeId, NodeId),
    (da, db): (Option<NodeId>, Option<NodeId>),
) -> Option<NodeId> {
    if da.is_none() && db.is_none() {
        return None;
    }
    let zero = graph.constant(0.0);
    match function {
        Binary::Add => Some(graph.add(da.unwrap_or(zero), db.unwrap_or(zero))),
        Binary::Subtract => Some(graph.subtract(da.unwrap_or(zero), db.unwrap_or(zero))),
        Binary::Multiply => {
            let left = da.map(|da| graph.multiply(da, b));
            let right = db.map(|db| graph.multiply(a, db));
            sum(graph, left, right)
        }
        Binary::Divide => {
            // (a/b)' = (a' - (a/b) b')/b
            let inner = db.map(|db| graph.multiply(value, db));
            let numerator = graph.subtract(da.unwrap_or(zero), inner.unwrap_or(zero));
            Some(graph.divide(numerator, b))
        }
        Binary::Power => {
            let by_base = da.map(|da| {
                let one = graph.constant(1.0);
                let lower = graph.subtract(b, one);
                let power = graph.power(a, lower);
                let factor = graph.multiply(b, power);
                graph.multiply(factor, da)
            });
            let by_exponent = db.map(|db| {
                let logarithm = graph.unary(Unary::Ln, a);
                let factor = graph.multiply(value, logarithm);
                graph.multiply(factor, db)
            });
            sum(graph, by_base, by_exponent)
        }
        Binary::Atan2 => {
            // a is the opposite, b the adjacent side.
            let left = da.map(|da| graph.multiply(b, da));
            let right = db.map(|db| graph.multiply(a, db));
            let numerator = graph.subtract(left.unwrap_or(zero), right.unwrap_or(zero));
            let (a_squared, b_squared) = (graph.multiply(a, a), graph.multiply(b, b));
            let divisor = graph.add(a_squared, b_squared);
            Some(graph.divide(numerator, divisor))
        }
        Binary::Minimum | Binary::Maximum => {
            let (low, high) = if function == Binary::Minimum { (a, b) } else { (b, a) };
            let a_taken = graph.binary(Binary::Less, low, high);
            Some(graph.select(a_taken, da.unwrap_or(zero), db.unwrap_or(zero)))
        }
        Binary::Less | Binary::LessOrEqual | Binary::Equal | Binary::NotEqual | Binary::And | Binary::Or => None,
        Binary::Stream | Binary::Poisson => None,
    }
}

fn sum(graph: &mut Graph, a: Option<NodeId>, b: Option<NodeId>) -> Option<NodeId> {
    match (a, b) {
        (Some(a), Some(b)) => Some(graph.add(a, b)),
        (one, other) => one.or(other),
    }
}

/// The system whose solution is the derivative of the solution of A x = r: A x' = r' - A' x. `None` if A and r are
/// constant.
fn of_system(graph: &mut Graph, system: u32, rates: &HashMap<NodeId, NodeId>) -> Option<u32> {
    let linear = graph.systems()[system as usize].clone();
    if linear.operands().all(|operand| !rates.contains_key(&operand)) {
        return None;
    }
    let size = linear.right.len() as u32;
    let solution: Vec<NodeId> = (0..size).map(|row| graph.insert(Node::Solution { system, row })).collect();
    let rate = |graph: &mut Graph, node: &NodeId| rates.get(node).copied().unwrap_or_else(|| graph.constant(0.0));
    let mut right: Vec<NodeId> = linear.right.iter().map(|node| rate(graph, node)).collect();
    for entry in &linear.entries {
        if let Some(&rate) = rates.get(&entry.node) {
            let product = graph.multiply(rate, solution[entry.column as usize]);
            let value = &mut right[entry.row as usize];
            *value = graph.subtract(*value, product);
        }
    }
    Some(graph.insert_system(LinearSystem { right, ..linear }))
}

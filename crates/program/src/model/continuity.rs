//! Continuity of the rates at a switch, judged from their form.

use crate::{Binary, Graph, Node, NodeId, Unary};

/// True if all of `rates` have the same value on both sides of a comparison or sign where its two sides are equal, as those of
/// `sign(h)*sqrt(abs(h))` or `if a > b then sqrt(a - b) else 0` have. The equal sides are replaced by one expression; false also
/// where the form does not show it. Every factor without a pole there is taken to be finite, and every exponent of 0 positive.
pub(super) fn is_continuous(graph: &mut Graph, rates: &[NodeId], switch: NodeId) -> bool {
    let zero = graph.constant(0.0);
    let (sides, values) = match graph.node(switch) {
        Node::Unary(Unary::Sign, x) => ((x, zero), [1.0, -1.0]),
        Node::Binary(Binary::Less | Binary::LessOrEqual, a, b) => ((a, b), [1.0, 0.0]),
        _ => return false,
    };
    let Some((replaced, other)) = replacement(graph, sides, switch) else { return false };
    let undefined = graph.constant(f64::NAN);
    let [above, below] = values.map(|value| {
        graph.rewrite(rates, |graph, id, node| {
            if id == switch {
                Some(graph.constant(value))
            } else if id == replaced {
                Some(other)
            } else {
                simplified(graph, node, [zero, undefined])
            }
        })
    });
    above == below && !above.contains(&undefined)
}

/// Node that is replaced and its replacement, for the two sides of a comparison. `None` if each depends on the other or on the
/// switch.
fn replacement(graph: &Graph, (a, b): (NodeId, NodeId), switch: NodeId) -> Option<(NodeId, NodeId)> {
    let is_zero = |node| graph.as_constant(node) == Some(0.0);
    let (a, b) = match [a, b].map(|node| graph.node(node)) {
        [Node::Binary(Binary::Subtract, p, q), _] if is_zero(b) => (p, q),
        [_, Node::Binary(Binary::Subtract, p, q)] if is_zero(a) => (p, q),
        [Node::Unary(Unary::Negate, x), _] if is_zero(b) => (x, b),
        [_, Node::Unary(Unary::Negate, x)] if is_zero(a) => (x, a),
        _ => (a, b),
    };
    let is_state = |node| matches!(graph.node(node), Node::State(_));
    let orders = if is_state(b) { [(b, a), (a, b)] } else { [(a, b), (b, a)] };
    orders.into_iter().find(|&(replaced, other)| {
        let needed = graph.reachable(&[other]);
        graph.as_constant(replaced).is_none() && !needed.contains(&replaced) && !needed.contains(&switch)
    })
}

/// Value of an operation whose operands are equal, 0 or `undefined`; `None` if it is none of these.
fn simplified(graph: &mut Graph, node: Node, [zero, undefined]: [NodeId; 2]) -> Option<NodeId> {
    let (is_zero, is_undefined) = (|operand| operand == zero, |operand| operand == undefined);
    match node {
        Node::Unary(_, x) if is_undefined(x) => Some(undefined),
        Node::Unary(Unary::Ln | Unary::Log10, x) if is_zero(x) => Some(undefined),
        Node::Unary(Unary::Negate, x) if is_zero(x) => Some(zero),
        Node::Binary(_, a, b) if is_undefined(a) || is_undefined(b) => Some(undefined),
        Node::Binary(Binary::Divide, a, b) if a == b || is_zero(b) => {
            Some(if is_zero(b) { undefined } else { graph.constant(1.0) })
        }
        Node::Binary(Binary::Divide, a, _) if is_zero(a) => Some(zero),
        Node::Binary(Binary::Multiply, a, b) if is_zero(a) || is_zero(b) => Some(zero),
        Node::Binary(Binary::Power, a, b) if is_zero(a) && graph.as_constant(b).is_none() => Some(zero),
        Node::Binary(Binary::Subtract, a, b) if a == b => Some(zero),
        Node::Binary(Binary::Minimum | Binary::Maximum, a, b) if a == b => Some(a),
        Node::Binary(Binary::Less, a, b) if a == b => Some(zero),
        Node::Binary(Binary::LessOrEqual, a, b) if a == b => Some(graph.constant(1.0)),
        Node::Select(condition, ..) if is_undefined(condition) => Some(undefined),
        Node::Select(_, chosen, other) if chosen == other => Some(chosen),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Binary::{Divide, Less, LessOrEqual, Multiply, Power, Subtract};

    /// Rates of two levels x and y, a speed v and a parameter p, with a switch in each.
    #[test]
    fn values_on_both_sides_of_a_switch() {
        let mut graph = Graph::default();
        let [x, y, p] = [Node::State(0), Node::State(1), Node::Parameter(0)].map(|node| graph.insert(node));
        let zero = graph.constant(0.0);
        let g = &mut graph;
        let (d, opposite) = (g.subtract(x, y), g.subtract(y, x));
        let (down, up) = (g.unary(Unary::SquareRoot, d), g.unary(Unary::SquareRoot, opposite));
        let back = g.negate(up);
        let sign = g.unary(Unary::Sign, d);
        let size = g.unary(Unary::Absolute, d);
        let root = g.unary(Unary::SquareRoot, size);
        let friction = g.multiply(sign, p);
        let torricelli = g.multiply(sign, root);
        let pole = g.binary(Divide, d, size);
        let product_with_pole = g.multiply(sign, pole);
        let levels = g.binary(LessOrEqual, y, x);
        let level = g.binary(Less, zero, x);
        let power = g.binary(Power, x, p);
        let beside = g.binary(Multiply, y, p);
        let shifted = g.binary(Subtract, x, p);
        let above = g.binary(Less, p, x);
        let cases = [
            (levels, [down, back], true),
            (levels, [down, up], true),
            (levels, [down, beside], false),
            (level, [power, zero], true),
            (level, [x, zero], true),
            (level, [y, y], true),
            (level, [beside, zero], false),
            (above, [shifted, zero], true),
            (above, [x, zero], false),
            (above, [x, p], true),
        ];
        for (switch, [chosen, other], expected) in cases {
            let rate = graph.select(switch, chosen, other);
            assert_eq!(is_continuous(&mut graph, &[rate], switch), expected, "{:?}", graph.node(rate));
        }
        for (rate, expected) in [(torricelli, true), (friction, false), (product_with_pole, false)] {
            assert_eq!(is_continuous(&mut graph, &[rate], sign), expected, "{:?}", graph.node(rate));
        }
    }
}

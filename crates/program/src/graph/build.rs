//! Constructors that simplify as they build. All simplifications are exact in IEEE arithmetic up to the sign of a zero:
//! constants are folded, neutral elements dropped, signs moved outwards, whole powers multiplied out. `0*x` is kept because
//! it is not 0 for an infinite x.

use crate::{Binary, Graph, Node, NodeId, Unary};
use std::sync::Arc;

/// Greatest whole power that is multiplied out: beyond it, repeated products have a greater error than `pow`.
const GREATEST_PRODUCT: f64 = 16.0;

impl Graph {
    /// Node of a constant.
    pub fn constant(&mut self, value: f64) -> NodeId {
        self.insert(Node::Constant(value.to_bits()))
    }

    /// Value of a constant node, `None` for any other node.
    pub fn as_constant(&self, id: NodeId) -> Option<f64> {
        match self.node(id) {
            Node::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    fn is(&self, id: NodeId, value: f64) -> bool {
        self.as_constant(id) == Some(value)
    }

    fn negated(&self, id: NodeId) -> Option<NodeId> {
        match self.node(id) {
            Node::Unary(Unary::Negate, inner) => Some(inner),
            _ => None,
        }
    }

    /// Node of a function of one argument.
    pub fn unary(&mut self, function: Unary, x: NodeId) -> NodeId {
        if let Some(value) = self.as_constant(x) {
            return self.constant(function.evaluate(value));
        }
        match (function, self.node(x)) {
            (Unary::Negate, Node::Unary(Unary::Negate, inner)) => inner,
            (Unary::Negate, Node::Binary(Binary::Subtract, a, b)) => self.insert(Node::Binary(Binary::Subtract, b, a)),
            (Unary::Absolute | Unary::Cos | Unary::Cosh, Node::Unary(Unary::Negate, inner)) => {
                self.unary(function, inner)
            }
            (Unary::Absolute, Node::Unary(Unary::Absolute | Unary::SquareRoot, _)) => x,
            _ => self.insert(Node::Unary(function, x)),
        }
    }

    /// Node of a function of two arguments.
    pub fn binary(&mut self, function: Binary, a: NodeId, b: NodeId) -> NodeId {
        match function {
            Binary::Add => self.add(a, b),
            Binary::Subtract => self.subtract(a, b),
            Binary::Multiply => self.multiply(a, b),
            Binary::Divide => self.divide(a, b),
            Binary::Power => self.power(a, b),
            Binary::Equal | Binary::NotEqual | Binary::And | Binary::Or => self.folded(function, a.min(b), a.max(b)),
            _ => self.folded(function, a, b),
        }
    }

    fn folded(&mut self, function: Binary, a: NodeId, b: NodeId) -> NodeId {
        match (self.as_constant(a), self.as_constant(b)) {
            (Some(a), Some(b)) => self.constant(function.evaluate(a, b)),
            _ => self.insert(Node::Binary(function, a, b)),
        }
    }

    /// `-x`
    pub fn negate(&mut self, x: NodeId) -> NodeId {
        self.unary(Unary::Negate, x)
    }

    /// `a + b`
    pub fn add(&mut self, a: NodeId, b: NodeId) -> NodeId {
        if self.is(a, 0.0) {
            return b;
        }
        if self.is(b, 0.0) {
            return a;
        }
        match (self.negated(a), self.negated(b)) {
            (Some(a), Some(b)) => {
                let sum = self.add(a, b);
                self.negate(sum)
            }
            (None, Some(b)) => self.subtract(a, b),
            (Some(a), None) => self.subtract(b, a),
            (None, None) => self.folded(Binary::Add, a.min(b), a.max(b)),
        }
    }

    /// `a - b`
    pub fn subtract(&mut self, a: NodeId, b: NodeId) -> NodeId {
        if self.is(b, 0.0) {
            return a;
        }
        if self.is(a, 0.0) {
            return self.negate(b);
        }
        match (self.negated(a), self.negated(b)) {
            (_, Some(b)) => self.add(a, b),
            (Some(a), None) => {
                let sum = self.add(a, b);
                self.negate(sum)
            }
            (None, None) => self.folded(Binary::Subtract, a, b),
        }
    }

    /// `a*b`
    pub fn multiply(&mut self, a: NodeId, b: NodeId) -> NodeId {
        let (a_negative, a) = self.split_sign(a);
        let (b_negative, b) = self.split_sign(b);
        let product = if self.is(a, 1.0) {
            b
        } else if self.is(b, 1.0) {
            a
        } else {
            self.folded(Binary::Multiply, a.min(b), a.max(b))
        };
        if a_negative == b_negative { product } else { self.negate(product) }
    }

    /// `a/b`
    pub fn divide(&mut self, a: NodeId, b: NodeId) -> NodeId {
        let (a_negative, a) = self.split_sign(a);
        let (b_negative, b) = self.split_sign(b);
        let quotient = match self.as_constant(b) {
            Some(1.0) => a,
            Some(divisor) if has_exact_reciprocal(divisor) => {
                let reciprocal = self.constant(1.0 / divisor);
                self.multiply(reciprocal, a)
            }
            _ => self.folded(Binary::Divide, a, b),
        };
        if a_negative == b_negative { quotient } else { self.negate(quotient) }
    }

    /// True if a minus sign can be moved out of `id`, with the node without it.
    fn split_sign(&mut self, id: NodeId) -> (bool, NodeId) {
        match self.node(id) {
            Node::Unary(Unary::Negate, inner) => (true, inner),
            Node::Constant(bits) if f64::from_bits(bits) < 0.0 => (true, self.constant(-f64::from_bits(bits))),
            _ => (false, id),
        }
    }

    /// `a^b`: small whole and half-integer powers by multiplication and square root.
    pub fn power(&mut self, a: NodeId, b: NodeId) -> NodeId {
        let Some(exponent) = self.as_constant(b) else {
            return self.folded(Binary::Power, a, b);
        };
        if let Some(base) = self.as_constant(a) {
            return self.constant(Binary::Power.evaluate(base, exponent));
        }
        let magnitude = exponent.abs();
        let whole = magnitude.floor();
        if !(magnitude <= GREATEST_PRODUCT && (magnitude == whole || magnitude == whole + 0.5)) {
            return self.folded(Binary::Power, a, b);
        }
        let mut result = self.whole_power(a, whole as u32);
        if magnitude != whole {
            let root = self.unary(Unary::SquareRoot, a);
            result = self.multiply(result, root);
        }
        if exponent < 0.0 {
            let one = self.constant(1.0);
            result = self.divide(one, result);
        }
        result
    }

    /// Whole power by repeated squaring.
    fn whole_power(&mut self, base: NodeId, mut exponent: u32) -> NodeId {
        let mut result = self.constant(1.0);
        let mut square = base;
        while exponent > 0 {
            if exponent % 2 == 1 {
                result = self.multiply(result, square);
            }
            exponent /= 2;
            if exponent > 0 {
                square = self.multiply(square, square);
            }
        }
        result
    }

    /// True if the reader draws the curve, so that its values are not constants.
    fn is_drawn(&self, interpolation: u32) -> bool {
        self.interpolations()[interpolation as usize].drawing().is_some()
    }

    /// Index of the piece of an interpolation in which `x` lies.
    pub fn piece(&mut self, interpolation: u32, x: NodeId) -> NodeId {
        match self.as_constant(x) {
            Some(x) if !self.is_drawn(interpolation) => {
                self.constant(self.interpolations()[interpolation as usize].piece(x))
            }
            _ => self.insert(Node::Piece(interpolation, x)),
        }
    }

    /// Value at `x` of the piece `piece` of an interpolation.
    pub fn interpolated(&mut self, interpolation: u32, x: NodeId, piece: NodeId) -> NodeId {
        match (self.as_constant(x), self.as_constant(piece)) {
            (Some(x), Some(piece)) if !self.is_drawn(interpolation) => {
                self.constant(self.interpolations()[interpolation as usize].value(x, piece))
            }
            _ => self.insert(Node::Interpolated(interpolation, x, piece)),
        }
    }

    /// Value of an interpolation at `x`.
    pub fn interpolate(&mut self, interpolation: u32, x: NodeId) -> NodeId {
        let piece = self.piece(interpolation, x);
        self.interpolated(interpolation, x, piece)
    }

    /// A number that changes its sign exactly where `x` passes a point of the interpolation ([`crate::Interpolation::zeros`]).
    pub fn passing_points(&mut self, interpolation: u32, x: NodeId) -> NodeId {
        let zeros = Arc::new(self.interpolations()[interpolation as usize].zeros());
        let zeros = self.insert_interpolation(&zeros);
        self.interpolate(zeros, x)
    }

    /// Index of the interpolation that is the derivative of this one.
    pub(super) fn derivative_of_table(&mut self, interpolation: u32) -> u32 {
        let derivative = Arc::new(self.interpolations()[interpolation as usize].derivative());
        self.insert_interpolation(&derivative)
    }

    /// `chosen` if `condition` is true, otherwise `other`.
    pub fn select(&mut self, condition: NodeId, chosen: NodeId, other: NodeId) -> NodeId {
        match self.as_constant(condition) {
            Some(0.0) => other,
            Some(_) => chosen,
            None if chosen == other => chosen,
            None => self.insert(Node::Select(condition, chosen, other)),
        }
    }
}

/// True if multiplication by `1/divisor` equals division, bit by bit: for powers of two.
fn has_exact_reciprocal(divisor: f64) -> bool {
    const FRACTION: u64 = (1 << 52) - 1;
    divisor.to_bits() & FRACTION == 0 && divisor.is_normal() && (1.0 / divisor).is_normal()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_expressions_are_one_node() {
        let mut graph = Graph::default();
        let (a, b) = (graph.insert(Node::State(0)), graph.insert(Node::State(1)));
        assert_eq!(graph.add(a, b), graph.add(b, a));
        assert_eq!(graph.multiply(a, b), graph.multiply(b, a));
        let difference = graph.subtract(a, b);
        let opposite = graph.subtract(b, a);
        assert_eq!(graph.negate(difference), opposite);
    }

    #[test]
    fn signs_move_outwards() {
        let mut graph = Graph::default();
        let (a, b) = (graph.insert(Node::State(0)), graph.insert(Node::State(1)));
        let minus_a = graph.negate(a);
        let minus_b = graph.negate(b);
        assert_eq!(graph.multiply(minus_a, minus_b), graph.multiply(a, b));
        assert_eq!(graph.add(b, minus_a), graph.subtract(b, a));
        assert_eq!(graph.subtract(b, minus_a), graph.add(a, b));
        let minus_two = graph.constant(-2.0);
        let two = graph.constant(2.0);
        let term = graph.multiply(minus_two, a);
        let positive = graph.multiply(two, a);
        assert_eq!(graph.add(b, term), graph.subtract(b, positive));
    }

    #[test]
    fn nothing_undefined_becomes_a_number() {
        let mut graph = Graph::default();
        let x = graph.insert(Node::State(0));
        let zero = graph.constant(0.0);
        let product = graph.multiply(zero, x);
        assert_eq!(graph.as_constant(product), None, "0*inf is not 0");
        let difference = graph.subtract(x, x);
        assert_eq!(graph.as_constant(difference), None, "inf - inf is not 0");
        let quotient = graph.divide(x, x);
        assert_eq!(graph.as_constant(quotient), None, "0/0 is not 1");
    }

    #[test]
    fn small_powers_are_products_and_roots() {
        let mut graph = Graph::default();
        let x = graph.insert(Node::State(0));
        let square = graph.multiply(x, x);
        let root = graph.unary(Unary::SquareRoot, x);
        for (exponent, expected) in [(1.0, x), (2.0, square), (0.5, root), (0.0, graph.constant(1.0))] {
            let exponent = graph.constant(exponent);
            assert_eq!(graph.power(x, exponent), expected);
        }
        let third = graph.constant(1.0 / 3.0);
        let power = graph.power(x, third);
        assert_eq!(graph.node(power), Node::Binary(Binary::Power, x, third), "the cube root of -8 stays undefined");
    }

    #[test]
    fn only_exact_reciprocals_replace_a_division() {
        let mut graph = Graph::default();
        let x = graph.insert(Node::State(0));
        let (half, two, three) = (graph.constant(0.5), graph.constant(2.0), graph.constant(3.0));
        assert_eq!(graph.divide(x, two), graph.multiply(half, x));
        let third = graph.divide(x, three);
        assert_eq!(graph.node(third), Node::Binary(Binary::Divide, x, three));
    }
}

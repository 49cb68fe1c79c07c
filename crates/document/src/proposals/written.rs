//! Expressions of the graph as an author would write them.

use super::study::with_unit;
use program::{Binary, Model, Node, NodeId, Unary};

/// Strength of the binding of an operator, from sums to names.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Binding {
    Sum,
    Product,
    Power,
    Name,
}

/// Maximum depth of a written expression.
const DEPTH: usize = 8;

/// The expression with the names of the document; `None` if it is long or has no short form. Numbers are in SI units.
pub fn written(model: &Model, node: NodeId) -> Option<String> {
    write(model, node, DEPTH).map(|(text, _)| text)
}

fn write(model: &Model, node: NodeId, depth: usize) -> Option<(String, Binding)> {
    let name = |text: String| Some((text, Binding::Name));
    match model.graph.node(node) {
        Node::Parameter(index) => return name(model.parameters.get(index as usize)?.name.clone()),
        Node::State(index) => return name(model.states.get(index as usize)?.name()),
        Node::Independent => return name(model.independent.name.clone()),
        Node::Initial(index) => return name(format!("{}(0)", model.states.get(index as usize)?.name())),
        Node::Constant(bits) => return name(with_unit(f64::from_bits(bits), "")),
        _ => {}
    }
    let mut known = model.quantities.iter().filter(|quantity| !quantity.remembered);
    if let Some(quantity) = known.find(|quantity| quantity.value.node == node) {
        return name(quantity.name.clone());
    }
    let depth = depth.checked_sub(1)?;
    let operand = |node: NodeId, least: Binding| {
        let (text, binding) = write(model, node, depth)?;
        Some(if binding < least { format!("({text})") } else { text })
    };
    match model.graph.node(node) {
        Node::Unary(Unary::Negate, x) => Some((format!("-{}", operand(x, Binding::Product)?), Binding::Sum)),
        Node::Unary(function, x) => name(format!("{}({})", unary(function)?, write(model, x, depth)?.0)),
        Node::Binary(function, a, b) => {
            let (sign, least, right, own) = match function {
                Binary::Add => (" + ", Binding::Sum, Binding::Sum, Binding::Sum),
                Binary::Subtract => (" - ", Binding::Sum, Binding::Product, Binding::Sum),
                Binary::Multiply => ("*", Binding::Product, Binding::Product, Binding::Product),
                Binary::Divide => ("/", Binding::Product, Binding::Power, Binding::Product),
                Binary::Power => ("^", Binding::Name, Binding::Name, Binding::Power),
                _ => return None,
            };
            Some((format!("{}{sign}{}", operand(a, least)?, operand(b, right)?), own))
        }
        _ => None,
    }
}

fn unary(function: Unary) -> Option<&'static str> {
    Some(match function {
        Unary::Absolute => "abs",
        Unary::Sign => "sign",
        Unary::SquareRoot => "sqrt",
        Unary::Exp => "exp",
        Unary::Ln => "ln",
        Unary::Sin => "sin",
        Unary::Cos => "cos",
        Unary::Tan => "tan",
        Unary::Sinh => "sinh",
        Unary::Cosh => "cosh",
        Unary::Tanh => "tanh",
        _ => return None,
    })
}

//! The expression graph: a model without names, units and syntax. Equal expressions are one node, so that nothing is
//! computed twice. All values are in SI units; a truth value is 0 or 1; a text is an index in [`crate::Model::texts`].

mod build;
mod differentiate;
mod evaluate;
mod interpolation;
mod same;
mod system;
mod walk;
mod written;

pub(crate) use differentiate::differentiate_through;
pub use differentiate::{Variable, along, differentiate, differentiate_all};
pub use interpolation::{Course, Interpolation, OfDrawing};

use rustc_hash::FxHashMap;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Index of a node in a [`Graph`]. Operands always have smaller indices than the node that uses them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub struct NodeId(pub u32);

/// An operation or input of the graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Node {
    /// A number, as its IEEE 754 bits.
    Constant(u64),
    /// Value of [`crate::Model::parameters`]`[i]`, SI units.
    Parameter(u32),
    /// Initial value of [`crate::Model::states`]`[i]`, written `y(0)`.
    Initial(u32),
    /// The independent variable.
    Independent,
    /// Current value of [`crate::Model::states`]`[i]`.
    State(u32),
    /// A function of one argument.
    Unary(Unary, NodeId),
    /// A function of two arguments.
    Binary(Binary, NodeId, NodeId),
    /// If the first operand is not 0, the second one, otherwise the third one. Both are computed.
    Select(NodeId, NodeId, NodeId),
    /// Force of dry friction: operands are speed, static limit and kinetic limit. It depends on all other forces, so this
    /// node is a placeholder while a model is built; a finished model does not evaluate it.
    Friction(NodeId, NodeId, NodeId),
    /// Index of the piece of [`Graph::interpolations`]`[i]` in which the operand lies; a step function, like `floor`.
    Piece(u32, NodeId),
    /// Value of [`Graph::interpolations`]`[i]` at the first operand, by the polynomial of the piece given by the second
    /// one.
    Interpolated(u32, NodeId, NodeId),
    /// Binomial draw: trials, probability, stream.
    Binomial(NodeId, NodeId, NodeId),
    /// Unknown `row` of the linear system [`Graph::systems`]`[system]`.
    Solution {
        /// Index of the system.
        system: u32,
        /// Index of the unknown.
        row: u32,
    },
}

/// Functions of one argument, in SI units; angles in radians.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[allow(missing_docs, reason = "each says itself")]
pub enum Unary {
    Negate,
    Not,
    Absolute,
    /// Sign: -1, 0 or 1.
    Sign,
    SquareRoot,
    CubeRoot,
    Exp,
    Ln,
    Log10,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Asinh,
    Acosh,
    Atanh,
    Floor,
    Ceil,
    /// Rounds half away from zero.
    Round,
    /// Uniform draw in (0, 1); the operand is the stream.
    Uniform,
    /// Normal draw with mean 0 and standard deviation 1; the operand is the stream.
    Normal,
    /// Exponential draw with mean 1; the operand is the stream.
    Exponential,
}

/// Functions of two arguments, in SI units; angles in radians.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[allow(missing_docs, reason = "each says itself")]
pub enum Binary {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    /// `atan2(y, x)`
    Atan2,
    Minimum,
    Maximum,
    Less,
    LessOrEqual,
    Equal,
    NotEqual,
    And,
    Or,
    /// Stream of random draws, a hash of two numbers.
    Stream,
    /// Poisson draw: mean, stream.
    Poisson,
}

/// A linear system A x = r, needed if the equations of motion are coupled.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LinearSystem {
    /// Entries of A, row by row; missing ones are 0.
    pub entries: Vec<Entry>,
    /// Right-hand side r, one node per row.
    pub right: Vec<NodeId>,
}

/// An entry of the matrix.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Entry {
    /// Row index.
    pub row: u32,
    /// Column index.
    pub column: u32,
    /// Node of the value.
    pub node: NodeId,
}

/// Serialized form of a [`Graph`], not yet checked.
#[derive(Serialize, Deserialize)]
struct Written {
    nodes: Vec<Node>,
    systems: Vec<LinearSystem>,
    interpolations: Vec<Interpolation>,
}

/// Expression graph: each different expression is one node.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(try_from = "Written", into = "Written")]
pub struct Graph {
    nodes: Vec<Node>,
    known: FxHashMap<Node, NodeId>,
    systems: Vec<LinearSystem>,
    interpolations: Vec<Arc<Interpolation>>,
}

impl Graph {
    /// Index of `node`, which is added if it is new. The node is taken as it is; constructors that simplify are in
    /// `build.rs`.
    pub fn insert(&mut self, node: Node) -> NodeId {
        if let Some(&id) = self.known.get(&node) {
            return id;
        }
        let id = NodeId(self.nodes.len() as u32);
        self.nodes.push(node);
        self.known.insert(node, id);
        id
    }

    /// Index of `node` if it exists.
    pub fn find(&self, node: Node) -> Option<NodeId> {
        self.known.get(&node).copied()
    }

    /// Adds a linear system, or finds an equal one, and returns its index; the unknowns are `Node::Solution { system, row
    /// }`.
    pub fn insert_system(&mut self, system: LinearSystem) -> u32 {
        if let Some(known) = self.systems.iter().position(|known| *known == system) {
            return known as u32;
        }
        self.systems.push(system);
        (self.systems.len() - 1) as u32
    }

    /// The node of index `id`.
    pub fn node(&self, id: NodeId) -> Node {
        self.nodes[id.0 as usize]
    }

    /// The linear systems.
    pub fn systems(&self) -> &[LinearSystem] {
        &self.systems
    }

    /// Replaces the curve drawn by the reader for a table, and its derivatives.
    pub(crate) fn redraw(&mut self, table: u32, curve: &Interpolation) {
        for interpolation in &mut self.interpolations {
            let Some(own) = interpolation.drawing().filter(|own| own.table == table) else { continue };
            let derivative = (0..own.derivative).fold(curve.clone(), |curve, _| curve.derivative());
            *interpolation = Arc::new(derivative);
        }
    }

    /// Adds an interpolation, or finds an equal one, and returns its index.
    pub fn insert_interpolation(&mut self, interpolation: &Arc<Interpolation>) -> u32 {
        let known = self.find_interpolation(interpolation).unwrap_or_else(|| {
            self.interpolations.push(Arc::clone(interpolation));
            self.interpolations.len() - 1
        });
        known as u32
    }

    fn find_interpolation(&self, wanted: &Arc<Interpolation>) -> Option<usize> {
        self.interpolations.iter().position(|known| Arc::ptr_eq(known, wanted) || known == wanted)
    }

    /// All functions given by tables.
    pub fn interpolations(&self) -> &[Arc<Interpolation>] {
        &self.interpolations
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// True if there are no nodes.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }
}

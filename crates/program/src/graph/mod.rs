//! The expression graph: what is left of a model when names, units and syntax are gone. Equal expressions are one node,
//! so that nothing is computed twice. All values are SI numbers; a truth value is 0 or 1; a text is an index into
//! [`crate::Model::texts`].

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

/// A node of a [`Graph`]. A node's operands always have smaller numbers than the node itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub struct NodeId(pub u32);

/// One operation or input.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Node {
    /// A number, by its bits.
    Constant(u64),
    /// The value of [`crate::Model::parameters`]`[i]`, in SI.
    Parameter(u32),
    /// The value that [`crate::Model::states`]`[i]` had at the start of the run, `y(0)`.
    Initial(u32),
    /// The independent variable.
    Independent,
    /// The value of [`crate::Model::states`]`[i]`.
    State(u32),
    /// A function of one argument.
    Unary(Unary, NodeId),
    /// A function of two arguments.
    Binary(Binary, NodeId, NodeId),
    /// The second if the first is not 0, otherwise the third. Both are computed.
    Select(NodeId, NodeId, NodeId),
    /// The force of dry friction at this speed with these limits, static and kinetic. It depends on all other forces: while
    /// a model is built it stands for itself, and in a finished model nothing is computed from it.
    Friction(NodeId, NodeId, NodeId),
    /// In which piece of [`Graph::interpolations`]`[i]` a number lies: it changes at isolated values, as `floor` does.
    Piece(u32, NodeId),
    /// The value of [`Graph::interpolations`]`[i]` at the first, by the polynomial of the piece whose number is the second.
    Interpolated(u32, NodeId, NodeId),
    /// A draw of the number of successes: trials, probability, stream.
    Binomial(NodeId, NodeId, NodeId),
    /// Unknown `row` of the linear system [`Graph::systems`]`[system]`.
    Solution {
        /// Which system.
        system: u32,
        /// Which of its unknowns.
        row: u32,
    },
}

/// Functions of one argument, on SI numbers; angles in radians.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[allow(missing_docs, reason = "each says itself")]
pub enum Unary {
    Negate,
    Not,
    Absolute,
    /// -1, 0 or 1.
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
    /// Half away from zero.
    Round,
    /// A draw between 0 and 1, of this stream.
    Uniform,
    /// A draw with the mean 0 and the standard deviation 1, of this stream.
    Normal,
    /// A draw with the mean 1, of this stream.
    Exponential,
}

/// Functions of two arguments.
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
    /// The stream of random draws that belongs to two numbers.
    Stream,
    /// A draw with this mean, of this stream.
    Poisson,
}

/// A linear system A x = r, solved where the equations of motion are coupled.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LinearSystem {
    /// The entries of A, row by row; those that are not there are 0.
    pub entries: Vec<Entry>,
    /// r.
    pub right: Vec<NodeId>,
}

/// An entry of a matrix.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Entry {
    /// Its row.
    pub row: u32,
    /// Its column.
    pub column: u32,
    /// Its value.
    pub node: NodeId,
}

/// The nodes and systems of a [`Graph`], not yet checked.
#[derive(Serialize, Deserialize)]
struct Written {
    nodes: Vec<Node>,
    systems: Vec<LinearSystem>,
    interpolations: Vec<Interpolation>,
}

/// Nodes, each equal expression once.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(try_from = "Written", into = "Written")]
pub struct Graph {
    nodes: Vec<Node>,
    known: FxHashMap<Node, NodeId>,
    systems: Vec<LinearSystem>,
    interpolations: Vec<Arc<Interpolation>>,
}

impl Graph {
    /// The node for `node`, the existing one if there is one. [`Graph`]'s simplifying constructors are in
    /// `build.rs`; this one takes the node as it is.
    pub fn insert(&mut self, node: Node) -> NodeId {
        if let Some(&id) = self.known.get(&node) {
            return id;
        }
        let id = NodeId(self.nodes.len() as u32);
        self.nodes.push(node);
        self.known.insert(node, id);
        id
    }

    /// The node for `node`, if it is there.
    pub fn find(&self, node: Node) -> Option<NodeId> {
        self.known.get(&node).copied()
    }

    /// Adds a linear system, or finds the equal one; its unknowns are then `Node::Solution { system, row }`.
    pub fn insert_system(&mut self, system: LinearSystem) -> u32 {
        if let Some(known) = self.systems.iter().position(|known| *known == system) {
            return known as u32;
        }
        self.systems.push(system);
        (self.systems.len() - 1) as u32
    }

    /// What `id` stands for.
    pub fn node(&self, id: NodeId) -> Node {
        self.nodes[id.0 as usize]
    }

    /// The linear systems.
    pub fn systems(&self) -> &[LinearSystem] {
        &self.systems
    }

    /// Puts another curve in the place of the one that the reader draws for a table, and its derivatives in the place of the
    /// former ones.
    pub(crate) fn redraw(&mut self, table: u32, curve: &Interpolation) {
        for interpolation in &mut self.interpolations {
            let Some(own) = interpolation.drawing().filter(|own| own.table == table) else { continue };
            let derivative = (0..own.derivative).fold(curve.clone(), |curve, _| curve.derivative());
            *interpolation = Arc::new(derivative);
        }
    }

    /// Adds an interpolation, or finds the equal one.
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

    /// The functions that are given by tables.
    pub fn interpolations(&self) -> &[Arc<Interpolation>] {
        &self.interpolations
    }

    /// How many nodes there are.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }
}

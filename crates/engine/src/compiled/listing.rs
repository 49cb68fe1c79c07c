//! The steps of a stepper as a compiler reads them.

use super::layout::Layout;
use crate::Method;
use crate::code::instruction::Register;
use crate::code::lines::Line;
use program::Interpolation;
use std::sync::Arc;

/// The right-hand side of a model and the method that integrates it.
#[derive(Clone, Debug, PartialEq)]
pub struct Listing {
    /// The method: a fixed-step method or Dormand-Prince.
    pub method: Method,
    /// Operations that compute the rates, in an order in which they can be executed. Register 0 holds the independent
    /// variable.
    pub lines: Vec<Line>,
    /// Register of each state.
    pub states: Vec<Register>,
    /// Register of the rate of each state.
    pub rates: Vec<Register>,
    /// For velocity Verlet, the indices of each position and its velocity; all other states are constant.
    pub pairs: Vec<(usize, usize)>,
    /// Functions of [`Operation::Piece`](crate::Operation::Piece) and
    /// [`Operation::Interpolated`](crate::Operation::Interpolated).
    pub interpolations: Vec<Arc<Interpolation>>,
    /// The block that the code works on.
    pub layout: Layout,
}

/// Reason why the steps of a stepper cannot be compiled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpreted {
    /// The independent variable counts.
    Counting,
    /// The method needs derivatives and linear algebra.
    Method(Method),
    /// The highest derivatives are the solution of a linear system.
    LinearSystem,
}

//! The steps of a stepper as a compiler reads them.

use super::layout::Layout;
use super::window_layout::WindowLayout;
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
    /// For each state, its rate if that is the constant 0 or -0: it stays constant between events.
    pub still: Vec<Option<f64>>,
    /// The block that code of a fixed-step method works on.
    pub layout: Layout,
    /// The window of the Dormand-Prince method.
    pub window: Option<WindowListing>,
}

/// A window of the Dormand-Prince method: steps with step control, and rows, until something could happen.
#[derive(Clone, Debug, PartialEq)]
pub struct WindowListing {
    /// The block that the code works on.
    pub layout: WindowLayout,
    /// Conditions of events; true values of switches; switches that depend on the independent variable alone; compared
    /// values; compared values, then their rates of change.
    pub formulas: [Formulas; 5],
}

/// Formulas with registers of their own: 0 holds the independent variable, the states follow in the order of the model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Formulas {
    /// Operations in an order in which they can be executed.
    pub lines: Vec<Line>,
    /// Registers of the values.
    pub roots: Vec<Register>,
    /// Number of registers.
    pub registers: usize,
}

/// Operations that precede formulas when parameters or initial values have changed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Preparation {
    /// Operations in an order in which they can be executed.
    pub lines: Vec<Line>,
    /// Index of each parameter, with its register. The held values of switches follow the parameters of the model.
    pub parameters: Vec<(usize, Register)>,
    /// Index of each state, with the register of its initial value.
    pub initial: Vec<(usize, Register)>,
    /// Values of all registers, of which only those of constants have a meaning here.
    pub registers: Vec<f64>,
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

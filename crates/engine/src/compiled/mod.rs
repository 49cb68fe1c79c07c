//! Steps in compiled form: code that is made outside of the engine, with the bits of the interpreter.

mod adaptive_lanes;
pub(crate) mod block;
mod fixed_lanes;
pub(crate) mod lanes;
pub(crate) mod layout;
pub(crate) mod listing;
pub(crate) mod preparing;
pub(crate) mod side_by_side;
pub(crate) mod window;
pub(crate) mod window_layout;

use crate::Setup;
use listing::Listing;
use program::{Model, NodeId};
use side_by_side::SideBySide;
use std::fmt::Debug;
use std::rc::Rc;

/// Code compiled from a [`Listing`](crate::Listing).
pub trait Compiled: Debug {
    /// Runs the code over a block of numbers. Code of a fixed-step method ([`Layout`](crate::Layout)) makes up to `count`
    /// steps and returns the number of steps whose states are all finite; the row after them is written, too.
    ///
    /// Code of the Dormand-Prince method ([`WindowLayout`](crate::WindowLayout)) makes steps until it has `count` rows, or
    /// until an event, switch or failure of the step control is possible, and returns the number of rows. If `count` is 0 it
    /// makes one attempt of the size and from the end of record 0 to record 1, with its error, and returns 0.
    fn run(&self, block: &mut [f64], count: u32) -> u32;
}

/// Makes compiled code. It is given from outside: the engine has an interpreter only.
pub trait Compiler: Debug {
    /// Code for the steps of `listing`; `None` if they stay interpreted.
    fn compile(&self, listing: Listing) -> Option<Rc<dyn Compiled>>;

    /// Runs side by side of `model` with this setup but other parameters; `nodes` are read at each row. `None` if they are made one by
    /// one.
    fn side_by_side(&self, model: &Model, setup: &Setup, nodes: &[NodeId]) -> Option<Box<dyn SideBySide>>;
}

/// Copies a state. A few numbers are moved one by one: a call that copies memory takes longer in WebAssembly.
#[inline]
pub(crate) fn copy(from: &[f64], to: &mut [f64]) {
    match (from, to) {
        (&[a], [to]) => *to = a,
        (&[a, b], [to_a, to_b]) => (*to_a, *to_b) = (a, b),
        (&[a, b, c], [to_a, to_b, to_c]) => (*to_a, *to_b, *to_c) = (a, b, c),
        (&[a, b, c, d], [to_a, to_b, to_c, to_d]) => (*to_a, *to_b, *to_c, *to_d) = (a, b, c, d),
        (from, to) => to.copy_from_slice(from),
    }
}

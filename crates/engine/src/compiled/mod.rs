//! Steps in compiled form: code that is made outside of the engine, with the bits of the interpreter.
//!
//! [`Stepper::listing`](crate::Stepper::listing) gives the operations of the right-hand side, the method and the places of
//! all numbers (`layout.rs`) to a [`Compiler`], and `use_compiled` takes what it makes, [`Compiled`], code that runs over one
//! block of numbers. A run can change over to it at any time.
//!
//! Fixed-step code makes up to 256 steps in one call where no event, switch or press can interrupt them
//! (`Surfaces::is_smooth`). Code of the Dormand-Prince method makes a *window* (`window.rs`): steps with step control, rows,
//! and the checks of every interval between them that no event, switch or timed change acts (`events/ahead.rs`,
//! `events/interpolant.rs`). It returns where one could; the engine looks at that interval itself, locates and acts. Rows and
//! steps are taken one by one, with the counters of work that the interpreter would have (`methods/stepper/ahead.rs`), so
//! that pauses and checkpoints lie at the same rows. Whatever changes the stepper discards the rest. `Listing::still` has the
//! states with the constant rate 0, such as those that only remember; code leaves out their sums.
//!
//! Runs can be made side by side (`lanes.rs`, trait [`SideBySide`]): 64 runs, with the numbers of each two of them next to
//! each other. Code of a fixed-step method (`fixed_lanes.rs`) makes each step for all pairs before the next one and computes
//! what is read at its rows; nothing may end a step there. Code of the Dormand-Prince method (`adaptive_lanes.rs`) makes
//! rounds over the pairs. The compiler offers them ([`Compiler::side_by_side`]), so that a page without a compiler contains
//! nothing of it. A run that fails is made again alone. Plots over a parameter use them (`play/src/plots/sweep/runs.rs`).

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

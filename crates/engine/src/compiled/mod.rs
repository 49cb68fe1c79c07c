//! Steps in compiled form: code that is made outside of the engine, with the bits of the interpreter.

pub(crate) mod block;
pub(crate) mod layout;
pub(crate) mod listing;

use listing::Listing;
use std::fmt::Debug;
use std::rc::Rc;

/// Code compiled from a [`Listing`](crate::Listing).
pub trait Compiled: Debug {
    /// Runs the code over a block of numbers laid out as in [`Layout`](crate::Layout). Code of a fixed-step method makes up
    /// to `count` steps and returns the number of steps whose states are all finite; the row after them is written, too.
    /// Code of the Dormand-Prince method makes one attempt of a step and returns 1.
    fn run(&self, block: &mut [f64], count: u32) -> u32;
}

/// Makes compiled code. It is given from outside: the engine has an interpreter only.
pub trait Compiler: Debug {
    /// Code for the steps of `listing`; `None` if they stay interpreted.
    fn compile(&self, listing: Listing) -> Option<Rc<dyn Compiled>>;
}

//! Ensembles: runs of one model side by side, with the parameters of each run in a lane of the processor's registers. One
//! instruction of the engine's register code is executed for all runs before the next one. It is a crate of its own because
//! pages do not have it.
//!
//! A `Grid` has a row for each register and a lane for each run, up to [`LANES`]; `Body` executes each line of the engine's
//! code (`Stepper::listing`, with what precedes it in `Stepper::preparations`). `Fixed` makes steps of fixed-step methods and
//! `Steps` those of Dormand-Prince, where each lane has its own time and step size. `Checks` asks of each interval what
//! emitted code asks. A lane in which an event or switch could act, or whose step control fails, continues with the engine's
//! stepper ([`Alone`]) to its next row and comes back; if it has left often, it stays there. [`Solutions`] solves smooth equations at given times, each lane with
//! times of its own, for fits. [`NoLanes`] says why a model has none: Rosenbrock's method, linear systems, counting
//! variables, presses of buttons.
//!
//! `pulp` compiles the loops for SSE2, AVX2 and AVX-512, for which all functions with loops over lanes are inlined into what
//! `Width::call` is given. A closure given to an iterator, and `std::array::from_fn`, are often compiled without these
//! features: loops over lanes are `for` loops. Elementary functions are those of `program`, lane by lane (`functions.rs`).
//!
//! - **Invariant:** a lane has the bits of the single run: rows, what is read at them, the last state, and errors.

mod advance;
mod advance_fixed;
mod alone;
mod body;
mod checks;
mod clock;
mod ends;
mod ensemble;
mod fixed;
mod functions;
mod grid;
mod intervals;
mod lanes;
mod leaving;
mod reason;
mod solutions;
mod steps;
mod width;

pub use alone::{Alone, LastRow};
pub use ensemble::{Ended, Ensemble, LANES};
pub use reason::NoLanes;
pub use solutions::{Solutions, Sought};
pub use width::Features;

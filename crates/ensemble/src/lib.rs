//! Ensembles: runs of one model side by side, with the parameters of each run in a lane of the processor's registers. One
//! instruction of the engine's register code is executed for all runs before the next one. Each run has the bits of a single run.
//! Where an event or switch could act, a run continues alone with the engine's stepper, and comes back at its next row.

mod advance;
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
mod reason;
mod solutions;
mod steps;
mod width;

pub use alone::{Alone, LastRow};
pub use ensemble::{Ended, Ensemble, LANES};
pub use reason::NoLanes;
pub use solutions::{Solutions, Sought};
pub use width::Features;

//! Programs that tests and benchmarks run both natively and in WebAssembly: golden runs and results, whose
//! bits must be equal everywhere, and steps, fits and checks of documents, whose speed is measured.
//!
//! `golden.txt` has the hashes of runs, draws, cycles, fits and tracks. A change that moves one of them raises
//! `program::BITS` and adds a line to `bits.txt`: hand-ins, reports and Python state that number, and values are compared
//! exactly only where it is equal.
//!
//! - **Invariant:** nothing that ships depends on this crate.

mod beside;
mod fits;
mod golden;
mod long;
mod measured;
mod pace;
mod shipped;
mod systems;

pub use beside::SideBySideTubes;
pub use fits::Fits;
pub use golden::{fingerprint, golden};
pub use long::{check, long_document};
pub use pace::Pace;
pub use shipped::Shipped;
pub use systems::System;

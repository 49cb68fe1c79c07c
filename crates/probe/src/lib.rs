//! What tests and benchmarks run natively and inside WebAssembly, to compare the two: golden runs, whose bits must be the
//! same everywhere, and the steps of the U-tube, whose speed is measured.

mod fits;
mod golden;
mod pace;

pub use fits::Fits;
pub use golden::{fingerprint, golden};
pub use pace::Pace;

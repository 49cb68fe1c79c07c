//! `meniscus hand-in` and `meniscus verify`: making and verifying hand-ins.

pub mod arguments;
mod hand_in;
pub mod read;
mod report;
mod verify;
pub mod write;

pub use hand_in::hand_in;
pub use verify::verify;

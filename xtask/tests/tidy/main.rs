//! What no compiler checks: the arrows between the crates, circles between the files of a crate, what the core must not
//! touch, long files, and paths of somebody's machine.

#![allow(clippy::expect_used, clippy::panic, reason = "a test that cannot go on has failed")]

mod circles;
mod crates;
mod lengths;
mod machine;
mod texts;
mod uses;

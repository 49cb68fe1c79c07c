//! Checks beyond the compiler: dependencies between crates, circles between the files of a crate, access of the core to
//! the outside, owned parts, long files, titles of diagnostics, features of browsers, and paths of a
//! machine.

#![allow(clippy::expect_used, clippy::panic, reason = "a test that cannot go on has failed")]

mod browsers;
mod circles;
mod crates;
mod lengths;
mod machine;
mod parts;
mod texts;
mod titles;
mod typed;
mod uses;

//! Lanes against single runs, to the bit.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod compare;
mod documents;
mod ends;
mod solutions;

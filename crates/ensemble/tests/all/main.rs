//! Lanes against single runs, to the bit.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod compare;
mod documents;
mod ends;
#[path = "../../../engine/tests/all/guards/models.rs"]
mod guarded;
mod guards;
mod solutions;

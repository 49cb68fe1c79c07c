//! Tests of the class server over real connections, linked as one test program.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by them")]

mod client;
mod durable;
mod erasing;
mod folding;
mod handing;
mod load;
mod postgres;
mod room;
mod security;
mod storage;
mod streams;
mod teacher;
mod tls;

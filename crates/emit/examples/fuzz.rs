//! Compares emitted code with the interpreter on arbitrary programs: `cargo run -p emit --example fuzz -- MINUTES [SEED]`.
//! Programs are numbered; SEED is the first, 1000 if it is left out. A difference panics after the number of its program.

#![allow(clippy::expect_used, clippy::panic, dead_code, reason = "it fails by them, and shares the code of the tests")]

#[path = "../tests/all/compare.rs"]
mod compare;
#[path = "../tests/all/host.rs"]
mod host;
#[path = "../tests/all/programs.rs"]
mod programs;

use std::io::Write;
use std::time::{Duration, Instant};

fn main() {
    let mut arguments = std::env::args().skip(1).map(|argument| argument.parse::<u64>().expect("a whole number"));
    let minutes = arguments.next().unwrap_or(10);
    let first = arguments.next().unwrap_or(1000);
    let (begun, mut rows) = (Instant::now(), 0);
    for seed in first.. {
        if begun.elapsed() >= Duration::from_secs(60 * minutes) {
            println!("\nprograms {first} to {}: {rows} rows have the same bits", seed - 1);
            return;
        }
        print!("\rprogram {seed}");
        std::io::stdout().flush().expect("a terminal");
        rows += compare::compare_text(&programs::of_seed(seed));
    }
}

//! Arbitrary programs.

use crate::compare::compare_text;
use crate::programs;

/// Number of programs of each test; one alone would keep one processor busy. `cargo run -p emit --example fuzz` compares more of them.
const PROGRAMS: u64 = 18;

#[test]
fn arbitrary_programs_have_the_same_bits_in_emitted_code() {
    compare(0);
}

#[test]
fn other_arbitrary_programs_have_the_same_bits_in_emitted_code() {
    compare(PROGRAMS);
}

fn compare(first: u64) {
    let rows: usize = (first..first + PROGRAMS).map(|seed| compare_text(&programs::of_seed(seed))).sum();
    assert!(rows > 40 * PROGRAMS as usize, "the programs make {rows} rows");
}

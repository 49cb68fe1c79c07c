//! Arbitrary programs.

use crate::compare::compare_text;
use crate::programs;

/// Number of programs. `cargo run -p emit --example fuzz` compares more of them.
const PROGRAMS: u64 = 80;

#[test]
fn arbitrary_programs_have_the_same_bits_in_emitted_code() {
    let rows: usize = (0..PROGRAMS).map(|seed| compare_text(&programs::of_seed(seed))).sum();
    assert!(rows > 100 * PROGRAMS as usize / 2, "the programs make {rows} rows");
}

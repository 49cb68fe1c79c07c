//! Any program in emitted code: it has the bits of the interpreter.

#![no_main]

#[path = "../../crates/emit/tests/all/compare.rs"]
mod compare;
#[path = "../../crates/emit/tests/all/host.rs"]
mod host;
#[path = "../../crates/emit/tests/all/programs.rs"]
mod programs;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    compare::compare_text(&programs::text(bytes));
});

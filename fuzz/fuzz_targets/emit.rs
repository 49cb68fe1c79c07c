//! Any program in emitted code: it has the bits of the interpreter.

#![no_main]

#[path = "../../crates/emit/tests/all/compare.rs"]
mod compare;
#[path = "../../crates/emit/tests/all/host.rs"]
mod host;
#[path = "../../crates/emit/tests/all/programs.rs"]
mod programs;

use engine::{Method, Setup};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let text = programs::text(bytes);
    let Some(checked) = model::compile(&text, std::slice::from_ref(&(0..text.len()))).0 else { return };
    let model = checked.model;
    for method in Method::ALL {
        compare::compare(&model, Setup { method, ..Setup::defaults(&model) }, 20);
    }
});

//! How fast a long document is checked.

use std::fmt::Write;
use wasm_bindgen::prelude::wasm_bindgen;

/// How many oscillators the document has, of [`PART`] lines each.
const PARTS: usize = 50;
/// The lines about one of them.
const PART: &str = include_str!("../systems/oscillator.md");

/// A document of 2,000 lines: fifty damped oscillators, each with its equations, a preset, checks, a question and prose.
#[wasm_bindgen]
pub fn long_document() -> String {
    let mut text =
        "---\ntitle: Fifty oscillators\nmethod: dormand-prince\nstep: 0.05 [s]\nuntil: 10 [s]\n---\n".to_owned();
    for part in 1..=PARTS {
        let _ = write!(text, "{}", PART.replace('@', &part.to_string()));
    }
    text
}

/// Opens a document so many times; how many states its model has.
///
/// # Errors
/// It has errors.
#[wasm_bindgen]
pub fn check(text: &str, times: u32) -> Result<usize, String> {
    let mut states = 0;
    for _ in 0..times {
        states = crate::golden::setup(text)?.0.program.model.states.len();
    }
    Ok(states)
}

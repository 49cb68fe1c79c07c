//! Speed of checking a long document.

use std::fmt::Write;
use wasm_bindgen::prelude::wasm_bindgen;

/// Number of oscillators in the document; each has the lines of [`PART`].
const PARTS: usize = 50;
/// Lines about one oscillator. `@` stands for its number.
const PART: &str = include_str!("../systems/oscillator.md");

/// Document of about 2,000 lines: fifty damped oscillators, each with its equations, a preset, checks, a question and
/// prose.
#[wasm_bindgen]
pub fn long_document() -> String {
    let mut text =
        "---\ntitle: Fifty oscillators\nmethod: dormand-prince\nstep: 0.05 [s]\nuntil: 10 [s]\n---\n".to_owned();
    for part in 1..=PARTS {
        let _ = write!(text, "{}", PART.replace('@', &part.to_string()));
    }
    text
}

/// Opens a document `times` times. Returns the number of states of its model.
///
/// # Errors
/// The document has errors.
#[wasm_bindgen]
pub fn check(text: &str, times: u32) -> Result<usize, String> {
    let mut states = 0;
    for _ in 0..times {
        states = crate::golden::setup(text)?.0.program.model.states.len();
    }
    Ok(states)
}

//! From bytes to a simulation: text encodings, the two formats, archives.

mod encoding;
mod json;
mod limits;
mod package;
mod xml;

use crate::refusal::Refusal;
use crate::simulation::Simulation;
use encoding::decoded;
use limits::{DEEPEST, MOST_BYTES, MOST_ELEMENTS};
pub(crate) use package::Files;

/// The simulation of a file and the files beside it in its archive.
///
/// # Errors
/// The reason why there is none.
pub(crate) fn read(bytes: &[u8]) -> Result<(Simulation, Files), Refusal> {
    if bytes.len() > MOST_BYTES {
        return Err(Refusal::TooLarge);
    }
    let files = Files::open(bytes)?;
    let (text, is_json) = match files.source()? {
        Some((text, is_json)) => (text, is_json),
        None => {
            let text = decoded(bytes);
            let is_json = text.trim_start().starts_with('{');
            (text, is_json)
        }
    };
    let simulation = if is_json { json::read(&text)? } else { xml::read(&text)? };
    let is_deep = |at: usize| {
        let mut parent = simulation.view.get(at).and_then(|element| element.parent);
        for _ in 0..DEEPEST {
            let Some(next) = parent else { return false };
            parent = simulation.view.get(next).and_then(|element| element.parent);
        }
        parent.is_some()
    };
    if simulation.view.len() > MOST_ELEMENTS || (0..simulation.view.len()).any(is_deep) {
        return Err(Refusal::TooComplex);
    }
    Ok((simulation, files))
}

/// True if a file begins like a source of EJS or WebEJS: UTF-16 or UTF-8, XML or JSON.
pub(crate) fn is_source(start: &[u8]) -> bool {
    let start = start.get(..start.len().min(4000) & !1).unwrap_or_default();
    let text = decoded(start);
    text.contains("<Osejs") || text.contains("\"information\"") && text.contains("\"Title\"")
}

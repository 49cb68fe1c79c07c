//! From bytes to a simulation: text encodings, the two formats, archives.

mod json;
mod package;
mod xml;

use crate::refusal::Refusal;
use crate::simulation::Simulation;
pub(crate) use package::Files;

/// Greatest size of a file, in bytes.
const MOST_BYTES: usize = 20 << 20;
/// Greatest number of elements of a view.
const MOST_ELEMENTS: usize = 2000;
/// Greatest depth of nesting.
const DEEPEST: usize = 64;

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

/// Text of bytes in UTF-16 or UTF-8, with or without a mark; other bytes as Latin-1.
fn decoded(bytes: &[u8]) -> String {
    let wide = |bytes: &[u8], unit: fn([u8; 2]) -> u16| {
        let units: Vec<u16> = bytes.chunks_exact(2).filter_map(|pair| pair.try_into().ok()).map(unit).collect();
        String::from_utf16_lossy(&units)
    };
    match bytes {
        [0xff, 0xfe, rest @ ..] => wide(rest, u16::from_le_bytes),
        [0xfe, 0xff, rest @ ..] => wide(rest, u16::from_be_bytes),
        [0, _, ..] => wide(bytes, u16::from_be_bytes),
        [_, 0, ..] => wide(bytes, u16::from_le_bytes),
        _ => {
            let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
            String::from_utf8(bytes.to_vec()).unwrap_or_else(|_| bytes.iter().map(|byte| char::from(*byte)).collect())
        }
    }
}

//! From bytes to a simulation: text encodings, the two formats, archives.

mod encoding;
mod format;
mod json;
mod limits;
mod package;
mod xml;

use crate::refusal::Refusal;
use crate::simulation::Simulation;
use encoding::decoded;
pub(crate) use format::Format;
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
    let (text, format) = match files.source()? {
        Some(source) => source,
        None => {
            let text = decoded(bytes);
            let format = if text.trim_start().starts_with('{') { Format::Json } else { Format::Xml };
            (text, format)
        }
    };
    let simulation = match format {
        Format::Json => json::read(&text)?,
        Format::Xml => xml::read(&text)?,
    };
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

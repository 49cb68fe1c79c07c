//! Pages that play a document.

use crate::Refusal;
use document::page::Source;
use flate2::{Compression, write::GzEncoder};
use program::{Program, bundle};
use std::io::Write as _;

/// `player`, the page without a simulation, with a compiled simulation and its sources.
///
/// # Errors
/// The simulation is too large for a page, or the player has no place for it.
pub fn played(player: &str, sources: &[Source], program: &Program) -> Result<String, Refusal> {
    let bundle = bundle::write(program)
        .map_err(|_| Refusal::request("this document is too large for a page that plays it; try `--lab`"))?;
    document::page::played(player, sources, program, gzip(&bundle)?).ok_or_else(no_place)
}

/// Refusal of a page without the expected place for documents.
pub fn no_place() -> Refusal {
    Refusal::request("the page inside this program has no place for documents")
}

/// Compresses with gzip, without a time or a name: the same content gives the same bytes.
///
/// # Errors
/// The compressor fails, which it does not do for content in memory.
pub fn gzip(content: &[u8]) -> Result<Vec<u8>, Refusal> {
    let mut gzip = GzEncoder::new(Vec::new(), Compression::best());
    let packed = gzip.write_all(content).and_then(|()| gzip.finish());
    packed.map_err(|error| Refusal::request(format!("the page cannot be compressed: {error}")))
}

//! Pages of the laboratory and of the player, which are embedded in the program if they were built before it.

use crate::failure::Failure;
use document::Document;
use document::page::{Options, Source, embed};
use flate2::{Compression, write::GzEncoder};
use program::{Program, bundle};
use runner::Sources;
use std::io::Write as _;

#[cfg(page_inside)]
const PAGE: Option<&str> = Some(include_str!(env!("MENISCUS_PAGE")));
#[cfg(not(page_inside))]
const PAGE: Option<&str> = None;

#[cfg(page_inside)]
const PLAYER: Option<&str> = Some(include_str!(env!("MENISCUS_PLAYER")));
#[cfg(not(page_inside))]
const PLAYER: Option<&str> = None;

/// The laboratory with its default document.
pub fn own() -> Result<&'static str, Failure> {
    PAGE.ok_or_else(missing)
}

/// The player without a simulation.
pub fn bare_player() -> Result<&'static str, Failure> {
    PLAYER.ok_or_else(missing)
}

fn missing() -> Failure {
    Failure::with_hint(
        "this program was built without the laboratory's page",
        "run `cargo xtask page`, then build the program again with `cargo build --release`",
    )
}

/// Page that plays a document and contains its source.
pub fn player(sources: &Sources, document: &Document) -> Result<String, Failure> {
    played(bare_player()?, &sources.embedded(), &document.program)
}

/// Player with a compiled simulation and these sources.
pub fn played(player: &str, sources: &[Source], program: &Program) -> Result<String, Failure> {
    let bundle = bundle::write(program)
        .map_err(|_| Failure::request("this document is too large for a page that plays it; try `--lab`"))?;
    document::page::played(player, sources, program, gzip(&bundle)?).ok_or_else(no_place)
}

/// The laboratory with these sources. `document`: the parsed sources, `None` if they have errors that leave no
/// document.
pub fn with(sources: &Sources, document: Option<&Document>) -> Result<String, Failure> {
    // Without a bundle, as of a document too large for one, the page opens with the laboratory itself.
    let bundle = document.and_then(|document| bundle::write(&document.program).ok());
    let options = Options {
        title: document.map(|document| document.program.title.clone()),
        language: document.map(|document| document.program.language.clone()),
        bundle: bundle.map(|bundle| gzip(&bundle)).transpose()?,
    };
    embed(own()?, &sources.embedded(), &options).ok_or_else(no_place)
}

/// The laboratory `html`, opening with this simulation.
pub fn opening(html: &str, name: &str, program: &Program) -> Result<String, Failure> {
    let bundle = bundle::write(program)
        .map_err(|_| Failure::request(format!("{name} is too large for the laboratory to open with")))?;
    document::page::opening(html, name, &gzip(&bundle)?).ok_or_else(no_place)
}

/// Error for an embedded page without the expected place.
pub fn no_place() -> Failure {
    Failure::request("the page inside this program has no place for documents")
}

/// Compresses with gzip, without a time or a name: the same content gives the same bytes.
pub fn gzip(content: &[u8]) -> Result<Vec<u8>, Failure> {
    let mut gzip = GzEncoder::new(Vec::new(), Compression::best());
    let packed = gzip.write_all(content).and_then(|()| gzip.finish());
    packed.map_err(|error| Failure::request(format!("the page cannot be compressed: {error}")))
}

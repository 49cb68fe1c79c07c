//! Pages of the laboratory and of the player, which are embedded in the program if they were built before it.

use crate::failure::Failure;
use document::Document;
use document::page::{Options, embed};
use program::{Program, bundle};
use runner::Sources;
pub use runner::page::{gzip, no_place, played};

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
    Ok(played(bare_player()?, &sources.embedded(), &document.program)?)
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
    Ok(embed(own()?, &sources.embedded(), &options).ok_or_else(no_place)?)
}

/// The laboratory `html`, opening with this simulation.
pub fn opening(html: &str, name: &str, program: &Program) -> Result<String, Failure> {
    let bundle = bundle::write(program)
        .map_err(|_| Failure::request(format!("{name} is too large for the laboratory to open with")))?;
    Ok(document::page::opening(html, name, &gzip(&bundle)?).ok_or_else(no_place)?)
}

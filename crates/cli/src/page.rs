//! The laboratory's page, which is inside the program where it was built before the program.

use crate::failure::Failure;
use crate::load::Sources;
use document::Document;
use document::page::{Options, embed};

#[cfg(page_inside)]
const PAGE: Option<&str> = Some(include_str!(env!("MENISCUS_PAGE")));
#[cfg(not(page_inside))]
const PAGE: Option<&str> = None;

/// The page with the document it comes with.
pub fn own() -> Result<&'static str, Failure> {
    PAGE.ok_or_else(|| {
        Failure::with_hint(
            "this program was built without the laboratory's page",
            "run `cargo xtask page`, then build the program again with `cargo build --release`",
        )
    })
}

/// The page with these sources instead. `document` is what they say, where they could be read.
pub fn with(sources: &Sources, document: Option<&Document>) -> Result<String, Failure> {
    let options = Options {
        title: document.map(|document| document.program.title.clone()),
        language: document.map(|document| document.program.language.clone()),
    };
    embed(own()?, &sources.embedded(), &options)
        .ok_or_else(|| Failure::request("the page inside this program has no place for documents"))
}

//! `meniscus export`: one offline page that plays the document, or the whole laboratory with it.

use crate::arguments::Export;
use crate::failure::Failure;
use crate::load::{self, Loaded};
use crate::page;
use crate::terminal::Terminal;
use crate::terminal::output::Output;
use std::io::Write;

/// Writes the page. Refuses a document with errors.
pub fn export(arguments: &Export, terminal: Terminal) -> Result<(), Failure> {
    page::own()?;
    let loaded = Loaded::open(load::sources(&arguments.document)?);
    terminal.report(&loaded);
    let Some(document) = loaded.opened.document.as_ref().filter(|_| !loaded.opened.has_errors()) else {
        return Err(Failure::Document);
    };
    let page = match arguments.lab {
        true => page::with(&loaded.sources, Some(document))?,
        false => page::player(&loaded.sources, document)?,
    };
    let mut output = Output::to(&arguments.output, &loaded.sources)?;
    output.write_all(page.as_bytes()).map_err(|error| output.failure(&error))?;
    output.finish()
}

//! `meniscus export`: one offline page that plays the document, or the whole laboratory with it, or a course package.

use crate::arguments::{Export, Platform};
use crate::failure::Failure;
use crate::load;
use crate::page;
use crate::terminal::Terminal;
use crate::terminal::output::Output;
use class::course::{Kind, package};
use runner::Loaded;
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
    let kind = arguments.platform.map(|platform| match platform {
        Platform::Scorm12 => Kind::Scorm12,
        Platform::Scorm2004 => Kind::Scorm2004,
        Platform::Cmi5 => Kind::Cmi5,
        Platform::Web => Kind::Web,
    });
    let content = match kind {
        Some(kind) => package(kind, &page, &document.program),
        None => page.into_bytes(),
    };
    let mut output = Output::to(&arguments.output, &loaded.sources)?;
    output.write_all(&content).map_err(|error| output.failure(&error))?;
    output.finish()
}

//! `meniscus format`: standard layout of documents.

use super::arguments::Format;
use crate::failure::Failure;
use crate::load::text_of;
use crate::terminal::Terminal;
use crate::terminal::output;
use document::{edit, read};
use model::Diagnostic;
use runner::Sources;
use std::path::Path;
use units::{say, words};

/// Formats each document, or reports those whose layout differs.
///
/// # Errors
/// A file cannot be read or written; a layout differs with `--check`; or a part with errors was left unchanged.
pub fn format(arguments: &Format, terminal: Terminal) -> Result<(), Failure> {
    let mut is_whole = true;
    for path in &arguments.documents {
        is_whole &= format_one(path, arguments.check, terminal)?;
    }
    if is_whole { Ok(()) } else { Err(Failure::Document) }
}

/// Formats one document. Returns true if all its parts now have the layout.
fn format_one(path: &Path, only_check: bool, terminal: Terminal) -> Result<bool, Failure> {
    let text = text_of(path)?;
    let outline = read(&text);
    let formatted = document::format(&outline);
    let sources = Sources::of_text(&path.display().to_string(), &text);
    for &part in &formatted.left {
        let message = words("this part keeps its layout, because it has errors");
        let hint = words("`meniscus check` says which");
        terminal.report_one(&sources, &Diagnostic::warning("layout-kept", message, part).with_hint(hint));
    }
    let written = edit::apply(&text, &formatted.edits)
        .map_err(|error| Failure::Request { message: error.words(), hint: None })?;
    let differs = written != text;
    if only_check {
        if differs {
            let line = 1 + text.lines().zip(written.lines()).take_while(|(before, after)| before == after).count();
            let (name, language) = (path.display(), terminal.language);
            output::print(&say!(language, "{name}: the layout differs, first in line {line}\n"))?;
        }
    } else if path == Path::new("-") {
        output::print(&written)?;
    } else if differs {
        output::file(path, &[], written.as_bytes())?;
        terminal.print(&format!("{}: {}\n", path.display(), terminal.language.say("formatted")));
    }
    Ok(formatted.left.is_empty() && !(only_check && differs))
}

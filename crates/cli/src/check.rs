//! `meniscus check`: what is wrong with documents, for people and for programs.

use crate::arguments::{Check, Findings};
use crate::failure::Failure;
use crate::load::{self, Loaded};
use crate::output::Output;
use crate::terminal::{Terminal, findings_as_json, findings_as_text};
use crate::visible::visible;
use std::io::Write;
use std::path::PathBuf;
use units::Language;

/// Checks each document once, with its translations.
pub fn check(arguments: &Check, terminal: Terminal) -> Result<(), Failure> {
    let mut checked: Vec<PathBuf> = Vec::new();
    let mut loaded = Vec::new();
    for path in &arguments.documents {
        let sources = load::sources(path)?;
        let base = sources.path().to_owned();
        if !checked.contains(&base) {
            checked.push(base);
            loaded.push(Loaded::open(sources));
        }
    }
    let language = terminal.language;
    let (mut output, text) = match arguments.format {
        Findings::Json => (Output::standard(), findings_as_json(&loaded, language)),
        Findings::Text => {
            let findings = findings_as_text(&loaded, language, terminal.standard_output_colors());
            (Output::rendered(), findings + &visible(&summary(&loaded, language)))
        }
    };
    output.write_all(text.as_bytes()).map_err(|error| output.failure(&error))?;
    output.finish()?;
    if loaded.iter().any(|document| document.opened.has_errors()) { Err(Failure::Document) } else { Ok(()) }
}

/// A line for each document.
fn summary(documents: &[Loaded], language: Language) -> String {
    let error = language.pick(["error", "errors"], ["error", "errores"]);
    let warning = language.pick(["warning", "warnings"], ["aviso", "avisos"]);
    let mut summary = String::new();
    for loaded in documents {
        let errors = loaded.errors();
        let warnings = loaded.opened.diagnostics.len() - errors;
        let verdict = match (errors, warnings) {
            (0, 0) => language.pick("ok", "correcto").to_owned(),
            (0, _) => counted(warnings, warning),
            (_, 0) => counted(errors, error),
            (_, _) => format!("{}, {}", counted(errors, error), counted(warnings, warning)),
        };
        summary.push_str(&format!("{}: {verdict}\n", loaded.sources.path().display()));
    }
    summary
}

fn counted(count: usize, [one, many]: [&str; 2]) -> String {
    if count == 1 { format!("1 {one}") } else { format!("{count} {many}") }
}

//! `meniscus import`: a document from a simulation of another program.

use super::arguments::{Import, ReportFormat};
use crate::failure::Failure;
use crate::terminal::Terminal;
use crate::terminal::output;
use ejss::{Imported, Report};
use runner::quoted;
use serde_json::json;
use std::fs;
use std::path::{Path, PathBuf};
use units::{Language, say, words};

/// Writes the document of a simulation and says what was not carried over.
///
/// # Errors
/// The file cannot be read or gives no document, or the document exists already.
pub fn import(arguments: &Import, terminal: Terminal) -> Result<(), Failure> {
    let path = arguments.file.as_path();
    let bytes = fs::read(path).map_err(|error| Failure::file("read", path, &error))?;
    let language = terminal.language;
    let mut accepts = |text: &str| {
        document::open(text, &[]).first_error().map_or(Ok(()), |error| Err(error.message.text(language).into_owned()))
    };
    let imported = ejss::import(&bytes, &mut accepts).map_err(|refusal| Failure::about(path, &refusal.words()))?;
    let target = match &arguments.output {
        Some(target) => target.clone(),
        None => beside(path)?,
    };
    output::file(&target, &[path.to_owned()], imported.document.as_bytes())?;
    match arguments.report {
        ReportFormat::Json => output::print(&as_json(&imported)),
        ReportFormat::Text if target == Path::new("-") => Ok(()),
        ReportFormat::Text => output::print(&as_text(&imported, &target, language)),
    }
}

/// `NAME.md` in the current folder.
fn beside(path: &Path) -> Result<PathBuf, Failure> {
    let stem = path.file_stem().and_then(|stem| stem.to_str()).unwrap_or("simulation");
    let target = PathBuf::from(format!("{}.md", stem.trim_end_matches("_source")));
    if target.exists() {
        let shown = target.display();
        return Err(Failure::in_words(words!("{shown} exists already"), words("name the document: --output DOC")));
    }
    Ok(target)
}

fn as_text(imported: &Imported, target: &Path, language: Language) -> String {
    let mut text = String::new();
    let (written, quoted) = (target.display(), quoted(target));
    let first = match &imported.listed_because {
        None => say!(language, "Wrote {written}: the model is translated."),
        Some(why) => say!(language, "Wrote {written}: the model is listed and not translated, because {why}."),
    };
    text.push_str(&first);
    text.push('\n');
    let entries = imported.report.entries();
    if !entries.is_empty() {
        text.push_str(&format!("\n{}\n", say!(language, "What is missing, or differs from the original:")));
        for entry in entries {
            text.push_str(&format!("- {}\n", entry.sentence(language)));
        }
        if imported.report.more() > 0 {
            let more = imported.report.more();
            text.push_str(&format!("- {}\n", say!(language, "{more} more are not listed.")));
        }
    }
    text.push_str(&format!("\n  {}\n", say!(language, "meniscus serve {quoted}   shows it while you write it")));
    text
}

/// The report for programs: texts are English, sections and kinds are identifiers.
fn as_json(imported: &Imported) -> String {
    let report: &Report = &imported.report;
    let entries: Vec<_> = report
        .entries()
        .iter()
        .map(|entry| {
            json!({
                "kind": entry.kind.key(),
                "section": entry.section().key(),
                "page": entry.page(),
                "line": entry.line(),
                "reason": entry.text.english(),
                "count": entry.count,
                "documentLine": entry.document_line,
            })
        })
        .collect();
    let whole = json!({
        "title": imported.title,
        "translated": imported.listed_because.is_none(),
        "listedBecause": imported.listed_because.as_ref().map(units::Words::english),
        "entries": entries,
        "more": report.more(),
    });
    format!("{whole:#}\n")
}

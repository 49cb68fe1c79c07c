//! `meniscus fit`: fits one theory to one or more records.

use super::arguments::{Common, Fit as Arguments, Form, LossName};
use super::carrying::carrying;
use super::theory;
use crate::command;
use crate::data;
use crate::failure::Failure;
use crate::terminal::Terminal;
use crate::terminal::output;
use base64::Engine as _;
use runner::fitting::{FitSettings, Theory, fit_as_json, fit_as_text, settle_units, task};
use runner::records::{Measured, columns_as_text};
use std::path::{Path, PathBuf};
use units::Language;

/// Fits the document to the data, prints the result and writes the output file.
pub fn fit(arguments: &Arguments, terminal: Terminal) -> Result<(), Failure> {
    let kind = arguments.output.as_deref().map(kind).transpose()?;
    if arguments.profile && arguments.common.loss != LossName::LeastSquares {
        return Err(Failure::with_hint(
            "--profile needs least squares: with another loss the profile has no probability",
            "leave out --profile, or --loss",
        ));
    }
    let mut theory = theory::theory(&arguments.document, terminal)?;
    let data = read(&arguments.data, &arguments.common, std::slice::from_mut(&mut theory), terminal)?;
    let task = task(&mut theory.document, &data, &(&arguments.common).into(), &mut theory::note(terminal))?;
    let fitted = theory::complete(theory, task, arguments.profile)?;
    let notes = notes(&data, &fitted.theory);
    if let (Some(path), Some(kind)) = (&arguments.output, kind) {
        let command = command::typed();
        let report = fitted.report(&notes, &command);
        let bytes = match kind {
            FileKind::Html => {
                carrying(&with_font(&report::html(&report)), &[&fitted], &data, &arguments.common).into_bytes()
            }
            FileKind::Xlsx => report::workbook(&report),
            FileKind::Csv => report::csv(&report, false).into_bytes(),
            FileKind::Svg => report::figure(&report).into_bytes(),
        };
        output::file(path, &arguments.data, &bytes)?;
    }
    let shown = match arguments.common.format {
        Form::Text => fit_as_text(&fitted, &notes),
        Form::Json => format!("{:#}\n", fit_as_json(&fitted, &data)),
    };
    output::print(&shown)
}

/// Reads the data for theories, of which the first says what is independent. The description of their columns is printed unless the format is JSON, which contains
/// it.
pub fn read(
    paths: &[PathBuf],
    arguments: &Common,
    theories: &mut [Theory],
    terminal: Terminal,
) -> Result<Vec<Measured>, Failure> {
    let settings = FitSettings::from(arguments);
    let Some(first) = theories.first() else { return Err(Failure::request("there is no theory")) };
    let stated = settings.stated(&first.document);
    let mut data: Vec<Measured> = paths.iter().map(|path| data::read(path, stated)).collect::<Result<_, _>>()?;
    settle_units(theories, &mut data, &settings)?;
    if arguments.format == Form::Text {
        for one in &data {
            terminal.print(&columns_as_text(one));
        }
    }
    Ok(data)
}

/// Findings about each file, in sentences of the report's language, which is that of the document.
pub fn notes(data: &[Measured], theory: &Theory) -> Vec<Vec<String>> {
    let language = Language::of(&theory.document.program.language);
    data.iter().map(|one| one.findings.iter().map(|finding| finding.text(language)).collect()).collect()
}

/// Type of an output file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    /// A report.
    Html,
    /// A workbook.
    Xlsx,
    /// A table.
    Csv,
    /// A figure.
    Svg,
}

/// Type of the output file from its extension.
pub fn kind(path: &Path) -> Result<FileKind, Failure> {
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_ascii_lowercase();
    match ending.as_str() {
        "html" | "htm" => Ok(FileKind::Html),
        "xlsx" => Ok(FileKind::Xlsx),
        "csv" => Ok(FileKind::Csv),
        "svg" => Ok(FileKind::Svg),
        _ => Err(Failure::with_hint(
            format!("--output {}: the ending says nothing that can be written", path.display()),
            "end it in .html (a report), .xlsx (a workbook), .csv (a table) or .svg (a figure)",
        )),
    }
}

/// Embeds the mathematical font of the laboratory in a report, because the reader's machine may not have one.
pub fn with_font(page: &str) -> String {
    const FONT: &[u8] = include_bytes!("../../../view/page/math.woff2");
    report::with_math_font(page, &base64::engine::general_purpose::STANDARD.encode(FONT))
}

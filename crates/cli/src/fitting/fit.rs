//! `meniscus fit`: fits one theory to one or more records.

use super::arguments::{Common, Fit as Arguments, Form, LossName};
use super::carrying::carrying;
use super::fitted::Fitted;
use super::prepare::{self, Theory};
use super::{json, text};
use crate::arguments::variable::Stated;
use crate::columns;
use crate::command;
use crate::data::{self, Measured};
use crate::failure::Failure;
use crate::terminal::Terminal;
use crate::terminal::output;
use analysis::fit::{Fit, FitError, Task, profiles};
use base64::Engine as _;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::path::{Path, PathBuf};
use std::time::Duration;
use units::Language;
use units::number::{Style, plain};

/// Number of points of a drawn curve.
const POINTS: usize = 600;

/// Fits the document to the data, prints the result and writes the output file.
pub fn fit(arguments: &Arguments, terminal: Terminal) -> Result<(), Failure> {
    let kind = arguments.output.as_deref().map(kind).transpose()?;
    if arguments.profile && arguments.common.loss != LossName::LeastSquares {
        return Err(Failure::with_hint(
            "--profile needs least squares: with another loss the profile has no probability",
            "leave out --profile, or --loss",
        ));
    }
    let mut theory = prepare::theory(&arguments.document, terminal)?;
    let data = read(&arguments.data, &arguments.common, &theory, terminal)?;
    let task = prepare::task(&mut theory.document, &data, &arguments.common, terminal)?;
    let fitted = complete(theory, task, arguments.profile)?;
    let notes = notes(&data, &fitted.theory);
    if let (Some(path), Some(kind)) = (&arguments.output, kind) {
        let command = command::typed();
        let report = fitted.report(&notes, &command);
        let bytes = match kind {
            FileKind::Html => with_font(&carrying(&report::html(&report), &[&fitted], &data, &arguments.common)),
            FileKind::Xlsx => report::workbook(&report),
            FileKind::Csv => report::csv(&report, false).into_bytes(),
            FileKind::Svg => report::figure(&report).into_bytes(),
        };
        output::file(path, &arguments.data, &bytes)?;
    }
    let shown = match arguments.common.format {
        Form::Text => text::fit(&fitted, &notes),
        Form::Json => format!("{:#}\n", json::fit(&fitted, &data)),
    };
    output::print(&shown)
}

/// Reads the data for a theory. The description of their columns is printed unless the format is JSON, which contains
/// it.
pub fn read(
    paths: &[PathBuf],
    arguments: &Common,
    theory: &Theory,
    terminal: Terminal,
) -> Result<Vec<Measured>, Failure> {
    let variable = &theory.document.program.model.independent;
    let stated = Stated {
        units: &arguments.unit,
        against: &arguments.against,
        variable: Some((&variable.name, variable.unit.dimension)),
        observed: &arguments.observe,
    };
    let data: Vec<Measured> = paths.iter().map(|path| data::read(path, stated)).collect::<Result<_, _>>()?;
    if arguments.format == Form::Text {
        for one in &data {
            terminal.print(&columns::as_text(one));
        }
    }
    Ok(data)
}

/// Runs a fit to its end. Shows progress on a terminal.
pub fn complete(theory: Theory, task: Task, with_profiles: bool) -> Result<Fitted, Failure> {
    let mut fit =
        Fit::new(&theory.document.program.model, task.clone()).map_err(|error| refused(&theory, &task, &error))?;
    let progress = progress(&theory.document.program.title);
    while !fit.advance() {
        progress.set_position(fit.trials() as u64);
    }
    let Some(mut outcome) = fit.outcome() else {
        progress.finish_and_clear();
        if fit.gave_up() {
            return Err(Failure::with_hint(
                "the model needs too many steps of the integration wherever it was tried",
                "give values from which it runs with --start NAME=VALUE, narrower ranges with --bounds NAME=LO..HI, or fit a shorter part of the record",
            ));
        }
        return Err(Failure::with_hint(
            "the model has no finite curve anywhere it was tried",
            "give values from which it runs with --start NAME=VALUE, and ranges with --bounds NAME=LO..HI",
        ));
    };
    let intervals = if with_profiles { profiles(&mut fit, &mut outcome) } else { Vec::new() };
    let traces = fit.traces(POINTS);
    progress.finish_and_clear();
    Ok(Fitted { theory, task, outcome, traces, intervals })
}

fn refused(theory: &Theory, task: &Task, error: &FitError) -> Failure {
    let model = &theory.document.program.model;
    let named = |place: usize| match task.varied.get(place).map(|varied| varied.target) {
        Some(analysis::fit::Target::Parameter(index)) => model.parameters[index].name.clone(),
        _ => "it".to_owned(),
    };
    let of_record = match error {
        FitError::RecordEmpty(record) | FitError::BadErrors { record, .. } => task.records.get(*record),
        _ => None,
    };
    let of_record = of_record.map(|record| format!("{}: ", record.name)).unwrap_or_default();
    let message = format!("{}: {of_record}{error}", theory.sources.path().display());
    match error {
        FitError::VariedTwice(place) => {
            Failure::with_hint(message, format!("name {} once, in --vary or in --fix", named(*place)))
        }
        FitError::TooFew { .. } => Failure::with_hint(message, "vary less, or fit a longer part of the record"),
        FitError::BadErrors { first, .. } => {
            let clock = &model.independent;
            let first =
                format!("{} = {} {}", clock.name, plain(clock.unit.from_si(*first), 6, Style::POINT), clock.unit);
            Failure::with_hint(
                message,
                format!("the first is at {}; correct its error, or leave the row out of the file", first.trim()),
            )
        }
        FitError::NothingObserved | FitError::RecordEmpty(_) => {
            Failure::with_hint(message, "look at --from and --until, and at the column")
        }
        _ => Failure::request(message),
    }
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
pub fn with_font(page: &str) -> Vec<u8> {
    const FONT: &[u8] = include_bytes!("../../../view/page/math.woff2");
    report::with_math_font(page, &base64::engine::general_purpose::STANDARD.encode(FONT)).into_bytes()
}

/// Progress indicator. indicatif shows nothing if the standard error is not a terminal.
fn progress(title: &str) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr()).with_message(title.to_owned());
    let bar = match ProgressStyle::with_template("{spinner} {msg}: {pos} trials, {elapsed}") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    };
    bar.enable_steady_tick(Duration::from_millis(500));
    bar
}

//! `meniscus track`: positions from the frames of films.
//!
//! `opened.rs` reads what the file says in ranges, `decoding.rs` takes pixels from `ffmpeg` (as Y4M, so that both kinds of
//! film have one reader), `following.rs` passes them to `film::tracking::Following`, `report.rs` hands over what `--report`
//! shows. Planes stay as the camera stored them, since a rolling shutter reads stored rows; clicks and results are turned.

pub mod arguments;
mod carrying;
mod checks;
mod clock;
mod decoding;
mod following;
mod json;
mod lengths;
mod notes;
mod opened;
mod project;
mod report;

use crate::failure::Failure;
use crate::terminal::Terminal;
use crate::terminal::output;
use analysis::csv::{self, Dialect};
use analysis::spreadsheet::{Cell, Sheet, Workbook};
use arguments::{Track as Arguments, TrackFormat};
use checks::Targets;
use clock::Clock;
use film::calibration::Calibration;
use film::table::Table;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use opened::Opened;
use std::path::Path;
use units::{Language, Words, words};

/// Tracks each film and writes its table. If one film fails, the others are still tracked.
pub fn run(arguments: &Arguments, terminal: Terminal) -> Result<(), Failure> {
    checks::arguments(arguments)?;
    let format = checks::format(arguments)?;
    let targets = checks::outputs(arguments, format)?;
    let several = arguments.films.len() > 1;
    let mut failed = false;
    for (film, target) in arguments.films.iter().zip(&targets) {
        let result = one(film, (target, format), arguments, terminal);
        match result {
            Err(Failure::Request { message, hint }) if several => {
                let language = terminal.language;
                terminal.error(&message.text(language), hint.as_ref().map(|hint| hint.text(language)).as_deref());
                failed = true;
            }
            other => other?,
        }
    }
    // The errors have already been printed.
    if failed { Err(Failure::Argument) } else { Ok(()) }
}

fn one(
    path: &Path,
    (targets, format): (&Targets, TrackFormat),
    arguments: &Arguments,
    terminal: Terminal,
) -> Result<(), Failure> {
    if let Some(failure) = project::refusal(path) {
        return Err(failure);
    }
    let film = Opened::open(path)?;
    checks::points(&film, arguments)?;
    let clock = Clock::of(&film, arguments)?;
    checks::durations(&film, &clock, arguments)?;
    let calibration = lengths::calibration(&film, arguments)?;
    let bar = progress(path);
    let followed = following::follow(&film, &clock, arguments, &bar);
    bar.finish_and_clear();
    let followed = followed?;
    let table = Table::of(&followed.tracks, &calibration, &|frame| clock.times.get(frame).copied().unwrap_or(f64::NAN));
    let found = notes::notes(&followed.tracks, &table, &calibration, (&film.times, film.upright_size()));
    let notes: Vec<Words> = [film.notes.clone(), clock.notes.clone(), followed.notes.clone(), found].concat();
    let language = terminal.language;
    let bytes = match format {
        TrackFormat::Csv => text(&table, &calibration).into_bytes(),
        TrackFormat::Xlsx => workbook(path, &table, &calibration, &notes, language),
        TrackFormat::Json => {
            let found = (followed.tracks.as_slice(), &table, &calibration);
            json::object(&film, arguments, &clock, found, &notes, language).into_bytes()
        }
    };
    output::deliver(targets.table.as_deref(), &arguments.films, &bytes)?;
    if let Some(target) = &targets.report {
        let page = report::page(&film, arguments, &clock, &followed, &notes, language);
        let table = text(&table, &calibration);
        let tracked = carrying::Tracked {
            film: &film,
            arguments,
            clock: &clock,
            followed: &followed,
            calibration: &calibration,
            table: &table,
        };
        let page = carrying::carrying(&page, tracked, language);
        output::file(target, &arguments.films, page.as_bytes())?;
    }
    let name = if arguments.films.len() > 1 { format!("{}: ", path.display()) } else { String::new() };
    for note in &notes {
        terminal.print(&format!("{name}{}: {}\n", language.say("note"), note.text(language)));
    }
    Ok(())
}

fn text(table: &Table, calibration: &Calibration) -> String {
    let columns = table.columns();
    let (heads, values): (Vec<&str>, Vec<&[f64]>) =
        columns.iter().map(|(head, values)| (head.as_str(), *values)).unzip();
    csv::write_film(&heads, &values, calibration.relative_sigma(), Dialect::Commas)
}

/// Workbook with the table, and the name of the film and the notes on a second sheet.
fn workbook(path: &Path, table: &Table, calibration: &Calibration, notes: &[Words], language: Language) -> Vec<u8> {
    let columns = table.columns();
    let (heads, values): (Vec<&str>, Vec<&[f64]>) =
        columns.iter().map(|(head, values)| (head.as_str(), *values)).unzip();
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    let film = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let times = words("times are those of the film's frames, from its beginning");
    let rows = std::iter::once(film)
        .chain(notes.iter().chain([&times]).map(|note| note.text(language).into_owned()))
        .map(|text| vec![Cell::from(text)]);
    let about = Sheet { name: language.say("Film").to_owned(), rows: rows.collect(), header: true };
    Workbook { sheets: vec![Sheet::of_film(&name, &heads, &values, calibration.relative_sigma()), about] }.xlsx()
}

/// Progress bar. It is hidden if the standard error is not a terminal.
fn progress(path: &Path) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
    let bar = bar.with_message(path.file_name().unwrap_or_default().to_string_lossy().into_owned());
    match ProgressStyle::with_template("{msg} {bar:30} {pos}/{len}  {eta}") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}

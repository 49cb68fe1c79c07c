//! Documents opened as theories, and fits with their progress on a terminal.

use crate::failure::Failure;
use crate::load;
use crate::terminal::Terminal;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use runner::Loaded;
use runner::fitting::{FitTask, Fitted, Theory};
use std::path::Path;
use std::time::Duration;
use units::Words;

/// Opens a document as a theory. Errors in it are reported.
pub fn theory(path: &Path, terminal: Terminal) -> Result<Theory, Failure> {
    let loaded = Loaded::open(load::sources(path)?);
    terminal.report(&loaded);
    let (sources, document) = loaded.sound().ok_or(Failure::Document)?;
    Ok(Theory { sources, document })
}

/// Prints a remark about data.
pub fn note(terminal: Terminal) -> impl FnMut(&Words) {
    move |note| {
        let head = terminal.language.say("note");
        terminal.print(&format!("{head}: {}\n", note.text(terminal.language)));
    }
}

/// Runs a fit to its end. Shows progress on a terminal.
pub fn complete(theory: Theory, task: FitTask, with_profiles: bool) -> Result<Fitted, Failure> {
    let progress = progress(&theory.document.program.title);
    let fitted = Fitted::complete(theory, task, with_profiles, &mut |trials| {
        progress.set_position(trials as u64);
        true
    });
    progress.finish_and_clear();
    Ok(fitted?)
}

/// Progress indicator. indicatif shows nothing if the standard error is not a terminal.
pub fn progress(title: &str) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr()).with_message(title.to_owned());
    let bar = match ProgressStyle::with_template("{spinner} {msg}: {pos} trials, {elapsed}") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    };
    bar.enable_steady_tick(Duration::from_millis(500));
    bar
}

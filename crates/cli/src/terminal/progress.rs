//! Progress on the terminal.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::path::Path;

/// Progress bar up to a number of steps or runs, which `what` names; hidden if the output goes to the terminal, too. indicatif
/// shows nothing if the standard error is not a terminal.
pub fn bar(length: u64, what: &str, output: Option<&Path>) -> ProgressBar {
    let output_on_screen = output.is_none_or(|path| path == Path::new("-")) && std::io::stdout().is_terminal();
    let target = if output_on_screen { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
    let bar = ProgressBar::with_draw_target(Some(length), target);
    let template = format!("{{bar:40}} {{percent:>3}} %  {{human_pos}} of {{human_len}} {what}  {{eta}} left");
    match ProgressStyle::with_template(&template) {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}

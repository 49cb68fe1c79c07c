//! `meniscus hand-in`: makes a hand-in from a project.

use super::arguments::HandIn;
use super::read::bytes;
use super::write::now;
use crate::failure::Failure;
use crate::terminal::Terminal;
use crate::terminal::output::file;
use crate::terminal::visible::visible;
use saved::hand_in::{HAND_IN_ENDING, Sender};
use saved::project::{LONGEST_PROJECT, Project};
use units::{Words, words};

/// Writes the hand-in of a project.
///
/// # Errors
/// The project cannot be read, its document has errors, or the file cannot be written.
pub fn hand_in(arguments: &HandIn, terminal: Terminal) -> Result<(), Failure> {
    let path = &arguments.project;
    let refused = |why: Words| Failure::about(path, &why);
    let project = Project::read(&String::from_utf8_lossy(&bytes(path, LONGEST_PROJECT)?))
        .map_err(|error| refused(error.words()))?;
    let sender =
        Sender { name: arguments.name.clone(), seat: arguments.seat, assignment: arguments.assignment.clone() };
    let (made, left_out) = class::verify::hand_in_with_losses(project, sender, now()).map_err(refused)?;
    let output = arguments.output.clone().unwrap_or_else(|| path.with_extension(&HAND_IN_ENDING[1..]));
    file(&output, std::slice::from_ref(path), made.write().as_bytes())?;
    let (count, output) = (made.facts.len(), output.display());
    let said = words!("Wrote {output} with {count} values");
    terminal.print(&format!("{}\n", said.text(terminal.language)));
    for why in &left_out {
        let why = visible(&why.text(terminal.language)).into_owned();
        let line = words!("Without values for {why}");
        terminal.print(&format!("  {}\n", line.text(terminal.language)));
    }
    Ok(())
}

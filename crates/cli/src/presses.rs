//! `--press Kick=3.2`: buttons of the document that are pressed during the run.

use crate::assignments::Assignment;
use crate::failure::Failure;
use crate::settings::{Reader, unknown};
use engine::Press;
use program::{Button, Program};

/// For each of the assignments which button of [`program::Model::buttons`] it means: by its title, also a translated one, or
/// by its name.
pub fn buttons(program: &Program, assignments: &[Assignment]) -> Result<Vec<usize>, Failure> {
    let buttons = &program.model.buttons;
    let titles = |button: &Button| -> Vec<String> {
        let translated = program.languages().map(|language| program.text(language, &button.title).to_owned());
        button.name.iter().cloned().chain(translated).collect()
    };
    let named = |assignment: &Assignment| {
        let meant = |button: &Button| titles(button).iter().any(|title| title.eq_ignore_ascii_case(&assignment.name));
        buttons.iter().position(meant).ok_or_else(|| match buttons.is_empty() {
            true => Failure::request(format!("--press {}: the document has no buttons", assignment.name)),
            false => unknown("button", &assignment.name, buttons.iter().map(|button| button.title.as_str())),
        })
    };
    assignments.iter().map(named).collect()
}

impl Reader<'_> {
    /// The presses at the times of the assignments; `buttons` are those of [`buttons`].
    pub fn presses(
        &mut self,
        buttons: &[usize],
        assignments: &[Assignment],
        parameters: &[f64],
        until: f64,
    ) -> Result<Vec<Press>, Failure> {
        let unit = self.model.independent.unit.clone();
        let mut presses = Vec::new();
        for (&button, assignment) in buttons.iter().zip(assignments) {
            let what = format!("--press {}", assignment.name);
            let time = self.value(&what, &assignment.value, &unit, parameters)?;
            if !(0.0..until).contains(&time) {
                let end = format!("{} {unit}", unit.from_si(until));
                return Err(Failure::request(format!("{what} must be at 0 or later and before the end, {}", end.trim())));
            }
            presses.push(Press { time, button });
        }
        Ok(presses)
    }
}

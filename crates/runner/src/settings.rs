//! Settings of a run, as a person states them.

use crate::names::Assignment;
use crate::refusal::Refusal;
use crate::values::{Reader, apply_preset, positive};
use document::Document;
use engine::{Method, Setup};
use program::{Button, Program, Seat};
use std::str::FromStr;
use units::words;

/// Settings of a run. Values are texts as typed: numbers in the declared unit, numbers with their own, or expressions.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Settings {
    /// Seat whose assigned values are taken.
    pub seat: Option<Seat>,
    /// Values of parameters, and sizes of families.
    pub set: Vec<Assignment>,
    /// Values of variables at the start.
    pub start: Vec<Assignment>,
    /// Presets by name, set before [`Settings::set`].
    pub preset: Vec<String>,
    /// Buttons, and the times at which they are pressed.
    pub press: Vec<Assignment>,
    /// Method of integration; `None`: that of the document.
    pub method: Option<String>,
    /// Distance of the rows; `None`: that of the document.
    pub step: Option<String>,
    /// Relative error of a step of an adaptive method.
    pub tolerance: Option<f64>,
    /// End of the run; `None`: that of the document, or 100 s.
    pub until: Option<String>,
}

/// Setup of a run, and the value of the independent variable at its end, SI. The document is changed by sizes and by a seat.
///
/// # Errors
/// A setting that the document does not have, or a value that it cannot have.
pub fn setup(document: &mut Document, settings: &Settings) -> Result<(Setup, f64), Refusal> {
    let parameters = resize(document, &settings.set)?;
    take_seat(&mut document.program, settings.seat)?;
    let mut setup = Setup::of(&document.program);
    for name in &settings.preset {
        apply_preset(document, name, &mut setup.parameters)?;
    }
    let end = document.program.end();
    let pressed = buttons(&document.program, &settings.press)?;
    let Program { model, .. } = &mut document.program;
    let (time, time_counts) = (model.independent.unit.clone(), model.independent.counts);
    let mut reader = Reader { model };
    for assignment in parameters {
        let (index, value) = reader.parameter("--set", assignment, &setup.parameters)?;
        setup.parameters[index] = value;
    }
    if !settings.start.is_empty() {
        setup.start = Some(reader.start(&settings.start, &setup.parameters)?);
    }
    if time_counts {
        refuse_steps(settings)?;
    }
    if let Some(name) = &settings.method {
        setup.method = Method::from_str(name)
            .map_err(|_| Refusal::unknown("method", name, Method::ALL.iter().map(|method| method.name())))?;
    }
    if let Some(text) = &settings.step {
        setup.step = positive("--step", reader.value("--step", text, &time, &setup.parameters)?)?;
    }
    if let Some(tolerance) = settings.tolerance {
        setup.tolerance = positive("--tolerance", tolerance)?;
    }
    let until = match &settings.until {
        Some(text) => positive("--until", reader.value("--until", text, &time, &setup.parameters)?)?,
        None => end,
    };
    setup.presses = reader.presses(&pressed, &settings.press, &setup.parameters, until)?;
    Ok((setup, until))
}

/// Index in [`program::Model::buttons`] of the button of each assignment. A button is named by its title, also a
/// translated one, or by its name.
fn buttons(program: &Program, assignments: &[Assignment]) -> Result<Vec<usize>, Refusal> {
    let buttons = &program.model.buttons;
    let titles = |button: &Button| -> Vec<String> {
        let translated = program.languages().map(|language| program.text(language, &button.title).to_owned());
        button.name.iter().cloned().chain(translated).collect()
    };
    let named = |assignment: &Assignment| {
        let meant = |button: &Button| titles(button).iter().any(|title| title.eq_ignore_ascii_case(&assignment.name));
        buttons.iter().position(meant).ok_or_else(|| match buttons.is_empty() {
            true => Refusal::request(format!("--press {}: the document has no buttons", assignment.name)),
            false => Refusal::unknown("button", &assignment.name, buttons.iter().map(|button| button.title.as_str())),
        })
    };
    assignments.iter().map(named).collect()
}

/// Refuses method, step and tolerance for a discrete model, which advances by 1.
fn refuse_steps(settings: &Settings) -> Result<(), Refusal> {
    let given = [
        ("--method", settings.method.is_some()),
        ("--step", settings.step.is_some()),
        ("--tolerance", settings.tolerance.is_some()),
    ];
    match given.iter().find(|(_, given)| *given) {
        Some((option, _)) => Err(Refusal::request(format!("{option} means nothing here: the model counts by 1"))),
        None => Ok(()),
    }
}

/// Sets the sizes of families, as in `--set N=50`. Another size gives other equations, so the document is opened again.
/// Returns the remaining assignments, those of parameters.
fn resize<'a>(document: &mut Document, assignments: &'a [Assignment]) -> Result<Vec<&'a Assignment>, Refusal> {
    let is_size =
        |assignment: &&Assignment| document.program.model.sizes.iter().any(|size| size.name == assignment.name);
    let (sizes, parameters): (Vec<_>, Vec<_>) = assignments.iter().partition(is_size);
    if !sizes.is_empty() {
        let values = sizes.iter().map(|assignment| (assignment.name.as_str(), assignment.value.as_str()));
        let values: Vec<(&str, &str)> = values.collect();
        *document = document::resized(document, &values).map_err(|reason| {
            let names: Vec<&str> = values.iter().map(|(name, _)| *name).collect();
            Refusal::request(format!("`{}` cannot have this size: {}", names.join("`, `"), reason.english()))
        })?;
    }
    Ok(parameters)
}

/// Gives the program the values of a seat.
///
/// # Errors
/// A document that assigns no values.
pub fn take_seat(program: &mut Program, seat: Option<Seat>) -> Result<(), Refusal> {
    if seat.is_none() || program.set_seat(seat) {
        return Ok(());
    }
    Err(no_seats())
}

/// Refusal of a document that assigns no values.
pub fn no_seats() -> Refusal {
    Refusal::in_words(
        words("the document assigns no values to seats"),
        words(
            "give a parameter values, `parameter b = 0.02 in 0..1 assigned 0.01..0.05 step 0.002`, and the front matter a line \
             `assignment: NAME`",
        ),
    )
}

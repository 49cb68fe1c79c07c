//! Conversion of the settings on the command line to the setup of a run.

use super::assignments::Assignment;
use crate::arguments::run_settings::RunSettings;
use crate::class::take_seat;
use crate::failure::{Failure, listed};
use crate::load::Sources;
use crate::terminal::Terminal;
use document::Document;
use engine::{Method, Press, Readings, Setup};
use model::Compiler;
use program::{Button, Compiled, Kind, Model, Parameter, Program};
use std::str::FromStr;
use units::Unit;
use units::nearest;

/// Setup of a run, and the value of the independent variable at its end, SI.
pub fn setup(document: &mut Document, arguments: &RunSettings, terminal: Terminal) -> Result<(Setup, f64), Failure> {
    let parameters = resize(document, &arguments.set)?;
    take_seat(&mut document.program, arguments.seat)?;
    let mut setup = Setup::of(&document.program);
    for name in &arguments.preset {
        apply_preset(document, name, &mut setup.parameters)?;
    }
    let end = document.program.end();
    let pressed = buttons(&document.program, &arguments.press)?;
    let Program { model, .. } = &mut document.program;
    let (time, time_counts) = (model.independent.unit.clone(), model.independent.counts);
    let mut reader = Reader { model, terminal };
    for assignment in parameters {
        let (index, value) = reader.parameter("--set", assignment, &setup.parameters)?;
        setup.parameters[index] = value;
    }
    if !arguments.start.is_empty() {
        setup.start = Some(reader.start(&arguments.start, &setup.parameters)?);
    }
    if time_counts {
        refuse_steps(arguments)?;
    }
    if let Some(name) = &arguments.method {
        setup.method = Method::from_str(name)
            .map_err(|_| unknown("method", name, Method::ALL.iter().map(|method| method.name())))?;
    }
    if let Some(text) = &arguments.step {
        setup.step = positive("--step", reader.value("--step", text, &time, &setup.parameters)?)?;
    }
    if let Some(tolerance) = arguments.tolerance {
        setup.tolerance = positive("--tolerance", tolerance)?;
    }
    let until = match &arguments.until {
        Some(text) => positive("--until", reader.value("--until", text, &time, &setup.parameters)?)?,
        None => end,
    };
    setup.presses = reader.presses(&pressed, &arguments.press, &setup.parameters, until)?;
    Ok((setup, until))
}

/// Index in [`program::Model::buttons`] of the button of each assignment. A button is named by its title, also a
/// translated one, or by its name.
fn buttons(program: &Program, assignments: &[Assignment]) -> Result<Vec<usize>, Failure> {
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

/// Refuses method, step and tolerance for a discrete model, which advances by 1.
fn refuse_steps(arguments: &RunSettings) -> Result<(), Failure> {
    let given = [
        ("--method", arguments.method.is_some()),
        ("--step", arguments.step.is_some()),
        ("--tolerance", arguments.tolerance.is_some()),
    ];
    match given.iter().find(|(_, given)| *given) {
        Some((option, _)) => Err(Failure::request(format!("{option} means nothing here: the model counts by 1"))),
        None => Ok(()),
    }
}

/// Sets the sizes of families, as in `--set N=50`. Another size gives other equations, so the document is opened again.
/// Returns the remaining assignments, those of parameters.
fn resize<'a>(document: &mut Document, assignments: &'a [Assignment]) -> Result<Vec<&'a Assignment>, Failure> {
    let is_size =
        |assignment: &&Assignment| document.program.model.sizes.iter().any(|size| size.name == assignment.name);
    let (sizes, parameters): (Vec<_>, Vec<_>) = assignments.iter().partition(is_size);
    if !sizes.is_empty() {
        let values = sizes.iter().map(|assignment| (assignment.name.as_str(), assignment.value.as_str()));
        let values: Vec<(&str, &str)> = values.collect();
        *document = document::resized(document, &values).map_err(|reason| {
            let names: Vec<&str> = values.iter().map(|(name, _)| *name).collect();
            Failure::request(format!("`{}` cannot have this size: {}", names.join("`, `"), reason.english()))
        })?;
    }
    Ok(parameters)
}

/// Parser of typed values that may contain names of the document.
pub struct Reader<'a> {
    /// Model of the document.
    pub model: &'a mut Model,
    /// Output of errors in expressions.
    pub terminal: Terminal,
}

impl Reader<'_> {
    /// Parses `NAME=VALUE` of a parameter. Returns its index and value, SI. `option`: name of the option, for messages.
    pub fn parameter(
        &mut self,
        option: &str,
        assignment: &Assignment,
        parameters: &[f64],
    ) -> Result<(usize, f64), Failure> {
        let Some(index) = self.model.parameters.iter().position(|parameter| parameter.name == assignment.name) else {
            return Err(self.no_parameter(&assignment.name));
        };
        if !self.model.parameters[index].is_number() {
            return Ok((index, self.chosen(option, index, &assignment.value)?));
        }
        let unit = self.model.parameters[index].unit.clone();
        let value = self.value(&format!("{option} {}", assignment.name), &assignment.value, &unit, parameters)?;
        within_range(&self.model.parameters[index], value)?;
        Ok((index, value))
    }

    /// Value of a switch or a choice, with or without quotation marks.
    fn chosen(&self, option: &str, index: usize, text: &str) -> Result<f64, Failure> {
        let parameter = &self.model.parameters[index];
        let word = text.trim().trim_matches('"');
        parameter.chosen(word, &self.model.texts).ok_or_else(|| {
            let known = parameter.words(&self.model.texts);
            let hint = match nearest(word, known.iter().copied()) {
                Some(near) => format!("did you mean `{near}`?"),
                None => format!("there are {}", listed(known.into_iter())),
            };
            Failure::with_hint(format!("{option} {}: there is no `{word}` to choose", parameter.name), hint)
        })
    }

    /// Error for a name that is not a parameter.
    pub fn no_parameter(&self, name: &str) -> Failure {
        if self.model.quantities.iter().any(|quantity| quantity.name == name) {
            return Failure::request(format!(
                "`{name}` is defined by the document and cannot be set; only parameters can"
            ));
        }
        if let Some(state) = self.model.states.iter().find(|state| state.name() == name) {
            return Failure::with_hint(
                format!("`{name}` is a variable of the equations, not a parameter"),
                format!("`--start \"{}=...\"` starts the run from another value", state.name()),
            );
        }
        unknown("parameter", name, self.model.parameters.iter().map(|parameter| parameter.name.as_str()))
    }

    /// Initial state of the run, SI, one value per state: from `--start NAME=VALUE`, otherwise from the document.
    fn start(&mut self, assignments: &[Assignment], parameters: &[f64]) -> Result<Vec<f64>, Failure> {
        let nodes: Vec<_> = self.model.states.iter().map(|state| state.initial).collect();
        let zeros = vec![0.0; nodes.len()];
        let mut state = Readings::new(self.model, &nodes).at(parameters, &zeros, 0.0, &zeros).to_vec();
        for assignment in assignments {
            let Some(index) = self.model.states.iter().position(|state| state.name() == assignment.name) else {
                let names: Vec<String> = self.model.states.iter().map(|state| state.name()).collect();
                return Err(unknown("variable", &assignment.name, names.iter().map(String::as_str)));
            };
            let unit = self.model.states[index].unit.clone();
            let what = format!("--start {}", assignment.name);
            state[index] = self.value(&what, &assignment.value, &unit, parameters)?;
        }
        Ok(state)
    }

    /// Presses of buttons at the times of the assignments. `buttons`: result of [`buttons`]. `until`: end of the run,
    /// SI.
    fn presses(
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
            if !(0.0..=until).contains(&time) {
                let end = format!("{} {unit}", unit.from_si(until));
                return Err(Failure::request(format!("{what} must be between 0 and the end, {}", end.trim())));
            }
            presses.push(Press { time, button });
        }
        Ok(presses)
    }

    /// SI value of a number in `unit`, of a number with its own unit, or of an expression in the parameters. `what`:
    /// name of the value, for messages.
    pub fn value(&mut self, what: &str, text: &str, unit: &Unit, parameters: &[f64]) -> Result<f64, Failure> {
        if let Ok(number) = text.parse::<f64>() {
            return finite(what, unit.to_si(number));
        }
        let (expression, stated, found) = model::parse_expression(text, 0..text.len());
        if let Some(number) = expression.bare_number().filter(|_| stated.is_none() && found.is_empty()) {
            return finite(what, unit.to_si(number));
        }
        let compiled = self.expression(what, text)?;
        if compiled.kind != Kind::Number || compiled.dimension() != unit.dimension {
            let given = match compiled.kind {
                Kind::Number if compiled.dimension().is_none() => "a pure number".to_owned(),
                Kind::Number => format!("in {}", compiled.unit),
                Kind::Truth => "a condition".to_owned(),
                Kind::Text => "a text".to_owned(),
            };
            return Err(Failure::request(format!("{what} is {}, and {text} is {given}", expected(unit))));
        }
        let dependence = self.model.depends(compiled.node);
        if dependence.varies() || !dependence.initial.is_empty() {
            return Err(Failure::request(format!(
                "{what}: {text} changes during the run; use parameters and constants only"
            )));
        }
        let zeros = vec![0.0; self.model.states.len()];
        let value = Readings::new(self.model, &[compiled.node]).at(parameters, &zeros, 0.0, &zeros).first().copied();
        finite(what, value.unwrap_or(f64::NAN))
    }

    /// Compiles an expression with names of the document. Errors in it are reported.
    pub fn expression(&mut self, what: &str, text: &str) -> Result<Compiled, Failure> {
        let (expression, unit, mut diagnostics) = model::parse_expression(text, 0..text.len());
        if diagnostics.is_empty() {
            match Compiler::new(self.model).compile(&expression, unit.as_ref()) {
                Ok(compiled) => return Ok(compiled),
                Err(errors) => diagnostics = errors,
            }
        }
        let source = Sources::of_text(what, text);
        for diagnostic in &diagnostics {
            self.terminal.report_one(&source, diagnostic);
        }
        Err(Failure::Argument)
    }
}

/// Description of the expected value: `in kg/s`, or `a pure number`.
fn expected(unit: &Unit) -> String {
    if unit.text.is_empty() { "a pure number".to_owned() } else { format!("in {unit}") }
}

fn apply_preset(document: &Document, name: &str, parameters: &mut [f64]) -> Result<(), Failure> {
    let Some(preset) = document.program.presets.iter().find(|preset| preset.name.eq_ignore_ascii_case(name)) else {
        return Err(unknown("preset", name, document.program.presets.iter().map(|preset| preset.name.as_str())));
    };
    let nodes: Vec<_> = preset.values.iter().map(|assignment| assignment.value.node).collect();
    let zeros = vec![0.0; document.program.model.states.len()];
    let values = Readings::new(&document.program.model, &nodes).at(parameters, &zeros, 0.0, &zeros).to_vec();
    for (assignment, value) in preset.values.iter().zip(values) {
        within_range(&document.program.model.parameters[assignment.parameter], value)?;
        parameters[assignment.parameter] = value;
    }
    Ok(())
}

/// Refuses a value (SI) outside of the range of a parameter.
pub fn within_range(parameter: &Parameter, value: f64) -> Result<(), Failure> {
    let Some((low, high)) = parameter.range else {
        return Ok(());
    };
    if (low..=high).contains(&value) {
        return Ok(());
    }
    let shown = |value: f64| parameter.unit.from_si(value).to_string();
    let unit = if parameter.unit.text.is_empty() { String::new() } else { format!(" {}", parameter.unit) };
    let (name, value, low, high) = (&parameter.name, shown(value), shown(low), shown(high));
    Err(Failure::request(format!("{name} = {value}{unit} is out of range: it can be from {low}{unit} to {high}{unit}")))
}

fn finite(what: &str, value: f64) -> Result<f64, Failure> {
    if value.is_finite() { Ok(value) } else { Err(Failure::request(format!("{what} must be a finite number"))) }
}

/// Returns `value` if it is greater than 0 and finite. `what`: name of the value, for messages.
pub fn positive(what: &str, value: f64) -> Result<f64, Failure> {
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(Failure::request(format!("{what} must be greater than 0")))
    }
}

/// Error for a name that the document does not have. The hint is the nearest name, or all names.
pub fn unknown<'a>(noun: &str, name: &str, known: impl Iterator<Item = &'a str> + Clone) -> Failure {
    let hint = match nearest(name, known.clone()) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("there are {}", listed(known)),
    };
    Failure::with_hint(format!("there is no {noun} `{name}`"), hint)
}

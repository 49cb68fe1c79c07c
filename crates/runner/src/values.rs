//! Conversion of typed values to SI.

use crate::names::Assignment;
use crate::refusal::{Refusal, listed};
use document::Document;
use engine::checks::assign;
use engine::{Press, Readings};
use model::Compiler;
use program::{Compiled, Kind, Model, Parameter};
use units::{Unit, nearest};

/// Parser of typed values that may contain names of the document.
pub struct Reader<'a> {
    /// Model of the document.
    pub model: &'a mut Model,
}

impl Reader<'_> {
    /// Parses `NAME=VALUE` of a parameter. Returns its index and value, SI. `option`: name of the option, for messages.
    pub fn parameter(
        &mut self,
        option: &str,
        assignment: &Assignment,
        parameters: &[f64],
    ) -> Result<(usize, f64), Refusal> {
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
    fn chosen(&self, option: &str, index: usize, text: &str) -> Result<f64, Refusal> {
        let parameter = &self.model.parameters[index];
        let word = text.trim().trim_matches('"');
        parameter.chosen(word, &self.model.texts).ok_or_else(|| {
            let known = parameter.words(&self.model.texts);
            let hint = match nearest(word, known.iter().copied()) {
                Some(near) => format!("did you mean `{near}`?"),
                None => format!("there are {}", listed(known.into_iter())),
            };
            Refusal::with_hint(format!("{option} {}: there is no `{word}` to choose", parameter.name), hint)
        })
    }

    /// Error for a name that is not a parameter.
    pub fn no_parameter(&self, name: &str) -> Refusal {
        if self.model.quantities.iter().any(|quantity| quantity.name == name) {
            return Refusal::request(format!(
                "`{name}` is defined by the document and cannot be set; only parameters can"
            ));
        }
        if let Some(state) = self.model.states.iter().find(|state| state.name() == name) {
            return Refusal::with_hint(
                format!("`{name}` is a variable of the equations, not a parameter"),
                format!("`--start \"{}=...\"` starts the run from another value", state.name()),
            );
        }
        Refusal::unknown("parameter", name, self.model.parameters.iter().map(|parameter| parameter.name.as_str()))
    }

    /// Initial state of the run, SI, one value per state: from `--start NAME=VALUE`, otherwise from the document.
    pub fn start(&mut self, assignments: &[Assignment], parameters: &[f64]) -> Result<Vec<f64>, Refusal> {
        let nodes: Vec<_> = self.model.states.iter().map(|state| state.initial).collect();
        let zeros = vec![0.0; nodes.len()];
        let mut state = Readings::new(self.model, &nodes).at(parameters, &zeros, 0.0, &zeros).to_vec();
        for assignment in assignments {
            let Some(index) = self.model.states.iter().position(|state| state.name() == assignment.name) else {
                let names: Vec<String> = self.model.states.iter().map(|state| state.name()).collect();
                return Err(Refusal::unknown("variable", &assignment.name, names.iter().map(String::as_str)));
            };
            let unit = self.model.states[index].unit.clone();
            let what = format!("--start {}", assignment.name);
            state[index] = self.value(&what, &assignment.value, &unit, parameters)?;
        }
        Ok(state)
    }

    /// Presses of buttons at the times of the assignments. `buttons`: index of the button of
    /// each assignment. `until`: end of the run,
    /// SI.
    pub fn presses(
        &mut self,
        buttons: &[usize],
        assignments: &[Assignment],
        parameters: &[f64],
        until: f64,
    ) -> Result<Vec<Press>, Refusal> {
        let unit = self.model.independent.unit.clone();
        let mut presses = Vec::new();
        for (&button, assignment) in buttons.iter().zip(assignments) {
            let what = format!("--press {}", assignment.name);
            let time = self.value(&what, &assignment.value, &unit, parameters)?;
            if !(0.0..=until).contains(&time) {
                let end = format!("{} {unit}", unit.from_si(until));
                return Err(Refusal::request(format!("{what} must be between 0 and the end, {}", end.trim())));
            }
            presses.push(Press { time, button });
        }
        Ok(presses)
    }

    /// SI value for a quantity stated in `unit`: of a number in `unit`, of a number with its own unit, or of an expression in
    /// the parameters. `what`: name of the value, for messages.
    pub fn value(&mut self, what: &str, text: &str, unit: &Unit, parameters: &[f64]) -> Result<f64, Refusal> {
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
            return Err(Refusal::request(format!("{what} is {}, and {text} is {given}", expected(unit))));
        }
        let dependence = self.model.depends(compiled.node);
        if dependence.varies() || !dependence.initial.is_empty() {
            return Err(Refusal::request(format!(
                "{what}: {text} changes during the run; use parameters and constants only"
            )));
        }
        let zeros = vec![0.0; self.model.states.len()];
        let value = Readings::new(self.model, &[compiled.node]).at(parameters, &zeros, 0.0, &zeros).first().copied();
        let value = value.unwrap_or(f64::NAN);
        let own = &compiled.unit;
        let turned = if own.turning(unit) == 1.0 { value } else { own.to_si_of(own.from_si(value), unit) };
        finite(what, turned)
    }

    /// Compiles an expression with names of the document. `what`: name of the value, for messages.
    pub fn expression(&mut self, what: &str, text: &str) -> Result<Compiled, Refusal> {
        let (expression, unit, mut diagnostics) = model::parse_expression(text, 0..text.len());
        if diagnostics.is_empty() {
            match Compiler::new(self.model).compile(&expression, unit.as_ref()) {
                Ok(compiled) => return Ok(compiled),
                Err(errors) => diagnostics = errors,
            }
        }
        Err(Refusal::Expression { setting: what.to_owned(), text: text.to_owned(), found: diagnostics })
    }
}

/// Description of the expected value: `in kg/s`, or `a pure number`.
fn expected(unit: &Unit) -> String {
    if unit.text.is_empty() { "a pure number".to_owned() } else { format!("in {unit}") }
}

/// Sets the values of a preset. `parameters`: one value per parameter, SI.
///
/// # Errors
/// A name that the document does not have, or a value outside of its range.
pub fn apply_preset(document: &Document, name: &str, parameters: &mut [f64]) -> Result<(), Refusal> {
    let Some(preset) = document.program.presets.iter().find(|preset| preset.name.eq_ignore_ascii_case(name)) else {
        return Err(Refusal::unknown(
            "preset",
            name,
            document.program.presets.iter().map(|preset| preset.name.as_str()),
        ));
    };
    let model = &document.program.model;
    for assignment in &preset.values {
        assign(model, parameters, std::slice::from_ref(assignment));
        within_range(&model.parameters[assignment.parameter], parameters[assignment.parameter])?;
    }
    Ok(())
}

/// Refuses a value (SI) outside of the range of a parameter.
pub fn within_range(parameter: &Parameter, value: f64) -> Result<(), Refusal> {
    let Some((low, high)) = parameter.range else {
        return Ok(());
    };
    if (low..=high).contains(&value) {
        return Ok(());
    }
    let shown = |value: f64| parameter.unit.from_si(value).to_string();
    let unit = if parameter.unit.text.is_empty() { String::new() } else { format!(" {}", parameter.unit) };
    let (name, value, low, high) = (&parameter.name, shown(value), shown(low), shown(high));
    Err(Refusal::request(format!("{name} = {value}{unit} is out of range: it can be from {low}{unit} to {high}{unit}")))
}

fn finite(what: &str, value: f64) -> Result<f64, Refusal> {
    if value.is_finite() { Ok(value) } else { Err(Refusal::request(format!("{what} must be a finite number"))) }
}

/// Returns `value` if it is greater than 0 and finite. `what`: name of the value, for messages.
pub fn positive(what: &str, value: f64) -> Result<f64, Refusal> {
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(Refusal::request(format!("{what} must be greater than 0")))
    }
}

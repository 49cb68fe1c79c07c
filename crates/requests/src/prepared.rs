//! Preparations that sweeps with other numbers have in common.

use crate::arguments::Given;
use crate::fault::{Fault, read};
use crate::host::Host;
use crate::settings::{Asked, Prepared};
use program::Outcomes;
use runner::fitting::Theory;
use runner::{Axis, Plan, Points, Refusal, SweepCode, Values, within_range};
use serde::Deserialize;

/// The part of a request that sweeps with other numbers have in common.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Preparation {
    over: Vec<Over>,
    keep: Vec<String>,
    settings: Asked,
}

/// A parameter and its values.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Over {
    /// Name, and place of the array with the values in the declared unit.
    Numbers(String, usize),
    /// Name and single values.
    Values(String, Vec<Given>),
    /// Name, and values as on the command line, such as `0..100 [kg/s] step 2`.
    Range(String, String),
    /// Name and values as on the command line.
    Text(String),
}

/// A document that is prepared for the runs of sweeps.
#[derive(Debug)]
pub struct Kept {
    /// Text of the [`Preparation`].
    pub request: String,
    /// The axes, with their texts for messages.
    axes: Vec<(PreparedAxis, String)>,
    pub prepared: Prepared,
    pub outcomes: Outcomes,
    pub code: SweepCode,
}

/// An axis, whose expressions are in the document, or which gets its values from an array.
#[derive(Debug)]
enum PreparedAxis {
    Whole(Axis),
    /// Name, and place of the array.
    Numbers(String, usize),
}

impl Kept {
    /// Prepares the runs of a request.
    pub fn new(host: &dyn Host, theory: &Theory, request: &str) -> Result<Self, Fault> {
        let Preparation { over, keep, settings } = read(request)?;
        let mut prepared = settings.prepare(host, theory)?;
        let mut axes = Vec::new();
        for over in over {
            let text = match over {
                Over::Numbers(name, place) => {
                    axes.push((PreparedAxis::Numbers(name.clone(), place), name));
                    continue;
                }
                Over::Values(name, values) => {
                    format!("{name} = {}", values.iter().map(Given::text).collect::<Vec<_>>().join(", "))
                }
                Over::Range(name, values) => {
                    format!("{name} {} {values}", if values.contains("..") { "in" } else { "=" })
                }
                Over::Text(text) => text,
            };
            let axis = runner::axis(&mut prepared.document, &text, &prepared.setup.parameters)?;
            axes.push((PreparedAxis::Whole(axis), text));
        }
        let outcomes = runner::kept(&mut prepared.document, &keep.join(", "))?;
        let Prepared { document, setup, until } = &prepared;
        let code = SweepCode::new(&document.program.model, (setup, *until), &outcomes);
        Ok(Self { request: request.to_owned(), axes, prepared, outcomes, code })
    }

    /// The plan of the runs, with these values in arrays.
    pub fn plan(&self, points: Points, arrays: &[Vec<f64>]) -> Result<Plan, Refusal> {
        let model = &self.prepared.document.program.model;
        let axis = |(axis, _): &(PreparedAxis, String)| match axis {
            PreparedAxis::Whole(axis) => Ok(axis.clone()),
            PreparedAxis::Numbers(name, place) => {
                numbers(model, name, arrays.get(*place).map(Vec::as_slice).unwrap_or_default())
            }
        };
        let axes = self.axes.iter().map(axis).collect::<Result<_, _>>()?;
        let described: Vec<String> = self.axes.iter().map(|(_, text)| text.clone()).collect();
        runner::plan(model, axes, points, &described)
    }
}

/// An axis with these values, in the declared unit of the parameter.
fn numbers(model: &program::Model, name: &str, values: &[f64]) -> Result<Axis, Refusal> {
    let known = model.parameters.iter().map(|parameter| parameter.name.as_str());
    let Some(parameter) = known.clone().position(|known| known == name) else {
        return Err(Refusal::unknown("parameter", name, known));
    };
    let own = &model.parameters[parameter];
    if !own.is_number() {
        return Err(Refusal::request(format!("{name} takes words, not numbers")));
    }
    let values: Vec<f64> = values.iter().map(|value| own.unit.to_si(*value)).collect();
    for value in &values {
        if !value.is_finite() {
            return Err(Refusal::request(format!("{name} must be a finite number")));
        }
        within_range(own, *value)?;
    }
    Ok(Axis { parameter, values: Values::List(values) })
}

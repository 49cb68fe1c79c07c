//! Sweeps: many runs, and what is kept of each.

use crate::arguments::{Options, is_several, names, text};
use crate::diagnostic::Diagnostic;
use crate::errors::{refused, run_diagnostic, value_error};
use crate::settings::{Asked, Prepared};
use crate::table::Table;
use model::Severity;
use program::Outcomes;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyString};
use runner::fitting::Theory;
use runner::{Axis, Outcome, Plan, Points, Refusal, Sources, Sweep, SweepCode, Values, within_range};
use std::sync::Arc;
use units::words;

/// Runs that are computed between two looks at signals.
const TOGETHER: u64 = 1 << 12;

/// A document that is prepared for the runs of sweeps.
#[derive(Debug)]
pub struct Kept {
    asked: Asked,
    keep: String,
    /// Texts of axes, whose expressions are in the document.
    texts: Vec<String>,
    axes: Vec<Axis>,
    prepared: Prepared,
    outcomes: Outcomes,
    code: SweepCode,
}

/// A parameter and its values.
enum Over {
    /// Numbers in the declared unit.
    Numbers(String, Vec<f64>),
    /// Text as on the command line, by its place among the texts.
    Text(usize),
}

/// The arguments of a sweep.
pub struct Request {
    asked: Asked,
    keep: String,
    over: Vec<Over>,
    texts: Vec<String>,
    points: Points,
    /// Number of the share from 0, and number of shares.
    shard: (u64, u64),
}

impl Request {
    /// Takes the arguments.
    pub fn take(over: &Bound<'_, PyAny>, keep: &Bound<'_, PyAny>, options: &Options) -> PyResult<Self> {
        let mut texts = Vec::new();
        let mut axes = Vec::new();
        if let Ok(over) = over.cast::<PyDict>() {
            for (name, values) in over {
                axes.push(axis(name.extract()?, &values, &mut texts)?);
            }
        } else {
            for text in names(over)? {
                axes.push(Over::Text(texts.len()));
                texts.push(text);
            }
        }
        let seed = options.get("seed")?.unwrap_or(1);
        let points = match (options.get("random")?, options.get("halton")?) {
            (Some(_), Some(_)) => return Err(value_error("random and halton exclude each other")),
            (Some(runs), None) => Points::Random(runs, seed),
            (None, Some(runs)) => Points::Halton(runs),
            (None, None) => Points::Grid,
        };
        let (number, of) = options.get("shard")?.unwrap_or((1, 1));
        if !(1..=of).contains(&number) {
            return Err(value_error("shard must be (number, shards), such as (3, 16) for the third of 16 parts"));
        }
        let keep = names(keep)?.join(", ");
        let asked = Asked::take(options)?;
        Ok(Self { asked, keep, over: axes, texts, points, shard: (number - 1, of) })
    }

    /// The prepared document: the last one, or another one if the settings differ from its own.
    pub fn prepare(&self, py: Python<'_>, theory: &Theory, last: Option<Arc<Kept>>) -> PyResult<Arc<Kept>> {
        let same = |kept: &Arc<Kept>| kept.asked == self.asked && kept.keep == self.keep && kept.texts == self.texts;
        if let Some(kept) = last.filter(same) {
            return Ok(kept);
        }
        py.detach(|| self.prepared(theory)).map(Arc::new).map_err(|refusal| refused(py, &refusal))
    }

    fn prepared(&self, theory: &Theory) -> Result<Kept, Refusal> {
        let mut prepared = self.asked.prepare(theory)?;
        let parameters = prepared.setup.parameters.clone();
        let axes = self.texts.iter().map(|text| runner::axis(&mut prepared.document, text, &parameters));
        let axes = axes.collect::<Result<_, _>>()?;
        let outcomes = runner::kept(&mut prepared.document, &self.keep)?;
        let Prepared { document, setup, until } = &prepared;
        let code = SweepCode::new(&document.program.model, (setup, *until), &outcomes);
        let (asked, keep, texts) = (self.asked.clone(), self.keep.clone(), self.texts.clone());
        Ok(Kept { asked, keep, texts, axes, prepared, outcomes, code })
    }

    /// Computes the runs.
    pub fn compute(&self, py: Python<'_>, sources: &Sources, kept: &Kept) -> PyResult<Table> {
        let Prepared { document, setup, until } = &kept.prepared;
        let model = &document.program.model;
        let plan = self.plan(kept).map_err(|refusal| refused(py, &refusal))?;
        let sweep = Sweep::new(model, (setup, *until), &plan, (&kept.outcomes, &kept.code));
        let runs = plan.share(self.shard.0, self.shard.1);
        let mut outcomes = Vec::new();
        let mut next = runs.start;
        while next < runs.end {
            let part = next..runs.end.min(next + TOGETHER);
            next = part.end;
            outcomes.extend(py.detach(|| sweep.compute(part)));
            py.check_signals()?;
        }
        let table = py.detach(|| runner::Table::of_runs(model, &plan, &kept.outcomes, &outcomes));
        Ok(Table::new(py, table, missing(&outcomes, sources, kept), None))
    }

    fn plan(&self, kept: &Kept) -> Result<Plan, Refusal> {
        let model = &kept.prepared.document.program.model;
        let (mut axes, mut described) = (Vec::new(), Vec::new());
        for over in &self.over {
            match over {
                Over::Text(place) => {
                    axes.extend(kept.axes.get(*place).cloned());
                    described.push(self.texts[*place].clone());
                }
                Over::Numbers(name, values) => {
                    axes.push(numbers(model, name, values)?);
                    described.push(name.clone());
                }
            }
        }
        runner::plan(model, axes, self.points, &described)
    }
}

/// Values of a parameter: an array or a list, or a text as on the command line.
fn axis(name: String, values: &Bound<'_, PyAny>, texts: &mut Vec<String>) -> PyResult<Over> {
    if values.hasattr("dtype")? {
        let numbers = values.call_method1("astype", ("f8",))?.call_method0("tobytes")?;
        let bytes = numbers.cast::<PyBytes>()?.as_bytes();
        let numbers = bytes.as_chunks().0.iter().map(|number| f64::from_ne_bytes(*number));
        return Ok(Over::Numbers(name, numbers.collect()));
    }
    let written = if values.is_instance_of::<PyString>() {
        values.extract()?
    } else if is_several(values) {
        if let Ok(numbers) = values.extract::<Vec<f64>>() {
            return Ok(Over::Numbers(name, numbers));
        }
        values.try_iter()?.map(|value| text(&value?)).collect::<PyResult<Vec<_>>>()?.join(", ")
    } else {
        text(values)?
    };
    let joint = if written.contains("..") { "in" } else { "=" };
    texts.push(format!("{name} {joint} {written}"));
    Ok(Over::Text(texts.len() - 1))
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

/// How many runs could not be computed, and why the first one could not.
fn missing(outcomes: &[Outcome], sources: &Sources, kept: &Kept) -> Vec<Diagnostic> {
    let mut failed = outcomes.iter().filter_map(|outcome| Some((outcome.run, outcome.taken.as_ref().err()?)));
    let Some((run, error)) = failed.next() else { return Vec::new() };
    let (count, all) = (1 + failed.count(), outcomes.len());
    let why = words!("{count} of {all} runs could not be computed; the first is run {}", run + 1);
    let summary = Diagnostic::without_place(Severity::Warning, "", &why, None);
    vec![summary, run_diagnostic((sources, &kept.prepared.document), error)]
}

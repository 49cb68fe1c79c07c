//! Fits of documents to measured data.

use crate::arguments::{Given, GivenByName, assignments, text};
use crate::fault::{Fault, read};
use crate::host::Host;
use crate::opened::Opened;
use crate::reply::{Buffer, Reply};
use crate::settings::seat;
use crate::table::Columns;
use analysis::fit::Loss;
use engine::table::Column;
use runner::Refusal;
use runner::fitting::{FitSettings, Fitted, Theory, fit_as_json, fit_as_text, settle_units, task};
use runner::names::{Assignment, Observe, date_order, observe};
use runner::records::{Measured, measured};
use runner::{ColumnValues, TableColumn};
use serde::{Deserialize, Serialize};
use std::path::PathBuf;
use units::{Language, Unit};

/// Measured data as they are given.
#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Record {
    /// A file.
    File(PathBuf),
    /// Headings, each with the place of its array.
    Columns(Vec<(String, usize)>),
}

/// A measured quantity.
#[derive(Deserialize)]
#[serde(untagged)]
enum Observed {
    /// `y` or `y=COLUMN`.
    Text(String),
    /// A quantity and its column.
    Column(String, String),
}

/// Range of a search.
#[derive(Deserialize)]
#[serde(untagged)]
enum Bounds {
    /// `1..2`.
    Text(String),
    /// Ends; `None` is no bound.
    Ends(Option<Given>, Option<Given>),
}

/// Settings of a fit as they are asked for.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Asked {
    observe: Vec<Observed>,
    against: Vec<String>,
    dates: Option<String>,
    unit: GivenByName,
    seat: Option<u64>,
    vary: Vec<String>,
    share: Vec<String>,
    fix: GivenByName,
    tie: GivenByName,
    start: GivenByName,
    bounds: Vec<(String, Bounds)>,
    error: GivenByName,
    loss: String,
    begin: Option<Given>,
    until: Option<Given>,
    exclude: Vec<String>,
}

/// A fit that is asked for.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Request {
    data: Vec<Record>,
    settings: Asked,
    profile: bool,
}

/// A fit as Python has it.
#[derive(Serialize)]
pub struct Answer {
    summary: serde_json::Value,
    text: String,
    curves: Vec<Columns>,
}

/// Fits a document.
pub fn fit(host: &dyn Host, opened: &Opened, request: &str, numbers: &[Vec<f64>]) -> Result<Reply, Fault> {
    let Request { data, settings, profile } = read(request)?;
    let settings = settings.settings()?;
    if profile && settings.loss != Loss::Squares {
        let message = "profile needs least squares: with another loss the profile has no probability";
        return Err(Fault::Value(message.to_owned()));
    }
    let mut theory = opened.theory().clone();
    let data = records(host, &data, numbers, (std::slice::from_mut(&mut theory), &settings))?;
    let task = task(&mut theory.document, &data, &settings, &mut |_| {})?;
    let fitted = Fitted::complete(theory, task, profile, &mut |_| true)?;
    let mut buffers = Vec::new();
    let answer = Answer::new(fit_as_json(&fitted, &data), &fitted, &data, &mut buffers);
    Ok(Reply::with_buffers(&answer, buffers)?)
}

impl Answer {
    /// A fit with its object in JSON. Numbers of its curves are added to the buffers.
    pub fn new(summary: serde_json::Value, fitted: &Fitted, data: &[Measured], buffers: &mut Vec<Buffer>) -> Self {
        let text = fit_as_text(fitted, &notes(data));
        Self { summary, text, curves: curves(fitted).map(|table| Columns::new(table, buffers)).collect() }
    }
}

/// For each observed quantity of each record a table: time, measured, fitted, residual, and whether the row was fitted.
fn curves(fitted: &Fitted) -> impl Iterator<Item = runner::Table> {
    fitted.outcome.observations.iter().map(|observation| {
        let clock = &fitted.theory.document.program.model.independent;
        let numbers = |name: &str, unit: &Unit, values: &[f64]| TableColumn {
            head: Column { name: name.to_owned(), label: None, unit: unit.clone() },
            values: ColumnValues::Numbers(values.iter().map(|value| unit.from_si(*value)).collect()),
        };
        let pairs = observation.measured.iter().zip(&observation.fitted);
        let residuals: Vec<f64> = pairs.map(|(measured, fitted)| measured - fitted).collect();
        let inside = Column { name: "inside".to_owned(), label: None, unit: Unit::dimensionless() };
        let columns = vec![
            numbers(&clock.name, &clock.unit, &observation.times),
            numbers("measured", &observation.unit, &observation.measured),
            numbers("fitted", &observation.unit, &observation.fitted),
            numbers("residual", &observation.unit, &residuals),
            TableColumn { head: inside, values: ColumnValues::Truths(observation.inside.clone()) },
        ];
        runner::Table { columns }
    })
}

/// Reads records for theories, of which the first says what is independent.
pub fn records(
    host: &dyn Host,
    records: &[Record],
    arrays: &[Vec<f64>],
    (theories, settings): (&mut [Theory], &FitSettings),
) -> Result<Vec<Measured>, Fault> {
    let first = theories.first().ok_or_else(|| Refusal::request("there are no documents"))?;
    let stated = settings.stated(&first.document);
    let one = |(place, record): (usize, &Record)| {
        let (name, bytes) = match record {
            Record::File(path) => (path.display().to_string(), host.record(path)?),
            Record::Columns(columns) => {
                let numbers = |place: &usize| arrays.get(*place).map(Vec::as_slice).unwrap_or_default();
                let columns: Vec<_> = columns.iter().map(|(name, place)| (name.as_str(), numbers(place))).collect();
                (format!("record {}", place + 1), csv(&columns)?.into_bytes())
            }
        };
        Ok::<_, Fault>(measured(name, bytes, stated)?)
    };
    let mut data: Vec<Measured> = records.iter().enumerate().map(one).collect::<Result<_, _>>()?;
    settle_units(theories, &mut data, settings)?;
    Ok(data)
}

/// Columns as the text of a file. Numbers read back as the same bits; NaN is an empty cell.
fn csv(columns: &[(&str, &[f64])]) -> Result<String, Fault> {
    let rows = columns.first().map_or(0, |(_, numbers)| numbers.len());
    if columns.iter().any(|(_, numbers)| numbers.len() != rows) {
        return Err(Fault::Value("the columns differ in length".to_owned()));
    }
    let quoted = |name: &str| format!("\"{}\"", name.replace('"', "\"\""));
    let mut text = columns.iter().map(|(name, _)| quoted(name)).collect::<Vec<_>>().join(",");
    for row in 0..rows {
        let cell = |number: f64| if number.is_finite() { format!("{number:?}") } else { String::new() };
        let cells = columns.iter().map(|(_, numbers)| cell(numbers[row]));
        text.push('\n');
        text.push_str(&cells.collect::<Vec<_>>().join(","));
    }
    text.push('\n');
    Ok(text)
}

impl Asked {
    /// The settings as `runner` has them.
    pub fn settings(self) -> Result<FitSettings, Fault> {
        let observed = |observed: Observed| match observed {
            Observed::Text(text) => observe(&text).map_err(Fault::Value),
            Observed::Column(quantity, column) => Ok(Observe { quantity, column: Some(column) }),
        };
        Ok(FitSettings {
            observe: self.observe.into_iter().map(observed).collect::<Result<_, _>>()?,
            against: self.against,
            dates: self.dates.map(|order| date_order(&order)).transpose().map_err(Fault::Value)?,
            unit: assignments(&self.unit),
            seat: seat(self.seat)?,
            vary: names(&self.vary),
            share: names(&self.share),
            fix: assignments(&self.fix),
            tie: assignments(&self.tie),
            start: assignments(&self.start),
            bounds: self.bounds.iter().map(Bounds::assignment).collect(),
            error: assignments(&self.error),
            loss: loss(&self.loss)?,
            from: text(self.begin.as_ref()),
            until: text(self.until.as_ref()),
            exclude: names(&self.exclude),
        })
    }
}

impl Bounds {
    fn assignment((name, bounds): &(String, Self)) -> Assignment {
        let value = match bounds {
            Self::Text(text) => text.clone(),
            Self::Ends(low, high) => {
                let end = |end: &Option<Given>| text(end.as_ref()).unwrap_or_default();
                format!("{} .. {}", end(low), end(high))
            }
        };
        Assignment { name: name.clone(), value }
    }
}

/// Names, also with commas between them.
fn names(names: &[String]) -> Vec<String> {
    names.iter().flat_map(|names| names.split(',')).map(|name| name.trim().to_owned()).collect()
}

fn loss(name: &str) -> Result<Loss, Fault> {
    match name {
        "least-squares" => Ok(Loss::Squares),
        "huber" => Ok(Loss::Huber),
        "tukey" => Ok(Loss::Tukey),
        other => Err(Fault::Value(format!("loss is least-squares, huber or tukey, not {other}"))),
    }
}

/// Findings about each record, in sentences.
fn notes(data: &[Measured]) -> Vec<Vec<String>> {
    let notes = |one: &Measured| one.findings.iter().map(|finding| finding.text(Language::English)).collect();
    data.iter().map(notes).collect()
}

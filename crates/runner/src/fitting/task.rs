//! Conversion of the settings of a fit to its task.

use super::errors::{errors, errors_of_files, of_values};
use super::exclude::excluded_rows;
use super::fixed::{fix, without_offset};
use super::offsets::default_offsets;
use super::settings::FitSettings;
use super::starts::Starts;
use super::tied_parameters::tie;
use crate::names::Assignment;
use crate::records::{Measured, nothing_between};
use crate::refusal::Refusal;
use crate::settings::take_seat;
use crate::values::Reader;
use analysis::fit::{Record, Target, Task, Varied, observation};
use analysis::origin::UnitOrigin;
use document::Document;
use program::{Compiled, Kind};
use std::path::Path;
use units::{Unit, Words};

/// A task, and the starts from which its fit is made.
#[derive(Clone, Debug)]
pub struct FitTask {
    /// The task, with the first start of each number.
    pub task: Task,
    /// Starts of numbers that have several.
    pub starts: Starts,
}

/// Fit task of the settings. `note` gets remarks about the data.
///
/// # Errors
/// A setting that does not suit the document or the data.
pub fn task(
    document: &mut Document,
    data: &[Measured],
    settings: &FitSettings,
    note: &mut dyn FnMut(&Words),
) -> Result<FitTask, Refusal> {
    take_seat(&mut document.program, settings.seat)?;
    let time = document.program.model.independent.unit.clone();
    let parameters: Vec<f64> = document.program.model.parameters.iter().map(|parameter| parameter.value).collect();
    let mut task = Task { parameters, loss: settings.loss, ..Task::default() };
    task.method = document.program.method.unwrap_or(task.method);
    let observed = observed(document, settings)?;
    let mut columns: Vec<Vec<usize>> = Vec::new();
    let excluded = excluded_rows(data, &settings.exclude)?;
    for (measured, excluded) in data.iter().zip(&excluded) {
        let (record, own) = record(document, (measured, excluded), settings, &observed)?;
        task.records.push(record);
        columns.push(own);
    }
    let vary = document.program.vary.clone();
    let mut reader = Reader { model: &mut document.program.model };
    let names: Vec<String> = observed.iter().map(|(name, _)| name.clone()).collect();
    let no_offset: Vec<usize> = settings.fix.iter().filter_map(|fixed| offset_of(&fixed.name, &names)).collect();
    for fixed in &settings.fix {
        if settings.vary.iter().any(|name| name.trim() == fixed.name) {
            return Err(Refusal::with_hint(
                format!("{} is both varied and held", fixed.name),
                "name it in --vary or in --fix; where a search begins says --start",
            ));
        }
        match offset_of(&fixed.name, &names) {
            Some(_) => without_offset(&mut reader, &task, fixed)?,
            None => fix(&mut reader, &mut task, fixed)?,
        }
    }
    for error in &settings.error {
        errors(&mut reader, &mut task, (data, &columns), error, &observed)?;
    }
    for (place, (name, compiled)) in observed.iter().enumerate() {
        if !settings.error.iter().any(|error| error.name == *name) {
            errors_of_files(&mut task, (data, &columns), (place, name, &compiled.unit), note)?;
        }
    }
    task.varied = if settings.vary.is_empty() {
        // A parameter that is fixed or tied is not varied.
        let parameter = |name: &String| reader.model.parameters.iter().position(|own| own.name == *name);
        let held = settings.fix.iter().chain(&settings.tie).filter_map(|held| parameter(&held.name));
        let held: Vec<usize> = held.collect();
        task.varied = vary.into_iter().filter(|index| !held.contains(index)).map(Varied::parameter).collect();
        let offsets = default_offsets(reader.model, &task, &held);
        let wanted = |offset: &Varied| no_offset.iter().all(|place| offset.target != Target::Offset(*place));
        let offsets = offsets.into_iter().filter(|offset| !task.varied.is_empty() && wanted(offset));
        task.varied.iter().cloned().chain(offsets).collect()
    } else {
        let targets: Result<Vec<Target>, Refusal> =
            settings.vary.iter().map(|name| target(&reader, name.trim(), &names)).collect();
        targets?.into_iter().map(|target| Varied { target, ..Varied::parameter(0) }).collect()
    };
    tie(&mut reader, &mut task, settings)?;
    if task.varied.is_empty() {
        return Err(Refusal::with_hint(
            "nothing is varied",
            "say what with --vary NAME,NAME, or in the document's front matter: `vary: b, y_0`",
        ));
    }
    let starts = refine(&mut reader, &mut task, settings, &names)?;
    let values = task.parameters.clone();
    let mut moment = |what: &str, text: &Option<String>| match text {
        Some(text) => reader.value(what, text, &time, &values).map(Some),
        None => Ok(None),
    };
    task.from = moment("--from", &settings.from)?;
    task.until = moment("--until", &settings.until)?;
    if let (Some(from), Some(until)) = (task.from, task.until)
        && until <= from
    {
        let typed = |text: &Option<String>| text.clone().unwrap_or_default();
        return Err(nothing_between(&typed(&settings.from), &typed(&settings.until)));
    }
    Ok(FitTask { task, starts })
}

/// Applies `--share`, `--start` and `--bounds` to the varied numbers. Returns the starts of numbers that have several.
fn refine(reader: &mut Reader, task: &mut Task, settings: &FitSettings, names: &[String]) -> Result<Starts, Refusal> {
    let mut starts = Starts::default();
    let values = task.parameters.clone();
    for name in &settings.share {
        let place = varied(reader, task, "--share", name.trim(), names)?;
        task.varied[place].shared = true;
    }
    if !settings.share.is_empty() && task.records.len() < 2 {
        return Err(Refusal::with_hint(
            format!("--share {}: there is only one record", settings.share.join(",")),
            "name more than one file of data, or leave out --share",
        ));
    }
    for start in &settings.start {
        let place = varied(reader, task, "--start", &start.name, names)?;
        let unit = unit(reader, task, task.varied[place].target);
        task.varied[place].start = starts.add(reader, (place, start), &unit, &values)?;
    }
    for bounds in &settings.bounds {
        let place = varied(reader, task, "--bounds", &bounds.name, names)?;
        let unit = unit(reader, task, task.varied[place].target);
        let what = format!("--bounds {}", bounds.name);
        let (low, high) = split_range(&bounds.value).ok_or_else(|| {
            Refusal::with_hint(format!("{what} is no range"), format!("write --bounds {}=LO..HI", bounds.name))
        })?;
        let low = if low.is_empty() { f64::NEG_INFINITY } else { reader.value(&what, low, &unit, &values)? };
        let high = if high.is_empty() { f64::INFINITY } else { reader.value(&what, high, &unit, &values)? };
        if low >= high {
            return Err(Refusal::request(format!("{what}: the lower bound is not below the upper one")));
        }
        task.varied[place].bounds = Some((low, high));
    }
    for start in &settings.start {
        let place = varied(reader, task, "--start", &start.name, names)?;
        for value in starts.of(place).into_iter().chain(task.varied[place].start) {
            starts_inside(reader, &Varied { start: Some(value), ..task.varied[place].clone() }, start)?;
        }
    }
    Ok(starts)
}

/// Refuses a start outside the search range, which the search would silently move to the nearest bound.
fn starts_inside(reader: &Reader, varied: &Varied, start: &Assignment) -> Result<(), Refusal> {
    let own = match varied.target {
        Target::Parameter(index) => reader.model.parameters.get(index).and_then(|parameter| parameter.range),
        Target::Origin | Target::Offset(_) => None,
    };
    let (Some(value), Some((low, high))) = (varied.start, varied.bounds.or(own)) else { return Ok(()) };
    if (low..=high).contains(&value) {
        return Ok(());
    }
    Err(Refusal::with_hint(
        format!("--start {}={} lies outside the range in which is searched", start.name, start.value),
        format!("choose a value inside, or another range with --bounds {}=LO..HI", start.name),
    ))
}

/// Splits a range at the first double dot: `1..2`, `1. .. 2.`, `..2`.
fn split_range(text: &str) -> Option<(&str, &str)> {
    let (low, high) = text.split_once("..")?;
    Some((low.trim(), high.trim()))
}

/// Compiled observed expressions with their names as typed.
fn observed(document: &mut Document, settings: &FitSettings) -> Result<Vec<(String, Compiled)>, Refusal> {
    let mut reader = Reader { model: &mut document.program.model };
    let mut observed: Vec<(String, Compiled)> = Vec::new();
    for observe in &settings.observe {
        let name = &observe.quantity;
        if observed.iter().any(|(known, _)| known == name) {
            return Err(Refusal::request(format!("--observe {name} is given twice")));
        }
        let compiled = reader.expression("--observe", name)?;
        if compiled.kind != Kind::Number {
            return Err(Refusal::request(format!("--observe {name} is no number that could be measured")));
        }
        observed.push((name.clone(), compiled));
    }
    Ok(observed)
}

/// A record with its observations, and the index of the column of each.
fn record(
    document: &Document,
    (measured, excluded): (&Measured, &[bool]),
    settings: &FitSettings,
    observed: &[(String, Compiled)],
) -> Result<(Record, Vec<usize>), Refusal> {
    let scale_error = measured.table.scale_error;
    let mut record = Record { name: short_name(&measured.name), scale_error, ..Record::default() };
    let mut columns: Vec<usize> = Vec::new();
    for (observe, (name, compiled)) in settings.observe.iter().zip(observed) {
        let column = measured.column(observe, &columns)?;
        measured.check_unit(column)?;
        let observation = observation(&document.program.model, &measured.table, column, name, compiled.clone())
            .map_err(|error| {
                let message = format!("{}: {error}", measured.name);
                match error.lacks_scale {
                    true => Refusal::with_hint(message, "give the film a scale: two points of its ruler, `meniscus track FILM --scale 'X1,Y1,X2,Y2=10 [cm]'`"),
                    false => Refusal::request(message),
                }
            })?;
        if measured.table.columns[column].origin.unit == UnitOrigin::Assumed {
            record
                .assumed
                .extend(measured.table.columns[column].unit.clone().map(|unit| (record.observations.len(), unit)));
        }
        record.excluded.push(of_values(measured, column, excluded));
        record.observations.push(observation);
        columns.push(column);
    }
    if !excluded.contains(&true) {
        record.excluded.clear();
    }
    for (place, column) in columns.iter().enumerate() {
        let source = measured.derived.iter().find(|derived| derived.column == *column).map(|derived| derived.of);
        record.observations[place].derived_from =
            source.and_then(|source| columns.iter().position(|column| *column == source));
    }
    Ok((record, columns))
}

/// Place of the observed quantity of which this is the name of the offset.
fn offset_of(name: &str, observed: &[String]) -> Option<usize> {
    observed.iter().position(|observed| name == format!("{observed}_offset"))
}

/// File name without its directory.
fn short_name(path: &str) -> String {
    Path::new(path).file_name().map_or_else(|| path.to_owned(), |name| name.to_string_lossy().into_owned())
}

/// Varied number of this name: a parameter, `t_origin`, or `y_offset`.
fn target(reader: &Reader, name: &str, observed: &[String]) -> Result<Target, Refusal> {
    if let Some(index) = reader.model.parameters.iter().position(|parameter| parameter.name == name) {
        if reader.model.parameters[index].choices != program::Choices::Numbers {
            return Err(Refusal::request(format!("{name} cannot be varied: it is no number")));
        }
        return Ok(Target::Parameter(index));
    }
    if name == format!("{}_origin", reader.model.independent.name) {
        return Ok(Target::Origin);
    }
    if let Some(place) = offset_of(name, observed) {
        return Ok(Target::Offset(place));
    }
    Err(reader.no_parameter(name))
}

/// Index of a varied number among the varied numbers of the task. `option`: name of the option, for messages.
fn varied(reader: &Reader, task: &Task, option: &str, name: &str, observed: &[String]) -> Result<usize, Refusal> {
    let target = target(reader, name, observed)?;
    task.varied.iter().position(|varied| varied.target == target).ok_or_else(|| {
        Refusal::with_hint(
            format!("{option} {name}: {name} is not varied"),
            format!("add it to --vary: --vary {name},..."),
        )
    })
}

fn unit(reader: &Reader, task: &Task, target: Target) -> Unit {
    match target {
        Target::Parameter(index) => reader.model.parameters[index].unit.clone(),
        Target::Origin => reader.model.independent.unit.clone(),
        Target::Offset(place) => task
            .records
            .first()
            .and_then(|record| record.observations.get(place))
            .map_or_else(Unit::dimensionless, |observation| observation.observed.unit.clone()),
    }
}

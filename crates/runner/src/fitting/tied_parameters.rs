//! `--tie`: parameters whose values are expressions of others, in all records or between records.

use super::settings::FitSettings;
use crate::names::Assignment;
use crate::refusal::Refusal;
use crate::values::Reader;
use analysis::fit::{Target, Task, TiedParameter, Varied};
use program::{Choices, Compiled, Kind, Node, Parameter};
use std::ops::Range;

/// Parameter of a record in the text of a tie: `L:2` is `L` in the second record.
struct OfRecord<'a> {
    /// Place in the text.
    range: Range<usize>,
    name: &'a str,
    /// Number of the record, from 1.
    record: usize,
}

/// Parameter that is divided into one for each record.
struct Divided {
    /// Index of the parameter in the model.
    parameter: usize,
    /// Index of the parameter of each record, `L:1`, `L:2`.
    parts: Vec<usize>,
}

/// Ties parameters of a task as `--tie NAME=EXPRESSION` states. A parameter that is named with a record, `L:2`, is divided
/// into one for each record. A tied parameter is not varied.
///
/// # Errors
/// A name or record that does not exist, a parameter that is also varied, fixed, shared or tied again, or an expression that
/// is no constant number of the same dimension.
pub(super) fn tie(reader: &mut Reader, task: &mut Task, settings: &FitSettings) -> Result<(), Refusal> {
    let mut divided: Vec<Divided> = Vec::new();
    for text in settings.tie.iter().flat_map(|tie| [&tie.name, &tie.value]) {
        for named in of_records(text) {
            let parameter = parameter(reader, named.name)?;
            let count = task.records.len();
            if !(1..=count).contains(&named.record) {
                let records = if count == 1 { "is 1 record" } else { &format!("are {count} records") };
                return Err(Refusal::request(format!("--tie {}: there {records}", &text[named.range])));
            }
            if !divided.iter().any(|known| known.parameter == parameter) {
                divided.push(divide(reader, task, settings, parameter)?);
            }
        }
    }
    for tie in &settings.tie {
        for (option, names) in [("--vary", &settings.vary), ("--share", &settings.share)] {
            if names.iter().any(|name| name.trim() == tie.name) {
                return Err(tied_and(&tie.name, option));
            }
        }
        if settings.fix.iter().any(|fixed| fixed.name == tie.name) {
            return Err(tied_and(&tie.name, "--fix"));
        }
        let of_record = of_records(&tie.name).into_iter().find(|named| named.range == (0..tie.name.len()));
        let name = of_record.as_ref().map_or(tie.name.as_str(), |named| named.name);
        let index = parameter(reader, name)?;
        let index = match (&of_record, divided.iter().find(|known| known.parameter == index)) {
            (Some(named), Some(divided)) => divided.parts[named.record - 1],
            (None, Some(_)) => {
                return Err(Refusal::request(format!("--tie: {name} is named both with a record and without")));
            }
            _ => index,
        };
        if task.tied.iter().any(|known| known.parameter == index) {
            return Err(Refusal::request(format!("--tie {}: it is tied twice", tie.name)));
        }
        let value = value(reader, task, &divided, (tie, index))?;
        if let Some(named) = of_record {
            refuse_own_values(reader, task, settings, (tie, &value), (&divided, named.record))?;
        }
        task.varied.retain(|varied| varied.target != Target::Parameter(index));
        task.tied.push(TiedParameter { parameter: index, values: vec![value] });
    }
    for Divided { parameter, parts } in divided {
        for (number, &part) in parts.iter().enumerate() {
            reader.model.parameters[part].name = format!("{}:{}", reader.model.parameters[parameter].name, number + 1);
        }
        let unit = reader.model.parameters[parameter].unit.clone();
        let graph = &mut reader.model.graph;
        let mut of_part = |part: usize| Compiled {
            node: graph.insert(Node::Parameter(part as u32)),
            kind: Kind::Number,
            unit: unit.clone(),
        };
        task.tied.push(TiedParameter { parameter, values: parts.into_iter().map(&mut of_part).collect() });
    }
    Ok(())
}

fn tied_and(name: &str, option: &str) -> Refusal {
    Refusal::with_hint(format!("{name} stands in {option} and in --tie"), format!("name it in {option} or in --tie"))
}

/// Index of the parameter of this name, which must be a number.
fn parameter(reader: &Reader, name: &str) -> Result<usize, Refusal> {
    let Some(index) = reader.model.parameters.iter().position(|parameter| parameter.name == name) else {
        return Err(reader.no_parameter(name));
    };
    match reader.model.parameters[index].choices {
        Choices::Numbers => Ok(index),
        _ => Err(Refusal::request(format!("{name} cannot be tied: it is no number"))),
    }
}

/// Divides a parameter into one for each record, with the value of the record. They are varied if it is.
fn divide(reader: &mut Reader, task: &mut Task, settings: &FitSettings, parameter: usize) -> Result<Divided, Refusal> {
    let whole: Parameter = reader.model.parameters[parameter].clone();
    if settings.share.iter().any(|name| name.trim() == whole.name) {
        return Err(Refusal::with_hint(
            format!("--share {0}: {0} has one value in all records", whole.name),
            "leave out --share, or name it in --tie without a record",
        ));
    }
    let varied = task.varied.iter().position(|varied| varied.target == Target::Parameter(parameter));
    let mut parts = Vec::new();
    for number in 0..task.records.len() {
        let part = reader.model.parameters.len();
        parts.push(part);
        let fixed = &mut task.records[number].fixed;
        let own = fixed.iter().position(|(index, _)| *index == parameter).map(|place| fixed.remove(place).1);
        let value = own.unwrap_or(task.parameters[parameter]);
        let name = identifier(reader, &whole.name, number + 1);
        reader.model.parameters.push(Parameter { name, value, ..whole.clone() });
        task.parameters.resize(part + 1, value);
        if let Some(place) = varied {
            let target = Target::Parameter(part);
            let varied = Varied { target, shared: true, ..task.varied[place].clone() };
            task.varied.insert(place + 1 + number, varied);
        }
    }
    if let Some(place) = varied {
        task.varied.remove(place);
    }
    Ok(Divided { parameter, parts })
}

/// Name that an expression can hold for a parameter in a record, unlike all names of the document.
fn identifier(reader: &Reader, name: &str, record: usize) -> String {
    let letters = name.chars().map(|letter| if letter.is_alphanumeric() { letter } else { '_' });
    let mut name = format!("{}_in_record_{record}", letters.collect::<String>());
    while reader.model.parameters.iter().any(|known| known.name == name) {
        name.push('_');
    }
    name
}

/// Value of the tied parameter with this index, in SI.
fn value(
    reader: &mut Reader,
    task: &Task,
    divided: &[Divided],
    (tie, index): (&Assignment, usize),
) -> Result<Compiled, Refusal> {
    let what = format!("--tie {}", tie.name);
    let mut text = tie.value.clone();
    for named in of_records(&tie.value).into_iter().rev() {
        let divided = divided.iter().find(|known| reader.model.parameters[known.parameter].name == named.name);
        let part = divided.and_then(|divided| divided.parts.get(named.record - 1));
        text.replace_range(named.range, part.map_or(named.name, |&part| &reader.model.parameters[part].name));
    }
    // A number without a unit has that of the parameter.
    let unit = reader.model.parameters[index].unit.clone();
    if let Ok(number) = text.parse::<f64>() {
        let node = reader.model.graph.constant(unit.to_si(number));
        return Ok(Compiled { node, kind: Kind::Number, unit });
    }
    let mut compiled = reader.expression(&what, &text)?;
    reader.value(&what, &text, &unit, &task.parameters)?;
    let factor = compiled.unit.turning(&unit);
    if factor != 1.0 {
        let graph = &mut reader.model.graph;
        let factor = graph.constant(factor);
        compiled.node = graph.binary(program::Binary::Multiply, compiled.node, factor);
    }
    Ok(Compiled { unit, ..compiled })
}

/// Refuses a value in a record that depends on another parameter which has a value in each, without saying in which.
fn refuse_own_values(
    reader: &Reader,
    task: &Task,
    settings: &FitSettings,
    (tie, value): (&Assignment, &Compiled),
    (divided, record): (&[Divided], usize),
) -> Result<(), Refusal> {
    let name = |index: u32| &reader.model.parameters[index as usize].name;
    let is_own = |index: &u32| {
        let place = *index as usize;
        let varied = task.varied.iter().any(|varied| varied.target == Target::Parameter(place) && !varied.shared);
        let is_shared = settings.share.iter().any(|shared| shared.trim() == *name(*index));
        let fixed = task.records.iter().any(|record| record.fixed.iter().any(|(known, _)| *known == place));
        fixed || varied && !is_shared || divided.iter().any(|known| known.parameter == place)
    };
    match reader.model.depends(value.node).parameters.iter().find(|index| is_own(index)) {
        Some(&own) if task.records.len() > 1 => Err(Refusal::with_hint(
            format!("--tie {}={}: {} has a value in each record", tie.name, tie.value, name(own)),
            format!("say in which record, such as {}:{record}", name(own)),
        )),
        _ => Ok(()),
    }
}

/// Parameters of records in a text: a name, a colon and a number, without blanks.
fn of_records(text: &str) -> Vec<OfRecord<'_>> {
    let mut found = Vec::new();
    let is_name = |letter: char| letter.is_alphanumeric() || "_[]".contains(letter);
    for (colon, _) in text.match_indices(':') {
        let before = &text[..colon];
        let begin = before.trim_end_matches(is_name).len();
        let digits = text[colon + 1..].bytes().take_while(u8::is_ascii_digit).count();
        let end = colon + 1 + digits;
        if let Ok(record) = text[colon + 1..end].parse()
            && text[begin..colon].starts_with(|letter: char| letter.is_alphabetic())
        {
            found.push(OfRecord { range: begin..end, name: &text[begin..colon], record });
        }
    }
    found
}

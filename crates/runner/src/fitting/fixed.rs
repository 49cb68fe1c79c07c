//! `--fix`: parameters that are held, and the offset of the readings that is left out.

use crate::names::Assignment;
use crate::refusal::Refusal;
use crate::values::Reader;
use analysis::fit::Task;
use units::Unit;

/// `--fix y_offset=0`: a fit without an offset of the readings.
pub(super) fn without_offset(reader: &mut Reader, task: &Task, fixed: &Assignment) -> Result<(), Refusal> {
    let number = fixed.value.split('[').next().unwrap_or_default();
    match reader.value("--fix", number, &Unit::dimensionless(), &task.parameters) {
        Ok(0.0) => Ok(()),
        _ => Err(Refusal::with_hint(
            format!("--fix {}={}: an offset can only be held at 0", fixed.name, fixed.value),
            format!("write --fix {}=0, or subtract it from the readings", fixed.name),
        )),
    }
}

/// `--fix NAME=VALUE`, with one value for all records or one per record. NAME is a parameter or `t_origin`.
pub(super) fn fix(reader: &mut Reader, task: &mut Task, fixed: &Assignment) -> Result<(), Refusal> {
    let values = task.parameters.clone();
    let several = listed_values(&fixed.value);
    let clock = reader.model.independent.clone();
    let is_origin = fixed.name == format!("{}_origin", clock.name);
    if several.len() > 1 {
        if several.len() != task.records.len() {
            let count = |n: usize, what: &str| format!("{n} {what}{}", if n == 1 { "" } else { "s" });
            return Err(Refusal::with_hint(
                format!(
                    "--fix {}: {} for {}",
                    fixed.name,
                    count(several.len(), "value"),
                    count(task.records.len(), "record")
                ),
                "give one value for all records or one for each; decimals have a point",
            ));
        }
        for (record, value) in several.iter().enumerate() {
            if is_origin {
                task.records[record].origin = Some(reader.value("--fix", value, &clock.unit, &values)?);
                continue;
            }
            let one = Assignment { name: fixed.name.clone(), value: (*value).to_owned() };
            let assigned = reader.parameter("--fix", &one, &values)?;
            task.records[record].fixed.push(assigned);
        }
        return Ok(());
    }
    if is_origin {
        let reading = reader.value("--fix", &fixed.value, &clock.unit, &values)?;
        task.records.iter_mut().for_each(|record| record.origin = Some(reading));
        return Ok(());
    }
    let (index, value) = reader.parameter("--fix", fixed, &values)?;
    task.parameters[index] = value;
    Ok(())
}

/// Splits a list at the commas outside parentheses.
fn listed_values(text: &str) -> Vec<&str> {
    let mut depth = 0_usize;
    let separates = |c: char| {
        match c {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            _ => {}
        }
        c == ',' && depth == 0
    };
    text.split(separates).map(str::trim).collect()
}

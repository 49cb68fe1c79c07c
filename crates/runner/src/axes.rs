//! `--over`: a parameter and its values.

use crate::names::{Assignment, names_in};
use crate::plan::{Axis, Values};
use crate::refusal::Refusal;
use crate::values::{Reader, within_range};
use document::{Document, Limits};
use units::words;

/// Reads `b in 0..100 [kg/s] step 2` or `h_l = 2, 3, 4 [m]`. `parameters`: values that expressions in the list may use, SI.
pub fn axis(document: &mut Document, text: &str, parameters: &[f64]) -> Result<Axis, Refusal> {
    if let Some((name, values)) = text.split_once('=') {
        return list(document, (name.trim(), values), parameters);
    }
    let (parameter, Limits { low, high, step }) = document::parameter_range(document, text)
        .map_err(|found| Refusal::Expression { setting: "--over".to_owned(), text: text.to_owned(), found })?;
    let own = &document.program.model.parameters[parameter];
    for end in [low, high] {
        within_range(own, end)?;
    }
    // The values of a seed are whole numbers.
    let step = if own.choices == program::Choices::Seed { step.or(Some(1.0)) } else { step };
    Ok(Axis { parameter, values: Values::Range { low, high, step } })
}

/// Reads values after a name. A unit behind the last value holds for all that have none of their own.
fn list(document: &mut Document, (name, values): (&str, &str), parameters: &[f64]) -> Result<Axis, Refusal> {
    let texts = names_in(values);
    let unit = texts.last().and_then(|last| last.find('[').map(|at| &last[at..])).unwrap_or_default();
    let mut reader = Reader { model: &mut document.program.model };
    let (mut parameter, mut read) = (0, Vec::new());
    for text in &texts {
        if text.is_empty() {
            let message = words!("--over {name}: there is a comma without a value");
            return Err(Refusal::Request { message, hint: None });
        }
        let value = if text.contains('[') { (*text).to_owned() } else { format!("{text} {unit}") };
        let assignment = Assignment { name: name.to_owned(), value: value.trim().to_owned() };
        let (index, value) = reader.parameter("--over", &assignment, parameters)?;
        parameter = index;
        read.push(value);
    }
    Ok(Axis { parameter, values: Values::List(read) })
}

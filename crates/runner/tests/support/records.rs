//! Records of damped oscillations, for the test and the durations of fits.

use analysis::fit::{Observation, Record, Task, Varied};
use document::Document;

/// A fit of several records of the level in a U-tube, with errors of 0.1 mm. Each begins at a time of its own, has initial values of
/// its own, and 7 frames more than the one before; the first has `frames`, 30 in a second. All have the same gamma. Fails if
/// the document has no `y`.
pub fn task(document: &Document, records: usize, frames: usize) -> Result<Task, String> {
    let model = &document.program.model;
    let observed = model.lookup("y", 0).ok_or("the document has no y")?;
    let record = |number: usize| {
        let times: Vec<f64> = (0..frames + 7 * number).map(|row| 0.4 * number as f64 + row as f64 / 30.0).collect();
        let level = |(row, time): (usize, &f64)| {
            let since = time - times[0];
            let error = 1e-4 * libm::sin((37 * row * row + 11 * number) as f64);
            0.05 * libm::exp(-0.4 * since) * libm::cos((9.6 + 0.1 * number as f64) * since) + error
        };
        let values = times.iter().enumerate().map(level).collect();
        let name = "y".to_owned();
        let observation =
            Observation { name, observed: observed.clone(), times, values, errors: None, derived_from: None };
        Record { name: format!("record {number}"), observations: vec![observation], ..Record::default() }
    };
    let vary = |&index: &usize| Varied { shared: model.parameters[index].name == "gamma", ..Varied::parameter(index) };
    Ok(Task {
        parameters: model.parameters.iter().map(|parameter| parameter.value).collect(),
        records: (0..records).map(record).collect(),
        varied: document.program.vary.iter().map(vary).collect(),
        ..Task::default()
    })
}

//! Offsets of the readings that a fit varies by default.

use analysis::fit::{Target, Task, Varied, lacks_constant};
use program::Model;

/// One offset for each measured quantity to which the theory adds no constant of its own, unless the values are too few for
/// it. A column that was computed from another one has no zero of its own. `held`: indices of parameters that a person has
/// fixed; a constant among them is one that the theory has.
pub fn default_offsets(model: &Model, task: &Task, held: &[usize]) -> Vec<Varied> {
    let varied = task.varied.iter().filter_map(|varied| match varied.target {
        Target::Parameter(index) => Some(index),
        Target::Origin | Target::Offset(_) => None,
    });
    let constants: Vec<usize> = varied.chain(held.iter().copied()).collect();
    let measured = task.records.iter().flat_map(|record| &record.observations);
    let values: usize = measured.filter(|one| one.derived_from.is_none()).map(|one| one.values.len()).sum();
    let Some(first) = task.records.first() else { return Vec::new() };
    let own = first.observations.iter().enumerate().filter(|(_, one)| one.derived_from.is_none());
    let lacking = own.filter(|(_, one)| lacks_constant(model, &one.observed, &constants));
    let offsets: Vec<Varied> =
        lacking.map(|(place, _)| Varied { target: Target::Offset(place), ..Varied::parameter(0) }).collect();
    let numbers = (task.varied.len() + offsets.len()) * task.records.len();
    if values > numbers { offsets } else { Vec::new() }
}

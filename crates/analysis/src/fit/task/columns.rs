//! Numbers of a search, one per column of its Jacobian: list, starts and bounds.

use super::plan::Plan;
use super::{Observation, Record, Target, Task};
use program::Model;

/// One number of the search: a target, in one record or shared by all.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Column {
    /// Index in [`Task::varied`] and its target; `None` for the scale of a record's film.
    pub varied: Option<(usize, Target)>,
    /// Index of its record; `None` if it is shared.
    pub record: Option<usize>,
}

impl Column {
    /// Target; `None` for the scale of a film.
    pub fn target(&self) -> Option<Target> {
        self.varied.map(|(_, target)| target)
    }

    /// True for the scale of a film.
    pub fn is_scale(&self) -> bool {
        self.varied.is_none()
    }

    /// True if the number acts in this record.
    pub fn belongs_to(&self, record: usize) -> bool {
        self.record.is_none_or(|own| own == record)
    }
}

/// Columns of a task: its varied numbers, then the scales of films.
pub(in crate::fit) fn of(task: &Task) -> Vec<Column> {
    let mut columns = Vec::new();
    for (varied, wanted) in task.varied.iter().enumerate() {
        let varied = Some((varied, wanted.target));
        if wanted.shared || task.records.len() <= 1 {
            columns.push(Column { varied, record: None });
        } else {
            columns.extend((0..task.records.len()).map(|record| Column { varied, record: Some(record) }));
        }
    }
    columns.extend(scales(task));
    columns
}

/// Varied parameters of the model, each once.
pub(in crate::fit) fn parameters(columns: &[Column]) -> Vec<usize> {
    let parameter = |column: &Column| match column.target() {
        Some(Target::Parameter(index)) => Some(index),
        _ => None,
    };
    let mut parameters: Vec<usize> = columns.iter().filter_map(parameter).collect();
    parameters.dedup();
    parameters
}

/// Scales of films: one for each record in which lengths have a known error.
fn scales(task: &Task) -> impl Iterator<Item = Column> + '_ {
    let scaled = |(_, record): &(usize, &Record)| {
        record.scale_error.is_some() && record.observations.iter().any(|one| power_of_length(one) != 0.0)
    };
    task.records.iter().enumerate().filter(scaled).map(|(record, _)| Column { varied: None, record: Some(record) })
}

/// Exponent of the length in the dimension of an observation.
pub(in crate::fit) fn power_of_length(observation: &Observation) -> f64 {
    let dimension = observation.observed.unit.dimension;
    dimension.base().find(|(symbol, _)| *symbol == "m").map_or(0.0, |(_, exponent)| exponent.to_number())
}

/// Bounds of each column, SI: given, else the range of the parameter, else infinite.
pub(in crate::fit) fn bounds(model: &Model, task: &Task, columns: &[Column]) -> Vec<(f64, f64)> {
    let free = (f64::NEG_INFINITY, f64::INFINITY);
    let of_column = |column: &Column| {
        let own = match column.target() {
            Some(Target::Parameter(index)) => model.parameters.get(index).and_then(|parameter| parameter.range),
            Some(Target::Origin | Target::Offset(_)) | None => None,
        };
        let given = column.varied.and_then(|(varied, _)| task.varied[varied].bounds);
        given.or(own).unwrap_or(free)
    };
    columns.iter().map(of_column).collect()
}

/// Start of each column, SI: given, else the value of the parameter, the origin of the plan, 0 for offsets, 1 for film
/// scales.
pub(in crate::fit) fn own_start(task: &Task, columns: &[Column], plans: &[Plan]) -> Vec<f64> {
    let given = |column: &Column| task.varied[column.varied?.0].start;
    let of_column = |column: &Column| match (given(column), column.target()) {
        (Some(start), _) => start,
        (None, Some(Target::Parameter(index))) => task.parameters.get(index).copied().unwrap_or(0.0),
        (None, Some(Target::Origin)) => plans.get(column.record.unwrap_or(0)).map_or(0.0, |plan| plan.origin),
        (None, Some(Target::Offset(_))) => 0.0,
        (None, None) => 1.0,
    };
    columns.iter().map(of_column).collect()
}

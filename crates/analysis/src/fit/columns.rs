//! The numbers of a search, one for each column of its Jacobian: which they are, where they begin, and between what they stay.

use super::plan::Plan;
use super::task::{Target, Task};
use program::Model;

/// One number of the search: a target, in one record or in all.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Column {
    /// Which of [`Task::varied`].
    pub varied: usize,
    /// What it is.
    pub target: Target,
    /// The record it belongs to; `None` if it is shared.
    pub record: Option<usize>,
}

impl Column {
    /// Whether it counts in this record.
    pub fn belongs_to(&self, record: usize) -> bool {
        self.record.is_none_or(|own| own == record)
    }
}

/// The numbers that a task asks for.
pub(super) fn of(task: &Task) -> Vec<Column> {
    let mut columns = Vec::new();
    for (varied, wanted) in task.varied.iter().enumerate() {
        let target = wanted.target;
        if wanted.shared || task.records.len() <= 1 {
            columns.push(Column { varied, target, record: None });
        } else {
            columns.extend((0..task.records.len()).map(|record| Column { varied, target, record: Some(record) }));
        }
    }
    columns
}

/// Least and greatest value of each: given, else the parameter's own range, else none.
pub(super) fn bounds(model: &Model, task: &Task, columns: &[Column]) -> Vec<(f64, f64)> {
    let free = (f64::NEG_INFINITY, f64::INFINITY);
    let of_column = |column: &Column| {
        let own = match column.target {
            Target::Parameter(index) => model.parameters.get(index).and_then(|parameter| parameter.range),
            Target::Origin | Target::Offset(_) => None,
        };
        task.varied[column.varied].bounds.or(own).unwrap_or(free)
    };
    columns.iter().map(of_column).collect()
}

/// Where the search begins: the given starts, else the parameters' own values, 0 for offsets.
pub(super) fn own_start(task: &Task, columns: &[Column], plans: &[Plan]) -> Vec<f64> {
    let of_column = |column: &Column| match (task.varied[column.varied].start, column.target) {
        (Some(start), _) => start,
        (None, Target::Parameter(index)) => task.parameters.get(index).copied().unwrap_or(0.0),
        (None, Target::Origin) => plans.get(column.record.unwrap_or(0)).map_or(0.0, |plan| plan.origin),
        (None, Target::Offset(_)) => 0.0,
    };
    columns.iter().map(of_column).collect()
}

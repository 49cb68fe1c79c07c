//! Checks of a task before its fit.

use super::plan::{Layout, Plan, independent_values};
use super::{FitError, Record, Target, Task};

/// Checks the varied numbers, their bounds and starts, and the values of parameters.
pub(in crate::fit) fn task(task: &Task) -> Result<(), FitError> {
    if task.varied.is_empty() {
        return Err(FitError::NothingVaried);
    }
    for (place, varied) in task.varied.iter().enumerate() {
        let fixed = |record: &Record| record.fixed.iter().any(|(index, _)| varied.target == Target::Parameter(*index));
        if task.varied[..place].iter().any(|other| other.target == varied.target) || task.records.iter().any(fixed) {
            return Err(FitError::VariedTwice(place));
        }
        if varied.bounds.is_some_and(|(low, high)| low.is_nan() || high.is_nan() || low >= high) {
            return Err(FitError::BadBounds(place));
        }
        if varied.start.is_some_and(|start| !start.is_finite()) {
            return Err(FitError::BadStart(place));
        }
    }
    let bad = |record: &Record| record.scale_error.is_some_and(|error| !(error > 0.0 && error.is_finite()));
    if let Some(record) = task.records.iter().position(bad) {
        return Err(FitError::BadScaleError(record));
    }
    let fixed = task.records.iter().flat_map(|record| &record.fixed).copied();
    if let Some((index, _)) =
        task.parameters.iter().copied().enumerate().chain(fixed).find(|(_, value)| !value.is_finite())
    {
        return Err(FitError::BadValue(index));
    }
    Ok(())
}

/// Checks that there are enough independent values for the varied numbers.
pub(in crate::fit) fn points(layout: &Layout, task: &Task, plans: &[Plan], varied: usize) -> Result<(), FitError> {
    if plans.iter().all(|plan| plan.points.is_empty()) {
        return Err(FitError::NothingObserved);
    }
    if let Some(record) = plans.iter().position(|plan| plan.points.is_empty()) {
        return Err(FitError::RecordEmpty(record));
    }
    layout.check_errors(task)?;
    let independent = independent_values(plans);
    if varied as f64 > independent {
        return Err(FitError::TooFew { values: independent as usize, varied });
    }
    Ok(())
}

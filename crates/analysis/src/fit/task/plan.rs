//! Measured values of a record, sorted by time for the comparison with the model's curve.

use super::{FitError, Observation, Record, Task};
use program::NodeId;

/// Measured value.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    /// Index of its time in [`Plan::times`].
    pub row: usize,
    /// Index of the observation in its record.
    pub observation: usize,
    /// Measured value, SI.
    pub value: f64,
    /// Weight of the residual from its error.
    pub weight: f64,
    /// Weight of the residual from a robust loss; else 1.
    pub trust: f64,
    /// Share of an independent value: 1/m if m columns hold the same information.
    pub share: f64,
    /// True if it was measured, false if it was computed from another column.
    pub measured: bool,
    /// True if a person has left it out of the fit.
    pub excluded: bool,
}

impl Point {
    /// Total weight of the residual.
    pub fn factor(&self) -> f64 {
        self.weight * self.trust
    }
}

/// Points of one record, ordered by time.
#[derive(Clone, Debug, Default)]
pub(crate) struct Plan {
    /// Readings of the clock, SI, ascending and distinct.
    pub times: Vec<f64>,
    /// Ordered by row, then by observation.
    pub points: Vec<Point>,
    /// For each observation of the record, its index among the expressions of the curve.
    pub expressions: Vec<usize>,
    /// Reading of the clock at the model's 0, where it is not varied.
    pub origin: f64,
}

impl Observation {
    /// Times and values without gaps, each with its index.
    fn rows(&self) -> impl Iterator<Item = (usize, f64, f64)> {
        let rows = self.times.iter().copied().zip(self.values.iter().copied()).enumerate();
        rows.map(|(place, (time, value))| (place, time, value))
            .filter(|(_, time, value)| time.is_finite() && value.is_finite())
    }

    /// Given error of a value; `None` if it is missing, not finite or not greater than 0.
    fn error(&self, place: usize) -> Option<f64> {
        let error = self.errors.as_ref()?.get(place).copied();
        error.filter(|error| error.is_finite() && *error > 0.0)
    }
}

impl Record {
    /// Time between the first and the last reading of the clock, SI; 0 without one.
    pub(in crate::fit) fn duration(&self) -> f64 {
        let times = self.observations.iter().flat_map(|observation| &observation.times).filter(|time| time.is_finite());
        let (low, high) =
            times.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &time| (low.min(time), high.max(time)));
        if low < high { high - low } else { 0.0 }
    }

    /// All values without gaps: true if the value is excluded, and its time.
    fn rows(&self) -> impl Iterator<Item = (bool, f64)> {
        self.observations.iter().enumerate().flat_map(move |(observation, one)| {
            one.rows().map(move |(place, time, _)| (self.excludes(observation, place), time))
        })
    }
}

/// Assignment of measured values to the curve: its expressions, and the position of the model's 0 on the clock.
#[derive(Clone, Debug)]
pub(crate) struct Layout {
    /// Expressions that the curve evaluates.
    pub expressions: Vec<NodeId>,
    /// True if the model's 0 may lie at any reading of the clock.
    pub autonomous: bool,
    /// One per record: true if its clock begins late and the model's 0 is moved to its beginning.
    pub moved: Vec<bool>,
    /// True if the model has no values before its 0: equations of motion are not integrated back from their initial values.
    /// Exception: the origin is varied, and the system is at rest before it.
    pub forwards: bool,
}

impl Layout {
    /// Plans of all records: with `all` points, or those of the fitted part. The weight is 1/error, or 1, times the square
    /// root of the share.
    pub fn plans(&self, task: &Task, all: bool) -> Vec<Plan> {
        let plan = |place: usize| {
            let origin = self.fixed_origin(task, place);
            let earliest = self.earliest(origin);
            let wanted = |excluded: bool, time: f64| all || !excluded && task.covers(time);
            self.plan_of(&task.records[place], origin, |excluded, time| time >= earliest && wanted(excluded, time))
        };
        (0..task.records.len()).map(plan).collect()
    }

    /// First reading of a record's clock at which the model has values, if its 0 is at `origin`.
    fn earliest(&self, origin: f64) -> f64 {
        if self.forwards { origin } else { f64::NEG_INFINITY }
    }

    /// Reading of the clock at the model's 0, where it is not varied.
    fn fixed_origin(&self, task: &Task, place: usize) -> f64 {
        let record = &task.records[place];
        let moves = self.autonomous || self.moved.get(place).is_some_and(|moved| *moved);
        let times = record.rows().filter(|(excluded, time)| !excluded && task.covers(*time));
        let first = times.map(|(_, time)| time).fold(f64::INFINITY, f64::min);
        match record.origin {
            Some(origin) => origin,
            None if moves && first.is_finite() => first,
            None => 0.0,
        }
    }

    /// Measured values of an observation before the model has values, as (time, value), in the order of time.
    pub fn too_early(&self, task: &Task, record: usize, observation: usize) -> Vec<(f64, f64)> {
        let earliest = self.earliest(self.fixed_origin(task, record));
        let record = &task.records[record];
        let rows = record.observations[observation].rows().map(|(_, time, value)| (time, value));
        let mut early: Vec<(f64, f64)> = rows.filter(|(time, _)| *time < earliest).collect();
        early.sort_by(|one, other| one.0.total_cmp(&other.0));
        early
    }

    /// Checks that where errors are given, all values in the fitted part have one.
    pub fn check_errors(&self, task: &Task) -> Result<(), FitError> {
        for (record, of_record) in task.records.iter().enumerate() {
            let earliest = self.earliest(self.fixed_origin(task, record));
            let fitted = |time: f64| time >= earliest && task.covers(time);
            for (observation, one) in of_record.observations.iter().enumerate().filter(|(_, one)| one.errors.is_some())
            {
                let is_fitted = |place: usize, time: f64| fitted(time) && !of_record.excludes(observation, place);
                let bad =
                    || one.rows().filter(|(place, time, _)| is_fitted(*place, *time) && one.error(*place).is_none());
                if let Some((_, first, _)) = bad().next() {
                    return Err(FitError::BadErrors { record, observation, count: bad().count(), first });
                }
            }
        }
        Ok(())
    }

    /// Plan of the values for which `usable` is true; it gets whether a value is excluded, and its time.
    fn plan_of(&self, record: &Record, origin: f64, usable: impl Fn(bool, f64) -> bool) -> Plan {
        let mut plan = Plan { origin, ..Plan::default() };
        let rows = record.rows().filter(|(excluded, time)| usable(*excluded, *time));
        plan.times = rows.map(|(_, time)| time).collect();
        plan.times.sort_unstable_by(f64::total_cmp);
        plan.times.dedup();
        for (index, observation) in record.observations.iter().enumerate() {
            let node = observation.observed.node;
            plan.expressions.push(self.expressions.iter().position(|known| *known == node).unwrap_or(0));
            let measured = independent(record, index) == index;
            let share = 1.0 / equal(record, index) as f64;
            for (place, time, value) in observation.rows() {
                let excluded = record.excludes(index, place);
                if !usable(excluded, time) {
                    continue;
                }
                // A value without an error lies outside the fitted part, where weights do not count.
                let weight = 1.0 / observation.error(place).unwrap_or(1.0);
                let row = plan.times.partition_point(|known| *known < time);
                let weight = weight * share.sqrt();
                let point = Point { row, observation: index, value, weight, trust: 1.0, share, measured, excluded };
                plan.points.push(point);
            }
        }
        plan.points.sort_by_key(|point| (point.row, point.observation));
        plan
    }
}

/// Source of an observation: follows `derived_from` to its end.
pub(crate) fn independent(record: &Record, mut index: usize) -> usize {
    // Bounded, because the chain may be circular.
    for _ in 0..record.observations.len() {
        match record.observations[index].derived_from {
            Some(source) if source < record.observations.len() && source != index => index = source,
            _ => break,
        }
    }
    index
}

/// Number of observations of a record with the same source as this one, itself included.
pub(crate) fn equal(record: &Record, index: usize) -> usize {
    let root = independent(record, index);
    (0..record.observations.len()).filter(|&other| independent(record, other) == root).count()
}

/// Number of independent values among the points.
pub(crate) fn independent_values(plans: &[Plan]) -> f64 {
    let shares = plans.iter().flat_map(|plan| &plan.points).map(|point| point.share);
    shares.sum::<f64>().round()
}

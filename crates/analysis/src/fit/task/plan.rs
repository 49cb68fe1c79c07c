//! The measured values of a record in the order in which the model's curve meets them.

use super::{FitError, Observation, Record, Task};
use program::NodeId;

/// A measured value.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    /// Its row among the times of the record.
    pub row: usize,
    /// Which observation of the record.
    pub observation: usize,
    /// The value.
    pub value: f64,
    /// What its residual is multiplied by, by its error.
    pub weight: f64,
    /// The same by its size, with a robust loss; else 1.
    pub trust: f64,
    /// How much of an independent value it is: 1/m if m columns tell the same.
    pub share: f64,
    /// Whether it was measured, and not computed from another column.
    pub measured: bool,
}

impl Point {
    /// What its residual is multiplied by.
    pub fn factor(&self) -> f64 {
        self.weight * self.trust
    }
}

/// The points of one record, ordered by time.
#[derive(Clone, Debug, Default)]
pub(crate) struct Plan {
    /// The clock's readings, ascending, each once.
    pub times: Vec<f64>,
    /// Ordered by row, then by observation.
    pub points: Vec<Point>,
    /// For each observation of the record: where among the curve's expressions it is.
    pub expressions: Vec<usize>,
    /// The clock's reading at the model's 0, where it is not varied.
    pub origin: f64,
}

impl Observation {
    /// Times and values without gaps, each with its place.
    fn rows(&self) -> impl Iterator<Item = (usize, f64, f64)> {
        let rows = self.times.iter().copied().zip(self.values.iter().copied()).enumerate();
        rows.map(|(place, (time, value))| (place, time, value))
            .filter(|(_, time, value)| time.is_finite() && value.is_finite())
    }

    /// The given error of a value, if it can be used as one.
    fn error(&self, place: usize) -> Option<f64> {
        let error = self.errors.as_ref()?.get(place).copied();
        error.filter(|error| error.is_finite() && *error > 0.0)
    }
}

/// Which of the measured values are fitted, and where the model's 0 lies on their clock.
#[derive(Clone, Debug)]
pub(crate) struct Layout {
    /// The expressions that the curve gives.
    pub expressions: Vec<NodeId>,
    /// Whether records may begin at any reading of the clock.
    pub autonomous: bool,
    /// Whether the model has no values before its 0: equations of motion are not followed to times before their initial values,
    /// except where the origin is varied, and nothing has moved before it.
    pub forwards: bool,
}

impl Layout {
    /// The points whose times are `inside`, each with the weight of its given error, or 1, by the root of its share.
    pub fn plans(&self, task: &Task, inside: impl Fn(f64) -> bool) -> Vec<Plan> {
        let plan = |record| {
            let origin = self.fixed_origin(task, record);
            let earliest = self.earliest(origin);
            self.plan_of(record, origin, |time| time >= earliest && inside(time))
        };
        task.records.iter().map(plan).collect()
    }

    /// The first reading of a record's clock at which the model has values, where its 0 is at `origin`.
    fn earliest(&self, origin: f64) -> f64 {
        if self.forwards { origin } else { f64::NEG_INFINITY }
    }

    /// The clock's reading at the model's 0, where it is not varied.
    fn fixed_origin(&self, task: &Task, record: &Record) -> f64 {
        let times = record.observations.iter().flat_map(|one| one.rows().map(|(_, time, _)| time));
        let first = times.filter(|time| task.covers(*time)).fold(f64::INFINITY, f64::min);
        match record.origin {
            Some(origin) => origin,
            None if self.autonomous && first.is_finite() => first,
            None => 0.0,
        }
    }

    /// The measured values of an observation that are too early for the model to have a value beside them: times and values,
    /// in the order of time.
    pub fn too_early(&self, task: &Task, record: usize, observation: usize) -> Vec<(f64, f64)> {
        let record = &task.records[record];
        let earliest = self.earliest(self.fixed_origin(task, record));
        let rows = record.observations[observation].rows().map(|(_, time, value)| (time, value));
        let mut early: Vec<(f64, f64)> = rows.filter(|(time, _)| *time < earliest).collect();
        early.sort_by(|one, other| one.0.total_cmp(&other.0));
        early
    }

    /// Checks that all values in the fitted part have errors where errors are given.
    pub fn check_errors(&self, task: &Task) -> Result<(), FitError> {
        for (record, of_record) in task.records.iter().enumerate() {
            let earliest = self.earliest(self.fixed_origin(task, of_record));
            let fitted = |time: f64| time >= earliest && task.covers(time);
            for (observation, one) in of_record.observations.iter().enumerate().filter(|(_, one)| one.errors.is_some())
            {
                let bad = || one.rows().filter(|(place, time, _)| fitted(*time) && one.error(*place).is_none());
                if let Some((_, first, _)) = bad().next() {
                    return Err(FitError::BadErrors { record, observation, count: bad().count(), first });
                }
            }
        }
        Ok(())
    }

    fn plan_of(&self, record: &Record, origin: f64, usable: impl Fn(f64) -> bool) -> Plan {
        let mut plan = Plan { origin, ..Plan::default() };
        let times = record.observations.iter().flat_map(|one| one.rows().map(|(_, time, _)| time));
        plan.times = times.filter(|time| usable(*time)).collect();
        plan.times.sort_unstable_by(f64::total_cmp);
        plan.times.dedup();
        for (index, observation) in record.observations.iter().enumerate() {
            let node = observation.observed.node;
            plan.expressions.push(self.expressions.iter().position(|known| *known == node).unwrap_or(0));
            let measured = independent(record, index) == index;
            let share = 1.0 / equal(record, index) as f64;
            for (place, time, value) in observation.rows().filter(|(_, time, _)| usable(*time)) {
                // Without an error it is outside the fitted part, where weights do not count.
                let weight = 1.0 / observation.error(place).unwrap_or(1.0);
                let row = plan.times.partition_point(|known| *known < time);
                let weight = weight * share.sqrt();
                plan.points.push(Point { row, observation: index, value, weight, trust: 1.0, share, measured });
            }
        }
        plan.points.sort_by_key(|point| (point.row, point.observation));
        plan
    }
}

/// The observation in the end of the chain of those from which each is computed.
pub(crate) fn independent(record: &Record, mut index: usize) -> usize {
    // A chain that leads in a circle ends somewhere.
    for _ in 0..record.observations.len() {
        match record.observations[index].derived_from {
            Some(source) if source < record.observations.len() && source != index => index = source,
            _ => break,
        }
    }
    index
}

/// How many observations of a record tell the same as this one, itself among them.
pub(crate) fn equal(record: &Record, index: usize) -> usize {
    let root = independent(record, index);
    (0..record.observations.len()).filter(|&other| independent(record, other) == root).count()
}

/// How many of the points no other one repeats.
pub(crate) fn independent_values(plans: &[Plan]) -> f64 {
    let shares = plans.iter().flat_map(|plan| &plan.points).map(|point| point.share);
    shares.sum::<f64>().round()
}

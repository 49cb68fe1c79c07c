//! The measured values of a record in the order in which the model's curve meets them.

use super::problem::Problem;
use super::task::{Record, Target};

/// A measured value.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    /// Its row among the times of the record.
    pub row: usize,
    /// Which observation of the record.
    pub observation: usize,
    /// The value.
    pub value: f64,
    /// What its residual is multiplied by.
    pub weight: f64,
    /// How much of an independent value it is: 1/m if m columns tell the same.
    pub share: f64,
    /// Whether it was measured, and not computed from another column.
    pub measured: bool,
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

impl Problem {
    /// The points whose times are `inside`, each with the weight of its given error, or 1, by the root of its share.
    pub fn plan(&self, inside: impl Fn(f64) -> bool) -> Vec<Plan> {
        let varies_origin = self.columns.iter().any(|column| column.target == Target::Origin);
        let plan = |record| {
            let origin = self.fixed_origin(record);
            let earliest = if self.curve.has_states() && !varies_origin { origin } else { f64::NEG_INFINITY };
            self.plan_of(record, origin, |time| time.is_finite() && time >= earliest && inside(time))
        };
        self.task.records.iter().map(plan).collect()
    }

    /// The clock's reading at the model's 0, where it is not varied.
    fn fixed_origin(&self, record: &Record) -> f64 {
        let times = record.observations.iter().flat_map(|observation| &observation.times);
        let first = times.copied().filter(|time| time.is_finite()).fold(f64::INFINITY, f64::min);
        match record.origin {
            Some(origin) => origin,
            None if self.autonomous && first.is_finite() => first,
            None => 0.0,
        }
    }

    fn plan_of(&self, record: &Record, origin: f64, usable: impl Fn(f64) -> bool) -> Plan {
        let mut plan = Plan { origin, ..Plan::default() };
        plan.times = record
            .observations
            .iter()
            .flat_map(|observation| observation.times.iter().zip(&observation.values))
            .filter(|(time, value)| value.is_finite() && usable(**time))
            .map(|(time, _)| *time)
            .collect();
        plan.times.sort_unstable_by(f64::total_cmp);
        plan.times.dedup();
        for (index, observation) in record.observations.iter().enumerate() {
            let node = observation.observed.node;
            plan.expressions.push(self.expressions.iter().position(|known| *known == node).unwrap_or(0));
            let measured = witness(record, index) == index;
            let share = 1.0 / alike(record, index) as f64;
            for (place, (&time, &value)) in observation.times.iter().zip(&observation.values).enumerate() {
                if !(value.is_finite() && usable(time)) {
                    continue;
                }
                let weight = match observation.errors.as_ref().and_then(|errors| errors.get(place)) {
                    Some(&error) if error > 0.0 => 1.0 / error,
                    Some(_) => continue,
                    None => 1.0,
                };
                let row = plan.times.partition_point(|known| *known < time);
                let weight = weight * share.sqrt();
                plan.points.push(Point { row, observation: index, value, weight, share, measured });
            }
        }
        plan.points.sort_by_key(|point| (point.row, point.observation));
        plan
    }
}

/// The observation in the end of the chain of those from which each is computed.
pub(crate) fn witness(record: &Record, mut index: usize) -> usize {
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
pub(crate) fn alike(record: &Record, index: usize) -> usize {
    let root = witness(record, index);
    (0..record.observations.len()).filter(|&other| witness(record, other) == root).count()
}

//! The residuals of a task: measured values beside the model's, weighted, with derivatives by every varied number.

use super::curve::Curve;
use super::linear::Jacobian;
use super::plan::{Plan, Point};
use super::search::Residuals;
use super::task::{FitError, Record, Target, Task};
use super::{MOST_VALUES, MOST_VARIED};
use program::{Model, NodeId};
use std::sync::Arc;

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

/// A task made ready.
#[derive(Clone, Debug)]
pub(crate) struct Problem {
    /// The model's curve.
    pub curve: Curve,
    /// The task.
    pub task: Task,
    /// The numbers of the search.
    pub columns: Vec<Column>,
    /// The expressions that the curve gives.
    pub expressions: Vec<NodeId>,
    /// Whether records may begin at any reading of the clock.
    pub autonomous: bool,
    /// What is fitted, by record.
    pub plans: Arc<Vec<Plan>>,
    /// Model times are computed here.
    clock: Vec<f64>,
}

impl Problem {
    /// Checks a task and makes it ready.
    pub fn new(model: &Model, task: Task) -> Result<Self, FitError> {
        if task.varied.is_empty() {
            return Err(FitError::NothingVaried);
        }
        for (place, varied) in task.varied.iter().enumerate() {
            let fixed =
                |record: &Record| record.fixed.iter().any(|(index, _)| varied.target == Target::Parameter(*index));
            if task.varied[..place].iter().any(|other| other.target == varied.target) || task.records.iter().any(fixed)
            {
                return Err(FitError::VariedTwice(place));
            }
            if varied.bounds.is_some_and(|(low, high)| low.is_nan() || high.is_nan() || low >= high) {
                return Err(FitError::BadBounds(place));
            }
            if varied.start.is_some_and(|start| !start.is_finite()) {
                return Err(FitError::BadStart(place));
            }
        }
        let fixed = task.records.iter().flat_map(|record| &record.fixed).copied();
        if let Some((index, _)) =
            task.parameters.iter().copied().enumerate().chain(fixed).find(|(_, value)| !value.is_finite())
        {
            return Err(FitError::BadValue(index));
        }
        let columns = columns(&task);
        let mut expressions: Vec<NodeId> = Vec::new();
        let mut values = 0;
        for observation in task.records.iter().flat_map(|record| &record.observations) {
            if !expressions.contains(&observation.observed.node) {
                expressions.push(observation.observed.node);
            }
            values += observation.values.len();
        }
        if values > MOST_VALUES || columns.len() > MOST_VARIED {
            return Err(FitError::TooLarge);
        }
        let targets: Vec<Target> = task.varied.iter().map(|varied| varied.target).collect();
        let duration = task.records.iter().map(duration).fold(0.0, f64::max);
        let curve = Curve::new(model, &expressions, &targets, &task.parameters, (task.method, duration))
            .map_err(FitError::Model)?;
        let autonomous = model.is_autonomous();
        let mut problem =
            Self { curve, autonomous, columns, expressions, plans: Arc::default(), clock: Vec::new(), task };
        problem.plans = Arc::new(problem.plan(|time| problem.task.covers(time)));
        problem.check()?;
        Ok(problem)
    }

    fn check(&self) -> Result<(), FitError> {
        let points: usize = self.plans.iter().map(|plan| plan.points.len()).sum();
        if points == 0 {
            return Err(FitError::NothingObserved);
        }
        if let Some(record) = self.plans.iter().position(|plan| plan.points.is_empty()) {
            return Err(FitError::RecordEmpty(record));
        }
        self.check_errors()?;
        let independent = self.independent_values();
        if (self.columns.len() as f64) > independent {
            return Err(FitError::TooFew { values: independent as usize, varied: self.columns.len() });
        }
        Ok(())
    }

    /// How many values are fitted that no other one repeats.
    pub fn independent_values(&self) -> f64 {
        let shares = self.plans.iter().flat_map(|plan| &plan.points).map(|point| point.share);
        shares.sum::<f64>().round()
    }

    /// All parameters of the model in a record, with the varied ones from `x`.
    pub fn parameters(&self, record: usize, x: &[f64]) -> Vec<f64> {
        let mut parameters = self.task.parameters.clone();
        for &(index, value) in &self.task.records[record].fixed {
            if let Some(parameter) = parameters.get_mut(index) {
                *parameter = value;
            }
        }
        for (column, &value) in self.columns.iter().zip(x) {
            if let Target::Parameter(index) = column.target
                && column.belongs_to(record)
                && let Some(parameter) = parameters.get_mut(index)
            {
                *parameter = value;
            }
        }
        parameters
    }

    /// Where the search begins: the given starts, else the parameters' own values, 0 for offsets.
    pub fn own_start(&self) -> Vec<f64> {
        self.columns
            .iter()
            .map(|column| match (self.task.varied[column.varied].start, column.target) {
                (Some(start), _) => start,
                (None, Target::Parameter(index)) => self.task.parameters.get(index).copied().unwrap_or(0.0),
                (None, Target::Origin) => self.plans.get(column.record.unwrap_or(0)).map_or(0.0, |plan| plan.origin),
                (None, Target::Offset(_)) => 0.0,
            })
            .collect()
    }

    /// The residuals of all points of `plans`, model minus measured, times weight, with their derivatives.
    pub fn residuals(&mut self, plans: &[Plan], x: &[f64], residuals: &mut [f64], jacobian: &mut Jacobian) -> bool {
        let mut base = 0;
        for (record, plan) in plans.iter().enumerate() {
            if !self.record_residuals(record, plan, x, base, residuals, jacobian) {
                return false;
            }
            base += plan.points.len();
        }
        residuals.iter().all(|value| value.is_finite())
    }

    /// Those of one record, from row `base` on. False if the solution does not reach all points; only those that it reaches
    /// are then set.
    pub fn record_residuals(
        &mut self,
        record: usize,
        plan: &Plan,
        x: &[f64],
        base: usize,
        residuals: &mut [f64],
        jacobian: &mut Jacobian,
    ) -> bool {
        let stride = self.curve.stride();
        let parameters = self.parameters(record, x);
        let origin = self.origin(record, plan, x);
        // Where the origin is varied, nothing has moved before it.
        let earliest = if self.curve.has_states() { 0.0 } else { f64::NEG_INFINITY };
        self.clock.clear();
        self.clock.extend(plan.times.iter().map(|time| (time - origin).max(earliest)));
        let rows = self.clock.len();
        let known = self.curve.follow(&parameters, &self.clock);
        let points = &plan.points[..plan.points.partition_point(|point| point.row < known)];
        let values = self.curve.values();
        let place = |point: &Point, column| (plan.expressions[point.observation] * stride + column) * rows + point.row;
        let residuals = &mut residuals[base..][..points.len()];
        for (residual, point) in residuals.iter_mut().zip(points) {
            *residual = values[place(point, 0)];
        }
        for (number, column) in self.columns.iter().enumerate() {
            let slopes = &mut jacobian.column_mut(number)[base..][..points.len()];
            let rows = slopes.iter_mut().zip(points);
            match column.target {
                _ if !column.belongs_to(record) => slopes.fill(0.0),
                Target::Parameter(index) => {
                    let of_parameter = self.curve.place(index);
                    rows.for_each(|(slope, point)| *slope = point.factor() * values[place(point, of_parameter)]);
                }
                Target::Origin => {
                    // What has not moved yet does not begin to move where the origin does.
                    let moves = |point: &Point| plan.times[point.row] - origin >= earliest;
                    rows.for_each(|(slope, point)| {
                        *slope = if moves(point) { point.factor() * -values[place(point, stride - 1)] } else { 0.0 };
                    });
                }
                Target::Offset(observation) => {
                    for ((slope, point), residual) in rows.zip(residuals.iter_mut()) {
                        let own = point.observation == observation;
                        *slope = if own { point.factor() } else { 0.0 };
                        *residual += if own { x[number] } else { 0.0 };
                    }
                }
            }
        }
        for (residual, point) in residuals.iter_mut().zip(points) {
            *residual = point.factor() * (*residual - point.value);
        }
        known == rows
    }

    /// The columns in which the residuals are linear, all of them together.
    pub fn linear_columns(&self) -> Vec<usize> {
        let linear = |target| match target {
            Target::Parameter(index) => self.curve.is_linear_in(index),
            Target::Offset(_) => true,
            Target::Origin => false,
        };
        (0..self.columns.len()).filter(|&number| linear(self.columns[number].target)).collect()
    }

    /// The clock's reading at the model's 0.
    pub fn origin(&self, record: usize, plan: &Plan, x: &[f64]) -> f64 {
        let varied =
            self.columns.iter().zip(x).find(|(column, _)| column.target == Target::Origin && column.belongs_to(record));
        varied.map_or(plan.origin, |(_, value)| *value)
    }
}

fn columns(task: &Task) -> Vec<Column> {
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

fn duration(record: &Record) -> f64 {
    let times = record.observations.iter().flat_map(|observation| &observation.times).filter(|time| time.is_finite());
    let (low, high) =
        times.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &time| (low.min(time), high.max(time)));
    if low < high { high - low } else { 0.0 }
}

/// The part of a problem that a search works on.
pub(crate) struct Window<'a> {
    /// The problem.
    pub problem: &'a mut Problem,
    /// What is fitted.
    pub plans: &'a [Plan],
}

impl Residuals for Window<'_> {
    fn evaluate(&mut self, x: &[f64], residuals: &mut [f64], jacobian: &mut Jacobian) -> bool {
        self.problem.residuals(self.plans, x, residuals, jacobian)
    }

    fn linear(&self) -> Vec<usize> {
        self.problem.linear_columns()
    }
}

//! Residuals of a task: weighted differences of the values of the model and the measured ones, with derivatives with
//! respect to every varied number.

use super::curve::{self, Curve};
use super::late;
use super::tones::Tones;
use crate::fit::lanes::Sought;
use crate::fit::linear::Jacobian;
use crate::fit::task::columns;
use crate::fit::task::columns::Column;
use crate::fit::task::plan;
use crate::fit::task::plan::{Layout, Plan, Point};
use crate::fit::task::scale;
use crate::fit::task::scale::Prior;
use crate::fit::task::tied;
use crate::fit::task::tied::Ties;
use crate::fit::task::{FitError, Record, Target, Task};
use crate::fit::task::{check, weights};
use crate::fit::{MOST_VALUES, MOST_VARIED};
use program::{Model, NodeId};
use std::sync::Arc;
use units::words;

/// Task with everything needed to compute its residuals.
#[derive(Clone, Debug)]
pub(crate) struct Problem {
    /// Model without tables, buttons, texts and sizes.
    pub model: Model,
    /// Curve of the model.
    pub curve: Curve,
    /// Task of the fit, with tied parameters replaced.
    pub task: Task,
    /// Values of the tied parameters.
    pub ties: Ties,
    /// Numbers of the search.
    pub columns: Vec<Column>,
    /// Bounds of each column, SI: given, else the range of the parameter, else infinite.
    pub bounds: Vec<(f64, f64)>,
    /// Start of each column, SI: given, else the value of the parameter, the origin of the plan, 0 for offsets, 1 for film
    /// scales.
    pub own: Vec<f64>,
    /// Sinusoids written in the model.
    pub tones: Tones,
    /// Assignment of measured values to the curve.
    pub layout: Layout,
    /// Fitted values, one plan per record.
    pub plans: Arc<Vec<Plan>>,
    /// Weighted sum of squares about the mean of each observation.
    pub total: f64,
    /// Standard deviation of a weighted residual, the weight of the priors of scales; 1 where errors are given.
    pub deviation: f64,
    /// Index in [`curve::TOLERANCES`], for equations of motion.
    precision: usize,
    /// True if searches may stop at a coarser tolerance.
    rough: bool,
    /// Buffer for the times of the model.
    clock: Vec<f64>,
    /// Buffer for the points of a record: place of each in the first column of the curve's values, and its total weight.
    places: Vec<(usize, f64)>,
}

/// Greatest number of values that solutions computed side by side have together: 32 MB.
const MOST_NUMBERS: usize = 4_000_000;

impl Problem {
    /// Convergence tolerance for formulas: relative decrease of the sum of squares.
    const TOLERANCE: f64 = 1e-18;
    /// Convergence tolerances for equations of motion, one per tolerance of the curve: their solutions carry the error of
    /// the integration.
    const TOLERANCES_OF_MOTION: [f64; curve::TOLERANCES.len()] = [1e-8, 1e-10, 1e-12];

    /// Checks and prepares a task.
    pub fn new(model: &Model, mut task: Task) -> Result<Self, FitError> {
        check::task(&task)?;
        let (ref model, ties) = tied::replace(model, &mut task)?;
        if model.is_random() {
            return Err(FitError::Model(words(
                "a model that draws at random is not fitted: each seed gives another curve",
            )));
        }
        let columns = columns::of(&task);
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
        let duration = task.records.iter().map(Record::duration).fold(0.0, f64::max);
        let curve = Curve::new(model, &expressions, &targets, &task.parameters, (task.method, duration))
            .map_err(FitError::Model)?;
        let varies_origin = targets.contains(&Target::Origin);
        let forwards = curve.has_states() && !varies_origin;
        let varied: Vec<usize> = columns::parameters(&columns);
        let tones = Tones::new(model, &expressions, &varied);
        let mut layout = Layout { expressions, autonomous: model.is_autonomous(), moved: Vec::new(), forwards };
        let bounds = columns::bounds(model, &task, &columns);
        if !layout.autonomous {
            let own = columns::own_start(&task, &columns, &[]);
            let moves = |place: usize| {
                let numbers = (&columns[..], &bounds[..], &own[..]);
                task.records[place].origin.is_none()
                    && if varies_origin {
                        late::span(&task.records[place]).is_some()
                    } else {
                        late::may_move(model, &layout.expressions, &task, numbers, place)
                    }
            };
            layout.moved = (0..task.records.len()).map(moves).collect();
        }
        let plans = layout.plans(&task, false);
        check::points(&layout, &task, &plans, columns.iter().filter(|column| !column.is_scale()).count())?;
        let mut problem = Self {
            model: curve::bare(model),
            bounds,
            own: columns::own_start(&task, &columns, &plans),
            curve,
            task,
            ties,
            columns,
            tones,
            layout,
            plans: Arc::new(plans),
            total: 0.0,
            deviation: 1.0,
            precision: 0,
            rough: false,
            clock: Vec::new(),
            places: Vec::new(),
        };
        problem.weigh(&problem.spread());
        Ok(problem)
    }

    /// All values of the records, also those that are not fitted.
    pub fn whole_plans(&self) -> Vec<Plan> {
        self.layout.plans(&self.task, true)
    }

    /// Number of independent fitted values.
    pub fn independent_values(&self) -> f64 {
        plan::independent_values(&self.plans)
    }

    /// Scatter of the fitted values by record and observation, SI.
    pub fn spread(&self) -> Vec<Vec<f64>> {
        weights::spread(&self.plans)
    }

    fn weigh(&mut self, sizes: &[Vec<f64>]) {
        let plans: &mut Vec<Plan> = Arc::make_mut(&mut self.plans);
        weights::weigh(plans, &self.task, sizes);
        self.total = weights::spread_sum(&self.plans);
    }

    /// Updates the weights of several observations and of the priors of scales from the scatter of the `residuals`. Returns
    /// true if they changed.
    pub fn reweigh(&mut self, residuals: &[f64]) -> bool {
        let sizes = weights::sizes(&self.plans, &self.task, residuals);
        if let Some(sizes) = &sizes {
            self.weigh(sizes);
            return true;
        }
        let deviation = self.deviation_of(residuals);
        let changed = (deviation / self.deviation - 1.0).abs() > 1e-3;
        if changed {
            self.deviation = deviation;
        }
        changed
    }

    /// Number of film scales; these are the last columns of the search. Each has a prior, which adds a row below the
    /// residuals of the values.
    pub fn scales(&self) -> usize {
        self.columns.iter().filter(|column| column.is_scale()).count()
    }

    /// All fitted points, to change their trust.
    pub fn points_mut(&mut self) -> impl Iterator<Item = &mut Point> {
        Arc::make_mut(&mut self.plans).iter_mut().flat_map(|plan| &mut plan.points)
    }

    /// Convergence tolerance: relative decrease of the sum of squares.
    pub fn tolerance(&self) -> f64 {
        match self.curve.has_states() {
            true => Self::TOLERANCES_OF_MOTION[if self.rough { 0 } else { self.precision }],
            false => Self::TOLERANCE,
        }
    }

    /// Makes later searches of equations of motion stop at the coarsest tolerance: weights that follow the residuals need
    /// many rounds.
    pub fn search_roughly(&mut self) {
        self.rough = true;
    }

    /// Integrates equations of motion more accurately from here on. Returns false if that is not possible.
    pub fn refine(&mut self) -> bool {
        let possible = self.curve.has_states() && self.precision + 1 < curve::TOLERANCES.len();
        if possible {
            self.integrate_to(self.precision + 1);
        }
        possible
    }

    /// Integrates equations of motion with the final accuracy from here on.
    pub fn refine_fully(&mut self) {
        self.integrate_to(curve::TOLERANCES.len() - 1);
    }

    fn integrate_to(&mut self, precision: usize) {
        self.precision = precision;
        self.curve.set_tolerance(curve::TOLERANCES[precision]);
    }

    /// Values of all parameters of the fit's model in a record, SI, with the varied ones from `x`.
    pub fn parameters(&self, record: usize, x: &[f64]) -> Vec<f64> {
        let mut parameters = self.task.parameters.clone();
        for &(index, value) in &self.task.records[record].fixed {
            if let Some(parameter) = parameters.get_mut(index) {
                *parameter = value;
            }
        }
        for (column, &value) in self.columns.iter().zip(x) {
            if let Some(Target::Parameter(index)) = column.target()
                && column.belongs_to(record)
                && let Some(parameter) = parameters.get_mut(index)
            {
                *parameter = value;
            }
        }
        parameters
    }

    /// Values of all parameters of the caller's model in a record, SI, with the varied ones from `x`.
    pub fn settings(&self, record: usize, x: &[f64]) -> Vec<f64> {
        self.ties.complete(&self.model, self.parameters(record, x))
    }

    /// Parameters and times of the solution for a record.
    fn sought(&self, (record, plan): (usize, &Plan), x: &[f64]) -> Sought {
        let times = self.times(&plan.times, self.origin(record, plan, x)).collect();
        Sought { parameters: self.parameters(record, x), times }
    }

    /// Readings of the clock as times of the model, whose 0 is at `origin`, SI.
    pub fn times<'p>(&self, times: &'p [f64], origin: f64) -> impl Iterator<Item = f64> + use<'p> {
        let earliest = self.earliest();
        times.iter().map(move |time| (time - origin).max(earliest))
    }

    /// First time at which the curve is known, SI. With a varied origin, the system is at rest before it.
    fn earliest(&self) -> f64 {
        if self.curve.has_states() { 0.0 } else { f64::NEG_INFINITY }
    }

    /// Solves the equations of motion for all records of `plans` at the numbers of several `trials` side by side, as many as there is
    /// room for, if there is a solver for that. [`Problem::residuals`] then finds the solutions.
    pub fn solve_together(&mut self, plans: &[Plan], trials: &[Vec<f64>]) {
        if !self.curve.has_lanes() {
            return;
        }
        let mut numbers = 0;
        let runs = trials.iter().flat_map(|x| plans.iter().enumerate().map(move |plan| (plan, x)));
        let runs = runs.take_while(|((_, plan), _)| {
            numbers += plan.times.len() * self.curve.readings();
            numbers <= MOST_NUMBERS
        });
        let sought: Vec<Sought> = runs.map(|(plan, x)| self.sought(plan, x)).collect();
        if sought.len() > 1 {
            self.curve.solve_together(sought);
        }
    }

    /// Solves the equations of motion for several records side by side, if that has not been done for this trial.
    fn solve_records(&mut self, plans: &[Plan], x: &[f64]) {
        if plans.len() > 1 && self.curve.has_lanes() {
            let Sought { parameters, times } = self.sought((0, &plans[0]), x);
            if !self.curve.is_solved(&parameters, &times) {
                self.solve_together(plans, &[x.to_vec()]);
            }
        }
    }

    /// Residuals of all points of `plans`, (model minus measured) times weight, and below them one for the prior of each
    /// scale, with their derivatives. Returns false if the curve does not reach all points or a residual is not finite.
    pub fn residuals(&mut self, plans: &[Plan], x: &[f64], residuals: &mut [f64], jacobian: &mut Jacobian) -> bool {
        self.curve.begin_trial();
        self.solve_records(plans, x);
        let mut base = 0;
        for (record, plan) in plans.iter().enumerate() {
            if !self.residuals_from(base, (record, plan), x, residuals, jacobian) {
                return false;
            }
            base += plan.points.len();
        }
        scale::add_priors((&self.priors(), self.deviation), x, base, residuals, jacobian);
        residuals.iter().all(|value| value.is_finite())
    }

    /// Residuals and derivatives of one record. Returns false if the solution does not reach all points; then only the rows that
    /// it reaches are set.
    pub fn record_residuals(
        &mut self,
        record: usize,
        plan: &Plan,
        x: &[f64],
        residuals: &mut [f64],
        jacobian: &mut Jacobian,
    ) -> bool {
        self.curve.begin_trial();
        self.residuals_from(0, (record, plan), x, residuals, jacobian)
    }

    /// [`Problem::record_residuals`] as a part of a trial, from row `base` on.
    fn residuals_from(
        &mut self,
        base: usize,
        (record, plan): (usize, &Plan),
        x: &[f64],
        residuals: &mut [f64],
        jacobian: &mut Jacobian,
    ) -> bool {
        let stride = self.curve.stride();
        let parameters = self.parameters(record, x);
        let origin = self.origin(record, plan, x);
        let (times, earliest) = (self.times(&plan.times, origin), self.earliest());
        self.clock.clear();
        self.clock.extend(times);
        let rows = self.clock.len();
        let known = self.curve.follow(&parameters, &self.clock);
        let points = &plan.points[..plan.points.partition_point(|point| point.row < known)];
        let values = self.curve.values();
        let place = |point: &Point| (plan.expressions[point.observation] * stride * rows + point.row, point.factor());
        self.places.clear();
        self.places.extend(points.iter().map(place));
        let places = self.places.as_slice();
        let residuals = &mut residuals[base..][..points.len()];
        for (residual, (place, _)) in residuals.iter_mut().zip(places) {
            *residual = values[*place];
        }
        for (number, column) in self.columns.iter().enumerate() {
            let slopes = &mut jacobian.column_mut(number)[base..][..points.len()];
            // Values of one column of the curve, and those after it.
            let column_of_curve = |column: usize| &values[column * rows..];
            match column.target() {
                _ if !column.belongs_to(record) => slopes.fill(0.0),
                Some(Target::Parameter(index)) => {
                    let values = column_of_curve(self.curve.place(index));
                    for (slope, (place, factor)) in slopes.iter_mut().zip(places) {
                        *slope = factor * values[*place];
                    }
                }
                Some(Target::Origin) => {
                    // Points at rest before the origin do not depend on it.
                    let moves = |point: &Point| plan.times[point.row] - origin >= earliest;
                    let values = column_of_curve(stride - 1);
                    for ((slope, point), (place, factor)) in slopes.iter_mut().zip(points).zip(places) {
                        *slope = if moves(point) { factor * -values[*place] } else { 0.0 };
                    }
                }
                Some(Target::Offset(observation)) => {
                    for ((slope, point), residual) in slopes.iter_mut().zip(points).zip(residuals.iter_mut()) {
                        let own = point.observation == observation;
                        *slope = if own { point.factor() } else { 0.0 };
                        *residual += if own { x[number] } else { 0.0 };
                    }
                }
                // Film scales are applied after all other terms.
                None => {}
            }
        }
        let of_record = |column: &Column| column.is_scale() && column.belongs_to(record);
        if let Some(number) = self.columns.iter().position(of_record) {
            let powers = self.task.records[record].observations.iter().map(columns::power_of_length).collect();
            scale::apply(powers, (number, x[number]), points, (base, residuals, jacobian));
        }
        for ((residual, point), (_, factor)) in residuals.iter_mut().zip(points).zip(places) {
            *residual = factor * (*residual - point.value);
        }
        known == rows
    }

    /// Typical size of each number: the absolute value at the start or at `x`, whichever is greater. If it starts at 0: the
    /// width of its range, or without one its absolute value, at least 1.
    pub fn reach(&self, x: &[f64]) -> Vec<f64> {
        let numbers = self.bounds.iter().zip(self.own.iter().zip(x));
        let of_number = |(&(low, high), (own, x)): (&(f64, f64), (&f64, &f64))| match high - low {
            _ if *own != 0.0 => own.abs().max(x.abs()),
            width if width.is_finite() => width,
            _ => x.abs().max(1.0),
        };
        numbers.map(of_number).collect()
    }

    /// Priors of the scales, in the order of their columns.
    pub fn priors(&self) -> Vec<Prior> {
        let prior = |(number, column): (usize, &Column)| {
            let record = column.record.filter(|_| column.is_scale())?;
            Some(Prior { number, record, error: self.task.records[record].scale_error? })
        };
        self.columns.iter().enumerate().filter_map(prior).collect()
    }

    /// Standard deviation of a weighted residual: 1 if errors are given or there is no prior, else from the `residuals` at
    /// the end of a search, bounded from below by that of an exact fit.
    fn deviation_of(&self, residuals: &[f64]) -> f64 {
        let scales = self.scales();
        if scales == 0 || self.task.errors_given() {
            return 1.0;
        }
        let values = &residuals[..residuals.len() - scales];
        let squares = values.iter().fold(0.0, |sum, residual| sum + residual * residual);
        let freedom = self.independent_values() - (self.own.len() - scales) as f64;
        let least = weights::EXACT * (self.total / values.len() as f64).sqrt();
        (squares / freedom.max(1.0)).sqrt().max(least).max(f64::MIN_POSITIVE)
    }

    /// Columns in which the residuals are linear, all of them together.
    pub fn linear_columns(&self) -> Vec<usize> {
        let linear = |target| match target {
            Some(Target::Parameter(index)) => self.curve.is_linear_in(index),
            Some(Target::Offset(_)) => true,
            Some(Target::Origin) | None => false,
        };
        (0..self.columns.len()).filter(|&number| linear(self.columns[number].target())).collect()
    }

    /// Reading of the clock at the model's 0, SI.
    pub fn origin(&self, record: usize, plan: &Plan, x: &[f64]) -> f64 {
        let varied = self
            .columns
            .iter()
            .zip(x)
            .find(|(column, _)| column.target() == Some(Target::Origin) && column.belongs_to(record));
        varied.map_or(plan.origin, |(_, value)| *value)
    }
}

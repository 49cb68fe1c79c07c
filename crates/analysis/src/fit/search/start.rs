//! Starts estimated from the data.
//!
//! For formulas: varied rates and times get the frequency and the damping of the data, in every order. The linear
//! parameters and the phase then follow from linear least squares. For any model: the record is fitted in windows that grow
//! from its beginning, so that the phase error at the end of a window stays below half a period.

use super::problem::Problem;
use super::tones::Phase;
use crate::cycles::{Estimate, estimate};
use crate::fit::linear::{Decomposition, Jacobian};
use crate::fit::task::Target;
use crate::fit::task::plan::{Plan, Point};
use std::f64::consts::TAU;

/// Role of a varied parameter in a formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// The formula is linear in it.
    Linear,
    /// Frequency or phase of a sinusoid of the formula.
    Tone,
    /// Other rate, of the dimension 1/independent variable.
    Rate,
    /// Number of the dimension of the independent variable.
    Time,
    /// Pure number, perhaps a phase.
    Number,
    /// Any other parameter; it keeps its value.
    Other,
}

/// Number of rows used to find a start.
pub(crate) const ROWS: usize = 64;

/// Damped oscillation estimated from the first observation of each record.
pub(crate) fn estimates(problem: &Problem) -> Vec<Option<Estimate>> {
    problem
        .plans
        .iter()
        .map(|plan| {
            let first = plan.points.first()?.observation;
            let of_first = || plan.points.iter().filter(|point| point.observation == first);
            let times: Vec<f64> = of_first().map(|point| plan.times[point.row]).collect();
            let values: Vec<f64> = of_first().map(|point| point.value).collect();
            estimate(&times, &values)
        })
        .collect()
}

/// Start for a formula (SI, one number per column), from the estimated oscillation of each record. `None` for equations of motion, or if the start does
/// not differ from the own values.
pub(crate) fn from_estimates(problem: &mut Problem, estimates: &[Option<Estimate>]) -> Option<Vec<f64>> {
    if problem.curve.has_states() {
        return None;
    }
    let roles = roles(problem);
    let mut start = problem.own.clone();
    // A shared number comes from the first record; a number of one record from its own.
    for (record, estimate) in estimates.iter().enumerate() {
        let Some(estimate) = estimate else { continue };
        let plan = thinned(&problem.plans[record]);
        let mine: Vec<usize> = (0..problem.columns.len())
            .filter(|&number| problem.columns[number].record.map_or(record == 0, |own| own == record))
            .collect();
        let part = Part { record, plan: &plan, roles: &roles, mine: &mine };
        // Frequencies: of the sinusoids of the formula, or if it has none that is varied, any rate or time.
        let mut tuned: Vec<(usize, Vec<f64>, Option<Phase>)> = Vec::new();
        for tone in 0..problem.tones.tones.len() {
            let phase = problem.tones.tones[tone].phase;
            for number in tone_columns(problem, tone, &mine) {
                if let Some(x) = with_tone(problem, (tone, number), record, &start, estimate.angular_frequency) {
                    tuned.push((number, x, phase));
                }
            }
        }
        let rates: Vec<usize> =
            mine.iter().copied().filter(|&number| matches!(roles[number], Role::Rate | Role::Time)).collect();
        if tuned.is_empty() {
            for &number in rates.iter().take(FEW) {
                let mut x = start.clone();
                x[number] = match roles[number] {
                    Role::Rate => estimate.angular_frequency,
                    _ => TAU / estimate.angular_frequency,
                };
                tuned.push((number, x, None));
            }
        }
        // Without damping the time constant would be infinite.
        let damping = estimate.damping.max(1e-3 * estimate.angular_frequency);
        let mut best = (f64::INFINITY, start.clone());
        for (frequency, x, phase) in &tuned {
            let damped = rates.iter().take(FEW).filter(|number| *number != frequency).map(|&number| Some(number));
            for damped in damped.chain([None]).take(if rates.len() > 1 { FEW } else { 1 }) {
                let mut trial = x.clone();
                if let Some(number) = damped {
                    trial[number] = if roles[number] == Role::Rate { damping } else { 1.0 / damping };
                }
                if let Some(sum) = part.complete(problem, *phase, &mut trial)
                    && sum < best.0
                {
                    best = (sum, trial);
                }
            }
        }
        start = best.1;
    }
    (start != problem.own).then_some(start)
}

/// Greatest number of rates and times that get a frequency or a damping.
const FEW: usize = 4;

/// Columns among `mine` that set the frequency of a tone.
pub(crate) fn tone_columns(problem: &Problem, tone: usize, mine: &[usize]) -> Vec<usize> {
    let sets = |number: &usize| match problem.columns[*number].target() {
        Some(Target::Parameter(index)) => problem.tones.tones[tone].frequencies.contains(&index),
        _ => false,
    };
    mine.iter().copied().filter(sets).collect()
}

/// `x` with one number changed so that a tone has the angular frequency `wanted` (rad per unit of the independent variable) in the
/// middle of a record; `None` if there is no such value.
pub(crate) fn with_tone(
    problem: &mut Problem,
    (tone, number): (usize, usize),
    record: usize,
    x: &[f64],
    wanted: f64,
) -> Option<Vec<f64>> {
    let Some(Target::Parameter(index)) = problem.columns[number].target() else { return None };
    let parameters = problem.parameters(record, x);
    let plan = &problem.plans[record];
    let middle = 0.5 * (plan.times.first()? + plan.times.last()?) - problem.origin(record, plan, x);
    let value = problem.tones.tuned(tone, index, &parameters, (middle, wanted))?;
    let mut x = x.to_vec();
    x[number] = value;
    Some(x)
}

/// Roles of the numbers in a formula.
pub(crate) fn roles(problem: &Problem) -> Vec<Role> {
    let time = problem.model.independent.unit.dimension;
    let rate = time.inverse();
    let tones = &problem.tones.tones;
    let in_tone = |index: usize| {
        tones
            .iter()
            .any(|tone| tone.frequencies.contains(&index) || tone.phase.is_some_and(|phase| phase.parameter == index))
    };
    problem
        .columns
        .iter()
        .map(|column| match column.target() {
            Some(Target::Offset(_)) => Role::Linear,
            Some(Target::Origin) | None => Role::Other,
            Some(Target::Parameter(index)) => {
                let dimension = problem.model.parameters.get(index).map(|parameter| parameter.unit.dimension);
                if problem.curve.is_linear_in(index) {
                    Role::Linear
                } else if in_tone(index) {
                    Role::Tone
                } else if dimension == Some(rate) {
                    Role::Rate
                } else if dimension == Some(time) {
                    Role::Time
                } else if dimension.is_some_and(|dimension| dimension.is_none()) {
                    Role::Number
                } else {
                    Role::Other
                }
            }
        })
        .collect()
}

/// Evenly thinned rows of a plan, about [`ROWS`].
pub(crate) fn thinned(plan: &Plan) -> Plan {
    let every = plan.times.len().div_ceil(ROWS).max(1);
    let kept: Vec<Point> = plan
        .points
        .iter()
        .filter(|point| point.row % every == 0)
        .map(|point| Point { row: point.row / every, ..*point })
        .collect();
    Plan { times: plan.times.iter().copied().step_by(every).collect(), points: kept, ..plan.clone() }
}

/// Numbers of one record, and its thinned rows.
pub(crate) struct Part<'a> {
    /// Index of the record.
    pub record: usize,
    /// Its rows.
    pub plan: &'a Plan,
    /// Role of each column.
    pub roles: &'a [Role],
    /// Columns that belong to the record.
    pub mine: &'a [usize],
}

impl Part<'_> {
    /// Sets the linear parameters and the phase in `trial` for its rates. `phase` is that of a tone; for `None` the first pure number is
    /// taken as a phase. Returns the sum of squares reached.
    ///
    /// A sinusoid of any phase is a sum of those of phase 0 and of a quarter turn: f(phi) = f(0) cos phi + f(pi/2) sin phi.
    /// Linear least squares gets both columns, and the amplitude and the phase follow from the two coefficients.
    pub fn complete(&self, problem: &mut Problem, phase: Option<Phase>, trial: &mut [f64]) -> Option<f64> {
        let &Part { record, plan, roles, mine } = self;
        let rows = plan.points.len();
        let linear: Vec<usize> = mine.iter().copied().filter(|&number| roles[number] == Role::Linear).collect();
        let of_tone = |phase: Phase| {
            let column = |number: &usize| problem.columns[*number].target() == Some(Target::Parameter(phase.parameter));
            Some((mine.iter().copied().find(column)?, phase.period))
        };
        let first_number = || mine.iter().copied().find(|&number| roles[number] == Role::Number);
        let phase = match phase {
            Some(phase) => of_tone(phase),
            None => first_number().map(|number| (number, TAU)),
        };
        let at = |problem: &mut Problem, x: &[f64]| {
            let mut residuals = vec![0.0; rows];
            let mut jacobian = Jacobian::new(rows, x.len());
            problem.record_residuals(record, plan, x, &mut residuals, &mut jacobian).then_some((residuals, jacobian))
        };
        // With the linear part at zero, the residuals are what the linear part has to explain.
        let mut bare = trial.to_vec();
        linear.iter().for_each(|&number| bare[number] = 0.0);
        if let Some((phase, _)) = phase {
            bare[phase] = 0.0;
        }
        let (residuals, first) = at(problem, &bare)?;
        let Some((phase, period)) = phase.filter(|_| !linear.is_empty()) else {
            let solved = solve(&first, &linear, &residuals)?;
            linear.iter().zip(&solved.0).for_each(|(&number, value)| bare[number] = *value);
            trial.copy_from_slice(&bare);
            return Some(solved.1);
        };
        let mut turned = bare.clone();
        turned[phase] = 0.25 * period;
        let (_, second) = at(problem, &turned)?;
        let mut best: Option<(f64, Vec<f64>)> = None;
        for &amplitude in &linear {
            // Basis: every linear column at phase 0, and that of this amplitude also at a quarter turn.
            let mut basis = Jacobian::new(rows, linear.len() + 1);
            for (place, &number) in linear.iter().enumerate() {
                basis.column_mut(place).copy_from_slice(first.column(number));
            }
            basis.column_mut(linear.len()).copy_from_slice(second.column(amplitude));
            let all: Vec<usize> = (0..=linear.len()).collect();
            let Some((values, sum)) = solve(&basis, &all, &residuals) else { continue };
            if best.as_ref().is_some_and(|(least, _)| *least <= sum) {
                continue;
            }
            let mut x = bare.clone();
            linear.iter().zip(&values).for_each(|(&number, value)| x[number] = *value);
            let (cosine, sine) = (x[amplitude], values[linear.len()]);
            x[amplitude] = libm::hypot(cosine, sine);
            x[phase] = libm::atan2(sine, cosine) / TAU * period;
            best = Some((sum, x));
        }
        let (sum, x) = best?;
        trial.copy_from_slice(&x);
        Some(sum)
    }
}

/// Linear least squares: returns the values that minimise `residuals` plus the columns times the values, and the remaining
/// sum of squares.
pub(crate) fn solve(columns: &Jacobian, chosen: &[usize], residuals: &[f64]) -> Option<(Vec<f64>, f64)> {
    let scale: Vec<f64> = (0..columns.columns)
        .map(|column| {
            let length = crate::fit::linear::norm(columns.column(column));
            if length > 0.0 { length } else { 1.0 }
        })
        .collect();
    let decomposition = Decomposition::new(columns, chosen, &scale, residuals);
    let flat = 1e-10 * decomposition.greatest();
    let step = decomposition.combine(|value| if value > flat { 1.0 / value } else { 0.0 });
    let values: Vec<f64> = chosen.iter().zip(&step).map(|(&column, step)| -step / scale[column]).collect();
    let mut sum = 0.0;
    for (row, residual) in residuals.iter().enumerate() {
        let explained =
            chosen.iter().zip(&values).fold(0.0, |sum, (&column, value)| sum + columns.column(column)[row] * value);
        sum += (residual + explained) * (residual + explained);
    }
    (sum.is_finite() && values.iter().all(|value| value.is_finite())).then_some((values, sum))
}

/// Durations of windows that grow from the beginning of each record, SI; the last one is infinite.
pub(crate) fn windows(problem: &Problem, estimates: &[Option<Estimate>]) -> Vec<f64> {
    let mut duration: f64 = 0.0;
    let mut first: f64 = f64::INFINITY;
    for (plan, estimate) in problem.plans.iter().zip(estimates) {
        let (Some(start), Some(end)) = (plan.times.first(), plan.times.last()) else { continue };
        duration = duration.max(end - start);
        let period = match estimate {
            Some(estimate) => TAU / estimate.angular_frequency,
            None => (end - start) / 6.0,
        };
        first = first.min(period);
    }
    let mut windows = Vec::new();
    let mut window = 0.75 * first;
    while window < 0.7 * duration && window > 0.0 && windows.len() < 12 {
        windows.push(window);
        window *= 1.7;
    }
    windows.push(f64::INFINITY);
    windows
}

/// Plans cut to a duration, each from its own beginning.
pub(crate) fn cut(plans: &[Plan], duration: f64) -> Vec<Plan> {
    plans
        .iter()
        .map(|plan| {
            let end = plan.times.first().map_or(0.0, |start| start + duration);
            let rows = plan.times.partition_point(|time| *time <= end);
            Plan {
                times: plan.times[..rows].to_vec(),
                points: plan.points.iter().copied().filter(|point| point.row < rows).collect(),
                ..plan.clone()
            }
        })
        .collect()
}

/// Start number `index` of a low-discrepancy sequence over the ranges (Halton, Numer. Math. 2 (1960) 84). Without a range
/// it lies between 1/5 and 5 times the own value for an even `index`, between 1/300 and 300 times for an odd one.
pub(crate) fn spread(own: &[f64], bounds: &[(f64, f64)], index: usize) -> Vec<f64> {
    own.iter()
        .zip(bounds)
        .enumerate()
        .map(|(place, (&value, &(low, high)))| {
            let part = halton(index, place);
            if low.is_finite() && high.is_finite() {
                // Logarithmic over a range of more than a factor of 20.
                if low > 0.0 && high > 20.0 * low {
                    low * libm::exp(part * libm::log(high / low))
                } else {
                    low + part * (high - low)
                }
            } else {
                let scale = if value == 0.0 { 1.0 } else { value };
                let reach: f64 = if index.is_multiple_of(2) { 5.0 } else { 300.0 };
                scale * libm::exp((2.0 * part - 1.0) * libm::log(reach))
            }
        })
        .collect()
}

/// Coordinate `place` of the point number `index` of the Halton sequence in the unit cube.
pub(crate) fn halton(index: usize, place: usize) -> f64 {
    const PRIMES: [usize; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
    radical_inverse(index + 1, PRIMES[place % PRIMES.len()])
}

fn radical_inverse(mut index: usize, base: usize) -> f64 {
    let (mut result, mut digit) = (0.0, 1.0);
    while index > 0 {
        digit /= base as f64;
        result += digit * (index % base) as f64;
        index /= base;
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first points of the sequence in the bases 2 and 3 are 1/2, 1/4, 3/4 and 1/3, 2/3, 1/9.
    #[test]
    fn starts_are_spread_over_ranges_of_all_kinds() {
        let near = |found: Vec<f64>, expected: [f64; 2]| {
            let pairs = found.iter().zip(expected);
            pairs.for_each(|(found, expected)| {
                assert!((found / expected - 1.0).abs() < 1e-12, "{found} for {expected}")
            });
        };
        // A range up to 20 times its lower end, and a wider one.
        let bounds = [(2.0, 6.0), (1.0, 1000.0)];
        near(spread(&[0.0, 0.0], &bounds, 0), [4.0, 10.0]);
        near(spread(&[0.0, 0.0], &bounds, 1), [3.0, 100.0]);
        near(spread(&[0.0, 0.0], &bounds, 2), [5.0, libm::pow(1000.0, 1.0 / 9.0)]);
        // One that reaches below 0, and none.
        let bounds = [(-6.0, 6.0), (f64::NEG_INFINITY, f64::INFINITY)];
        near(spread(&[0.0, 7.0], &bounds, 1), [-3.0, 7.0 * libm::pow(300.0, 1.0 / 3.0)]);
        near(spread(&[0.0, 0.0], &bounds, 2), [3.0, libm::pow(5.0, 2.0 / 9.0 - 1.0)]);
    }
}

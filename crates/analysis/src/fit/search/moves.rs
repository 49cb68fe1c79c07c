//! Starts away from an answer that is no minimum, or not the lowest one: numbers that have stayed equal are moved apart, and
//! numbers that set a frequency are moved to the oscillations that the data and the residuals show.

use super::Search;
use super::line::{Line, lines};
use super::problem::Problem;
use super::stages;
use super::start::{self, Part};
use super::symmetry::sort;
use crate::cycles::estimate;
use crate::fit::linear::{Jacobian, dot, norm};
use crate::fit::task::plan::Plan;
use std::f64::consts::TAU;
use units::order::sort_by;

/// Moves away from answers.
#[derive(Clone, Debug, Default)]
pub(in crate::fit) struct Moves {
    /// Starts of short searches still to be made, the last one first.
    short: Vec<Vec<f64>>,
    /// Sums of squares and numbers at the ends of the short searches.
    ended: Vec<(f64, Vec<f64>)>,
    /// Starts of whole searches still to be made, the last one first.
    whole: Vec<Vec<f64>>,
    /// Sum of squares of the answer from which the present moves go.
    from: Option<f64>,
    rounds: usize,
    /// True if the present moves part equal numbers.
    parted: bool,
}

/// Number that sets a frequency.
#[derive(Clone, Copy, Debug)]
enum Setter {
    /// Number of a sinusoid written in the model: index of the tone, and column.
    Tone(usize, usize),
    /// Number of the equations of motion: column, its value at an angular frequency that it sets, that frequency, and the power of
    /// the number with which it grows.
    Motion(usize, f64, f64, f64),
}

impl Moves {
    /// Upper bound of the answers that are left.
    const ROUNDS: usize = 6;
    /// Upper bound of the trials of a short search, and of a whole one.
    pub const SHORT: usize = 8;
    /// Number of short searches that are continued.
    const CONTINUED: usize = 3;
    /// Relative decrease of the sum of squares from which on an answer is left for good.
    const MOVED: f64 = 0.05;
    /// Factors by which equal numbers are moved apart.
    const APART: [f64; 3] = [1.05, 1.5, 4.0];
    /// Numbers that differ by less than this part are equal; columns whose angle has a cosine closer to 1 are parallel.
    const EQUAL: f64 = 1e-6;
    /// A sum of squares below this part of the scatter cannot be improved.
    const NOTHING: f64 = 1e-12;
    /// Upper bound of the number of short searches of a round times the number of residuals.
    const VALUES: usize = 100_000;

    /// Start of the next search, and true if that is a short one; `None` if there is none.
    pub fn next(&mut self, problem: &mut Problem, best: &Search) -> Option<(Vec<f64>, bool)> {
        if let Some(start) = self.short.pop() {
            return Some((start, true));
        }
        if !self.ended.is_empty() {
            let mut ended = std::mem::take(&mut self.ended);
            sort_by(&mut ended, |one, other| one.0.total_cmp(&other.0));
            self.whole = ended.into_iter().take(Self::CONTINUED).rev().map(|(_, x)| x).collect();
            return self.whole.pop().map(|start| (start, false));
        }
        let left = self.from.is_none_or(|from| best.sum < from * (1.0 - Self::MOVED));
        if !left && let Some(start) = self.whole.pop() {
            return Some((start, false));
        }
        self.whole.clear();
        // If the equal numbers have not parted, their frequencies may still be others.
        let stays = std::mem::take(&mut self.parted) && !left;
        if self.rounds == Self::ROUNDS || !(left || stays) || best.sum <= Self::NOTHING * problem.total {
            return None;
        }
        self.rounds += 1;
        self.from = Some(best.sum);
        self.short = if stays { Vec::new() } else { saddles(problem, best) };
        self.parted = !self.short.is_empty();
        if self.short.is_empty() {
            self.short = tuned(problem, best);
        }
        self.short.truncate((Self::VALUES / best.residuals.len().max(1)).max(Self::CONTINUED));
        self.short.reverse();
        self.short.pop().map(|start| (start, true))
    }

    /// Takes the end of a short search.
    pub fn remember(&mut self, search: &Search) {
        if search.sum.is_finite() {
            self.ended.push((search.sum, search.x.clone()));
        }
    }
}

/// Starts with equal numbers moved apart: two numbers of one sort whose columns are parallel stay equal in every step.
fn saddles(problem: &Problem, best: &Search) -> Vec<Vec<f64>> {
    let (linear, moving) = (problem.linear_columns(), stages::moving(problem));
    let numbers = problem.own.len() - problem.scales();
    let acts = |column: &usize| if problem.curve.has_states() { moving[*column] } else { !linear.contains(column) };
    let columns: Vec<usize> = (0..numbers).filter(acts).collect();
    let parallel = |a: usize, b: usize| {
        let (one, other) = (best.jacobian.column(a), best.jacobian.column(b));
        let both = norm(one) * norm(other);
        both > 0.0 && dot(one, other).abs() >= both * (1.0 - Moves::EQUAL)
    };
    let mut starts = Vec::new();
    for (place, &a) in columns.iter().enumerate() {
        for &b in &columns[place + 1..] {
            let equal = (best.x[a] - best.x[b]).abs() <= Moves::EQUAL * best.x[a].abs() && best.x[a] != 0.0;
            if equal && sort(problem, a).0.is_some() && sort(problem, a) == sort(problem, b) && parallel(a, b) {
                starts.extend(Moves::APART.map(|factor| {
                    let mut x = best.x.clone();
                    (x[a], x[b]) = (x[a] * factor, x[b] / factor);
                    x
                }));
            }
        }
    }
    starts
}

/// Least part of the sum of squared residuals in a line that is followed.
const CLEAN: f64 = 0.1;
/// Least part of it in a line that stays unexplained.
const CLEAR: f64 = 0.3;
/// Lines of the data that are followed, and least part of their sum of squares in one.
const LINES: usize = 3;
const SEEN: f64 = 1e-3;
/// Frequencies closer than this, in cycles of the record, are one.
const CLOSE: f64 = 0.3;

/// Period of an oscillation in the residuals, SI: a frequency of a model with several is likely to be wrong. `None` if the residuals
/// of all records look random, or the model has fewer than two frequencies.
pub(in crate::fit) fn unexplained(problem: &mut Problem, best: &Search) -> Option<f64> {
    if !may_have_setters(problem) {
        return None;
    }
    let plans = problem.plans.clone();
    let found = (0..plans.len()).filter_map(|record| residual_line(&plans, record, best));
    let line = found.max_by(|one, other| one.share.total_cmp(&other.share)).filter(|line| line.share >= CLEAR)?;
    (setters(problem, best, 0).len() > 1).then_some(TAU / line.frequency)
}

/// Line in the residuals of a record.
fn residual_line(plans: &[Plan], record: usize, best: &Search) -> Option<Line> {
    let begin: usize = plans[..record].iter().map(|plan| plan.points.len()).sum();
    let plan = &plans[record];
    let (times, residuals) = series(plan, &best.residuals[begin..begin + plan.points.len()]);
    lines(&times, &residuals, 1, usize::MAX).into_iter().find(|line| line.share >= CLEAN)
}

/// Times of the first observation of a record, with its part of `values`, one per point.
fn series(plan: &Plan, values: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let first = plan.points.first().map(|point| point.observation);
    let own = plan.points.iter().zip(values).filter(|(point, _)| Some(point.observation) == first);
    own.map(|(point, value)| (plan.times[point.row], *value)).unzip()
}

/// True if the model may have several numbers that set frequencies: those of sinusoids written in it, and one for two states.
fn may_have_setters(problem: &Problem) -> bool {
    let of_tones: usize = problem.tones.tones.iter().map(|tone| tone.frequencies.len()).sum();
    of_tones + problem.model.states.len() / 2 > 1
}

/// Numbers of a record that set frequencies, at the answer.
fn setters(problem: &mut Problem, best: &Search, record: usize) -> Vec<Setter> {
    let mine: Vec<usize> =
        (0..problem.columns.len()).filter(|&number| problem.columns[number].belongs_to(record)).collect();
    let mut setters = Vec::new();
    for tone in 0..problem.tones.tones.len() {
        setters.extend(start::tone_columns(problem, tone, &mine).into_iter().map(|number| Setter::Tone(tone, number)));
    }
    if problem.curve.has_states() {
        let moving = stages::moving(problem);
        let in_tone =
            |number: usize| setters.iter().any(|one| matches!(one, Setter::Tone(_, other) if *other == number));
        let others: Vec<usize> = mine.iter().copied().filter(|&number| moving[number] && !in_tone(number)).collect();
        setters.extend(others.into_iter().filter_map(|number| of_motion(problem, best, record, number)));
    }
    setters
}

/// Relative change of a number by which its frequency is measured, and least power with which a frequency grows.
const CHANGE: f64 = 1.05;
const POWER: f64 = 0.2;
/// Rows from which the frequency of a derivative is measured.
const FEW_ROWS: usize = 128;

/// Setter of the equations of motion: the derivative of the curve with respect to it oscillates with the frequency that it sets, and
/// that changes with it.
fn of_motion(problem: &mut Problem, best: &Search, record: usize, number: usize) -> Option<Setter> {
    if best.x[number] == 0.0 {
        return None;
    }
    let plans = problem.plans.clone();
    let plan = &plans[record];
    let mut frequency = |factor: f64| {
        let mut x = best.x.clone();
        x[number] *= factor;
        let rows = plan.points.len();
        let (mut residuals, mut jacobian) = (vec![0.0; rows], Jacobian::new(rows, x.len()));
        let known = problem.record_residuals(record, plan, &x, &mut residuals, &mut jacobian);
        let (times, slopes) = series(plan, jacobian.column(number));
        known.then(|| lines(&times, &slopes, 1, FEW_ROWS).pop()).flatten().map(|line| line.frequency)
    };
    let (now, after) = (frequency(1.0)?, frequency(CHANGE)?);
    let power = libm::log(after / now) / libm::log(CHANGE);
    let power = [1.0, -1.0, 0.5, -0.5].into_iter().find(|usual: &f64| (power - usual).abs() < 0.2).unwrap_or(power);
    (power.abs() >= POWER).then_some(Setter::Motion(number, best.x[number], now, power))
}

/// Starts with numbers that set frequencies at those of the data and the residuals.
fn tuned(problem: &mut Problem, best: &Search) -> Vec<Vec<f64>> {
    if !may_have_setters(problem) {
        return Vec::new();
    }
    let plans = problem.plans.clone();
    let mut starts = Vec::new();
    for record in 0..plans.len() {
        let Some(line) = residual_line(&plans, record, best) else { continue };
        let setters = setters(problem, best, record);
        if setters.len() < 2 {
            continue;
        }
        let plan = &plans[record];
        let values: Vec<f64> = plan.points.iter().map(|point| point.value).collect();
        let (times, values) = series(plan, &values);
        let seen = lines(&times, &values, LINES, usize::MAX).into_iter().filter(|line| line.share >= SEEN);
        let seen: Vec<f64> = [line].into_iter().chain(seen).map(|line| line.frequency).collect();
        starts.extend(starts_of(problem, best, (record, plan), &setters, &seen));
    }
    starts
}

/// Starts for a record with the frequencies `seen` in it.
fn starts_of(
    problem: &mut Problem,
    best: &Search,
    (record, plan): (usize, &Plan),
    setters: &[Setter],
    seen: &[f64],
) -> Vec<Vec<f64>> {
    let span = plan.times.last().zip(plan.times.first()).map_or(1.0, |(last, first)| last - first);
    let distinct = |frequencies: &mut dyn Iterator<Item = f64>| {
        let mut distinct: Vec<f64> = Vec::new();
        for one in frequencies {
            let close = |known: f64| (known - one).abs() * span < CLOSE * TAU;
            if !close(0.0) && !distinct.iter().any(|known| close(*known)) {
                distinct.push(one);
            }
        }
        distinct
    };
    let seen = distinct(&mut seen.iter().copied());
    // A parametric drive shows sums and differences of its frequency and the system's own.
    let doubled = seen.iter().map(|one| 2.0 * one);
    let pairs =
        || seen.iter().enumerate().flat_map(|(place, one)| seen[place + 1..].iter().map(move |other| (*one, *other)));
    let combined = pairs().flat_map(|(one, other)| [(one - other).abs(), one + other]);
    let of_drives = match problem.curve.has_states() {
        true => distinct(&mut seen.iter().copied().chain(doubled).chain(combined)),
        false => seen.clone(),
    };
    // Numbers that have run to an end of their ranges, or to 0, begin again.
    let away = |column: usize| best.at_bound(column) || best.x[column].abs() < 1e-3 * problem.own[column].abs();
    let base: Vec<f64> =
        (0..best.x.len()).map(|column| if away(column) { problem.own[column] } else { best.x[column] }).collect();
    let own = problem.own.clone();
    let mut starts: Vec<Vec<f64>> = Vec::new();
    for setter in setters {
        let targets = if matches!(setter, Setter::Tone(..)) { &of_drives } else { &seen };
        for &target in targets {
            starts.extend(set(problem, record, *setter, &base, target));
        }
    }
    for (place, one) in setters.iter().enumerate() {
        for other in &setters[place + 1..] {
            for (a, b) in pairs().flat_map(|(a, b)| [(a, b), (b, a)]) {
                let begun = set(problem, record, *one, &own, a);
                starts.extend(begun.and_then(|x| set(problem, record, *other, &x, b)));
            }
        }
    }
    for tone in 0..problem.tones.tones.len() {
        starts.extend(WINDOWS.iter().filter_map(|windows| along_ridge(problem, tone, (record, plan), *windows)));
    }
    if !problem.curve.has_states() {
        complete(problem, (record, plan), setters, &mut starts);
    }
    let bounds = problem.open_bounds();
    let inside = |x: &Vec<f64>| x.iter().zip(&bounds).all(|(value, (low, high))| (*low..=*high).contains(value));
    starts.retain(inside);
    starts
}

/// Gives the starts of a formula their best linear numbers and phases, and keeps the best ones.
fn complete(problem: &mut Problem, (record, plan): (usize, &Plan), setters: &[Setter], starts: &mut [Vec<f64>]) {
    let plan = start::thinned(plan);
    let roles = start::roles(problem);
    let mine: Vec<usize> =
        (0..problem.columns.len()).filter(|&number| problem.columns[number].belongs_to(record)).collect();
    let part = Part { record, plan: &plan, roles: &roles, mine: &mine };
    let phases: Vec<_> = setters
        .iter()
        .filter_map(|setter| match setter {
            Setter::Tone(tone, _) => problem.tones.tones[*tone].phase,
            Setter::Motion(..) => None,
        })
        .collect();
    for x in starts.iter_mut() {
        if phases.is_empty() {
            part.complete(problem, None, x);
        }
        // Each phase in turn, twice: the first one is found while the others are wrong.
        for phase in phases.iter().chain(&phases) {
            part.complete(problem, Some(*phase), x);
        }
    }
}

/// Numbers of windows of a record in which the frequency of a sweep is measured, and steps of the search for its numbers.
const WINDOWS: [usize; 3] = [4, 8, 16];
const STEPS: usize = 10;

/// Own values with the numbers of a tone whose frequency changes, such as a sweep, set to the frequencies seen in windows of the record.
fn along_ridge(problem: &mut Problem, tone: usize, (record, plan): (usize, &Plan), windows: usize) -> Option<Vec<f64>> {
    let mine: Vec<usize> =
        (0..problem.columns.len()).filter(|&number| problem.columns[number].belongs_to(record)).collect();
    let numbers = start::tone_columns(problem, tone, &mine);
    if numbers.len() < 2 {
        return None;
    }
    let values: Vec<f64> = plan.points.iter().map(|point| point.value).collect();
    let (times, values) = series(plan, &values);
    let mut x = problem.own.clone();
    let origin = problem.origin(record, plan, &x);
    let width = times.len().div_ceil(windows);
    let windows = times.chunks(width).zip(values.chunks(width));
    let seen: Vec<(f64, f64)> = windows
        .filter_map(|(times, values)| {
            let middle = 0.5 * (times.first()? + times.last()?) - origin;
            Some((middle, estimate(times, values)?.angular_frequency))
        })
        .collect();
    for _ in 0..STEPS {
        let mut frequencies = |x: &[f64]| -> Vec<f64> {
            let parameters = problem.parameters(record, x);
            seen.iter().map(|(time, _)| problem.tones.frequency(tone, &parameters, *time)).collect()
        };
        let now = frequencies(&x);
        let residuals: Vec<f64> = now.iter().zip(&seen).map(|(now, (_, seen))| now - seen).collect();
        let mut slopes = Jacobian::new(seen.len(), x.len());
        for &number in &numbers {
            let mut moved = x.clone();
            let step = 1e-6 * x[number].abs().max(1e-3);
            moved[number] += step;
            let column = slopes.column_mut(number);
            column
                .iter_mut()
                .zip(frequencies(&moved))
                .zip(&now)
                .for_each(|((slope, moved), now)| *slope = (moved - now) / step);
        }
        let (change, _) = start::solve(&slopes, &numbers, &residuals)?;
        numbers.iter().zip(&change).for_each(|(&number, change)| x[number] += change);
    }
    Some(x)
}

/// `x` with a number changed to set the angular frequency `target`.
fn set(problem: &mut Problem, record: usize, setter: Setter, x: &[f64], target: f64) -> Option<Vec<f64>> {
    match setter {
        Setter::Tone(tone, number) => start::with_tone(problem, (tone, number), record, x, target),
        Setter::Motion(number, value, now, power) => {
            let mut x = x.to_vec();
            x[number] = value * libm::pow(target / now, 1.0 / power);
            x[number].is_finite().then_some(x)
        }
    }
}

//! Clocks that begin late: the model's 0 moves to the beginning of a record where that only gives its numbers other values.

use super::curve::Curve;
use crate::fit::autoregression::{orthonormal, subtract_projection};
use crate::fit::linear::{dot, norm};
use crate::fit::task::columns::Column;
use crate::fit::task::{Record, Target, Task};
use program::{Model, NodeId};
use units::Dimension;

/// Rows at which the curve is compared.
const ROWS: usize = 64;
/// Points at which the curve is compared; the curve may be translated only if it may be at all of them.
const POINTS: usize = 3;
/// Greatest part of the rate of the curve that its other derivatives may leave, for a formula and for equations of motion.
const REST: [f64; 2] = [1e-6, 1e-3];

/// First and last time of a record, SI, if it begins later after the clock's 0 than it lasts, or ends as long before it.
pub(in crate::fit) fn span(record: &Record) -> Option<(f64, f64)> {
    let times = record.observations.iter().flat_map(|one| &one.times).copied().filter(|time| time.is_finite());
    let (first, last) =
        times.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), time| (low.min(time), high.max(time)));
    let duration = last - first;
    (duration > 0.0 && (first > duration || last < -duration)).then_some((first, last))
}

/// True if the curve in a record keeps its shape when the clock moves: its rate of change is a combination of its derivatives
/// with respect to the numbers of this record. Then other values of these numbers give the same curve at a later time. False if
/// one of them is a moment on the record's clock.
pub(in crate::fit) fn may_move(
    model: &Model,
    expressions: &[NodeId],
    task: &Task,
    (columns, bounds, own): (&[Column], &[(f64, f64)], &[f64]),
    place: usize,
) -> bool {
    let record = &task.records[place];
    let Some((first, last)) = span(record) else { return false };
    if model.independent.unit.dimension != Dimension::TIME {
        return false;
    }
    let mut targets: Vec<Target> = columns.iter().filter_map(Column::target).collect();
    targets.push(Target::Origin);
    let Ok(mut curve) = Curve::new(model, expressions, &targets, &task.parameters, (task.method, last - first)) else {
        return false;
    };
    let times: Vec<f64> = (0..ROWS).map(|row| (last - first) * row as f64 / (ROWS - 1) as f64).collect();
    let alone = task.records.len() == 1;
    let free: Vec<usize> =
        (0..columns.len()).filter(|&number| alone || columns[number].record == Some(place)).collect();
    (0..POINTS).all(|point| {
        let x: Vec<f64> =
            own.iter().zip(bounds).enumerate().map(|(number, own)| near(own, point + number * POINTS)).collect();
        let mut parameters = task.parameters.clone();
        record.fixed.iter().for_each(|&(index, value)| parameters[index] = value);
        for (column, value) in columns.iter().zip(&x).filter(|(column, _)| column.belongs_to(place)) {
            if let Some(Target::Parameter(index)) = column.target() {
                parameters[index] = *value;
            }
        }
        if curve.follow(&parameters, &times) < ROWS {
            return false;
        }
        let stride = curve.stride();
        let column = |number: usize| -> Vec<f64> {
            let of_expression = |expression: usize| &curve.values()[(expression * stride + number) * ROWS..][..ROWS];
            (0..expressions.len()).flat_map(of_expression).copied().collect()
        };
        let rate = column(stride - 1);
        let mut slopes = Vec::new();
        for &number in &free {
            match columns[number].target() {
                Some(Target::Parameter(index)) => {
                    let slope = column(curve.place(index));
                    let is_time = model.parameters[index].unit.dimension == Dimension::TIME;
                    let moves = -dot(&slope, &rate) / dot(&rate, &rate);
                    let (low, high) = bounds[number];
                    let inside = if low.is_finite() {
                        low <= last && high >= first
                    } else {
                        (first..=last).contains(&own[number])
                    };
                    if is_time && (moves - 1.0).abs() < REST[1] && inside {
                        return false;
                    }
                    slopes.push(slope);
                }
                Some(Target::Offset(observation)) => {
                    let node = record.observations.get(observation).map(|one| one.observed.node);
                    let own = |row: usize| if Some(expressions[row / ROWS]) == node { 1.0 } else { 0.0 };
                    slopes.push((0..rate.len()).map(own).collect());
                }
                Some(Target::Origin) | None => {}
            }
        }
        let size = norm(&rate);
        let mut rest = rate;
        subtract_projection(&orthonormal(slopes), &mut rest);
        size.is_finite() && norm(&rest) <= REST[usize::from(curve.has_states())] * size
    })
}

/// A value beside a start, within its range.
fn near((own, (low, high)): (&f64, &(f64, f64)), index: usize) -> f64 {
    // Multiples of the golden section, which are spread evenly between 0 and 1.
    let part = (0.618_033_988_75 * (index + 1) as f64).fract();
    let width = if (high - low).is_finite() { high - low } else { 1.0 };
    let moved = if *own == 0.0 { low.max(-width) + (0.3 + 0.4 * part) * width } else { own * (0.8 + 0.4 * part) };
    moved.max(*low).min(*high)
}

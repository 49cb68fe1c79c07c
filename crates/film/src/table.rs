//! Table of tracked positions: times, coordinates and standard errors.

use crate::calibration::{Calibration, Lengths};
use crate::tracking::{Point, Track};
use std::collections::BTreeSet;

/// Number of points for the interpolation at another time.
const AROUND: usize = 6;

/// Table of one or several tracks, one row per frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Unit of lengths: `px` or `m`.
    pub unit: &'static str,
    /// Frame number of each row.
    pub frames: Vec<usize>,
    /// Time of each row, s.
    pub times: Vec<f64>,
    /// Quantities of each track, one value per row; NaN in frames without a point.
    pub quantities: Vec<Vec<Quantity>>,
}

/// Column of values with standard errors.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// Name: `x` or `y`, with the number of the track if there are several (`y_2`).
    pub name: String,
    /// Values in units of [`Table::unit`], one per row.
    pub values: Vec<f64>,
    /// Standard errors in the same unit, one per row.
    pub sigmas: Vec<f64>,
}

impl Table {
    /// Table of the tracks of one film. `taken`: time of the middle row of a frame, s, on the same clock as the tracks.
    ///
    /// A rolling shutter reads each track at another time within the frame. If there are several tracks, their values
    /// are interpolated to the time of the middle row, by the polynomial through the six nearest points.
    pub fn of(tracks: &[Track], calibration: &Calibration, taken: &dyn Fn(usize) -> f64) -> Self {
        let frames: BTreeSet<usize> =
            tracks.iter().flat_map(|track| track.points.iter().map(|point| point.frame)).collect();
        let frames: Vec<usize> = frames.into_iter().collect();
        let mut times: Vec<f64> = frames.iter().map(|frame| taken(*frame)).collect();
        if let [track] = tracks {
            times = track.points.iter().map(|point| point.time).collect();
        }
        let table = |(number, track): (usize, &Track)| {
            let suffix = if tracks.len() > 1 { format!("_{number}") } else { String::new() };
            let mut quantities = measured(track, calibration, &suffix);
            let read: Vec<f64> = track.points.iter().map(|point| point.time).collect();
            let place = |frame: usize| track.points.binary_search_by_key(&frame, |point| point.frame).ok();
            for quantity in &mut quantities {
                let value = |(frame, time): (&usize, &f64)| {
                    let at = place(*frame)?;
                    if read[at] == *time {
                        Some(quantity.values[at])
                    } else {
                        Some(at_time(&read, &quantity.values, at, *time))
                    }
                };
                let values = frames.iter().zip(&times).map(|row| value(row).unwrap_or(f64::NAN)).collect();
                let sigma = |frame: &usize| place(*frame).map_or(f64::NAN, |at| quantity.sigmas[at]);
                (quantity.values, quantity.sigmas) = (values, frames.iter().map(sigma).collect());
            }
            quantities
        };
        let quantities = (1..).zip(tracks).map(table).collect();
        let unit = if matches!(calibration.lengths, Lengths::Pixels) { "px" } else { "m" };
        Self { unit, frames, times, quantities }
    }

    /// Columns with headings: the time, then the quantities and their standard errors for each track.
    pub fn columns(&self) -> Vec<(String, &[f64])> {
        let mut columns = vec![("t [s]".to_owned(), self.times.as_slice())];
        for track in &self.quantities {
            let values = track.iter().map(|one| (format!("{} [{}]", one.name, self.unit), one.values.as_slice()));
            columns.extend(values);
            let sigmas = track.iter().map(|one| (format!("sigma_{} [{}]", one.name, self.unit), one.sigmas.as_slice()));
            columns.extend(sigmas);
        }
        columns
    }
}

/// Quantities of a track: the level along a tube, or both coordinates of a body. `suffix` is appended to their names.
fn measured(track: &Track, calibration: &Calibration, suffix: &str) -> Vec<Quantity> {
    let quantity = |name: &str, pick: &dyn Fn(&Point) -> [f64; 2]| {
        let (values, sigmas) = track.points.iter().map(|point| pick(point).into()).unzip();
        Quantity { name: format!("{name}{suffix}"), values, sigmas }
    };
    let Some(direction) = track.direction else {
        let coordinate = |k: usize| {
            move |point: &Point| {
                [calibration.apply(point.position)[k], calibration.sigma(point.position, point.sigma)[k]]
            }
        };
        return vec![quantity("x", &coordinate(0)), quantity("y", &coordinate(1))];
    };
    let (up, pixel) = calibration.upwards_along(direction);
    let level = |point: &Point| {
        let [x, y] = calibration.apply(point.position);
        let [p, q] = point.sigma;
        [x * up[0] + y * up[1], pixel * (p * p + q * q).sqrt()]
    };
    vec![quantity("y", &level)]
}

/// Lagrange interpolation at `time`, close to `times[at]`.
fn at_time(times: &[f64], values: &[f64], at: usize, time: f64) -> f64 {
    let count = AROUND.min(times.len());
    let first = at.saturating_sub(count / 2).min(times.len() - count);
    let part = first..first + count;
    part.clone()
        .map(|k| {
            let others = part.clone().filter(|other| *other != k);
            values[k] * others.map(|other| (time - times[other]) / (times[k] - times[other])).product::<f64>()
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polynomial_is_interpolated_exactly() {
        let times: Vec<f64> = (0..12).map(|k| f64::from(k) / 30.0).collect();
        let curve = |t: f64| 1.0 + t - 20.0 * t * t * t + 300.0 * t * t * t * t * t;
        let values: Vec<f64> = times.iter().map(|t| curve(*t)).collect();
        for at in [0, 1, 5, 10, 11] {
            let time = times[at] + 0.012;
            assert!((at_time(&times, &values, at, time) - curve(time)).abs() < 1e-12, "{at}");
        }
        assert_eq!(at_time(&[1.0], &[2.0], 0, 3.0), 2.0);
    }
}

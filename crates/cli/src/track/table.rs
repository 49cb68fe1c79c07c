//! The table of what was found in a film, as CSV.

use super::clock::Clock;
use super::lengths::{Measured, measured};
use analysis::csv::{self, Dialect};
use film::calibration::{Calibration, Lengths};
use film::tracking::Track;
use std::collections::BTreeSet;

/// Points through which a value at another time is interpolated.
const AROUND: usize = 6;

/// The table.
#[derive(Debug)]
pub struct Table {
    /// The unit of lengths.
    pub unit: &'static str,
    /// The number of the frame of each row.
    pub frames: Vec<usize>,
    /// The time of each row in seconds.
    pub times: Vec<f64>,
    /// Name, values and standard errors of each quantity; not a number where its track has no point.
    pub quantities: Vec<Vec<Measured>>,
}

impl Table {
    /// The rows of some tracks of one film.
    ///
    /// A rolling shutter reads two surfaces at two times of one frame. Several tracks are therefore brought to the time of the
    /// frame itself, that of its middle row, by the polynomial through the six points around.
    pub fn of(tracks: &[Track], calibration: &Calibration, clock: &Clock) -> Self {
        let frames: BTreeSet<usize> =
            tracks.iter().flat_map(|track| track.points.iter().map(|point| point.frame)).collect();
        let frames: Vec<usize> = frames.into_iter().collect();
        let taken = |frame: usize| clock.times.get(frame).copied().unwrap_or(f64::NAN);
        let mut times: Vec<f64> = frames.iter().map(|frame| taken(*frame)).collect();
        if let [track] = tracks {
            times = track.points.iter().map(|point| point.time).collect();
        }
        let table = |(number, track): (usize, &Track)| {
            let suffix = if tracks.len() > 1 { format!("_{number}") } else { String::new() };
            let mut quantities = measured(track, calibration, &suffix);
            for quantity in &mut quantities {
                let read: Vec<f64> = track.points.iter().map(|point| point.time).collect();
                let place = |frame: usize| track.points.binary_search_by_key(&frame, |point| point.frame).ok();
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

    /// It as CSV: the time, then for each track its quantities and their standard errors.
    pub fn csv(&self) -> String {
        let mut heads = vec!["t [s]".to_owned()];
        let mut columns: Vec<&[f64]> = vec![&self.times];
        for track in &self.quantities {
            for (prefix, errors) in [("", false), ("sigma_", true)] {
                for quantity in track {
                    heads.push(format!("{prefix}{} [{}]", quantity.name, self.unit));
                    columns.push(if errors { &quantity.sigmas } else { &quantity.values });
                }
            }
        }
        let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
        csv::write(&heads, &columns, Dialect::Commas)
    }
}

/// The value at a time near that of one of some points, by the polynomial through the points around (J. L. Lagrange).
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

//! From what was seen to a track.

use crate::tracking::body::refining::Seen;
use crate::tracking::body::{SCORE, Settings};
use crate::tracking::errors::{outliers, scaled};
use crate::tracking::similarity::Similarity;
use crate::tracking::track::{Known, Point, Readout, Track};

/// A point that lies more of its standard errors from what its neighbours predict is doubtful.
const DEVIATION: f64 = 6.0;

/// The track with times and errors, in the order of time.
pub(super) fn joined(
    settings: &Settings,
    size: Option<(usize, usize)>,
    seen: &[Seen],
    cameras: &[Similarity],
    lost: Option<usize>,
) -> Track {
    let readout = match settings.readout {
        Known::Seconds(seconds) => Some(Readout { seconds, sigma: 0.0 }),
        Known::Estimated => None,
    };
    let seconds = readout.map_or(0.0, |readout| readout.seconds);
    let height = size.map_or(1.0, |(_, height)| height as f64);
    let mut order: Vec<usize> = (0..seen.len()).collect();
    order.sort_by(|a, b| seen[*a].time.total_cmp(&seen[*b].time));
    let mut points: Vec<Point> = Vec::with_capacity(seen.len());
    let mut formal = [Vec::new(), Vec::new()];
    for at in order {
        let (one, camera) = (&seen[at], &cameras[at]);
        let now = one.now;
        for (formal, variance) in formal.iter_mut().zip(now.variance) {
            formal.push(variance.sqrt());
        }
        points.push(Point {
            frame: one.frame,
            time: one.time + seconds * (now.position[1] / height - 0.5),
            position: camera.undo(now.position),
            sigma: [0.0; 2],
            score: now.score,
            doubtful: now.score < SCORE || !now.settled,
        });
    }
    let times: Vec<f64> = points.iter().map(|point| point.time).collect();
    for (k, formal) in formal.iter().enumerate() {
        let values: Vec<f64> = points.iter().map(|point| point.position[k]).collect();
        let sigmas = scaled(&times, &values, formal);
        let outliers = outliers(&times, &values, &sigmas, DEVIATION);
        for ((point, sigma), outlier) in points.iter_mut().zip(sigmas).zip(outliers) {
            point.sigma[k] = sigma;
            point.doubtful |= outlier;
        }
    }
    Track { points, exposure: None, readout, direction: None, lost }
}

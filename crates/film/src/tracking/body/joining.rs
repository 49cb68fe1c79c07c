//! Track with errors and doubts from the sightings of a body.

use crate::tracking::body::refining::Seen;
use crate::tracking::body::template::Template;
use crate::tracking::errors::scaled;
use crate::tracking::similarity::Similarity;
use crate::tracking::track::{Known, Outline, Point, Readout, Track};
use units::order::sort_by;

/// Minimum agreement of a reliable point, relative to the best possible one.
const AGREES: f64 = 0.5;
/// Maximum deviation of a reliable point from its neighbours, px and relative to the radius.
const ASIDE: (f64, f64) = (2.5, 0.2);
/// Deviation in standard errors from which it replaces the standard error.
const DEVIATION: f64 = 4.0;
/// Number of successive frames and extent in px of a rest.
const REST: (usize, f64) = (6, 0.3);
/// Displacement per frame before a rest, px, from which the rest is doubtful.
const STOP: f64 = 2.0;
/// Extent of a track without motion, px.
const STILL: f64 = 1.0;

/// Track with times and errors, ordered by time. Doubts are absolute: they depend on the size of the body and on smooth
/// motion, not on the rest of the track, which may be wrong for the most part. `moved`: false for a template whose disc
/// never moved as a whole; its points are doubtful. `height`: height of the picture, px.
pub(super) fn joined(
    readout: Known,
    (templates, moved): (&[Template], &[bool]),
    height: f64,
    (seen, cameras): (&[Seen], &[Similarity]),
    lost: Option<usize>,
) -> Track {
    let readout = match readout {
        Known::Seconds(seconds) => Some(Readout { seconds, sigma: 0.0 }),
        Known::Estimated => None,
    };
    let seconds = readout.map_or(0.0, |readout| readout.seconds);
    let mut order: Vec<usize> = (0..seen.len()).collect();
    sort_by(&mut order, |a, b| seen[*a].time.total_cmp(&seen[*b].time));
    let mut points: Vec<Point> = Vec::with_capacity(seen.len());
    let mut formal = [Vec::new(), Vec::new()];
    let mut sizes = Vec::with_capacity(seen.len());
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
            doubtful: one.agreement < AGREES
                || one.aside
                || !one.moves
                || !one.alone
                || moved.get(one.key) == Some(&false),
        });
        sizes.push(templates.get(one.key).map_or(0.0, |template| template.disc.outline));
    }
    let times: Vec<f64> = points.iter().map(|point| point.time).collect();
    let mut aside = vec![0.0; points.len()];
    for (k, formal) in formal.iter().enumerate() {
        let values: Vec<f64> = points.iter().map(|point| point.position[k]).collect();
        let (sigmas, distances) = (scaled(&times, &values, formal), distances(&times, &values));
        for (at, (point, sigma)) in points.iter_mut().zip(sigmas).enumerate() {
            let distance = distances.get(at).copied().unwrap_or(0.0);
            point.sigma[k] = if distance > DEVIATION * sigma { distance } else { sigma };
            aside[at] = libm::hypot(aside[at], distance);
        }
    }
    for (at, (point, size)) in points.iter_mut().zip(sizes).enumerate() {
        let limit = ASIDE.0.max(ASIDE.1 * size);
        // A wrong position displaces the interpolation of its neighbours; it deviates most itself.
        let around = &aside[at.saturating_sub(2)..(at + 3).min(aside.len())];
        let furthest = around.iter().all(|other| *other <= aside[at]);
        point.doubtful |= aside[at] > limit && furthest || point.sigma.iter().any(|sigma| *sigma > limit);
    }
    for at in resting(&points) {
        points[at].doubtful = true;
    }
    let outline =
        templates.last().map(|template| Outline { offset: template.disc.shift, radius: template.disc.outline });
    Track { points, readout, lost, outline, ..Track::default() }
}

/// Distance of each value from the cubic through two neighbours on each side; 0 near the ends and beside gaps.
fn distances(times: &[f64], values: &[f64]) -> Vec<f64> {
    let mut distances = vec![0.0; values.len()];
    for (at, (times, values)) in times.windows(5).zip(values.windows(5)).enumerate() {
        let weight = |k: usize| {
            [0, 1, 3, 4]
                .into_iter()
                .filter(|j| *j != k)
                .map(|j| (times[2] - times[j]) / (times[k] - times[j]))
                .product::<f64>()
        };
        let led: f64 = [0, 1, 3, 4].into_iter().map(|k| weight(k) * values[k]).sum();
        // No extrapolation across gaps.
        if times[4] - times[0] < 6.0 * (times[3] - times[2]).min(times[2] - times[1]) {
            distances[at + 2] = (values[2] - led).abs();
        }
    }
    distances
}

/// Indices of points at which the track stops abruptly; all indices if it never moves.
fn resting(points: &[Point]) -> Vec<usize> {
    let far = |one: &Point, other: &Point| {
        libm::hypot(one.position[0] - other.position[0], one.position[1] - other.position[1])
    };
    let within = |from: usize, most: f64| {
        let first = &points[from];
        points[from..].iter().take_while(|point| far(first, point) < most).count()
    };
    let mut found = Vec::new();
    let mut at = 0;
    while at < points.len() {
        let length = within(at, REST.1);
        let arrival = at.checked_sub(1).map(|before| far(&points[before], &points[at]));
        let whole = at == 0 && within(0, STILL) == points.len();
        if length >= REST.0 && (whole || arrival.is_some_and(|way| way > STOP)) {
            found.extend(at..at + length);
        }
        if whole && length >= REST.0 {
            return (0..points.len()).collect();
        }
        at += length.max(1);
    }
    found
}

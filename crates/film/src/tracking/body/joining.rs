//! Track with errors and doubts from the sightings of a body.

use crate::tracking::body::evidence::Evidence;
use crate::tracking::body::refining::Seen;
use crate::tracking::body::template::Template;
use crate::tracking::errors::scaled;
use crate::tracking::smooth::Motion;
use crate::tracking::track::{Known, Outline, Point, Readout, Track};
use units::order::sort_by;

/// Minimum agreement of a reliable point, relative to the best possible one.
const AGREES: f64 = 0.5;
/// Minimum correlation of a reliable point with the template.
const LIKE: f64 = 0.4;
/// The updated template has drifted to something else where its correlation exceeds that of the mean of all frames by so much, less at the first and
/// last of these points, and the latter is below this.
const DRIFTED: ([f64; 2], f64) = ([0.2, 0.3], 0.6);
/// Minimum correlation of a moving point that is likely, and maximum deviation of such a point from a smooth curve through others, relative to that
/// of a reliable point.
const LIKELY: f64 = 0.7;
const SMOOTH: f64 = 0.5;
/// Maximum deviation of a reliable point from its neighbours, px and relative to the radius.
const ASIDE: (f64, f64) = (2.5, 0.2);
/// Maximum standard error of a reliable point, px and relative to the radius.
const WIDE: (f64, f64) = (2.5, 0.5);
/// Deviation in standard errors from which it replaces the standard error.
const DEVIATION: f64 = 4.0;
/// Number of successive frames and extent in px of a rest.
const REST: (usize, f64) = (6, 0.3);
/// Displacement per frame before a rest, px, from which the rest is doubtful.
const STOP: f64 = 2.0;
/// Extent of a track without motion, px.
const STILL: f64 = 1.0;

/// Track with times and errors, ordered by time. Doubts are absolute: they depend on the size of the body and on smooth
/// motion, not on the rest of the track, which may be wrong for the most part. Points of templates without `evidence` are
/// doubtful. `height`: height of the picture, px.
pub(super) fn joined(
    readout: Known,
    (templates, evidence): (&[Template], &[Evidence]),
    height: f64,
    seen: &[Seen],
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
    let (mut limits, mut widest) = (Vec::with_capacity(seen.len()), Vec::with_capacity(seen.len()));
    let (mut unsure, mut likely) = (Vec::with_capacity(seen.len()), Vec::with_capacity(seen.len()));
    let mut excess = Vec::with_capacity(seen.len());
    let is_shown: Vec<bool> = evidence
        .iter()
        .enumerate()
        .map(|(key, evidence)| evidence.is_shown((seen, key), templates.get(key), lost.is_some()))
        .collect();
    for at in order {
        let one = &seen[at];
        let now = one.now;
        for (formal, variance) in formal.iter_mut().zip(now.variance) {
            formal.push(variance.sqrt());
        }
        points.push(Point {
            frame: one.frame,
            time: one.time + seconds * (now.position[1] / height - 0.5),
            position: one.camera.undo(now.position),
            sigma: [0.0; 2],
            score: now.score,
            doubtful: !one.alone || is_shown.get(one.key) == Some(&false),
        });
        unsure.push(one.agreement < AGREES || now.score < LIKE || one.aside || !one.moves);
        excess.push(if one.updated && now.score < DRIFTED.1 { one.first.score - now.score } else { 0.0 });
        likely.push(now.score >= LIKELY && one.moves);
        let radius = templates.get(one.key).map_or(0.0, |template| template.disc.outline);
        limits.push(limit(radius));
        widest.push(WIDE.0.max(WIDE.1 * radius));
    }
    let motion = Motion::new(
        points.iter().map(|point| point.time).collect(),
        points.iter().map(|point| point.position).collect(),
    );
    let outliers = outliers(&motion, &limits);
    let off: Vec<[f64; 2]> =
        (0..points.len()).map(|at| motion.distance(at, |one| !outliers[one]).unwrap_or_default()).collect();
    for (k, formal) in formal.iter().enumerate() {
        let values: Vec<f64> = points.iter().map(|point| point.position[k]).collect();
        let times: Vec<f64> = points.iter().map(|point| point.time).collect();
        for ((point, sigma), off) in points.iter_mut().zip(scaled(&times, &values, formal)).zip(&off) {
            point.sigma[k] = if off[k] > DEVIATION * sigma { off[k] } else { sigma };
        }
    }
    for (at, point) in points.iter_mut().enumerate() {
        let is_wide = point.sigma.iter().any(|sigma| *sigma > widest[at]);
        point.doubtful |= outliers[at] || is_wide;
    }
    for at in resting(&points) {
        points[at].doubtful = true;
    }
    unsure.iter_mut().zip(drifted(&excess)).for_each(|(unsure, drifted)| *unsure |= drifted);
    settle(&mut points, (&unsure, &likely), &motion, &limits);
    let outline =
        templates.last().map(|template| Outline { offset: template.disc.shift, radius: template.disc.outline });
    Track { points, readout, lost, outline, ..Track::default() }
}

/// True for points at which the updated template has drifted to something else. `excess`: by how much its correlation exceeds that of the mean of all
/// frames.
fn drifted(excess: &[f64]) -> Vec<bool> {
    let [edge, middle] = DRIFTED.0;
    let runs = excess.chunk_by(|one, next| (*one > edge) == (*next > edge));
    runs.flat_map(|run| {
        let has_drifted = run.iter().any(|excess| *excess > middle);
        run.iter().map(move |_| has_drifted)
    })
    .collect()
}

/// Settles doubts that the look leaves, by the motion of other points on both sides. `unsure`: true for points with such a doubt; `likely`: true
/// for those that resemble the body and move; `limits` in px.
fn settle(points: &mut [Point], (unsure, likely): (&[bool], &[bool]), motion: &Motion, limits: &[f64]) {
    let certain: Vec<bool> = points.iter().zip(unsure).map(|(point, unsure)| !point.doubtful && !unsure).collect();
    let is_led = |at: usize| motion.through(at, |one| certain[one]).is_some_and(|off| off <= limits[at]);
    let settled: Vec<bool> =
        (0..points.len()).map(|at| certain[at] || unsure[at] && !points[at].doubtful && is_led(at)).collect();
    // Patterns of the background that resemble the body lie on no smooth curve with it and with one another. A track that is certain in few frames
    // may follow something else that does.
    let is_certain = 2 * settled.iter().filter(|settled| **settled).count() > points.len();
    let likely: Vec<bool> =
        (0..points.len()).map(|at| settled[at] || is_certain && likely[at] && !points[at].doubtful).collect();
    for (at, point) in points.iter_mut().enumerate().filter(|(at, _)| !settled[*at]) {
        let curves = || [motion.through(at, |one| likely[one]), motion.closely(at, |one| likely[one])];
        let is_near = likely[at] && curves().into_iter().flatten().any(|off| off <= SMOOTH * limits[at]);
        point.doubtful |= !is_near;
    }
}

/// Maximum deviation of a reliable point from its neighbours, px. `radius` in px.
fn limit(radius: f64) -> f64 {
    ASIDE.0.max(ASIDE.1 * radius)
}

/// True for positions that lie more than their limit (px) from where their neighbours lead, unless the body bounces there.
fn outliers(motion: &Motion, limits: &[f64]) -> Vec<bool> {
    let count = limits.len();
    let off: Vec<f64> = (0..count).map(|at| motion.between(at, |_| true).map_or(0.0, length)).collect();
    // A wrong position displaces the interpolation of its neighbours; it deviates most itself.
    let is_furthest = |at: usize| off[at.saturating_sub(2)..(at + 3).min(count)].iter().all(|other| *other <= off[at]);
    (0..count).map(|at| off[at] > limits[at] && is_furthest(at) && !motion.bounces(at, limits[at])).collect()
}

fn length([x, y]: [f64; 2]) -> f64 {
    libm::hypot(x, y)
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

//! Track of a surface from its rows: times, errors, doubts, and gaps where it is hidden.

use crate::tracking::column::compression::lag;
use crate::tracking::column::solving::Solving;
use crate::tracking::column::strip::{Line, Strip};
use crate::tracking::errors::{jumps, outliers, scaled};
use crate::tracking::readout;
use crate::tracking::smooth::Motion;
use crate::tracking::track::{Known, Point, Readout, Track};

/// Minimum score of a reliable point.
const SCORE: f64 = 0.6;
/// Maximum deviation of a reliable point from the prediction of its neighbours, in standard errors.
const DEVIATION: f64 = 6.0;
/// Maximum deviation of a reliable point from a smooth motion, px.
const JUMP: f64 = 3.0;
/// Maximum standard error of a reliable point, px.
const UNCERTAIN: f64 = 3.0;
/// Minimum score, and range of gains, of a point that needs no advantage over other rows. Smear makes the two regions
/// uncertain although the surface is visible.
const SAME: f64 = 0.995;
const LEAST_GAIN: f64 = 0.8;
const MOST_GAIN: f64 = 1.25;
/// Maximum distance in px from the motion of certain points on both sides at which a doubt that the look leaves is settled.
const NEAR: f64 = 2.0;
/// Maximum number of frames between two doubtful ones that become doubtful too, unless their regions are clear.
const BETWEEN: usize = 3;
/// Minimum length of a gap in frames. In shorter runs of hidden frames the points are doubtful.
const HIDDEN: usize = 4;
/// Maximum fraction of hidden frames; with more of them the film has no gaps.
const MOST_HIDDEN: f64 = 0.5;
/// Fraction of doubtful frames above which the path as a whole may be that of something else.
const MOST_DOUBTFUL: f64 = 0.5;

/// Track with times and errors. `height`: height of the picture, px.
pub(super) fn joined(readout: Known, line: Line, height: usize, (strips, solving): (&[Strip], &Solving)) -> Track {
    let found = strips.iter().zip(&solving.poses).zip(solving.agreements.iter().zip(&solving.certainties));
    let mut points = Vec::with_capacity(strips.len());
    let (mut formal, mut read) = (Vec::new(), Vec::new());
    let mut hidden = Vec::with_capacity(strips.len());
    for ((strip, pose), (agreement, certainty)) in found {
        let seen = strip.line.at(pose.row);
        let seen_there = agreement.settled && agreement.score >= SCORE;
        let is_same = agreement.settled && agreement.score >= SAME && (LEAST_GAIN..MOST_GAIN).contains(&pose.gain);
        // Readout position of the row, relative to the middle of the frame, in frame heights.
        read.push(seen[1] / height as f64 - 0.5);
        formal.push(agreement.variance.sqrt());
        hidden.push(certainty.is_hidden() && !is_same);
        points.push(Point {
            frame: strip.frame,
            time: strip.time,
            position: strip.camera.undo(seen),
            sigma: [0.0; 2],
            score: agreement.score,
            doubtful: certainty.is_doubtful() && !is_same || !(seen_there || certainty.is_clear()),
        });
    }
    // Intervals of the film between gaps.
    let parts = parts(&hidden);
    let kept = || parts.iter().cloned().flatten();
    let pick = |values: &[f64]| -> Vec<f64> { kept().filter_map(|at| values.get(at).copied()).collect() };
    let times: Vec<f64> = points.iter().map(|point| point.time).collect();
    let along: Vec<f64> = points.iter().map(|point| line.row(point.position)).collect();
    let readout = match readout {
        Known::Seconds(seconds) => Some(Readout { seconds, sigma: 0.0 }),
        Known::Estimated => readout::estimate(&pick(&times), &pick(&along), &pick(&read)),
    };
    let seconds = readout.map_or(0.0, |readout| readout.seconds);
    let times: Vec<f64> = times.iter().zip(&read).map(|(time, part)| time + seconds * part).collect();
    let sigmas = scaled(&pick(&times), &pick(&along), &pick(&formal));
    let lag = lag(strips, &pick(&times), &pick(&along), &pick(&read));
    for (at, sigma) in kept().zip(sigmas) {
        let sigma = sigma.max(lag);
        points[at].time = times[at];
        points[at].sigma = line.direction.map(|part| part.abs() * sigma);
        formal[at] = sigma;
    }
    // Doubts that the look alone leaves.
    let mut by_look: Vec<bool> = points.iter().zip(&hidden).map(|(point, hidden)| point.doubtful && !hidden).collect();
    for part in parts.iter().cloned() {
        let outliers = outliers(&times[part.clone()], &along[part.clone()], &formal[part.clone()], DEVIATION);
        let jumps = jumps(&along[part.clone()], JUMP);
        for (at, (is_outlier, is_jump)) in part.zip(outliers.into_iter().zip(jumps)) {
            let is_off = is_outlier || is_jump || formal[at] > UNCERTAIN;
            points[at].doubtful |= is_off;
            by_look[at] &= !is_off;
        }
    }
    for part in parts.iter().cloned() {
        let motion =
            Motion::new(times[part.clone()].to_vec(), along[part.clone()].iter().map(|row| [*row, 0.0]).collect());
        let certain: Vec<bool> = points[part.clone()].iter().map(|point| !point.doubtful).collect();
        for at in part.clone().filter(|at| by_look[*at]) {
            let off = motion.through(at - part.start, |one| certain[one]);
            points[at].doubtful = off.is_none_or(|off| off > NEAR);
        }
    }
    let doubtful: Vec<usize> = kept().filter(|at| points[*at].doubtful).collect();
    for pair in doubtful.windows(2).filter(|pair| pair[1] - pair[0] <= BETWEEN + 1) {
        let between = points.iter_mut().zip(&solving.certainties).take(pair[1]).skip(pair[0] + 1);
        between.for_each(|(point, certainty)| point.doubtful = !certainty.is_clear());
    }
    let mut points: Vec<Point> = kept().map(|at| points[at]).collect();
    // Something else that moves may look certain in a few frames.
    if points.iter().filter(|point| point.doubtful).count() as f64 > MOST_DOUBTFUL * points.len() as f64 {
        points.iter_mut().for_each(|point| point.doubtful = true);
    }
    Track { points, exposure: solving.exposure, readout, direction: Some(line.direction), ..Track::default() }
}

/// Ranges of frames between gaps. Hidden frames at both ends of the film belong to them: a gap has two sides.
fn parts(hidden: &[bool]) -> Vec<std::ops::Range<usize>> {
    let count = hidden.len();
    let mut parts = Vec::new();
    let mut first = 0;
    let mut at = 0;
    for run in hidden.chunk_by(|one, next| one == next) {
        let end = at + run.len();
        if run[0] && run.len() >= HIDDEN && at > 0 && end < count {
            parts.push(first..at);
            first = end;
        }
        at = end;
    }
    parts.push(first..count);
    let kept: usize = parts.iter().map(ExactSizeIterator::len).sum();
    if (kept as f64) < (1.0 - MOST_HIDDEN) * count as f64 { std::iter::once(0..count).collect() } else { parts }
}

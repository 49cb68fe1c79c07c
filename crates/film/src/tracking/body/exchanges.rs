//! Exchanges of two bodies of the same look in successive frames. An exchange turns the vector between them round; the motion of the bodies
//! changes it smoothly.

use std::ops::Range;

use crate::tracking::errors::weights;

/// Number of vectors in a difference, which vanishes for a cubic.
const JOINED: usize = 5;
/// Number of vectors before the last one of a difference.
const EARLIER: usize = JOINED - 1;
/// Minimum number of vectors before a meeting. The first differences join fewer vectors.
const LEAST: usize = 1;
/// Number of assignments of these vectors, one bit each.
const STATES: usize = 1 << EARLIER;
/// Minimum difference of the squares of two assignments, in mean squares.
const EVIDENCE: f64 = 30.0;
/// Error of a vector in a meeting without smear, and minimum error by which assignments are compared, px.
const NOISE: f64 = 0.5;
const EXACT: f64 = 0.25;
/// Maximum error of a vector, px and relative to the radius.
const SMOOTH: (f64, f64) = (1.5, 0.1);

/// Error along the motion by its smear, px per px of motion in a frame. Two bodies that cover one another in part are smeared to one.
const SMEAR: f64 = 0.25;

/// Vector from one body to the other in a frame, px.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Vector {
    /// Time in s.
    pub time: f64,
    pub between: [f64; 2],
    /// Mean motion of both bodies in a frame, px.
    pub motion: [f64; 2],
}

/// Assignment of the positions in a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Assigned {
    pub is_exchanged: bool,
    pub is_certain: bool,
}

/// Weights of the difference of so many values at these times; `None` for fewer.
fn difference<const COUNT: usize>(vectors: &[Vector]) -> Option<Vec<f64>> {
    let times: Vec<f64> = vectors.iter().map(|one| one.time).collect();
    Some(weights::<COUNT>(times.first_chunk()?)?.to_vec())
}

/// Square of the difference of three to five successive vectors, with these bits of `signs` turned round; the last vector has the lowest bit.
/// The part along the motion counts as much as its smear allows.
fn square(vectors: &[Vector], signs: usize) -> f64 {
    let last = vectors.len() - 1;
    let weights = match last {
        EARLIER => difference::<JOINED>(vectors),
        3 => difference::<4>(vectors),
        _ => difference::<3>(vectors),
    };
    let terms = weights.iter().flatten().zip(vectors).enumerate();
    let sum = terms.fold([0.0; 2], |sum, (at, (weight, one))| {
        let weight = if signs >> (last - at) & 1 == 1 { -weight } else { *weight };
        [sum[0] + weight * one.between[0], sum[1] + weight * one.between[1]]
    });
    let [x, y] = vectors[last / 2].motion;
    let length = libm::hypot(x, y).max(f64::MIN_POSITIVE);
    let (along, across) = ((sum[0] * x + sum[1] * y) / length, (sum[0] * y - sum[1] * x) / length);
    let smear = SMEAR * length / NOISE;
    across * across + along * along / (1.0 + smear * smear)
}

/// Assignments in the frames of a meeting, and whether the bodies are exchanged afterwards (Viterbi, *IEEE Trans. Inf. Theory* 13 (1967) 260).
/// `vectors`: those of all frames in which both are seen, from before the meeting on; `meeting`: indices. `radius` in px. `None` if both ways
/// are about as smooth, or there is no vector before or there are fewer than four after.
pub(super) fn exchanges(vectors: &[Vector], meeting: Range<usize>, radius: f64) -> Option<(Vec<Assigned>, bool)> {
    let count = vectors.len();
    if meeting.start < LEAST || meeting.end + EARLIER > count {
        return None;
    }
    let mut costs = [f64::INFINITY; STATES];
    costs[0] = 0.0;
    let mut before: Vec<[usize; STATES]> = Vec::with_capacity(count);
    for at in LEAST..count {
        let mut next = [f64::INFINITY; STATES];
        let mut from = [0; STATES];
        for state in (0..STATES).filter(|state| costs[*state].is_finite()) {
            for turned in 0..2 {
                if at < meeting.start && turned == 1 || at >= meeting.end && turned != state & 1 {
                    continue;
                }
                let signs = state << 1 | turned;
                let cost = costs[state] + square(&vectors[at.saturating_sub(EARLIER)..=at], signs);
                if cost < next[signs % STATES] {
                    (next[signs % STATES], from[signs % STATES]) = (cost, state);
                }
            }
        }
        costs = next;
        before.push(from);
    }
    let (same, exchanged) = (costs[0], costs[STATES - 1]);
    let is_exchanged = exchanged < same;
    let disturbed = (meeting.end + EARLIER).min(count) - meeting.start.max(LEAST);
    let error = (same.min(exchanged) / (2 * disturbed.max(1)) as f64).max(EXACT * EXACT);
    let limit = SMOOTH.0.max(SMOOTH.1 * radius);
    if error > limit * limit || (same - exchanged).abs() < EVIDENCE * error {
        return None;
    }
    let mut state = if is_exchanged { STATES - 1 } else { 0 };
    let mut turned = vec![false; count];
    for at in (LEAST..count).rev() {
        turned[at] = state & 1 == 1;
        state = before[at - LEAST][state];
    }
    let squares = |at: usize, turned: &[bool]| -> f64 {
        let windows = (at.max(LEAST)..(at + JOINED).min(count)).map(|end| end.saturating_sub(EARLIER)..=end);
        let signs = |turned: &[bool]| turned.iter().fold(0, |signs, one| signs << 1 | usize::from(*one));
        windows.map(|window| square(&vectors[window.clone()], signs(&turned[window]))).sum()
    };
    let assigned = meeting.map(|at| {
        let least = squares(at, &turned);
        let mut other = turned.clone();
        other[at] = !other[at];
        Assigned { is_exchanged: turned[at], is_certain: squares(at, &other) - least > EVIDENCE * error }
    });
    Some((assigned.collect(), is_exchanged))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exchanges_are_those_that_make_the_motion_smooth() {
        // Two bodies that pass one another at a distance of `aside`; the positions are exchanged in the frames of `turned`. The first frame is
        // `first`.
        let assigned = |first: usize, aside: f64, turned: &[usize]| {
            let vector = |at: usize| {
                let late = at as f64 - 12.0;
                let sign = if turned.contains(&at) { -1.0 } else { 1.0 };
                let between = [sign * late * (4.0 - 0.02 * late * late), sign * aside];
                Vector { time: late, between, motion: [1.0, 0.0] }
            };
            exchanges(&(first..25).map(vector).collect::<Vec<_>>(), 8 - first..17 - first, 10.0)
        };
        for first in [0, 4, 6, 7] {
            for turned in [vec![], vec![12], vec![9, 10, 11], vec![10, 13, 14]] {
                let (assigned, is_exchanged) = assigned(first, 6.0, &turned).expect("an assignment");
                assert!(!is_exchanged);
                for (at, one) in (8..17).zip(assigned) {
                    let expected = Assigned { is_exchanged: turned.contains(&at), is_certain: true };
                    assert_eq!(one, expected, "from {first}, {turned:?}, {at}");
                }
            }
            let (_, is_exchanged) = assigned(first, 6.0, &(13..25).collect::<Vec<_>>()).expect("an assignment");
            assert!(is_exchanged);
        }
        assert_eq!(assigned(8, 6.0, &[]), None, "no vector before the meeting");
        // Bodies that are at the same place in the meeting cannot be told apart.
        let vectors: Vec<Vector> =
            (0..25).map(|at| Vector { time: f64::from(at), between: [0.01, 0.0], motion: [1.0, 0.0] }).collect();
        assert_eq!(exchanges(&vectors, 8..17, 10.0), None);
    }
}

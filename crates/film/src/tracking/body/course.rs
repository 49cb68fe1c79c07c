//! Prediction of the position of a body from its last positions.

use crate::tracking::linear::solve;

/// Number of positions used.
const RECENT: usize = 4;

/// Predicted position.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Course {
    pub place: [f64; 2],
    /// Radius of the search around it, px.
    pub reach: f64,
    /// Last known position, px.
    pub last: [f64; 2],
    /// Distance from the last position to the prediction, px.
    pub way: f64,
}

/// Predicts the position at `time` (s) from times (s) and positions (px) in order. One position is continued at rest,
/// two with constant velocity, more with constant acceleration. `radius`: radius of the body, px. `None` without
/// positions.
pub(crate) fn course(seen: &[(f64, [f64; 2])], time: f64, radius: f64) -> Option<Course> {
    let recent = &seen[seen.len().saturating_sub(RECENT)..];
    let (last, at) = recent.last().copied()?;
    let late = time - last;
    let Some((before, from)) = recent.len().checked_sub(2).and_then(|at| recent.get(at)).copied() else {
        // After one position the velocity is unknown: up to two radii.
        return Some(Course { place: at, reach: 2.2 * radius + 6.0, last: at, way: 0.0 });
    };
    let step = late / (last - before);
    let mut place = [0, 1].map(|k| at[k] + step * (at[k] - from[k]));
    let straight = place;
    if recent.len() > 2 {
        // Least-squares parabola; time relative to the last position, in units of the last interval.
        let mut matrix = [[0.0; 3]; 3];
        let mut sides = [[0.0; 3]; 2];
        for (moment, position) in recent {
            let t = (moment - last) / (last - before);
            let terms = [1.0, t, t * t];
            // Weights decrease with age.
            let weight = 1.0 / (1.0 + t * t);
            for row in 0..3 {
                (0..3).for_each(|column| matrix[row][column] += weight * terms[row] * terms[column]);
                (0..2).for_each(|k| sides[k][row] += weight * terms[row] * position[k]);
            }
        }
        for (k, side) in sides.into_iter().enumerate() {
            if let Some((curve, _)) = solve(matrix, side) {
                place[k] = curve[0] + step * curve[1] + step * step * curve[2];
            }
        }
    }
    let way = libm::hypot(place[0] - at[0], place[1] - at[1]);
    let bend = libm::hypot(place[0] - straight[0], place[1] - straight[1]);
    let reach = match recent.len() {
        2 => 3.0 + 0.5 * radius + 0.8 * way,
        _ => 3.0 + 0.35 * radius + 0.2 * way + 0.5 * bend,
    };
    Some(Course { place, reach, last: at, way })
}

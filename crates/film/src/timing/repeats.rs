//! Frames that show the same picture again: a film of 24 frames a second that was converted to 30 repeats every fourth.

/// Differences below this, in grey values, are nothing.
const FLOOR: f64 = 1e-3;
/// Repeated frames differ by at least this factor less than all others do.
const CLEFT: f64 = 3.0;
/// The least difference of frames that are not repeated, in grey values.
const LEAST_MOTION: f64 = 0.02;
/// More pictures in a row that are the same show something at rest.
const LONGEST: usize = 4;

/// Which frames repeat the one before, by their places, in order.
///
/// `differences` has the mean absolute difference, in grey values from 0 to 255, of each two successive pictures; small ones of the
/// whole frame are enough. The frame `n + 1` belongs to `differences[n]`.
///
/// Noise makes all pictures different, but a repeated one is coded as a copy. So the differences of repeated frames and of others
/// are apart, by the largest ratio of neighbours in the sorted list. Without a ratio of 3 no frame counts as repeated; and
/// where more than four in a row are the same, nothing moves.
pub fn repeats(differences: &[f64]) -> Vec<usize> {
    let mut sorted: Vec<f64> = differences.iter().map(|difference| difference.max(FLOOR)).collect();
    sorted.sort_by(f64::total_cmp);
    let ratios = sorted.windows(2).filter(|pair| pair[1] >= LEAST_MOTION).map(|pair| (pair[1] / pair[0], pair[1]));
    let Some((ratio, moving)) = ratios.max_by(|one, other| one.0.total_cmp(&other.0)) else { return Vec::new() };
    if ratio < CLEFT {
        return Vec::new();
    }
    let places = 1..=differences.len();
    let same: Vec<usize> =
        places.zip(differences).filter(|(_, difference)| **difference < moving).map(|(at, _)| at).collect();
    same.chunk_by(|one, next| one + 1 == *next).filter(|run| run.len() <= LONGEST).flatten().copied().collect()
}

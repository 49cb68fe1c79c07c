//! Frames that show the same picture again: a film of 24 frames a second that was converted to 30 repeats every fourth.

/// So many differences on each side tell how much pictures differ there.
const AROUND: usize = 5;
/// A repeated picture differs from the one before by less than this part of them.
const PART: f64 = 0.25;
/// The least difference of pictures that are not repeated, in grey values.
const LEAST_MOTION: f64 = 0.02;
/// More pictures in a row that are the same show something at rest.
const LONGEST: usize = 4;
/// A converted film repeats at least this part of its frames; a few small differences are turning points of the motion.
const LEAST_SHARE: f64 = 0.14;

/// Which frames repeat the one before, by their places, in order; none in a film that was not converted.
///
/// `differences` has the mean absolute difference, in grey values from 0 to 255, of each two successive pictures; small ones of the
/// whole frame are enough. The frame `n + 1` belongs to `differences[n]`.
///
/// A repeated picture is coded almost as a copy, so that its difference is small among those around: below a quarter of the
/// third largest of the ten (near an end, of the second largest of fewer). At least one frame in seven and at most two in three
/// must repeat. Single repeats are not found: strong compression and turning points of the motion look the same.
pub fn repeats(differences: &[f64]) -> Vec<usize> {
    let is_repeat = |at: &usize| {
        let before = &differences[at.saturating_sub(AROUND)..*at];
        let behind = &differences[at + 1..differences.len().min(at + 1 + AROUND)];
        let mut around = [before, behind].concat();
        around.sort_by(f64::total_cmp);
        let usual = around.iter().rev().nth(around.len() / 4).copied().unwrap_or(0.0);
        usual >= LEAST_MOTION && differences[*at] < PART * usual
    };
    let same: Vec<usize> = (0..differences.len()).filter(is_repeat).map(|at| at + 1).collect();
    let runs = same.chunk_by(|one, next| one + 1 == *next).filter(|run| run.len() <= LONGEST);
    let repeats: Vec<usize> = runs.flatten().copied().collect();
    if (repeats.len() as f64) < LEAST_SHARE * differences.len() as f64 { Vec::new() } else { repeats }
}

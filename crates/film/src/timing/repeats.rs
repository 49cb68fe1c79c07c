//! Repeated pictures: a film of 24 frames per second that was converted to 30 repeats every fourth.

use super::cadence::{blocks, pattern};
use units::order::sort_numbers;

/// Number of differences on each side that define the usual difference.
const AROUND: usize = 5;
/// Upper bound of the difference of a repeat, relative to the usual one.
const PART: f64 = 0.25;
/// Smallest usual difference, grey values. Below it the picture is at rest.
const LEAST_MOTION: f64 = 0.02;
/// Maximum number of successive small differences. Longer runs show something at rest.
const LONGEST: usize = 4;
/// Minimum share of repeats in a converted film. Fewer small differences are turning points of the motion.
const LEAST_SHARE: f64 = 0.14;

/// Indices of the frames that repeat the picture before, ascending; empty for a film that was not converted.
///
/// `differences[n]`: mean absolute difference between the pictures `n` and `n + 1`, in grey values from 0 to 255. Small
/// versions of the pictures are enough.
///
/// If the repeats follow a pattern, as in a film of 25 frames per second written at 50, all are found, even if the
/// motion is slow or compression makes a picture and its repeat differ. Repeats without a pattern are found if they are
/// nearly copies and the motion around is not slow. Single repeats are not found, because strong compression and
/// turning points of the motion look alike. Repeats are not told from the turning points of a swing with a period of
/// eight frames or fewer.
pub fn repeats(differences: &[f64]) -> Vec<usize> {
    let mut repeats = Vec::new();
    for block in blocks(differences.len()) {
        let part = differences.get(block.clone()).unwrap_or_default();
        let places = pattern(part).unwrap_or_else(|| copies(part));
        repeats.extend(places.into_iter().map(|place| block.start + place + 1));
    }
    repeats
}

/// Indices of differences that are small among their neighbours: below a quarter of the third largest of the ten around
/// (near an end, of the second largest of fewer). Empty if fewer than one in seven is small.
fn copies(differences: &[f64]) -> Vec<usize> {
    let small_below = |at: usize| {
        let before = &differences[at.saturating_sub(AROUND)..at];
        let behind = &differences[at + 1..differences.len().min(at + 1 + AROUND)];
        let mut around = [before, behind].concat();
        sort_numbers(&mut around);
        let usual = around.iter().rev().nth(around.len() / 4).copied().unwrap_or(0.0);
        if usual < LEAST_MOTION { 0.0 } else { PART * usual }
    };
    // More successive small differences than in a converted film belong to something at rest.
    let is_short = |at: usize, below: f64| {
        let is_small = |place: &usize| differences[*place] < below;
        let before = (0..at).rev().take_while(is_small).take(LONGEST).count();
        before + (at..differences.len()).take_while(is_small).take(LONGEST + 1).count() <= LONGEST
    };
    let is_small = |at: &usize| differences[*at] < small_below(*at) && is_short(*at, small_below(*at));
    let small: Vec<usize> = (0..differences.len()).filter(is_small).collect();
    let copies: Vec<usize> = small.iter().copied().filter(|&at| is_sudden(differences, &small, at)).collect();
    if (copies.len() as f64) < LEAST_SHARE * differences.len() as f64 { Vec::new() } else { copies }
}

/// True if a small difference is far below the extrapolation of its neighbours. At a turning point of the motion the
/// differences decrease gradually and rise again.
fn is_sudden(differences: &[f64], small: &[usize], at: usize) -> bool {
    let is_large = |place: &usize| small.binary_search(place).is_err();
    let continued = |near: Option<usize>, far: Option<usize>| match (near, far) {
        (Some(near), Some(far)) => 2.0 * differences[near] - differences[far],
        (Some(near), None) => differences[near],
        _ => 0.0,
    };
    let mut before = (0..at).rev().filter(is_large);
    let mut behind = (at + 1..differences.len()).filter(is_large);
    let expected = (continued(before.next(), before.next()) + continued(behind.next(), behind.next())) / 2.0;
    differences[at] < PART * expected
}

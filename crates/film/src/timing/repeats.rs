//! Frames that show the same picture again: a film of 24 frames a second that was converted to 30 repeats every fourth.

use super::cadence::{blocks, pattern};

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
/// Where repeats follow a pattern, as where a film of 25 frames a second is written at 50, all of them are found, also where the
/// motion is slow and where compression makes a picture and its repeat differ. Repeats without a pattern are found where they are
/// nearly copies and the motion around is not slow. Single ones are not found: strong compression and turning points of the motion
/// look the same. So do the turning points of a swing with eight frames in a period or fewer.
pub fn repeats(differences: &[f64]) -> Vec<usize> {
    let mut repeats = Vec::new();
    for block in blocks(differences.len()) {
        let part = differences.get(block.clone()).unwrap_or_default();
        let places = pattern(part).unwrap_or_else(|| copies(part));
        repeats.extend(places.into_iter().map(|place| block.start + place + 1));
    }
    repeats
}

/// Differences that are small among those around, by their places: below a quarter of the third largest of the ten (near an end, of the
/// second largest of fewer). At least one in seven and at most two in three are.
fn copies(differences: &[f64]) -> Vec<usize> {
    let small_below = |at: usize| {
        let before = &differences[at.saturating_sub(AROUND)..at];
        let behind = &differences[at + 1..differences.len().min(at + 1 + AROUND)];
        let mut around = [before, behind].concat();
        around.sort_by(f64::total_cmp);
        let usual = around.iter().rev().nth(around.len() / 4).copied().unwrap_or(0.0);
        if usual < LEAST_MOTION { 0.0 } else { PART * usual }
    };
    // More small differences in a row than a converted film has are those of something at rest.
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

/// True if the small difference does not continue the others around it. At a turning point of the motion differences fall towards it
/// from both sides and rise again.
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

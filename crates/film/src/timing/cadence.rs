//! Patterns of repeated pictures in films that were converted to a higher frame rate.

use units::order::sort_numbers;

/// Number of frames that are examined together. The pattern may change during a long film.
const BLOCK: usize = 180;
/// Minimum number of frames and of repeats for a pattern.
const LEAST_FRAMES: usize = 18;
const LEAST_REPEATS: usize = 5;
/// Number of other differences on each side of a repeat that define the usual difference there.
const AROUND: usize = 2;
/// Upper bound of the 0.9 quantile of relative differences, over the half of the repeats with the most motion.
/// Differences in unconverted films reach more than 0.85 there, with every compression tried.
const MOST: f64 = 0.7;
/// Upper bound of the median of relative differences over all repeats.
const USUAL: f64 = 0.6;
/// Upper bound of their median in each third of a block.
const IN_A_THIRD: f64 = 0.8;
/// Lower bound of the differences beside repeats, relative to those further away.
const SLOWING: f64 = 0.85;
/// Smallest usual difference, grey values. Below it the picture is at rest.
const LEAST_MOTION: f64 = 0.02;
/// Maximum length of a pattern in frames: 5 of 12 for 25 frames per second written at 60.
const LONGEST_PATTERN: usize = 12;

/// Ranges of blocks of nearly equal length in a list of `differences` entries.
pub(super) fn blocks(differences: usize) -> impl Iterator<Item = std::ops::Range<usize>> {
    let count = (differences / BLOCK).max(1);
    (0..count).map(move |block| differences * block / count..differences * (block + 1) / count)
}

/// Indices of the differences that belong to repeated pictures. `None` if no pattern explains them. Of several
/// patterns, the one whose repeats have the smallest differences relative to their neighbours is chosen.
///
/// A film of rate `a` written at rate `b` shows the picture `floor((n a + phase)/b)` in frame `n`. Frame-rate filters
/// and 3:2 pulldown place their repeats so.
pub(super) fn pattern(differences: &[f64]) -> Option<Vec<usize>> {
    if differences.len() < LEAST_FRAMES {
        return None;
    }
    let mut best: Option<(f64, Vec<usize>)> = None;
    for length in 2..=LONGEST_PATTERN {
        for pictures in length.div_ceil(4)..=length * 5 / 6 {
            for phase in 0..length {
                let shown = |frame: usize| (frame * pictures + phase) / length;
                let places: Vec<usize> = (0..differences.len()).filter(|&at| shown(at + 1) == shown(at)).collect();
                let Some(lacking) = explained(differences, &places) else { continue };
                if best.as_ref().is_none_or(|(most, _)| lacking > *most) {
                    best = Some((lacking, places));
                }
            }
        }
    }
    best.map(|(_, places)| places)
}

/// Score of a pattern: sum of the reductions of the differences at `places`, relative to those around. `None` if the
/// tests above fail.
fn explained(differences: &[f64], places: &[usize]) -> Option<f64> {
    let is_other = |place: &usize| places.binary_search(place).is_err();
    let usual = |at: usize| {
        let around = (0..at).rev().filter(is_other).take(AROUND);
        let around = around.chain((at + 1..differences.len()).filter(is_other).take(AROUND));
        let values: Vec<f64> = around.map(|place| differences[place]).collect();
        Some(values.iter().sum::<f64>() / values.len() as f64).filter(|usual| *usual >= LEAST_MOTION)
    };
    let (own, others): (Vec<usize>, Vec<usize>) = (0..differences.len()).partition(|at| !is_other(at));
    let values = |places: Vec<usize>| places.into_iter().map(|at| differences[at]).collect::<Vec<f64>>();
    let (own, others) = (values(own), values(others));
    // Excludes most patterns quickly. In a motion that stops and goes, differences between the repeats are as small as
    // at them.
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    if own.len() < LEAST_REPEATS || mean(&own) > MOST * mean(&others) || quantile(own, 0.5)? >= quantile(others, 0.25)?
    {
        return None;
    }
    // A motion that reverses periodically slows down before and after each turning point.
    let is_beside = |at: &usize| !is_other(&(at + 1)) || at.checked_sub(1).is_some_and(|before| !is_other(&before));
    let (beside, apart): (Vec<usize>, Vec<usize>) = (0..differences.len()).filter(is_other).partition(is_beside);
    // In denser patterns most frames lie beside repeats.
    if 10 * apart.len() >= 9 * places.len() && mean(&values(beside)) < SLOWING * mean(&values(apart)) {
        return None;
    }
    // Usual difference around each repeat, and its own difference relative to that.
    let parts: Vec<(f64, f64)> =
        places.iter().filter_map(|&at| usual(at).map(|usual| (usual, differences[at] / usual))).collect();
    if parts.len() < LEAST_REPEATS.max(places.len() / 2) {
        return None;
    }
    let least = quantile(parts.iter().map(|part| part.0).collect(), 0.5)?;
    let moving = parts.iter().filter(|part| part.0 >= least).map(|part| part.1).collect();
    let is_below = |parts: Vec<f64>, share, most| quantile(parts, share).is_some_and(|part| part < most);
    let third = |third: usize| {
        let range = parts.len() * third / 3..parts.len() * (third + 1) / 3;
        parts.get(range).unwrap_or_default().iter().map(|part| part.1).collect()
    };
    let is_explained = is_below(moving, 0.9, MOST)
        && is_below(parts.iter().map(|part| part.1).collect(), 0.5, USUAL)
        && (0..3).all(|number| is_below(third(number), 0.5, IN_A_THIRD));
    is_explained.then(|| parts.iter().map(|part| (USUAL - part.1).max(-1.0)).sum())
}

/// Quantile of the values at `share` (0 to 1); `None` for an empty list.
fn quantile(mut values: Vec<f64>, share: f64) -> Option<f64> {
    sort_numbers(&mut values);
    values.get((values.len() as f64 * share) as usize).copied()
}

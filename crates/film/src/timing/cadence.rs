//! Films of one rate that were written at a higher one: every so many pictures one is shown again, in a fixed pattern.

/// Frames of a film that are examined together: a long film may have several patterns, one after the other.
const BLOCK: usize = 180;
/// A shorter film, or fewer repeats, show no pattern.
const LEAST_FRAMES: usize = 18;
const LEAST_REPEATS: usize = 5;
/// So many differences on each side, repeats left out, tell how much pictures differ there.
const AROUND: usize = 2;
/// In the half of the repeats with the most motion around, nine in ten differ by less than this part of the others. Pictures of films
/// that were not converted differ by more than 0.85 of each other there, with every kind of compression that was tried.
const MOST: f64 = 0.7;
/// Half of all repeats differ by less than this part of the others.
const USUAL: f64 = 0.6;
/// In each third of a block half of the repeats do.
const IN_A_THIRD: f64 = 0.8;
/// The differences beside repeats are at least this part of the others.
const SLOWING: f64 = 0.85;
/// The least difference of pictures that are not repeated, in grey values.
const LEAST_MOTION: f64 = 0.02;
/// Of so many frames of the written film, at most, a pattern repeats itself: 5 of 12 for 25 frames a second written at 60.
const LONGEST_PATTERN: usize = 12;

/// The blocks of a film of `frames` frames, nearly equal ones.
pub(super) fn blocks(differences: usize) -> impl Iterator<Item = std::ops::Range<usize>> {
    let count = (differences / BLOCK).max(1);
    (0..count).map(move |block| differences * block / count..differences * (block + 1) / count)
}

/// The differences in a block that belong to repeated pictures, by their places in it; `None` if no pattern explains them. Of several
/// patterns the one does whose repeats lack most of the difference that is usual around them.
///
/// A film of rate `a` that is written at rate `b` shows the picture `floor((n a + phase)/b)` in its frame `n`: so frame-rate filters and
/// pulldown by 3:2 place their repeats.
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

/// How much the differences at these places lack together, in parts of those around each, if they are those of repeated pictures.
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
    // Most patterns are far from it. What stops and goes has as small differences between the repeats of a pattern as in them.
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    if own.len() < LEAST_REPEATS || mean(&own) > MOST * mean(&others) || quantile(own, 0.5)? >= quantile(others, 0.25)?
    {
        return None;
    }
    // A motion that turns every so many frames slows down towards each turning point and behind it.
    let is_beside = |at: &usize| !is_other(&(at + 1)) || at.checked_sub(1).is_some_and(|before| !is_other(&before));
    let (beside, apart): (Vec<usize>, Vec<usize>) = (0..differences.len()).filter(is_other).partition(is_beside);
    // In denser patterns most lie beside repeats.
    if 10 * apart.len() >= 9 * places.len() && mean(&values(beside)) < SLOWING * mean(&values(apart)) {
        return None;
    }
    // How much pictures differ around a repeat, and what part of this the repeat differs by.
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

/// The value below which this share of the values lies; `None` of nothing.
fn quantile(mut values: Vec<f64>, share: f64) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    values.get((values.len() as f64 * share) as usize).copied()
}

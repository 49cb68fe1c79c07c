//! Medians of samples, of which there may be none.

use std::cmp::Ordering;
use units::order::sort;

/// Number of values up to which they are sorted.
const FEW: usize = 32;

/// Median, of an even number the upper one; 0 for an empty list. In the order of [`f64::total_cmp`].
pub(crate) fn median(values: Vec<f64>) -> f64 {
    if values.is_empty() { 0.0 } else { units::order::median(values) }
}

/// Median of each component of some shades, of an even number the upper one; 0 without shades.
pub(crate) fn median_shade<T: Copy + Default>(shades: &[[T; 3]], compare: impl Fn(&T, &T) -> Ordering) -> [T; 3] {
    [0, 1, 2].map(|k| {
        let mut values: Vec<T> = shades.iter().map(|shade| shade[k]).collect();
        let middle = values.len() / 2;
        if values.is_empty() { T::default() } else { *values.select_nth_unstable_by(middle, &compare).1 }
    })
}

/// Median of numbers without a sign, of an even number the upper one; 0 for an empty list.
pub(crate) fn magnitude(values: &[f32]) -> f64 {
    // Numbers without a sign have the order of their bits. Digits are selected from the top: first the exponent.
    let mut keys: Vec<u32> = values.iter().map(|value| value.to_bits() << 1).collect();
    let mut rank = keys.len() / 2;
    for shift in [24, 16, 8, 0] {
        if keys.len() <= FEW {
            break;
        }
        let digit = |key: u32| (key >> shift) as usize & 0xff;
        let mut counts = [0_usize; 256];
        keys.iter().for_each(|key| counts[digit(*key)] += 1);
        let mut wanted = 0;
        while let Some(rest) = rank.checked_sub(counts[wanted]) {
            rank = rest;
            wanted += 1;
        }
        // Without a branch, which would be hard to predict.
        let mut kept = 0;
        for at in 0..keys.len() {
            let key = keys[at];
            keys[kept] = key;
            kept += usize::from(digit(key) == wanted);
        }
        keys.truncate(kept);
    }
    if keys.len() <= FEW {
        sort(&mut keys);
    }
    keys.get(rank).map_or(0.0, |key| f64::from(f32::from_bits(*key >> 1)))
}

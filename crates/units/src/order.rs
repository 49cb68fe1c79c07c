//! Selection of the value of a given rank in linear time, and sorting with little code.
//!
//! The standard library's sort is compiled again for every type and comparison, about 6 kB each time. [`sort_by`] and
//! [`sort_by_key`] share one copy of it and suit everything but long lists: they call the comparison through a pointer and
//! need memory for indices.

use std::cmp::Ordering;

/// Number of values up to which they are sorted.
const FEW: usize = 32;

/// Value at index `rank`, from 0, in the order of [`f64::total_cmp`]; NaN if there are not as many values.
pub fn nth(values: &[f64], rank: usize) -> f64 {
    select(values.iter().map(|value| key(*value)).collect(), rank).map_or(f64::NAN, value)
}

/// Median of the magnitudes of numbers, for an even number the upper one of the two middle values; NaN without values.
pub fn median_magnitude(values: &[f32]) -> f32 {
    // Numbers without a sign have the order of their bits.
    let magnitudes: Vec<u32> = values.iter().map(|value| value.abs().to_bits()).collect();
    let half = magnitudes.len() / 2;
    select(magnitudes, half).map_or(f32::NAN, f32::from_bits)
}

/// Key at index `rank`, from 0, in their order; none if there are not as many.
///
/// Digits are selected byte by byte from the top, as in a radix sort. The standard library's selection is quadratic for
/// equal values if compiled for size, as in the page, and the steps of an evenly sampled record are all equal.
fn select<K: Copy + Ord + Into<u64>>(mut keys: Vec<K>, mut rank: usize) -> Option<K> {
    if rank >= keys.len() {
        return None;
    }
    for byte in (0..size_of::<K>()).rev() {
        if keys.len() <= FEW {
            break;
        }
        let digit = |key: K| (key.into() >> (8 * byte)) as usize & 0xff;
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
    // The remaining keys are few, or all equal.
    if keys.len() <= FEW {
        sort(&mut keys);
    }
    keys.get(rank).copied()
}

/// Median, for an even number the upper one of the two middle values; NaN without values.
pub fn median(values: Vec<f64>) -> f64 {
    nth(&values, values.len() / 2)
}

/// Median, for an even number the mean of the two middle values; NaN without values.
pub fn middle(values: Vec<f64>) -> f64 {
    let (half, is_even) = (values.len() / 2, values.len().is_multiple_of(2));
    let upper = nth(&values, half);
    if is_even && half > 0 { 0.5 * (nth(&values, half - 1) + upper) } else { upper }
}

/// Sorts numbers in the order of [`f64::total_cmp`].
pub fn sort_numbers(numbers: &mut [f64]) {
    numbers.sort_unstable_by(f64::total_cmp);
}

/// Sorts by the natural order; equal items keep their order.
pub fn sort<T: Ord>(items: &mut [T]) {
    sort_by(items, T::cmp);
}

/// Sorts by a key; items with equal keys keep their order.
pub fn sort_by_key<T, K: Ord>(items: &mut [T], mut key: impl FnMut(&T) -> K) {
    sort_by(items, |one, other| key(one).cmp(&key(other)));
}

/// Sorts by a comparison; equal items keep their order.
pub fn sort_by<T>(items: &mut [T], mut compare: impl FnMut(&T, &T) -> Ordering) {
    let mut places = places(items.len(), &mut |one, other| compare(&items[one], &items[other]));
    // Swaps along the cycles of the permutation until every item is at its place.
    for at in 0..items.len() {
        while places[at] != at {
            let place = places[at];
            items.swap(at, place);
            places.swap(at, place);
        }
    }
}

/// Place of each item in the order of a comparison of two indices.
fn places(count: usize, compare: &mut dyn FnMut(usize, usize) -> Ordering) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|&one, &other| compare(one, other));
    let mut places = vec![0; count];
    for (place, &item) in order.iter().enumerate() {
        places[item] = place;
    }
    places
}

const SIGN: u64 = 1 << 63;

/// Integer key with the same order as the values.
fn key(value: f64) -> u64 {
    let bits = value.to_bits();
    if bits & SIGN == 0 { bits | SIGN } else { !bits }
}

fn value(key: u64) -> f64 {
    f64::from_bits(if key & SIGN == 0 { !key } else { key & !SIGN })
}

#[cfg(test)]
mod tests {
    use super::{median, median_magnitude, middle, nth, sort, sort_by, sort_by_key, sort_numbers};
    use proptest::prelude::*;

    fn agrees(values: &[f64]) {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        for (rank, expected) in sorted.iter().enumerate() {
            assert_eq!(nth(values, rank).to_bits(), expected.to_bits(), "{rank} of {values:?}");
        }
        assert!(nth(values, values.len()).is_nan());
    }

    #[test]
    fn medians_of_even_numbers_are_the_upper_one_or_the_mean() {
        for (values, upper, mean) in [(vec![3.0, 1.0, 2.0], 2.0, 2.0), (vec![4.0, 1.0, 2.0, 3.0], 3.0, 2.5)] {
            assert_eq!((median(values.clone()), middle(values)), (upper, mean));
        }
        assert!(median(Vec::new()).is_nan() && middle(Vec::new()).is_nan());
    }

    proptest! {
        #[test]
        fn items_are_sorted_as_by_the_standard_library(items in prop::collection::vec((0_u8..6, any::<u8>()), 0..80)) {
            let mut expected = items.clone();
            expected.sort_by_key(|item| item.0);
            let (mut by_key, mut by) = (items.clone(), items.clone());
            sort_by_key(&mut by_key, |item| item.0);
            prop_assert_eq!(&by_key, &expected);
            sort_by(&mut by, |one, other| other.0.cmp(&one.0));
            let mut reversed = items.clone();
            reversed.sort_by_key(|item| std::cmp::Reverse(item.0));
            prop_assert_eq!(&by, &reversed);
            let (mut whole, mut whole_expected) = (items.clone(), items);
            sort(&mut whole);
            whole_expected.sort();
            prop_assert_eq!(whole, whole_expected);
        }

        #[test]
        fn numbers_are_sorted_by_their_total_order(mut numbers in prop::collection::vec(any::<f64>(), 0..40)) {
            sort_numbers(&mut numbers);
            prop_assert!(numbers.windows(2).all(|pair| pair[0].total_cmp(&pair[1]).is_le()));
        }
    }

    #[test]
    fn ranks_are_those_of_sorting() {
        agrees(&[]);
        agrees(&[0.1; 100]);
        agrees(&[0.0, -0.0, f64::NAN, f64::INFINITY, -f64::NAN, f64::MIN_POSITIVE, 5e-324, -1.0, 1.0]);
        let steps: Vec<f64> = (0..200_u32).map(|row| f64::from(row + 1) / 30.0 - f64::from(row) / 30.0).collect();
        agrees(&steps);
    }

    proptest! {
        #[test]
        fn ranks_of_any_values(values in prop::collection::vec(prop::num::f64::ANY, 0..200), equal in 1..50_usize) {
            agrees(&values);
            let repeated: Vec<f64> = values.iter().take(equal).cycle().take(values.len()).copied().collect();
            agrees(&repeated);
        }

        #[test]
        fn the_median_of_magnitudes_does_not_see_signs(values in prop::collection::vec(prop::num::f32::ANY, 1..200)) {
            let mut magnitudes: Vec<f32> = values.iter().map(|value| value.abs()).collect();
            magnitudes.sort_by(f32::total_cmp);
            prop_assert_eq!(median_magnitude(&values).to_bits(), magnitudes[magnitudes.len() / 2].to_bits());
        }
    }
}

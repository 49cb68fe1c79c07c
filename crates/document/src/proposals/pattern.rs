//! Which powers a rate of change is the sum of.

/// Maximum number of powers of which all combinations are tried.
const MOST: usize = 12;
/// Greatest residual that counts as rounding, relative to the amounts that are added.
const ROUNDING: f64 = 1e-8;

/// A power that may contribute to a rate.
#[derive(Clone, Debug)]
pub struct Power {
    /// Values at the points.
    pub values: Vec<f64>,
    /// True if it is expected to contribute.
    pub expected: bool,
}

/// Amounts against which a residual is compared, one per point.
pub fn amounts(lists: &[&[f64]]) -> Vec<f64> {
    let points = lists.first().map_or(0, |list| list.len());
    (0..points).map(|point| lists.iter().map(|list| list[point].abs()).sum()).collect()
}

/// True if a residual is rounding at all points at which it is a number. The mean amount is the scale of small points.
pub fn is_rounding(residual: &[f64], amounts: &[f64]) -> bool {
    let numbers =
        || residual.iter().zip(amounts).filter(|(residual, amount)| residual.is_finite() && amount.is_finite());
    let count = numbers().count();
    if count == 0 {
        return false;
    }
    let mean = numbers().map(|(_, amount)| amount).sum::<f64>() / count as f64;
    numbers().all(|(residual, amount)| residual.abs() <= ROUNDING * (amount + mean))
}

/// Which powers add up to `rate`: the combination nearest to the expected one; `None` if no combination does.
pub fn combination(rate: &[f64], powers: &[Power], amounts: &[f64]) -> Option<Vec<bool>> {
    let expected: Vec<bool> = powers.iter().map(|power| power.expected).collect();
    let fits = |chosen: &[bool]| is_rounding(&residual(rate, powers, chosen), amounts);
    if fits(&expected) {
        return Some(expected);
    }
    if powers.len() > MOST {
        return None;
    }
    let mut masks: Vec<u32> = (1..1u32 << powers.len()).collect();
    masks.sort_by_key(|mask| mask.count_ones());
    let flipped = |mask: u32| expected.iter().enumerate().map(|(index, is)| is ^ (mask >> index & 1 == 1)).collect();
    masks.into_iter().map(flipped).find(|chosen: &Vec<bool>| fits(chosen))
}

/// `rate` without the chosen powers, one value per point.
fn residual(rate: &[f64], powers: &[Power], chosen: &[bool]) -> Vec<f64> {
    let mut residual = rate.to_vec();
    for (power, _) in powers.iter().zip(chosen).filter(|(_, chosen)| **chosen) {
        residual.iter_mut().zip(&power.values).for_each(|(left, value)| *left -= value);
    }
    residual
}

/// The one power that explains what is left of `rate` with a factor: its index and the factor. `None` if none does.
pub fn factor(rate: &[f64], powers: &[Power], amounts: &[f64]) -> Option<(usize, f64)> {
    let expected: Vec<bool> = powers.iter().map(|power| power.expected).collect();
    (0..powers.len()).find_map(|index| {
        let others: Vec<bool> = (0..powers.len()).map(|other| other != index && expected[other]).collect();
        let left = residual(rate, powers, &others);
        let factor = ratio(&left, &powers[index].values)?;
        let rest: Vec<f64> =
            left.iter().zip(&powers[index].values).map(|(left, value)| left - factor * value).collect();
        is_rounding(&rest, amounts).then_some((index, factor))
    })
}

/// Factor of `unit` in `values` by least squares.
fn ratio(values: &[f64], unit: &[f64]) -> Option<f64> {
    let pairs = || values.iter().zip(unit).filter(|(value, unit)| value.is_finite() && unit.is_finite());
    let square: f64 = pairs().map(|(_, unit)| unit * unit).sum();
    (square > 0.0).then(|| pairs().map(|(value, unit)| value * unit).sum::<f64>() / square)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn power(values: &[f64], expected: bool) -> Power {
        Power { values: values.to_vec(), expected }
    }

    #[test]
    fn the_nearest_combination_is_found() {
        let (a, b, c) = ([1.0, -2.0, 3.0], [2.0, 5.0, 1.0], [0.5, 0.25, -4.0]);
        let powers = [power(&a, true), power(&b, false), power(&c, false)];
        let amounts = amounts(&[&a, &b, &c]);
        assert_eq!(combination(&a, &powers, &amounts), Some(vec![true, false, false]));
        assert_eq!(combination(&c, &powers, &amounts), Some(vec![false, false, true]));
        let twice: Vec<f64> = a.iter().zip(&b).map(|(a, b)| a + 2.0 * b).collect();
        assert_eq!(combination(&twice, &powers, &amounts), None);
        assert_eq!(factor(&twice, &powers, &amounts).map(|(index, factor)| (index, factor.round())), Some((1, 2.0)));
    }

    #[test]
    fn points_without_a_value_do_not_count() {
        assert!(is_rounding(&[0.0, f64::NAN], &[1.0, 1.0]));
        assert!(!is_rounding(&[f64::NAN], &[1.0]));
        assert!(!is_rounding(&[1e-3, 0.0], &[1.0, 1.0]));
    }
}

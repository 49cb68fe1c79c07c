//! Several starts of a fit: lists and ranges of `--start`.

use crate::names::{Assignment, names_in};
use crate::refusal::Refusal;
use crate::values::Reader;
use units::Unit;

/// Maximum number of starts from which a fit is made.
const MOST: usize = 200;

/// Starts of varied numbers that have several; the fit is made from each combination.
#[derive(Clone, Debug, Default)]
pub struct Starts {
    /// Index of the number among the varied numbers, and its starts, SI.
    lists: Vec<(usize, Vec<f64>)>,
}

impl Starts {
    /// Takes a value, a list `3,5,8` or a range `3..9 step 1` of a varied number. Returns the first start, SI.
    pub(super) fn add(
        &mut self,
        reader: &mut Reader,
        (place, start): (usize, &Assignment),
        unit: &Unit,
        parameters: &[f64],
    ) -> Result<Option<f64>, Refusal> {
        let what = format!("--start {}", start.name);
        let mut value = |text: &str| reader.value(&what, text, unit, parameters);
        let values: Vec<f64> = match start.value.split_once("..") {
            None => names_in(&start.value).into_iter().map(&mut value).collect::<Result<_, _>>()?,
            Some((low, rest)) => {
                let Some((high, step)) = rest.split_once("step") else {
                    return Err(Refusal::with_hint(
                        format!("{what}={} is a range without a step", start.value),
                        format!("write --start '{}={} step STEP', or a list, 3,5,8", start.name, start.value),
                    ));
                };
                range(&what, [value(low.trim())?, value(high.trim())?, value(step.trim())?])?
            }
        };
        let first = values.first().copied();
        if values.len() > 1 {
            self.lists.push((place, values));
        }
        if self.count() > MOST {
            return Err(Refusal::with_hint(
                format!("{what}: these are {} starts", self.count()),
                format!("give at most {MOST}, over all numbers together"),
            ));
        }
        Ok(first)
    }

    /// Starts of a varied number; empty if it has only one.
    pub(super) fn of(&self, place: usize) -> Vec<f64> {
        self.lists.iter().filter(|(own, _)| *own == place).flat_map(|(_, values)| values.clone()).collect()
    }

    /// Number of combinations.
    pub fn count(&self) -> usize {
        self.lists.iter().fold(1, |count, (_, values)| count.saturating_mul(values.len()))
    }

    /// Starts of combination `number`, each with the index of its varied number.
    pub(super) fn combination(&self, mut number: usize) -> Vec<(usize, f64)> {
        let mut found = Vec::new();
        for (place, values) in &self.lists {
            found.push((*place, values[number % values.len()]));
            number /= values.len();
        }
        found
    }
}

/// Values from `low` up to `high`, both included, SI.
fn range(what: &str, [low, high, step]: [f64; 3]) -> Result<Vec<f64>, Refusal> {
    let count = (high - low) / step;
    if !(step > 0.0 && (0.0..1e6).contains(&count)) {
        return Err(Refusal::with_hint(
            format!("{what}: the range has no values"),
            "write LO..HI step STEP, with HI above LO and STEP above 0",
        ));
    }
    Ok((0..=(count + 1e-9) as usize).map(|place| low + place as f64 * step).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_hold_both_ends_and_every_combination_is_made() {
        let of = |ends| range("--start w", ends).ok();
        assert_eq!(of([3.0, 9.0, 2.0]), Some(vec![3.0, 5.0, 7.0, 9.0]));
        assert_eq!(of([0.1, 0.3, 0.1]).map(|values| values.len()), Some(3));
        assert_eq!(of([1.0, 1.0, 1.0]), Some(vec![1.0]));
        for wrong in [[9.0, 3.0, 1.0], [3.0, 9.0, 0.0], [3.0, 9.0, -1.0], [0.0, 1.0, 1e-9], [f64::NAN, 1.0, 1.0]] {
            assert_eq!(of(wrong), None, "{wrong:?}");
        }
        let starts = Starts { lists: vec![(1, vec![1.0, 2.0]), (4, vec![5.0, 6.0, 7.0])] };
        let all: Vec<_> = (0..starts.count()).map(|number| starts.combination(number)).collect();
        assert_eq!(all.len(), 6);
        assert!(all.contains(&vec![(1, 2.0), (4, 7.0)]) && all.contains(&vec![(1, 1.0), (4, 5.0)]));
    }
}

//! With which parameters the runs are computed.

use std::ops::Range;
use units::split_mix::{SplitMix64, scramble};

/// A parameter that differs between the runs.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Index in [`program::Model::parameters`].
    pub parameter: usize,
    /// Its values.
    pub values: Values,
}

/// Values of a parameter, SI units.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// These values.
    List(Vec<f64>),
    /// From the least to the greatest, both included if the step reaches it.
    Range {
        /// Least value.
        low: f64,
        /// Greatest value.
        high: f64,
        /// Distance of the values, greater than 0; `None` for samples between the ends.
        step: Option<f64>,
    },
}

/// Which combinations of the values are computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Points {
    /// All combinations; the values of the last axis follow one another.
    Grid,
    /// This many independent draws, each value with the same probability. The seed decides them.
    Random(u64, u64),
    /// This many points of the sequence of J. H. Halton, *Numer. Math.* 2 (1960), 84, which fill the ranges evenly.
    Halton(u64),
}

/// Why a plan cannot be made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PlanError {
    /// A grid needs a step for this axis.
    NoStep(usize),
    /// There are more runs than [`Plan::MOST`].
    TooMany,
    /// More axes than [`Plan::AXES`] are sampled by the sequence of Halton.
    TooManyAxes,
    /// Two axes are of the same parameter, that of the second one.
    Twice(usize),
}

/// The parameters of all runs.
#[derive(Clone, Debug)]
pub struct Plan {
    axes: Vec<Axis>,
    points: Points,
    runs: u64,
}

/// Bases of the sequence of Halton, one for each axis.
const PRIMES: [u64; Plan::AXES] = [2, 3, 5, 7, 11, 13, 17, 19];

impl Plan {
    /// Greatest number of runs.
    pub const MOST: u64 = 1 << 40;

    /// Greatest number of axes of the sequence of Halton; with more of them its points lie on lines.
    pub const AXES: usize = 8;

    /// A plan of these axes.
    ///
    /// # Errors
    /// See [`PlanError`].
    pub fn new(axes: Vec<Axis>, points: Points) -> Result<Self, PlanError> {
        for (place, axis) in axes.iter().enumerate() {
            if axes[..place].iter().any(|before| before.parameter == axis.parameter) {
                return Err(PlanError::Twice(axis.parameter));
            }
        }
        let runs = match points {
            Points::Grid => {
                let mut runs = 1_u64;
                for (place, axis) in axes.iter().enumerate() {
                    let count = axis.values.count().ok_or(PlanError::NoStep(place))?;
                    runs = runs.checked_mul(count).ok_or(PlanError::TooMany)?;
                }
                runs
            }
            Points::Random(runs, _) => runs,
            Points::Halton(_) if axes.len() > Self::AXES => return Err(PlanError::TooManyAxes),
            Points::Halton(runs) => runs,
        };
        if runs > Self::MOST { Err(PlanError::TooMany) } else { Ok(Self { axes, points, runs }) }
    }

    /// The parameters that differ.
    pub fn axes(&self) -> &[Axis] {
        &self.axes
    }

    /// Number of runs.
    pub fn runs(&self) -> u64 {
        self.runs
    }

    /// Numbers of the runs of one of several equal shares, which differ by at most one run; `share` counts from 0.
    pub fn share(&self, share: u64, shares: u64) -> Range<u64> {
        let first = |share: u64| (u128::from(self.runs) * u128::from(share) / u128::from(shares.max(1))) as u64;
        first(share)..first(share + 1)
    }

    /// Sets `values` to the value of each axis in a run, SI units. Runs count from 0.
    pub fn set(&self, run: u64, values: &mut Vec<f64>) {
        values.clear();
        match self.points {
            Points::Grid => {
                let mut rest = run;
                values.resize(self.axes.len(), 0.0);
                for (value, axis) in values.iter_mut().zip(&self.axes).rev() {
                    let count = axis.values.count().unwrap_or(1).max(1);
                    *value = axis.values.get(rest % count);
                    rest /= count;
                }
            }
            Points::Random(_, seed) => {
                // A generator for each run, so that every share draws the same.
                let mut random = SplitMix64::new(scramble(seed) ^ scramble(run.wrapping_add(1)));
                values.extend(self.axes.iter().map(|axis| axis.values.at((random.bits() >> 11) as f64 * EPSILON)));
            }
            Points::Halton(_) => {
                let axes = self.axes.iter().zip(PRIMES);
                values.extend(axes.map(|(axis, base)| axis.values.at(mirrored(run + 1, base))));
            }
        }
    }
}

/// 2^-53, the distance of the random numbers in 0..1.
const EPSILON: f64 = 1.0 / (1_u64 << 53) as f64;

/// The digits of a number in a base, mirrored at the point: 6 is 110 in base 2, and 0.011 is 0.375.
fn mirrored(mut number: u64, base: u64) -> f64 {
    let (mut value, mut scale) = (0.0, 1.0);
    while number > 0 {
        scale /= base as f64;
        value += (number % base) as f64 * scale;
        number /= base;
    }
    value
}

impl Values {
    /// Number of values of a grid; `None` for a range without a step.
    fn count(&self) -> Option<u64> {
        match self {
            Self::List(values) => Some(values.len() as u64),
            // The greatest value is included in spite of rounding. A conversion to an integer saturates.
            Self::Range { low, high, step } => {
                step.map(|step| (((high - low) / step + 1e-9).floor() as u64).saturating_add(1))
            }
        }
    }

    /// Value of a grid with this number.
    fn get(&self, number: u64) -> f64 {
        match self {
            Self::List(values) => values.get(number as usize).copied().unwrap_or(f64::NAN),
            Self::Range { low, step, .. } => low + number as f64 * step.unwrap_or(0.0),
        }
    }

    /// Value at a part of the range, from 0 to 1 without 1.
    fn at(&self, part: f64) -> f64 {
        match self {
            Self::List(values) => self.get((part * values.len() as f64) as u64),
            Self::Range { step: Some(_), .. } => {
                let count = self.count().unwrap_or(1);
                self.get(((part * count as f64) as u64).min(count - 1))
            }
            Self::Range { low, high, step: None } => low + part * (high - low),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(parameter: usize, values: Values) -> Axis {
        Axis { parameter, values }
    }

    fn range(low: f64, high: f64, step: Option<f64>) -> Values {
        Values::Range { low, high, step }
    }

    fn all(plan: &Plan) -> Vec<Vec<f64>> {
        let values = |run: u64| {
            let mut values = Vec::new();
            plan.set(run, &mut values);
            values
        };
        (0..plan.runs()).map(values).collect()
    }

    #[test]
    fn a_grid_has_all_combinations_with_both_ends() {
        let axes = vec![axis(0, Values::List(vec![5.0, 1.0])), axis(2, range(0.0, 0.3, Some(0.1)))];
        let plan = Plan::new(axes, Points::Grid).unwrap();
        let found = all(&plan);
        assert_eq!(found.len(), 8);
        assert_eq!((found[0].as_slice(), found[4].as_slice()), (&[5.0, 0.0][..], &[1.0, 0.0][..]));
        assert!((found[7][1] - 0.3).abs() < 1e-15);
    }

    /// Shares cover a plan once and in order, and differ by at most one run.
    #[test]
    fn shares_are_the_whole() {
        for runs in [0, 1, 7, 100, Plan::MOST] {
            let plan = Plan::new(vec![axis(0, range(0.0, 1.0, None))], Points::Random(runs, 1)).unwrap();
            for shares in [1, 2, 3, 16, 1000] {
                let all: Vec<_> = (0..shares).map(|share| plan.share(share, shares)).collect();
                assert_eq!((all[0].start, all.last().map(|last| last.end)), (0, Some(runs)));
                assert!(all.windows(2).all(|pair| pair[0].end == pair[1].start));
                let lengths = || all.iter().map(|share| share.end - share.start);
                assert!(lengths().max().unwrap() - lengths().min().unwrap() <= 1);
            }
        }
    }

    /// Mean and variance of a uniform distribution, and no correlation of two axes.
    #[test]
    fn samples_are_uniform() {
        for (points, allowed) in [(Points::Random(20_000, 3), 0.02), (Points::Halton(20_000), 0.001)] {
            let axes = vec![axis(0, range(-1.0, 1.0, None)), axis(1, range(-1.0, 1.0, None))];
            let found = all(&Plan::new(axes, points).unwrap());
            let mean =
                |of: &dyn Fn(&[f64]) -> f64| found.iter().map(|values| of(values)).sum::<f64>() / found.len() as f64;
            assert!(mean(&|values| values[0]).abs() < allowed && mean(&|values| values[1]).abs() < allowed);
            assert!((mean(&|values| values[0] * values[0]) - 1.0 / 3.0).abs() < allowed);
            assert!(mean(&|values| values[0] * values[1]).abs() < allowed, "{points:?}");
            assert!(found.iter().flatten().all(|value| (-1.0..1.0).contains(value)));
        }
        let first = Plan::new(vec![axis(0, range(0.0, 1.0, None))], Points::Halton(6)).unwrap();
        assert_eq!(all(&first).concat(), [0.5, 0.25, 0.75, 0.125, 0.625, 0.375]);
        let drawn = Plan::new(vec![axis(0, Values::List(vec![2.0, 3.0]))], Points::Random(100, 1)).unwrap();
        assert!(all(&drawn).concat().iter().all(|value| [2.0, 3.0].contains(value)));
    }

    #[test]
    fn plans_that_cannot_be_are_refused() {
        let open = || axis(0, range(0.0, 1.0, None));
        assert_eq!(Plan::new(vec![open()], Points::Grid).unwrap_err(), PlanError::NoStep(0));
        assert_eq!(Plan::new(vec![open(), open()], Points::Halton(1)).unwrap_err(), PlanError::Twice(0));
        let fine = |parameter| axis(parameter, range(0.0, 1.0, Some(1e-12)));
        assert_eq!(Plan::new(vec![fine(0), fine(1)], Points::Grid).unwrap_err(), PlanError::TooMany);
        assert_eq!(
            Plan::new(vec![axis(0, range(0.0, 1e300, Some(1e-300)))], Points::Grid).unwrap_err(),
            PlanError::TooMany
        );
        let many = (0..9).map(|parameter| axis(parameter, range(0.0, 1.0, None))).collect();
        assert_eq!(Plan::new(many, Points::Halton(1)).unwrap_err(), PlanError::TooManyAxes);
    }
}

//! Ranking of several theories of the same data.

use crate::fit::observed::ObservationFit;
use crate::fit::outcome::Outcome;
use units::Language;
use units::order::{sort_by, sort_by_key};

/// Rank of a theory among others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ranked {
    /// Index among the given theories.
    pub index: usize,
    /// Rank, from 1. Theories that give the same curve share a rank.
    pub place: usize,
    /// AICc minus that of the best theory, multiplied by [`worth`]: in units of independent values. 0 for equally good
    /// theories, infinite without an AICc.
    pub difference: f64,
    /// Akaike weight from this difference; the weights of all theories add up to 1.
    pub weight: f64,
}

/// Two curves are the same if the root mean square of their difference is below this part of the residuals'. Sums of
/// squares then differ by 1e-6, less than the accuracy of search and integration.
const SAME: f64 = 1e-3;

/// Effective share of independent information per value, allowing for autocorrelated residuals: 0 to 1.
pub fn worth(outcome: &Outcome) -> f64 {
    (outcome.independent / outcome.n.max(1) as f64).clamp(0.0, 1.0)
}

/// Orders theories by AICc, the smallest first; those without one come last, in their order. AICc overestimates the
/// information in correlated residuals, so differences and weights are multiplied by the [`worth`] of the best theory.
/// Theories that give the same curve share a rank; among them the one with the fewest varied numbers comes first.
pub fn rank(outcomes: &[&Outcome]) -> Vec<Ranked> {
    let aicc: Vec<Option<f64>> = outcomes.iter().map(|outcome| outcome.aicc).collect();
    let ranked = ordered(&aicc);
    let worth = ranked.first().and_then(|best| outcomes.get(best.index)).map_or(1.0, |best| worth(best));
    let at = |ranked: &Ranked| outcomes.get(ranked.index);
    let same = |one: &Ranked, other: &Ranked| at(one).zip(at(other)).is_some_and(|(one, other)| same_curve(one, other));
    let simple = |one: &Ranked| at(one).map_or(0, |outcome| outcome.parameters.len());
    let mut ranked = shared(ranked, same, simple);
    weigh(&mut ranked, worth);
    ranked
}

/// For each rank shared by several theories, the rank and a sentence about it. `title` takes the index of a theory.
pub fn ties(
    ranked: &[Ranked],
    outcomes: &[&Outcome],
    language: Language,
    title: impl Fn(usize) -> String,
) -> Vec<(usize, String)> {
    let sentence = |tied: &[Ranked]| {
        let quote = |one: &Ranked| {
            let [open, close] = language.say_all(["“", "”"]);
            [open, &title(one.index), close].concat()
        };
        let names = language.join(&tied.iter().map(quote).collect::<Vec<_>>());
        let mut counts = tied.iter().filter_map(|one| Some(outcomes.get(one.index)?.parameters.len()));
        let first = counts.next();
        let simpler = if counts.any(|count| Some(count) != first) {
            language.say(" The one with the fewest parameters stands first.")
        } else {
            ""
        };
        let same = language.say(" give the same curve: the data cannot tell them apart, and they share a place.");
        [&names, same, simpler].concat()
    };
    let tied = ranked.chunk_by(|one, other| one.place == other.place).filter(|tied| tied.len() > 1);
    tied.map(|tied| (tied[0].place, sentence(tied))).collect()
}

/// True if two fits of the same values give the same curve with as many determined numbers, so that they differ only by
/// rounding.
fn same_curve(one: &Outcome, other: &Outcome) -> bool {
    let same = |one: &ObservationFit, other: &ObservationFit| {
        let both = || one.fitted.iter().zip(&other.fitted).zip(&one.inside).filter(|(_, inside)| **inside);
        let square = both().fold(0.0, |sum, ((one, other), _)| sum + (one - other) * (one - other));
        let size = SAME * one.rmse.min(other.rmse);
        one.times == other.times && square <= both().count() as f64 * size * size
    };
    let (these, those) = (&one.observations, &other.observations);
    let curves = || these.len() == those.len() && these.iter().zip(those).all(|(one, other)| same(one, other));
    let counts = (one.n, one.dof) == (other.n, other.dof);
    one.aicc.is_some() && other.aicc.is_some() && counts && ((one.exact && other.exact) || curves())
}

fn ordered(aicc: &[Option<f64>]) -> Vec<Ranked> {
    let best = aicc.iter().flatten().copied().fold(f64::INFINITY, f64::min);
    let difference = |aicc: f64| if aicc == best { 0.0 } else { aicc - best };
    let place = |(index, aicc): (usize, &Option<f64>)| {
        let difference = aicc.filter(|aicc| !aicc.is_nan()).map_or(f64::INFINITY, difference);
        Ranked { index, place: 0, difference, weight: 0.0 }
    };
    let mut ranked: Vec<Ranked> = aicc.iter().enumerate().map(place).collect();
    sort_by(&mut ranked, |a, b| a.difference.total_cmp(&b.difference));
    ranked
}

/// Groups theories that are the `same` at one rank, the simplest first.
fn shared(
    ranked: Vec<Ranked>,
    same: impl Fn(&Ranked, &Ranked) -> bool,
    simple: impl Fn(&Ranked) -> usize,
) -> Vec<Ranked> {
    let mut groups: Vec<Vec<Ranked>> = Vec::new();
    for one in ranked {
        match groups.iter_mut().find(|group| group.first().is_some_and(|first| same(first, &one))) {
            Some(group) => group.push(one),
            None => groups.push(vec![one]),
        }
    }
    let mut ranked = Vec::new();
    for mut group in groups {
        let (place, difference) = (ranked.len() + 1, group.first().map_or(0.0, |first| first.difference));
        sort_by_key(&mut group, |one| (simple(one), one.index));
        ranked.extend(group.into_iter().map(|one| Ranked { place, difference, ..one }));
    }
    ranked
}

fn weigh(ranked: &mut [Ranked], worth: f64) {
    // Infinity times 0 would be NaN.
    for one in ranked.iter_mut().filter(|one| one.difference.is_finite()) {
        one.difference *= worth;
        one.weight = libm::exp(-0.5 * one.difference);
    }
    let sum: f64 = ranked.iter().map(|one| one.weight).sum();
    if sum > 0.0 {
        ranked.iter_mut().for_each(|one| one.weight /= sum);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rank(aicc: &[Option<f64>], worth: f64) -> Vec<Ranked> {
        let mut ranked = ordered(aicc);
        weigh(&mut ranked, worth);
        ranked
    }

    #[test]
    fn weights_of_evidence() {
        let ranked = rank(&[Some(-100.0), None, Some(-102.0)], 1.0);
        assert_eq!(ranked.iter().map(|one| one.index).collect::<Vec<_>>(), [2, 0, 1]);
        assert_eq!(ranked[1].difference, 2.0);
        // 1 : 1/e
        assert!((ranked[0].weight / ranked[1].weight - libm::exp(1.0)).abs() < 1e-12);
        assert_eq!(ranked[2].weight, 0.0);
    }

    #[test]
    fn correlated_values_weigh_less() {
        let ranked = rank(&[Some(10.0), Some(30.0)], 0.1);
        assert!((ranked[0].weight / ranked[1].weight - libm::exp(1.0)).abs() < 1e-12);
        assert_eq!(ranked[1].difference, 2.0);
    }

    #[test]
    fn what_is_the_same_shares_a_place() {
        let numbers = [3, 2, 1, 2];
        let ranked = shared(
            ordered(&[Some(1.0), Some(9.0), Some(1.0 + 1e-9), None]),
            |one, other| [one, other].iter().all(|one| [0, 2].contains(&one.index)),
            |one| numbers[one.index],
        );
        let found: Vec<(usize, usize)> = ranked.iter().map(|one| (one.index, one.place)).collect();
        assert_eq!(found, [(2, 1), (0, 1), (1, 3), (3, 4)]);
        assert_eq!(ranked[0].difference.to_bits(), ranked[1].difference.to_bits());
    }

    #[test]
    fn what_is_not_finite_is_still_ordered() {
        let ranked = rank(&[Some(3.0), Some(f64::NEG_INFINITY), None, Some(f64::NEG_INFINITY), Some(f64::NAN)], 1.0);
        assert_eq!(ranked.iter().map(|one| one.index).collect::<Vec<_>>(), [1, 3, 0, 2, 4]);
        assert_eq!(ranked.iter().map(|one| one.weight).collect::<Vec<_>>(), [0.5, 0.5, 0.0, 0.0, 0.0]);
        assert_eq!((ranked[0].difference, ranked[1].difference), (0.0, 0.0));
    }
}

//! Several theories of the same data, best first.

use super::outcome::Outcome;

/// A theory's place among others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ranked {
    /// Which of the given ones.
    pub index: usize,
    /// How much larger its AICc is than the best one's; 0 for all that are as good. Infinite where it has none.
    pub difference: f64,
    /// Its share of the evidence among the given theories (Akaike's weight), differences counted by the values that are
    /// independent.
    pub weight: f64,
}

/// For how much of a value each one counts, where residuals are correlated: the part of them that is independent.
pub fn worth(outcome: &Outcome) -> f64 {
    (outcome.independent / outcome.n.max(1) as f64).clamp(0.0, 1.0)
}

/// Orders theories by AICc, the smallest first; those without one come last, in their order. The log-likelihood of correlated
/// residuals adds up less than AICc supposes: where each of the best theory's values counts for the part [`worth`], so do
/// the differences of which the weights are made.
pub fn rank(outcomes: &[&Outcome]) -> Vec<Ranked> {
    let aicc: Vec<Option<f64>> = outcomes.iter().map(|outcome| outcome.aicc).collect();
    let mut ranked = ordered(&aicc);
    let worth = ranked.first().and_then(|best| outcomes.get(best.index)).map_or(1.0, |best| worth(best));
    weigh(&mut ranked, worth);
    ranked
}

fn ordered(aicc: &[Option<f64>]) -> Vec<Ranked> {
    let best = aicc.iter().flatten().copied().fold(f64::INFINITY, f64::min);
    let difference = |aicc: f64| if aicc == best { 0.0 } else { aicc - best };
    let place = |(index, aicc): (usize, &Option<f64>)| {
        let difference = aicc.filter(|aicc| !aicc.is_nan()).map_or(f64::INFINITY, difference);
        Ranked { index, difference, weight: 0.0 }
    };
    let mut ranked: Vec<Ranked> = aicc.iter().enumerate().map(place).collect();
    ranked.sort_by(|a, b| a.difference.total_cmp(&b.difference));
    ranked
}

fn weigh(ranked: &mut [Ranked], worth: f64) {
    for one in ranked.iter_mut() {
        // Nothing counts for nothing: infinity times 0 is no number.
        one.weight = if one.difference.is_finite() { libm::exp(-0.5 * worth * one.difference) } else { 0.0 };
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
        assert_eq!(ranked[1].difference, 20.0);
    }

    #[test]
    fn what_is_not_finite_is_still_ordered() {
        let ranked = rank(&[Some(3.0), Some(f64::NEG_INFINITY), None, Some(f64::NEG_INFINITY), Some(f64::NAN)], 1.0);
        assert_eq!(ranked.iter().map(|one| one.index).collect::<Vec<_>>(), [1, 3, 0, 2, 4]);
        assert_eq!(ranked.iter().map(|one| one.weight).collect::<Vec<_>>(), [0.5, 0.5, 0.0, 0.0, 0.0]);
        assert_eq!((ranked[0].difference, ranked[1].difference), (0.0, 0.0));
    }
}

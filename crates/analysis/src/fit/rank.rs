//! Several theories of the same data, best first.

/// A theory's place among others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ranked {
    /// Which of the given ones.
    pub index: usize,
    /// How much larger its AICc is than the best one's.
    pub difference: f64,
    /// Its share of the evidence among the given theories (Akaike's weight), if residuals knew nothing of each other.
    pub weight: f64,
}

/// Orders theories by AICc, the smallest first; those without one come last, in their order.
pub fn rank(aicc: &[Option<f64>]) -> Vec<Ranked> {
    let best = aicc.iter().flatten().copied().fold(f64::INFINITY, f64::min);
    let mut ranked: Vec<Ranked> = aicc
        .iter()
        .enumerate()
        .map(|(index, aicc)| {
            let difference = aicc.map_or(f64::INFINITY, |aicc| aicc - best);
            Ranked { index, difference, weight: libm::exp(-0.5 * difference) }
        })
        .collect();
    ranked.sort_by(|a, b| a.difference.total_cmp(&b.difference));
    let sum: f64 = ranked.iter().map(|one| one.weight).sum();
    if sum > 0.0 {
        ranked.iter_mut().for_each(|one| one.weight /= sum);
    }
    ranked
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_of_evidence() {
        let ranked = rank(&[Some(-100.0), None, Some(-102.0)]);
        assert_eq!(ranked.iter().map(|one| one.index).collect::<Vec<_>>(), [2, 0, 1]);
        assert_eq!(ranked[1].difference, 2.0);
        // 1 : 1/e
        assert!((ranked[0].weight / ranked[1].weight - libm::exp(1.0)).abs() < 1e-12);
        assert_eq!(ranked[2].weight, 0.0);
    }
}

//! What a fit says of its model, by the residuals.

use super::judgement::Outlier;
use super::observed::ObservationFit;
use super::outcome::Outcome;

/// Fewer independent values than this make standard errors that are uncertain by a quarter and more.
const FEW: f64 = 15.0;

/// Whether the model is compatible with the data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Nothing is left over but rounding.
    Exact,
    /// Residuals look random and, where errors were given, have their size.
    Compatible,
    /// Residuals look random but are larger than the given errors.
    TooLarge,
    /// Residuals look random but are smaller than the given errors.
    TooSmall,
    /// Residuals are autocorrelated: the model misses something, or the measurement does.
    Structured,
    /// There are too few values to tell.
    Unknown,
}

impl Outcome {
    /// What the residuals say.
    pub fn verdict(&self) -> Verdict {
        if self.exact {
            return Verdict::Exact;
        }
        let Some(runs) = self.runs else { return Verdict::Unknown };
        // 2.6 standard deviations: one in a hundred by chance.
        let by_chance = 2.6 / (self.judged as f64).sqrt();
        if runs.z < -2.6 || self.autocorrelation > by_chance {
            return Verdict::Structured;
        }
        match self.chi2_reduced {
            // Chi-square has the variance of twice its degrees of freedom.
            Some(reduced) if reduced > 1.0 + 2.6 * (2.0 / self.dof as f64).sqrt() => Verdict::TooLarge,
            Some(reduced) if reduced < 1.0 - 2.6 * (2.0 / self.dof as f64).sqrt() => Verdict::TooSmall,
            _ => Verdict::Compatible,
        }
    }

    /// Whether the record is short for the correlation of its errors: it is worth fewer than 15 independent values, and
    /// would be worth more without it.
    pub fn is_short(&self) -> bool {
        let correlated = self.independent < 0.5 * self.judged as f64;
        self.wanders || (correlated && self.independent < FEW)
    }

    /// The row of an outlier among its observation's columns.
    pub fn outlying(&self, outlier: &Outlier) -> Option<&ObservationFit> {
        self.observations.iter().find(|one| one.record == outlier.record && one.observation == outlier.observation)
    }
}

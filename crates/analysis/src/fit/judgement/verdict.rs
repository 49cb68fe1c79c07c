//! Verdict on the model of a fit, from the residuals.

use super::Outlier;
use crate::fit::observed::ObservationFit;
use crate::fit::outcome::Outcome;

/// Number of independent values below which standard errors are uncertain by a quarter and more.
const FEW: f64 = 15.0;

/// Compatibility of the model with the data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// There are as many values as determined numbers.
    Saturated,
    /// The residuals are rounding errors.
    Exact,
    /// Values far from all others have decided the fit.
    Misled,
    /// Residuals look random and, where errors were given, have their size.
    Compatible,
    /// Residuals look random but are larger than the given errors.
    TooLarge,
    /// Residuals look random but are smaller than the given errors.
    TooSmall,
    /// Residuals are autocorrelated: the model misses something, or the measurement does.
    Structured,
    /// Residuals are autocorrelated, and larger than the part that the curve explains: the fit misses what the data show.
    Missed,
    /// Neighbouring residuals have opposite signs more often than by chance.
    Alternating,
    /// Residuals look random, and so do the values themselves: the curve explains no more of them than a constant.
    Nothing,
    /// There are too few values to tell.
    Unknown,
}

/// Comparison of the residuals with the given errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::fit) enum Size {
    /// The residuals are larger than by chance.
    Larger,
    /// The residuals are smaller than by chance.
    Smaller,
}

/// Critical value in standard deviations: one in a hundred by chance.
const BY_CHANCE: f64 = 2.6;

/// Coefficient of determination below which the curve explains less than it leaves.
const EXPLAINED: f64 = 0.5;

/// Least number of values for a judgement of signs and neighbours.
const LEAST: usize = 10;

/// Size of residuals, as a share of the swing of the values, up to which a curve meets them.
const MET: f64 = 0.05;

/// Size of the residuals of one observation beside its swing.
#[derive(Clone, Copy, Debug)]
pub struct Share<'a> {
    /// Observation.
    pub of: &'a ObservationFit,
    /// Root mean square of the residuals over the distance from the lowest to the highest measured value, without outliers.
    pub value: f64,
}

/// How near a curve comes to the values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Nearness {
    /// The residuals are small beside the swing of the values.
    Met,
    /// The residuals are large but scatter about the curve.
    Scattered,
    /// The residuals are large, and those of neighbouring values agree.
    Missed,
}

impl Outcome {
    /// Verdict from the residuals.
    pub fn verdict(&self) -> Verdict {
        if self.dof == 0 {
            return Verdict::Saturated;
        }
        if self.exact {
            return Verdict::Exact;
        }
        if self.misled {
            return Verdict::Misled;
        }
        let known = self.judged >= LEAST;
        let correlation = BY_CHANCE / (self.judged as f64).sqrt();
        if known && (self.runs.is_some_and(|runs| runs.z < -BY_CHANCE) || self.autocorrelation > correlation) {
            return if self.r2 < EXPLAINED { Verdict::Missed } else { Verdict::Structured };
        }
        // Each fitted number makes the correlation of neighbouring residuals a little more negative.
        let adjusted = self.determined() / self.judged as f64;
        if known && self.autocorrelation < -correlation - adjusted {
            return Verdict::Alternating;
        }
        match self.size() {
            _ if known && self.explains_nothing() => Verdict::Nothing,
            Some(Size::Larger) => Verdict::TooLarge,
            Some(Size::Smaller) => Verdict::TooSmall,
            None if known => Verdict::Compatible,
            None => Verdict::Unknown,
        }
    }

    /// Comparison of the residuals with the given errors; `None` if they agree or no errors were given.
    pub(in crate::fit) fn size(&self) -> Option<Size> {
        // The variance of chi-square is twice its degrees of freedom.
        let by_chance = BY_CHANCE * (2.0 / self.dof as f64).sqrt();
        let off = self.chi2_reduced? - 1.0;
        match off.abs() > by_chance {
            true if off > 0.0 => Some(Size::Larger),
            true => Some(Size::Smaller),
            false => None,
        }
    }

    /// The observation with the largest residuals beside its swing; `None` if no values vary.
    pub fn largest_share(&self) -> Option<Share<'_>> {
        let share = |of| {
            let of: &ObservationFit = of;
            let own = |one: &Outlier| (one.record, one.observation) == (of.record, of.observation);
            let off = |row: usize| self.outliers.iter().any(|one| own(one) && one.row == row);
            let rows = of.measured.iter().zip(&of.fitted).zip(&of.inside).enumerate();
            let rows = rows.filter(|(row, (_, inside))| **inside && !off(*row));
            let (mut count, mut squares, mut low, mut high) = (0.0, 0.0, f64::INFINITY, f64::NEG_INFINITY);
            for (_, ((measured, fitted), _)) in rows {
                count += 1.0;
                squares += (measured - fitted) * (measured - fitted);
                (low, high) = (f64::min(low, *measured), f64::max(high, *measured));
            }
            let value = (squares / count).sqrt() / (high - low);
            (value, of)
        };
        let shares = self.observations.iter().filter(|one| !one.derived).map(share);
        let largest = shares.filter(|(value, _)| value.is_finite()).max_by(|one, other| one.0.total_cmp(&other.0));
        largest.map(|(value, of)| Share { of, value })
    }

    /// Nearness of the curve to the values. Residuals of which neighbours agree are no scatter.
    pub(in crate::fit) fn nearness(&self, share: Share<'_>) -> Nearness {
        let systematic = share.value * self.autocorrelation.max(0.0).sqrt();
        match self.verdict() {
            _ if share.value <= MET => Nearness::Met,
            Verdict::Missed => Nearness::Missed,
            _ if systematic > MET => Nearness::Missed,
            _ => Nearness::Scattered,
        }
    }

    /// Number of values that the data determine.
    fn determined(&self) -> f64 {
        self.n.saturating_sub(self.dof) as f64
    }

    /// True if a curve unrelated to the values, fitted in the same way, would explain as much of their scatter. Reference:
    /// chi-square of the numbers beyond the mean of each observation, plus, as in a periodogram, the greatest of as many
    /// chances as there are values (J. D. Scargle, Astrophys. J. 263 (1982) 835), because a search can choose among as many
    /// frequencies.
    fn explains_nothing(&self) -> bool {
        let means = self.observations.iter().filter(|one| !one.derived && one.inside.contains(&true)).count();
        let free = self.determined() - means as f64;
        let explained = self.dof as f64 * self.r2 / (1.0 - self.r2);
        free > 0.0 && explained < free + BY_CHANCE * (2.0 * free).sqrt() + 2.0 * libm::log(self.n as f64)
    }

    /// True if the record is short for the correlation of its errors: its effective number of independent values is below
    /// 15 and less than half of the values, or the errors cannot be distinguished from a random walk.
    pub fn is_short(&self) -> bool {
        let correlated = self.independent < 0.5 * self.judged as f64;
        self.wanders || (correlated && self.independent < FEW)
    }

    /// Fit of the observation that an outlier belongs to.
    pub fn outlying(&self, outlier: &Outlier) -> Option<&ObservationFit> {
        self.observations.iter().find(|one| one.record == outlier.record && one.observation == outlier.observation)
    }
}

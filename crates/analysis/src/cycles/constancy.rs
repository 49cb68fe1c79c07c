//! Constancy of a quantity over the cycles of a record, as the linear theory predicts it.

use super::cycle::{Cycle, Measured};
use super::quantity::Quantity;
use units::{Language, say};

/// Result of a chi-square test of one quantity over cycles that share no data. Values in the units of the record.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Constancy {
    /// There is only one independent cycle.
    Alone(Measured),
    /// The quantity is constant within its errors.
    Same {
        /// Weighted mean.
        mean: Measured,
        /// Sum of the squares of the deviations over their errors.
        chi_square: f64,
        /// Degrees of freedom: independent cycles minus one.
        freedom: usize,
    },
    /// The quantity scatters by more than the errors explain, but the first and last third of the cycles agree.
    Scatters {
        /// Weighted mean, with its error from the scatter.
        mean: Measured,
        /// Sum of the squares of the deviations over their errors.
        chi_square: f64,
        /// Degrees of freedom: independent cycles minus one.
        freedom: usize,
    },
    /// The quantity changes from the first to the last third of the cycles.
    Changes {
        /// Weighted mean of the first third of the independent cycles.
        early: Measured,
        /// Weighted mean of the last third.
        late: Measured,
        /// Sum of the squares of the deviations over their errors.
        chi_square: f64,
        /// Degrees of freedom: independent cycles minus one.
        freedom: usize,
    },
}

impl Constancy {
    /// Tests a quantity over the cycles; `None` if no error is known.
    pub fn of(cycles: &[Cycle], quantity: Quantity) -> Option<Self> {
        // Every third cycle shares no data with the one before.
        let independent: Vec<Measured> =
            cycles.iter().step_by(3).map(|cycle| quantity.of(cycle)).filter(|one| one.error > 0.0).collect();
        let mean = mean(&independent)?;
        let Some(freedom) = independent.len().checked_sub(1).filter(|freedom| *freedom > 0) else {
            return Some(Self::Alone(mean));
        };
        let off = |one: &Measured| (one.value - mean.value) / one.error;
        let chi_square: f64 = independent.iter().map(off).map(|off| off * off).sum();
        if !is_beyond_chance(chi_square, freedom as f64) {
            return Some(Self::Same { mean, chi_square, freedom });
        }
        let third = independent.len().div_ceil(3);
        let (early, late) = (independent.get(..third)?, independent.get(independent.len() - third..)?);
        let (early, late) = (self::mean(early)?, self::mean(late)?);
        if (early.value - late.value).abs() < 2.0 * libm::hypot(early.error, late.error) {
            // Error from the scatter (R. T. Birge, Phys. Rev. 40 (1932) 207).
            let mean = Measured { error: mean.error * (chi_square / freedom as f64).sqrt(), ..mean };
            return Some(Self::Scatters { mean, chi_square, freedom });
        }
        Some(Self::Changes { early, late, chi_square, freedom })
    }

    /// Result as a sentence in English or Spanish. `written` formats a value with its error and unit, `fixed` a number with
    /// one decimal.
    pub fn text(
        &self,
        quantity: Quantity,
        language: Language,
        written: &dyn Fn(Measured) -> String,
        fixed: &dyn Fn(f64) -> String,
    ) -> String {
        let the = quantity.with_article(language);
        let test = |chi_square: f64, freedom: usize| match freedom {
            1 => say!(language, "(chi-square {} for 1 degree of freedom)", fixed(chi_square)),
            _ => say!(language, "(chi-square {} for {freedom} degrees of freedom)", fixed(chi_square)),
        };
        match *self {
            Self::Alone(mean) => say!(language, "{the} is {}; one cycle alone shows no change.", written(mean)),
            Self::Same { mean, chi_square, freedom } => say!(
                language,
                "{the} is the same in all cycles within its errors, as in the linear theory: {} {}.",
                written(mean),
                test(chi_square, freedom)
            ),
            Self::Changes { early, late, chi_square, freedom } if written(early) == written(late) => say!(
                language,
                "{the} is {} throughout; its change is too small to show in these digits {}.",
                written(early),
                test(chi_square, freedom)
            ),
            Self::Scatters { mean, chi_square, freedom } => say!(
                language,
                "{the} varies from cycle to cycle by more than its errors explain {}, without a trend: {} on average.",
                test(chi_square, freedom),
                written(mean)
            ),
            Self::Changes { early, late, chi_square, freedom } => say!(
                language,
                "{the} changes by more than its errors explain {}, which the linear theory does not allow: {} in the first \
                 third of the cycles, {} in the last.",
                test(chi_square, freedom),
                written(early),
                written(late)
            ),
        }
    }
}

/// True if independent values exceed this chi-square with a probability below 0.01 (E. B. Wilson & M. M. Hilferty, Proc.
/// Natl. Acad. Sci. 17 (1931) 684).
fn is_beyond_chance(chi_square: f64, freedom: f64) -> bool {
    const QUANTILE: f64 = 2.326;
    let variance = 2.0 / (9.0 * freedom);
    libm::cbrt(chi_square / freedom) > 1.0 - variance + QUANTILE * variance.sqrt()
}

/// Mean weighted by the inverse squares of the errors; `None` without values or if an error is not known.
pub fn mean(of: &[Measured]) -> Option<Measured> {
    let weight = |one: &Measured| 1.0 / (one.error * one.error);
    let sum: f64 = of.iter().map(weight).sum();
    let value = of.iter().map(|one| weight(one) * one.value).sum::<f64>() / sum;
    value.is_finite().then(|| Measured { value, error: 1.0 / sum.sqrt() })
}

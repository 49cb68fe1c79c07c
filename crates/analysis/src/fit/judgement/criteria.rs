//! AICc and BIC from the likelihood of normal residuals, or of Student's distribution with a robust loss.

use crate::fit::observed::ObservationFit;
use crate::fit::search::loss::Loss;
use crate::fit::search::problem::Problem;
use crate::fit::search::robust;
use crate::fit::task::plan::equal;
use crate::fit::task::weights::EXACT;

/// Information criteria of a fit.
pub(in crate::fit) struct Criteria {
    /// See [`crate::fit::Outcome::aicc`].
    pub aicc: Option<f64>,
    /// See [`crate::fit::Outcome::bic`].
    pub bic: f64,
    /// See [`crate::fit::Outcome::exact`].
    pub exact: bool,
}

/// Criteria from the given errors, or with a variance of its own for each observation at its maximum of the likelihood.
/// This variance is bounded from below by that of an exact fit, so that several exact fits are rated equal. `determined` is
/// the number of parameters that the data determine, `chi2` the weighted sum of squares, `values` the number of independent
/// values.
pub(in crate::fit) fn criteria(
    problem: &Problem,
    observations: &[ObservationFit],
    determined: usize,
    chi2: f64,
    values: f64,
) -> Criteria {
    let spread = problem.spread();
    let mut exact = true;
    let (mut deviance, mut variances) = (0.0, 0.0);
    for one in observations {
        let record = &problem.task.records[one.record];
        let equal = equal(record, one.observation) as f64;
        let n = one.inside.iter().filter(|inside| **inside).count() as f64;
        if n > 0.0 {
            // 1e-150: the square of the size stays representable if all values are 0.
            let least = (EXACT * spread[one.record][one.observation]).max(1e-150);
            exact &= one.rmse <= least;
            deviance += match problem.task.loss {
                Loss::Squares => 2.0 * n * libm::log(one.rmse.max(least)),
                Loss::Huber | Loss::Tukey => robust::deviance(&one.inside_residuals(), least),
            } / equal;
            variances += 1.0 / equal;
        }
    }
    let mut k = determined as f64;
    if problem.task.errors_given() && problem.task.loss == Loss::Squares {
        deviance = chi2;
    } else {
        k += variances;
    }
    let room = values - k - 1.0;
    let aicc = (room > 0.0).then(|| deviance + 2.0 * k + 2.0 * k * (k + 1.0) / room);
    Criteria { aicc, bic: deviance + k * libm::log(values), exact }
}

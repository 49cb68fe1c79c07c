//! The scales of films that a fit has found.

use super::covariance::Covariance;
use super::problem::Problem;
use super::scale::Prior;
use super::search::Search;

/// The scale of a record's film, as a fit has found it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FilmScale {
    /// Which record.
    pub record: usize,
    /// By which factor its measured lengths are too large.
    pub value: f64,
    /// The standard error of the factor; `None` where the fit leaves no degree of freedom.
    pub stderr: Option<f64>,
    /// The standard error that it had before the fit.
    pub prior: f64,
}

/// The scales at the end of a search.
pub(super) fn found(problem: &Problem, best: &Search, covariance: &Covariance) -> Vec<FilmScale> {
    let scale = |Prior { number, record, error }: Prior| {
        let mut gradient = vec![0.0; best.x.len()];
        gradient[number] = 1.0;
        let stderr = (covariance.dof > 0.0).then(|| covariance.robust(&gradient).sqrt());
        FilmScale { record, value: best.x[number], stderr, prior: error }
    };
    problem.priors().into_iter().map(scale).collect()
}

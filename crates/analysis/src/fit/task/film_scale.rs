//! The scales of films that a fit has found.

use super::scale::Prior;
use crate::fit::search::Search;
use crate::fit::search::problem::Problem;
use crate::fit::uncertainty::covariance::Covariance;

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
pub(in crate::fit) fn found(problem: &Problem, best: &Search, covariance: &Covariance) -> Vec<FilmScale> {
    let scale = |Prior { number, record, error }: Prior| {
        let mut gradient = vec![0.0; best.x.len()];
        gradient[number] = 1.0;
        let stderr = (covariance.dof > 0.0).then(|| covariance.robust(&gradient).sqrt());
        FilmScale { record, value: best.x[number], stderr, prior: error }
    };
    problem.priors().into_iter().map(scale).collect()
}

//! Fitted scales of films.

use super::scale::Prior;
use crate::fit::search::Search;
use crate::fit::search::problem::Problem;
use crate::fit::uncertainty::covariance::Covariance;
use serde::{Deserialize, Serialize};

/// Fitted scale of the film of a record.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FilmScale {
    /// Index in [`Task::records`](super::Task::records).
    pub record: usize,
    /// Factor by which its measured lengths are too large.
    pub value: f64,
    /// Standard error of the factor; `None` where the fit leaves no degree of freedom.
    pub stderr: Option<f64>,
    /// Standard error before the fit.
    pub prior: f64,
}

/// Scales at the end of a search.
pub(in crate::fit) fn found(problem: &Problem, best: &Search, covariance: &Covariance) -> Vec<FilmScale> {
    let scale = |Prior { number, record, error }: Prior| {
        let mut gradient = vec![0.0; best.x.len()];
        gradient[number] = 1.0;
        let stderr = (covariance.dof > 0.0).then(|| covariance.robust(&gradient).sqrt());
        FilmScale { record, value: best.x[number], stderr, prior: error }
    };
    problem.priors().into_iter().map(scale).collect()
}

//! Fits a model to measured data.
//!
//! A [`Task`] says what is measured and what may vary, [`Fit`] works on it in slices, and [`Outcome`] is what is known in
//! the end. All numbers are SI; names and units are the model's.

use model::{Compiled, Model};

/// One measured column, bound to what it is a measurement of.
#[derive(Clone, Debug)]
pub struct Observation {
    /// What it is called, `y'`.
    pub name: String,
    /// What is observed: an expression of the model.
    pub observed: Compiled,
    /// The independent variable, SI.
    pub times: Vec<f64>,
    /// The measured values, SI; NaN for a gap.
    pub values: Vec<f64>,
    /// The standard error of each value, SI, where it is known.
    pub errors: Option<Vec<f64>>,
    /// The observation of the same record that this one was computed from (a velocity by finite differences): it is
    /// no second witness.
    pub derived_from: Option<usize>,
}

/// One run of the experiment.
#[derive(Clone, Debug, Default)]
pub struct Record {
    /// What it is called: its file's name.
    pub name: String,
    /// What was measured.
    pub observations: Vec<Observation>,
    /// Parameters that have a value of their own in this run: which of the model's, and the SI value.
    pub fixed: Vec<(usize, f64)>,
}

/// What a varied number is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// A parameter of the model.
    Parameter(usize),
    /// The reading of the independent variable at which the model's is 0.
    Origin,
    /// What is added to the model's value of the observation of this number before it is compared: the zero of the scale.
    Offset(usize),
}

/// A number to be varied.
#[derive(Clone, Debug)]
pub struct Varied {
    /// What it is.
    pub target: Target,
    /// One value for all records, instead of one for each.
    pub shared: bool,
    /// Where to begin, SI; the parameter's own value if there is none.
    pub start: Option<f64>,
    /// Least and greatest value, SI; a parameter's own range does not bind a fit.
    pub bounds: Option<(f64, f64)>,
}

/// What is to be fitted.
#[derive(Clone, Debug)]
pub struct Task<'a> {
    /// The theory.
    pub model: &'a Model,
    /// The values of all its parameters where they are not varied, SI.
    pub parameters: Vec<f64>,
    /// The measurements.
    pub records: Vec<Record>,
    /// What is varied.
    pub varied: Vec<Varied>,
    /// The fitted part begins here, SI.
    pub from: Option<f64>,
    /// The fitted part ends here, SI.
    pub until: Option<f64>,
}

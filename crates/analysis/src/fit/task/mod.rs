//! What is to be fitted. All numbers are SI.

pub(in crate::fit) mod bind;
pub(in crate::fit) mod check;
pub(in crate::fit) mod columns;
pub(in crate::fit) mod film_scale;
pub(in crate::fit) mod plan;
pub(in crate::fit) mod scale;
pub(in crate::fit) mod weights;

use super::search::loss::Loss;
use engine::Method;
use program::Compiled;

/// One measured column, bound to what it is a measurement of.
#[derive(Clone, Debug, PartialEq)]
pub struct Observation {
    /// What it is called, `y'`.
    pub name: String,
    /// What is observed: an expression of the model.
    pub observed: Compiled,
    /// The independent variable.
    pub times: Vec<f64>,
    /// The measured values; NaN for a gap.
    pub values: Vec<f64>,
    /// The standard error of each value, where it is known.
    pub errors: Option<Vec<f64>>,
    /// Which observation of the same record this one was computed from (a velocity by finite differences): it adds no
    /// independent information.
    pub derived_from: Option<usize>,
}

/// One run of the experiment.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record {
    /// What it is called: its file's name.
    pub name: String,
    /// What was measured.
    pub observations: Vec<Observation>,
    /// Parameters that have a value of their own in this run: which of the model's, and the value.
    pub fixed: Vec<(usize, f64)>,
    /// The reading of its clock at which the model's independent variable is 0, where it is not varied. Without it: for
    /// equations of motion in which the independent variable does not occur, the first measured value of the fitted part, so
    /// that initial values hold there; otherwise 0.
    pub origin: Option<f64>,
    /// The relative standard error that all its lengths share, where it is known: that of the ruler in a film. The fit then takes
    /// in a factor of all lengths, [`super::Outcome::scales`].
    pub scale_error: Option<f64>,
}

/// What a varied number is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// A parameter of the model.
    Parameter(usize),
    /// The reading of the clock at which the model's independent variable is 0.
    Origin,
    /// The zero of a scale: what is added to the model's value of the observation of this number (in each record) before
    /// it is compared.
    Offset(usize),
}

/// A number to be varied.
#[derive(Clone, Debug, PartialEq)]
pub struct Varied {
    /// What it is.
    pub target: Target,
    /// One value for all records, instead of one for each.
    pub shared: bool,
    /// Where to begin; without it the parameter's own value, and 0 for an offset.
    pub start: Option<f64>,
    /// Least and greatest value; without them the parameter's own range, if it has one.
    pub bounds: Option<(f64, f64)>,
}

impl Varied {
    /// A parameter of the model, from its own value within its own range; in several records each with its own value.
    pub fn parameter(index: usize) -> Self {
        Self { target: Target::Parameter(index), shared: false, start: None, bounds: None }
    }
}

/// What is to be fitted.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Task {
    /// The values of all the model's parameters where they are not varied.
    pub parameters: Vec<f64>,
    /// The document's method; equations of motion are integrated to 1e-9 with a method for stiff equations if it is one, and
    /// with Dormand and Prince's otherwise.
    pub method: Method,
    /// The measurements.
    pub records: Vec<Record>,
    /// What is varied.
    pub varied: Vec<Varied>,
    /// The fitted part begins here.
    pub from: Option<f64>,
    /// The fitted part ends here.
    pub until: Option<f64>,
    /// What residuals cost.
    pub loss: Loss,
}

impl Task {
    /// Whether the clock's reading `time` lies in the fitted part.
    pub fn covers(&self, time: f64) -> bool {
        self.from.is_none_or(|from| time >= from) && self.until.is_none_or(|until| time <= until)
    }

    /// Whether every observation has errors of its own, so that they are taken at their word.
    pub fn errors_given(&self) -> bool {
        self.records.iter().flat_map(|record| &record.observations).all(|one| one.errors.is_some())
    }
}

/// Why a fit cannot be made.
#[derive(Clone, Debug, PartialEq)]
pub enum FitError {
    /// Nothing is to be varied.
    NothingVaried,
    /// Nothing was observed, or no value of it lies in the fitted part.
    NothingObserved,
    /// Fewer independent values than varied numbers: how many there are of each.
    TooFew {
        /// Values.
        values: usize,
        /// Varied numbers.
        varied: usize,
    },
    /// The same number is varied twice, or one is both varied and fixed: its place in [`Task::varied`].
    VariedTwice(usize),
    /// The error of the lengths of a record that is not finite or not greater than 0: which of [`Task::records`].
    BadScaleError(usize),
    /// Bounds without room between them: the place in [`Task::varied`].
    BadBounds(usize),
    /// A start that is no finite number: the place in [`Task::varied`].
    BadStart(usize),
    /// A value of a parameter that is no finite number: which of the model's.
    BadValue(usize),
    /// Given errors in the fitted part that are missing, not finite or not greater than 0.
    BadErrors {
        /// Which of [`Task::records`].
        record: usize,
        /// Which of its observations.
        observation: usize,
        /// How many of its values have such an error.
        count: usize,
        /// The clock's reading at the first of them.
        first: f64,
    },
    /// One of several records has no value in the fitted part: which.
    RecordEmpty(usize),
    /// More than [`super::MOST_VARIED`] numbers or [`super::MOST_VALUES`] values.
    TooLarge,
    /// The model with its sensitivities is too large, or its method cannot treat it.
    Model(units::Words),
}

impl std::fmt::Display for FitError {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::NothingVaried => f.write_str("nothing is varied"),
            Self::NothingObserved => f.write_str("there is no measured value in the fitted part"),
            Self::TooFew { values, varied } => {
                write!(f, "{values} values cannot determine {varied} numbers")
            }
            Self::VariedTwice(_) => f.write_str("a number is varied twice, or varied and fixed"),
            Self::BadScaleError(_) => f.write_str("the standard error of the scale is not greater than 0"),
            Self::BadBounds(_) => f.write_str("the lower bound is not below the upper one"),
            Self::BadStart(_) => f.write_str("a start is not a finite number"),
            Self::BadValue(_) => f.write_str("the value of a parameter is not a finite number"),
            Self::BadErrors { count, .. } => {
                write!(f, "{count} values have a standard error that is missing or not greater than 0")
            }
            Self::RecordEmpty(_) => f.write_str("a record has no measured value in the fitted part"),
            Self::TooLarge => f.write_str("there are too many values or too many varied numbers"),
            Self::Model(message) => f.write_str(&message.english),
        }
    }
}

impl std::error::Error for FitError {}

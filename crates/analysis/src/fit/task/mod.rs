//! Task of a fit: measurements, varied numbers and loss. All numbers are SI.

pub(in crate::fit) mod bind;
pub(in crate::fit) mod check;
pub(in crate::fit) mod columns;
pub(in crate::fit) mod film_scale;
pub(in crate::fit) mod offset;
pub(in crate::fit) mod plan;
pub(in crate::fit) mod scale;
pub(in crate::fit) mod tied;
pub(in crate::fit) mod weights;

use super::search::loss::Loss;
use engine::Method;
use program::Compiled;
use serde::{Deserialize, Serialize};
use units::Unit;

/// One measured column, bound to an expression of the model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Observation {
    /// Name, for example `y'`.
    pub name: String,
    /// Expression of the model that was measured.
    pub observed: Compiled,
    /// Values of the independent variable, SI.
    pub times: Vec<f64>,
    /// Measured values, SI; NaN for a gap.
    pub values: Vec<f64>,
    /// Standard error of each value, SI; `None` if unknown.
    pub errors: Option<Vec<f64>>,
    /// Index of the observation of the same record from which this one was computed, such as a velocity by finite
    /// differences. It then adds no independent information.
    pub derived_from: Option<usize>,
}

/// One run of the experiment.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Name: that of its file.
    pub name: String,
    /// Measured columns.
    pub observations: Vec<Observation>,
    /// Parameters with a value of their own in this run: index in the model, and value in SI.
    pub fixed: Vec<(usize, f64)>,
    /// Reading of the clock at which the model's independent variable is 0, where it is not varied, SI. `None`: for
    /// equations of motion in which the independent variable does not occur, the time of the first measured value of the
    /// fitted part, so that initial values hold there. The same for a record that begins later after the clock's 0 than it lasts, if
    /// other values of its numbers then give the same curve. Otherwise 0.
    pub origin: Option<f64>,
    /// Relative standard error common to all lengths of the record, such as that of the ruler in a film; `None` if unknown.
    /// If given, a factor of all lengths is fitted: [`super::Outcome::scales`].
    pub scale_error: Option<f64>,
    /// One list per observation, one entry per value: true for values that a person has left out of the fit. A missing list
    /// or entry leaves out nothing.
    pub excluded: Vec<Vec<bool>>,
    /// Observations whose record states no unit: index, and the unit in which their numbers were read.
    pub assumed: Vec<(usize, Unit)>,
}

impl Record {
    /// True if a person has left out this value of an observation.
    pub fn excludes(&self, observation: usize, place: usize) -> bool {
        self.excluded.get(observation).and_then(|list| list.get(place)).copied().unwrap_or(false)
    }

    /// Number of values that a person has left out.
    pub fn excluded_count(&self) -> usize {
        self.excluded.iter().flatten().filter(|excluded| **excluded).count()
    }
}

/// Kind of a varied number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Target {
    /// Parameter of the model, by its index.
    Parameter(usize),
    /// Reading of the clock at which the model's independent variable is 0, SI.
    Origin,
    /// Offset of the observation of this index, in each record: it is added to the value of the model before the
    /// comparison. SI.
    Offset(usize),
}

/// Number to be varied.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Varied {
    /// Parameter, origin or offset.
    pub target: Target,
    /// One value for all records, instead of one for each.
    pub shared: bool,
    /// Start, SI. `None`: the parameter's own value, 0 for an offset, and for the origin that of the record.
    pub start: Option<f64>,
    /// Lower and upper bound, SI. `None`: the range of the parameter, if it has one.
    pub bounds: Option<(f64, f64)>,
}

impl Varied {
    /// Varies a parameter of the model from its own value within its own range; in several records each has its own value.
    pub fn parameter(index: usize) -> Self {
        Self { target: Target::Parameter(index), shared: false, start: None, bounds: None }
    }
}

/// Parameter whose value is an expression of other parameters, such as `L2 = 2*L1`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TiedParameter {
    /// Index of the parameter in the model.
    pub parameter: usize,
    /// Its value: one expression for all records, or one for each. A number, SI, that depends on parameters alone.
    pub values: Vec<Compiled>,
}

/// Task of a fit.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Task {
    /// Values of all parameters of the model, SI, used where they are not varied.
    pub parameters: Vec<f64>,
    /// Method of the document. Equations of motion are integrated to 1e-9: with a stiff method if this is one, otherwise
    /// with that of Dormand and Prince.
    pub method: Method,
    /// Measurements, one entry per run.
    pub records: Vec<Record>,
    /// Varied numbers.
    pub varied: Vec<Varied>,
    /// Parameters whose values are expressions of others.
    pub tied: Vec<TiedParameter>,
    /// Begin of the fitted part, a reading of the clock in SI; `None`: from the first value.
    pub from: Option<f64>,
    /// End of the fitted part, inclusive; `None`: to the last value.
    pub until: Option<f64>,
    /// Loss function of the residuals.
    pub loss: Loss,
}

impl Task {
    /// True if the reading `time` of the clock, SI, lies in the fitted part.
    pub fn covers(&self, time: f64) -> bool {
        self.from.is_none_or(|from| time >= from) && self.until.is_none_or(|until| time <= until)
    }

    /// True if every observation has given errors, which are then taken as absolute.
    pub fn errors_given(&self) -> bool {
        self.records.iter().flat_map(|record| &record.observations).all(|one| one.errors.is_some())
    }
}

/// Reason why a fit cannot be made.
#[derive(Clone, Debug, PartialEq)]
pub enum FitError {
    /// No number is varied.
    NothingVaried,
    /// No measured value lies in the fitted part.
    NothingObserved,
    /// Fewer independent values than varied numbers.
    TooFew {
        /// Number of independent values.
        values: usize,
        /// Number of varied numbers.
        varied: usize,
    },
    /// A number is varied twice, or both varied and fixed: its index in [`Task::varied`].
    VariedTwice(usize),
    /// A parameter is tied to itself, perhaps by way of others: its index in the model.
    TiedInCircle(usize),
    /// A parameter is tied twice, or to what is no number or changes during a run: its index in the model.
    BadTie(usize),
    /// The relative error of the lengths of a record is not finite or not greater than 0: index in [`Task::records`].
    BadScaleError(usize),
    /// The lower bound is not below the upper one: index in [`Task::varied`].
    BadBounds(usize),
    /// A start is not finite: index in [`Task::varied`].
    BadStart(usize),
    /// The value of a parameter is not finite: its index in the model.
    BadValue(usize),
    /// Given errors in the fitted part are missing, not finite or not greater than 0.
    BadErrors {
        /// Index in [`Task::records`].
        record: usize,
        /// Index of the observation in its record.
        observation: usize,
        /// Number of values with such an error.
        count: usize,
        /// Reading of the clock at the first of them, SI.
        first: f64,
    },
    /// One of several records has no value in the fitted part: its index.
    RecordEmpty(usize),
    /// More than [`super::MOST_VARIED`] numbers or [`super::MOST_VALUES`] values.
    TooLarge,
    /// The model with its sensitivities is too large, or the method cannot integrate it.
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
            Self::TiedInCircle(_) => f.write_str("a parameter is tied to itself"),
            Self::BadTie(_) => f.write_str("a parameter is tied twice, or to what is no constant number"),
            Self::BadScaleError(_) => f.write_str("the standard error of the scale is not greater than 0"),
            Self::BadBounds(_) => f.write_str("the lower bound is not below the upper one"),
            Self::BadStart(_) => f.write_str("a start is not a finite number"),
            Self::BadValue(_) => f.write_str("the value of a parameter is not a finite number"),
            Self::BadErrors { count, .. } => {
                write!(f, "{count} values have a standard error that is missing or not greater than 0")
            }
            Self::RecordEmpty(_) => f.write_str("a record has no measured value in the fitted part"),
            Self::TooLarge => f.write_str("there are too many values or too many varied numbers"),
            Self::Model(message) => f.write_str(&message.english()),
        }
    }
}

impl std::error::Error for FitError {}

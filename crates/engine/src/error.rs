//! Errors that prevent or stop a run.
//!
//! The message of an error takes the names from the model; on the command line, `places` of the document supply the span.

use crate::{Method, Setup};
use program::Model;
use std::fmt;
use units::number::plain;
use units::{Words, words};

/// An error that prevents or stops a run, with its time.
#[derive(Clone, Debug, PartialEq)]
pub struct RunError {
    /// The kind of error.
    pub cause: Cause,
    /// Independent variable at the error, SI units; 0 before the first row.
    pub time: f64,
}

/// The kind of a [`RunError`]. States, parameters and events are given by their index in the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// Wrong number of parameters: given, needed.
    WrongParameters(usize, usize),
    /// The parameter of this index is not a finite number.
    ParameterNotFinite(usize),
    /// Wrong number of start values: given, needed.
    WrongStart(usize, usize),
    /// The step is not positive, or not below [`Setup::GREATEST_STEP`].
    StepNotPositive,
    /// The tolerance of an adaptive method is below [`Setup::LEAST_TOLERANCE`], or 1 or more.
    BadTolerance,
    /// Velocity Verlet with an equation that is not of second order; index of the first such state.
    NotSecondOrder(usize),
    /// The initial value of the state of this index is not a finite number.
    InitialNotFinite(usize),
    /// The Jacobian of the stiff method would need too much memory.
    ModelTooLarge,
    /// The linear system for the highest derivatives is singular; index of the first state that is not finite.
    Singular(usize),
    /// The state of this index became infinite, with this method.
    Infinite(usize, Method),
    /// The state of this index became NaN, with this method.
    NotANumber(usize, Method),
    /// The adaptive method needs a step below its smallest one.
    StepTooSmall,
    /// More steps of the adaptive method between two rows than this limit.
    TooManySteps(usize, Method),
    /// More events than this limit within a hundredth of a step; the index of one of the last events.
    TooManyEvents(usize, Option<usize>),
    /// The event of this index ended the run, as its document prescribes.
    Ended(usize),
    /// More switches of the equations than this limit within one step of the grid.
    TooManySwitches(usize),
}

/// The part of the model that an error or a notice concerns, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// A parameter, by index.
    Parameter(usize),
    /// A state, by index.
    State(usize),
    /// An event, by index.
    Event(usize),
}

impl RunError {
    /// An error at time 0, before the first row.
    pub(crate) fn at_start(cause: Cause) -> Self {
        Self { cause, time: 0.0 }
    }

    /// True if an event ended the run as planned; the run can then be continued.
    pub fn is_end(&self) -> bool {
        matches!(self.cause, Cause::Ended(_))
    }

    /// The part of the model that the error concerns, `None` for errors of the setup.
    pub fn subject(&self) -> Option<Subject> {
        match self.cause {
            Cause::ParameterNotFinite(index) => Some(Subject::Parameter(index)),
            Cause::NotSecondOrder(index)
            | Cause::InitialNotFinite(index)
            | Cause::Singular(index)
            | Cause::Infinite(index, _)
            | Cause::NotANumber(index, _) => Some(Subject::State(index)),
            Cause::ModelTooLarge | Cause::StepTooSmall | Cause::TooManySteps(..) | Cause::TooManySwitches(_) => {
                Some(Subject::State(0))
            }
            Cause::TooManyEvents(_, event) => event.map(Subject::Event),
            Cause::Ended(event) => Some(Subject::Event(event)),
            Cause::WrongParameters(..) | Cause::WrongStart(..) | Cause::StepNotPositive | Cause::BadTolerance => None,
        }
    }

    /// Stable identifier such as `not-finite`; never translated.
    pub fn code(&self) -> &'static str {
        match self.cause {
            Cause::WrongParameters(..) => "wrong-parameters",
            Cause::ParameterNotFinite(_) => "parameter-not-finite",
            Cause::WrongStart(..) => "wrong-start",
            Cause::StepNotPositive => "step-not-positive",
            Cause::BadTolerance => "bad-tolerance",
            Cause::NotSecondOrder(_) => "not-second-order",
            Cause::InitialNotFinite(_) => "initial-not-finite",
            Cause::ModelTooLarge => "model-too-large",
            Cause::Singular(_) => "singular-equations",
            Cause::Infinite(..) | Cause::NotANumber(..) => "not-finite",
            Cause::StepTooSmall => "step-too-small",
            Cause::TooManySteps(..) => "too-many-steps",
            Cause::TooManyEvents(..) => "too-many-events",
            Cause::Ended(_) => "ended",
            Cause::TooManySwitches(_) => "too-many-switches",
        }
    }

    /// The error in one sentence without a full stop, with the names used in the model.
    pub fn message(&self, model: &Model) -> Words {
        self.message_in(model, str::to_owned)
    }

    /// [`RunError::message`] with titles of events passed through `translate`.
    pub fn message_in(&self, model: &Model, translate: impl Fn(&str) -> String) -> Words {
        let state = |index: usize| model.states.get(index).map(program::State::name).unwrap_or_default();
        let moment = moment(model, self.time);
        match self.cause {
            Cause::WrongParameters(given, needed) => words!("{given} parameters given, the model has {needed}"),
            Cause::ParameterNotFinite(index) => {
                let name = model.parameters.get(index).map_or("", |parameter| parameter.name.as_str());
                words!("the parameter {name} is not a finite number")
            }
            Cause::WrongStart(given, needed) => words!("{given} start values given, the model has {needed} states"),
            Cause::StepNotPositive => words("the step is not a positive, finite number"),
            Cause::BadTolerance => {
                let least = units::number::shortest(Setup::LEAST_TOLERANCE);
                words!("the tolerance is not between {least} and 1")
            }
            Cause::NotSecondOrder(index) => {
                let variable = model.states.get(index).map_or("", |state| state.variable.as_str());
                let order = model.states.iter().filter(|other| other.variable == variable).count();
                words!("velocity-verlet is for equations of second order; that for {variable} is of order {order}")
            }
            Cause::InitialNotFinite(index) => words!("the initial value of {} is not a finite number", state(index)),
            Cause::ModelTooLarge => words("the model is too large for the stiff method"),
            Cause::Singular(_) => {
                words!("the equations have no unique solution for the highest derivatives after {moment}",)
            }
            Cause::Infinite(index, _) => {
                let name = state(index);
                words!("{name} exceeds the largest number after {moment}")
            }
            Cause::NotANumber(index, _) => {
                let name = state(index);
                words!("{name} has no defined value after {moment}")
            }
            Cause::StepTooSmall => words!("no step from {moment} is small enough for the tolerance"),
            Cause::TooManySteps(limit, _) => {
                words!("{limit} steps were not enough for one row, at {moment}")
            }
            Cause::TooManyEvents(limit, _) => {
                words!("more than {limit} events in a hundredth of a step, at {moment}")
            }
            Cause::Ended(event) => match model.events.get(event).and_then(|event| event.title.as_deref()) {
                Some(title) => {
                    words!("the run ends at {moment}: {title}", title = words!("{}", translate(title)))
                }
                None => {
                    words!("an event ends the run at {moment}")
                }
            },
            Cause::TooManySwitches(limit) => {
                words!("the equations switch to and fro without end: more than {limit} times in one step, at {moment}",)
            }
        }
    }

    /// Advice on how to avoid the error.
    pub fn hint(&self) -> Words {
        match self.cause {
            Cause::WrongParameters(..) => words("give one value for each parameter"),
            Cause::ParameterNotFinite(_) => words("give it a value"),
            Cause::WrongStart(..) => words("give one value for each state"),
            Cause::StepNotPositive => words("the usual step is 0.05 s"),
            Cause::BadTolerance => words("the usual tolerance is 1e-6"),
            Cause::NotSecondOrder(_) => words("use the method Runge-Kutta (rk4)"),
            Cause::InitialNotFinite(_) => words("change the parameters it depends on"),
            Cause::ModelTooLarge => words("choose another method"),
            Cause::Singular(_) => words("the determinant of the masses or coefficients has become zero there"),
            Cause::Infinite(_, Method::Rosenbrock) | Cause::NotANumber(_, Method::Rosenbrock) => {
                words("check the equations for a division by zero or a root of a negative number")
            }
            Cause::Infinite(_, Method::DormandPrince) | Cause::NotANumber(_, Method::DormandPrince) => {
                words("check the equations for a division by zero; if there is none, try the method Rosenbrock")
            }
            Cause::Infinite(..) | Cause::NotANumber(..) => words(
                "check the equations for a division by zero or a root of a negative number; if there is none, they may be stiff, \
                 as those of a circuit with a diode: use the method Rosenbrock (`rosenbrock`), or a smaller step",
            ),
            Cause::StepTooSmall => words("the solution is not smooth there, or grows beyond all bounds"),
            Cause::TooManySteps(_, Method::Rosenbrock) => {
                words("a larger tolerance or rows at shorter distances may help")
            }
            Cause::TooManySteps(..) => words("if the equations are stiff, use the method Rosenbrock"),
            Cause::TooManyEvents(..) => words(
                "let a slow bounce be the last one: write `discrete rests = false`, in the event `rests = abs(y') < 0.01 [m/s], \
                 y' = if abs(y') < 0.01 [m/s] then 0 else -e*y'`, and in the equation `if rests then 0 else -g`; let a controller \
                 switch on and off at different values; or end the run there with `stop`",
            ),
            Cause::Ended(_) => words("press Play to go on from there"),
            Cause::TooManySwitches(_) => words(
                "both sides of a condition or of `sign` lead back to it; if it is dry friction, write `coulomb(v, F)`; if it is a \
                 controller, let it switch on and off at different values",
            ),
        }
    }
}

/// The identifier and the time, for programs; [`RunError::message`] is the text for people.
impl fmt::Display for RunError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} at {}", self.code(), self.time)
    }
}

impl std::error::Error for RunError {}

/// The independent variable as text, for example `t = 3.2 s`, in Spanish `t = 3,2 s`; `time` in SI units, seven significant
/// digits.
pub(crate) fn moment(model: &Model, time: f64) -> Words {
    let (name, unit) = (&model.independent.name, &model.independent.unit);
    let shown = unit.from_si(time);
    let value = Words::each(move |language| plain(shown, 7, language.style()));
    let unit = if unit.text.is_empty() { String::new() } else { format!(" {unit}") };
    words!("{name} = {value}{unit}")
}

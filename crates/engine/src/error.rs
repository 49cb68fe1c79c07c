//! Why a run cannot start or go on.

use crate::{Method, Setup};
use program::Model;
use std::fmt;
use units::number::{Style, plain};
use units::{Words, words};

/// Why a run cannot start or go on, and when.
#[derive(Clone, Debug, PartialEq)]
pub struct RunError {
    /// What happened.
    pub cause: Cause,
    /// The value of the independent variable, in SI.
    pub time: f64,
}

/// What keeps a run from starting or going on. Numbers name states, parameters and events by their places in the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// So many parameters were given where so many are needed.
    WrongParameters(usize, usize),
    /// This parameter is not a finite number.
    ParameterNotFinite(usize),
    /// So many start values were given where so many are needed.
    WrongStart(usize, usize),
    /// The step is not a positive, finite number.
    StepNotPositive,
    /// The tolerance is less than rounding allows, or 1 and more.
    BadTolerance,
    /// Velocity Verlet was chosen, and this state's equation is not of second order.
    NotSecondOrder(usize),
    /// The initial value of this state is not a finite number.
    InitialNotFinite(usize),
    /// The stiff method's derivatives would fill the memory.
    ModelTooLarge,
    /// The equations cannot be solved for the highest derivatives; this state shows it.
    Singular(usize),
    /// This state has become infinite, with this method.
    Infinite(usize, Method),
    /// This state is not a number any more, with this method.
    NotANumber(usize, Method),
    /// No step of the adaptive method is small enough.
    StepTooSmall,
    /// The adaptive method has made so many steps for one row.
    TooManySteps(usize, Method),
    /// More than so many events have happened in a hundredth of a step, the last of them this one.
    TooManyEvents(usize, Option<usize>),
    /// This event has ended the run, as the document wants it.
    Ended(usize),
    /// The equations have switched more than this number of times within one step of the grid.
    TooManySwitches(usize),
}

/// The part of a model that an error is about, by its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// One of the parameters.
    Parameter(usize),
    /// One of the states.
    State(usize),
    /// One of the events.
    Event(usize),
}

impl RunError {
    /// An error before the first row.
    pub(crate) fn at_start(cause: Cause) -> Self {
        Self { cause, time: 0.0 }
    }

    /// Whether nothing is wrong: an event has ended the run, and it can go on.
    pub fn is_end(&self) -> bool {
        matches!(self.cause, Cause::Ended(_))
    }

    /// The part of the model that it is about, if there is one.
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

    /// A stable name, such as `not-finite`; never translated.
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

    /// What is wrong, in one sentence without a full stop, with the names of the model that was run.
    pub fn message(&self, model: &Model) -> Words {
        self.message_in(model, str::to_owned)
    }

    /// The same with the titles of events as `translate` gives them.
    pub fn message_in(&self, model: &Model, translate: impl Fn(&str) -> String) -> Words {
        let state = |index: usize| model.states.get(index).map(program::State::name).unwrap_or_default();
        let moment = moment(model, self.time);
        match self.cause {
            Cause::WrongParameters(given, needed) => words!(
                "{given} parameters given, the model has {needed}",
                "se dieron {given} parámetros y el modelo tiene {needed}"
            ),
            Cause::ParameterNotFinite(index) => {
                let name = model.parameters.get(index).map_or("", |parameter| parameter.name.as_str());
                words!("the parameter {name} is not a finite number", "el parámetro {name} no es un número finito")
            }
            Cause::WrongStart(given, needed) => words!(
                "{given} start values given, the model has {needed} states",
                "se dieron {given} valores iniciales y el modelo tiene {needed} estados"
            ),
            Cause::StepNotPositive => {
                words("the step is not a positive, finite number", "el paso no es un número positivo y finito")
            }
            Cause::BadTolerance => {
                let least = units::number::shortest(Setup::LEAST_TOLERANCE);
                words!("the tolerance is not between {least} and 1", "la tolerancia no está entre {least} y 1")
            }
            Cause::NotSecondOrder(index) => {
                let variable = model.states.get(index).map_or("", |state| state.variable.as_str());
                let order = model.states.iter().filter(|other| other.variable == variable).count();
                words!(
                    "velocity-verlet is for equations of second order; that for {variable} is of order {order}",
                    "velocity-verlet es para ecuaciones de segundo orden; la de {variable} es de orden {order}"
                )
            }
            Cause::InitialNotFinite(index) => words!(
                "the initial value of {} is not a finite number",
                "el valor inicial de {} no es un número finito",
                state(index)
            ),
            Cause::ModelTooLarge => words(
                "the model is too large for the stiff method",
                "el modelo es demasiado grande para el método rígido",
            ),
            Cause::Singular(_) => words!(
                "the equations have no unique solution for the highest derivatives after {moment}",
                "las ecuaciones no tienen solución única para las derivadas de mayor orden después de {moment}",
                moment = moment
            ),
            Cause::Infinite(index, _) => {
                let name = state(index);
                words!(
                    "{name} exceeds the largest number after {moment}",
                    "{name} supera el mayor número representable después de {moment}",
                    moment = moment
                )
            }
            Cause::NotANumber(index, _) => {
                let name = state(index);
                words!(
                    "{name} has no defined value after {moment}",
                    "{name} no tiene un valor definido después de {moment}",
                    moment = moment
                )
            }
            Cause::StepTooSmall => words!(
                "no step from {moment} is small enough for the tolerance",
                "ningún paso desde {moment} es bastante pequeño para la tolerancia",
                moment = moment
            ),
            Cause::TooManySteps(limit, _) => words!(
                "{limit} steps were not enough for one row, at {moment}",
                "{limit} pasos no bastaron para una fila, en {moment}",
                moment = moment
            ),
            Cause::TooManyEvents(limit, _) => words!(
                "more than {limit} events in a hundredth of a step, at {moment}",
                "más de {limit} eventos en una centésima de paso, en {moment}",
                moment = moment
            ),
            Cause::Ended(event) => match model.events.get(event).and_then(|event| event.title.as_deref()) {
                Some(title) => words!(
                    "the run ends at {moment}: {title}",
                    "la simulación termina en {moment}: {title}",
                    moment = moment,
                    title = words!("{}", "{}", translate(title))
                ),
                None => {
                    words!(
                        "an event ends the run at {moment}",
                        "un evento termina la simulación en {moment}",
                        moment = moment
                    )
                }
            },
            Cause::TooManySwitches(limit) => words!(
                "the equations switch to and fro without end: more than {limit} times in one step, at {moment}",
                "las ecuaciones conmutan sin fin de un lado a otro: más de {limit} veces en un paso, en {moment}",
                moment = moment
            ),
        }
    }

    /// What to do.
    pub fn hint(&self) -> Words {
        match self.cause {
            Cause::WrongParameters(..) => words("give one value for each parameter", "da un valor para cada parámetro"),
            Cause::ParameterNotFinite(_) => words("give it a value", "dale un valor"),
            Cause::WrongStart(..) => words("give one value for each state", "da un valor para cada estado"),
            Cause::StepNotPositive => words("the usual step is 0.05 s", "el paso habitual es 0,05 s"),
            Cause::BadTolerance => words("the usual tolerance is 1e-6", "la tolerancia habitual es 1e-6"),
            Cause::NotSecondOrder(_) => words("use the method Runge-Kutta (rk4)", "usa el método de Runge-Kutta (rk4)"),
            Cause::InitialNotFinite(_) => {
                words("change the parameters it depends on", "cambia los parámetros de los que depende")
            }
            Cause::ModelTooLarge => words("choose another method", "elige otro método"),
            Cause::Singular(_) => words(
                "the determinant of the masses or coefficients has become zero there",
                "el determinante de las masas o los coeficientes se anula allí",
            ),
            Cause::Infinite(_, Method::Rosenbrock) | Cause::NotANumber(_, Method::Rosenbrock) => words(
                "check the equations for a division by zero or a root of a negative number",
                "busca en las ecuaciones una división entre cero o la raíz de un número negativo",
            ),
            Cause::Infinite(_, Method::DormandPrince) | Cause::NotANumber(_, Method::DormandPrince) => words(
                "check the equations for a division by zero; if there is none, try the method Rosenbrock",
                "busca en las ecuaciones una división entre cero; si no la hay, prueba el método de Rosenbrock",
            ),
            Cause::Infinite(..) | Cause::NotANumber(..) => words(
                "check the equations for a division by zero; if there is none, try a smaller step or the method Dormand-Prince",
                "busca en las ecuaciones una división entre cero; si no la hay, prueba un paso menor o el método de Dormand-Prince",
            ),
            Cause::StepTooSmall => words(
                "the solution is not smooth there, or grows beyond all bounds",
                "la solución no es suave allí, o crece sin límite",
            ),
            Cause::TooManySteps(_, Method::Rosenbrock) => words(
                "a larger tolerance or rows at shorter distances may help",
                "puede ayudar una tolerancia mayor o filas más próximas",
            ),
            Cause::TooManySteps(..) => words(
                "if the equations are stiff, use the method Rosenbrock",
                "si las ecuaciones son rígidas, usa el método de Rosenbrock",
            ),
            Cause::TooManyEvents(..) => words(
                "the events follow one another ever faster, like the last bounces of a ball; let an event end the \
                 motion, or stop before",
                "los eventos se suceden cada vez más deprisa, como los últimos botes de una pelota; haz que un evento \
                 termine el movimiento, o detente antes",
            ),
            Cause::Ended(_) => words("press Play to go on from there", "pulsa Reproducir para seguir desde ahí"),
            Cause::TooManySwitches(_) => words(
                "both sides of a condition or of `sign` lead back to it; if it is dry friction, write `coulomb(v, F)`; if it is a \
                 controller, let it switch on and off at different values",
                "ambos lados de una condición o de `sign` llevan de vuelta a ella; si es un rozamiento seco, escribe \
                 `coulomb(v, F)`; si es un regulador, haz que conecte y desconecte con valores distintos",
            ),
        }
    }
}

/// The code and the time, for programs; people read [`RunError::message`].
impl fmt::Display for RunError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} at {}", self.code(), self.time)
    }
}

impl std::error::Error for RunError {}

/// `t = 3.2 s`; in Spanish `t = 3,2 s`. Seven digits are enough for people; what programs read has all.
pub(crate) fn moment(model: &Model, time: f64) -> Words {
    let (name, unit) = (&model.independent.name, &model.independent.unit);
    let [value, spanish] = [Style::POINT, Style::COMMA].map(|style| plain(unit.from_si(time), 7, style));
    let unit = if unit.text.is_empty() { String::new() } else { format!(" {unit}") };
    words!("{name} = {value}{unit}", "{name} = {spanish}{unit}")
}

//! What a run is started with.

use crate::Method;
use crate::events::press::{Press, fitting};
use program::{Model, Program};

/// What a run is started with; all values SI. The independent variable starts at 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// One for each of the model's parameters.
    pub parameters: Vec<f64>,
    /// How to integrate.
    pub method: Method,
    /// The distance of the rows; with methods of fixed step also the step.
    pub step: f64,
    /// The error allowed in each step of an adaptive method, relative to the state.
    pub tolerance: f64,
    /// A state to start from instead of the model's initial values.
    pub start: Option<Vec<f64>>,
    /// The values of the curves that the reader draws, one list for each in the order of the tables ([`Model::drawings`]).
    pub drawings: Vec<Vec<f64>>,
    /// Which buttons are pressed when, in the order of time. Those of one moment act one after the other.
    pub presses: Vec<Press>,
}

impl Setup {
    /// The step where the document does not say, in SI units of the independent variable.
    pub const STEP: f64 = 0.05;
    /// The tolerance where the document does not say.
    pub const TOLERANCE: f64 = 1e-6;
    /// Multiples of a greater step could be infinite.
    pub const GREATEST_STEP: f64 = 1e290;
    /// What rounding lets an adaptive method reach.
    pub const LEAST_TOLERANCE: f64 = 1e-14;

    /// The model's own values, the classical Runge-Kutta method and a step of 0.05 s.
    pub fn defaults(model: &Model) -> Self {
        Self {
            parameters: model.parameters.iter().map(|parameter| parameter.value).collect(),
            method: Method::default(),
            step: Self::STEP,
            tolerance: Self::TOLERANCE,
            start: None,
            drawings: model.drawings(),
            presses: Vec::new(),
        }
        .fitting(model)
    }

    /// What a document asks for; where it does not say, as [`Self::defaults`].
    pub fn of(program: &Program) -> Self {
        let defaults = Self::defaults(&program.model);
        Self {
            method: program.method.unwrap_or(defaults.method),
            step: program.step.unwrap_or(defaults.step),
            tolerance: program.tolerance.unwrap_or(defaults.tolerance),
            ..defaults
        }
        .fitting(&program.model)
    }

    /// The same for a model: with presses of its buttons and curves of its tables only; one that counts goes by 1, and no method has anything to do.
    pub(crate) fn fitting(mut self, model: &Model) -> Self {
        self.presses = fitting(self.presses, model);
        if !model.takes_drawings(&self.drawings) {
            self.drawings = model.drawings();
        }
        if model.independent.counts { Self { step: 1.0, method: Method::Euler, ..self } } else { self }
    }

    /// The same more finely: with half the step or, where the method chooses its own steps, a tenth of the tolerance.
    pub fn finer(&self) -> Self {
        let finer = self.clone();
        if self.method.adaptive() {
            Self { tolerance: (self.tolerance / 10.0).max(Self::LEAST_TOLERANCE), ..finer }
        } else {
            Self { step: self.step / 2.0, ..finer }
        }
    }
}

//! The setup of a run.

use crate::Method;
use crate::events::press::{Press, fitting};
use program::{Model, Program};

/// The setup of a run; all values in SI units. The independent variable starts at 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// One value per parameter of the model.
    pub parameters: Vec<f64>,
    /// The integration method.
    pub method: Method,
    /// Distance of the rows; for fixed-step methods also the step.
    pub step: f64,
    /// Error tolerance per step of an adaptive method, relative to the state.
    pub tolerance: f64,
    /// State to start from, one value per state; `None`: the initial values of the model.
    pub start: Option<Vec<f64>>,
    /// Values of the curves drawn by the reader: one list per curve, in the order of the tables ([`Model::drawings`]).
    pub drawings: Vec<Vec<f64>>,
    /// The presses of buttons in the order of time. Presses at the same time act one after the other.
    pub presses: Vec<Press>,
}

impl Setup {
    /// Default step, in SI units of the independent variable.
    pub const STEP: f64 = 0.05;
    /// Default tolerance.
    pub const TOLERANCE: f64 = 1e-6;
    /// Upper bound of the step, exclusive: multiples of a greater one could be infinite.
    pub const GREATEST_STEP: f64 = 1e290;
    /// Smallest tolerance that an adaptive method reaches in spite of rounding.
    pub const LEAST_TOLERANCE: f64 = 1e-14;

    /// Default setup: the values of the model, the default method and a step of 0.05 s.
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

    /// The setup of a document; missing settings as in [`Self::defaults`].
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

    /// The setup adapted to a model. Presses of unknown buttons are dropped, and invalid drawings are replaced by those of
    /// the model. A counting independent variable has the step 1 and no integration method (Euler stands for it).
    pub(crate) fn fitting(mut self, model: &Model) -> Self {
        self.presses = fitting(self.presses, model);
        if !model.takes_drawings(&self.drawings) {
            self.drawings = model.drawings();
        }
        if model.independent.counts { Self { step: 1.0, method: Method::Euler, ..self } } else { self }
    }

    /// Setup for a finer run: half the step, or for an adaptive method a tenth of the tolerance.
    pub fn finer(&self) -> Self {
        let finer = self.clone();
        if self.method.adaptive() {
            Self { tolerance: (self.tolerance / 10.0).max(Self::LEAST_TOLERANCE), ..finer }
        } else {
            Self { step: self.step / 2.0, ..finer }
        }
    }
}

//! How fast the U-tube steps: in the engine's virtual machine, and in the same loop written by hand.

use engine::{Method, Stepper};
use std::hint::black_box;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::golden::{UTUBE, setup};

/// A run begins again after so many steps: much later the damped motion would be made of subnormal numbers, which are slow
/// on some processors.
const STEPS_OF_A_RUN: u32 = 20_000;

/// The U-tube of the document, ready to step by the classical Runge-Kutta method, without recording.
#[wasm_bindgen]
pub struct Pace {
    stepper: Stepper,
    tube: Tube,
}

/// The quantities of the equation of motion, SI.
#[derive(Clone, Copy)]
struct Tube {
    rho: f64,
    area: f64,
    length: f64,
    damping: f64,
    gravity: f64,
    start: [f64; 2],
    step: f64,
}

#[wasm_bindgen]
impl Pace {
    /// Opens the document and compiles its model.
    ///
    /// # Errors
    /// The document has errors, or is no longer a U-tube with the parameters of this one.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Result<Pace, String> {
        let (document, mut setup) = setup(UTUBE)?;
        setup.method = Method::RungeKutta4;
        let model = &document.program.model;
        let value = |name: &str| {
            let place = model.parameters.iter().position(|parameter| parameter.name == name);
            place.map(|place| setup.parameters[place]).ok_or_else(|| format!("no parameter {name}"))
        };
        let stepper = Stepper::new(model, &setup).map_err(|error| error.to_string())?;
        let [position, velocity] = *stepper.initial() else {
            return Err("a U-tube has two states".to_owned());
        };
        let tube = Tube {
            rho: value("rho")?,
            area: value("S")?,
            length: 2.0 + value("h_l")? + value("h_r")?,
            damping: value("b")?,
            gravity: value("g")?,
            start: [position, velocity],
            step: setup.step,
        };
        Ok(Pace { stepper, tube })
    }

    /// So many steps in the virtual machine; the last displacement.
    ///
    /// # Errors
    /// A state that is no longer finite.
    pub fn machine(&self, steps: u32) -> Result<f64, String> {
        let mut last = 0.0;
        for run in runs(steps) {
            let mut stepper = self.stepper.clone();
            for _ in 0..run {
                stepper.advance(|_, _, _| ()).map_err(|error| error.to_string())?;
            }
            last = stepper.state()[0];
        }
        Ok(last)
    }

    /// So many steps in a loop as one writes it by hand, with the parameters known only now; the last displacement.
    pub fn by_hand(&self, steps: u32) -> f64 {
        let mut last = 0.0;
        for run in runs(steps) {
            last = by_hand(black_box(self.tube), run);
        }
        last
    }
}

/// The lengths of the runs that make so many steps.
fn runs(steps: u32) -> impl Iterator<Item = u32> {
    let rest = steps % STEPS_OF_A_RUN;
    let whole = (0..steps / STEPS_OF_A_RUN).map(|_| STEPS_OF_A_RUN);
    whole.chain((rest > 0).then_some(rest))
}

/// The classical Runge-Kutta method for rho S L y'' + b y' + 2 rho S g y = 0.
#[inline(never)]
fn by_hand(tube: Tube, steps: u32) -> f64 {
    let Tube { rho, area, length, damping, gravity, start: [mut y, mut v], step: h } = tube;
    let mass = rho * area * length;
    let stiffness = 2.0 * rho * area * gravity;
    let acceleration = |y: f64, v: f64| -(damping * v + stiffness * y) / mass;
    for _ in 0..steps {
        let (y1, v1) = (v, acceleration(y, v));
        let (y2, v2) = (v + 0.5 * h * v1, acceleration(y + 0.5 * h * y1, v + 0.5 * h * v1));
        let (y3, v3) = (v + 0.5 * h * v2, acceleration(y + 0.5 * h * y2, v + 0.5 * h * v2));
        let (y4, v4) = (v + h * v3, acceleration(y + h * y3, v + h * v3));
        y += h / 6.0 * (y1 + 2.0 * y2 + 2.0 * y3 + y4);
        v += h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
    }
    y
}

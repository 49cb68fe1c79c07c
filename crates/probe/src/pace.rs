//! Speed of the steps of the U-tube in the engine's virtual machine, in emitted code and in hand-written loops.

use engine::{Method, Stepper};
use std::hint::black_box;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::golden::{UTUBE, setup};

/// Number of steps after which a run is restarted. Much later the damped motion would consist of subnormal numbers,
/// which are slow on some processors.
const STEPS_OF_A_RUN: u32 = 20_000;

/// The U-tube of the document, ready for steps of the classical Runge-Kutta method without recording.
#[wasm_bindgen]
pub struct Pace {
    stepper: Stepper,
    tube: Tube,
}

/// Parameters of the equation of motion, SI. `start`: displacement and velocity.
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
    /// The document has errors, or does not have the states and parameters of a U-tube.
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

    /// Computes `steps` steps in the virtual machine. Returns the last displacement, SI.
    ///
    /// # Errors
    /// A state is not finite.
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

    /// Makes the steps of [`Pace::machine`] in emitted code from now on; in WebAssembly only.
    ///
    /// # Errors
    /// The reason why they are interpreted.
    pub fn emit(&mut self) -> Result<(), String> {
        let code = host::compile(self.stepper.listing()).map_err(|reason| format!("{reason:?}"))?;
        self.stepper.use_compiled(code);
        Ok(())
    }

    /// [`Pace::by_hand`] with coefficients that are computed beforehand.
    pub fn best_by_hand(&self, steps: u32) -> f64 {
        let mut last = 0.0;
        for run in runs(steps) {
            last = best_by_hand(black_box(self.tube), run);
        }
        last
    }

    /// Computes `steps` steps in a hand-written loop whose parameters are known only at run time. Returns the last
    /// displacement, SI.
    pub fn by_hand(&self, steps: u32) -> f64 {
        let mut last = 0.0;
        for run in runs(steps) {
            last = by_hand(black_box(self.tube), run);
        }
        last
    }
}

/// Lengths of the runs that together have `steps` steps.
fn runs(steps: u32) -> impl Iterator<Item = u32> {
    let rest = steps % STEPS_OF_A_RUN;
    let whole = (0..steps / STEPS_OF_A_RUN).map(|_| STEPS_OF_A_RUN);
    whole.chain((rest > 0).then_some(rest))
}

/// Classical Runge-Kutta method for rho S L y'' + b y' + 2 rho S g y = 0. Returns the last displacement, SI.
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

/// [`by_hand`] with coefficients that are computed beforehand.
#[inline(never)]
fn best_by_hand(tube: Tube, steps: u32) -> f64 {
    let Tube { rho, area, length, damping, gravity, start: [mut y, mut v], step: h } = tube;
    let mass = rho * area * length;
    let (stiffness, damping) = (-2.0 * rho * area * gravity / mass, -damping / mass);
    let (half, sixth) = (0.5 * h, h / 6.0);
    let acceleration = |y: f64, v: f64| stiffness * y + damping * v;
    for _ in 0..steps {
        let (y1, v1) = (v, acceleration(y, v));
        let (y2, v2) = (v + half * v1, acceleration(y + half * y1, v + half * v1));
        let (y3, v3) = (v + half * v2, acceleration(y + half * y2, v + half * v2));
        let (y4, v4) = (v + h * v3, acceleration(y + h * y3, v + h * v3));
        y += sixth * (y1 + 2.0 * (y2 + y3) + y4);
        v += sixth * (v1 + 2.0 * (v2 + v3) + v4);
    }
    y
}

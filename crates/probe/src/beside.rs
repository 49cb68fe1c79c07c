//! Speed of the steps of U-tubes side by side in emitted code.

use crate::golden::{UTUBE, setup};
use engine::{LANES, Method, SideBySide, Stepper, side_by_side};
use wasm_bindgen::prelude::wasm_bindgen;

/// Runs of the U-tube of the document with different damping, by the classical Runge-Kutta method.
#[wasm_bindgen]
pub struct SideBySideTubes {
    /// Parameters and initial values of each run, SI units.
    runs: Vec<[Vec<f64>; 2]>,
    side_by_side: Box<dyn SideBySide>,
    /// Size of a step, s.
    step: f64,
}

#[wasm_bindgen]
impl SideBySideTubes {
    /// Opens the document and compiles its model; in WebAssembly only.
    ///
    /// # Errors
    /// The document has errors, or its runs cannot be made side by side.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Result<SideBySideTubes, String> {
        let (document, mut setup) = setup(UTUBE)?;
        setup.method = Method::RungeKutta4;
        let model = &document.program.model;
        let damping = model.parameters.iter().position(|parameter| parameter.name == "b").ok_or("no b")?;
        let initial = Stepper::new(model, &setup).map_err(|error| error.to_string())?.initial().to_vec();
        let run = |run: usize| {
            let mut parameters = setup.parameters.clone();
            parameters[damping] *= 1.0 + 0.001 * run as f64;
            [parameters, initial.clone()]
        };
        let runs = (0..LANES).map(run).collect();
        let compile = |listing: &_| host::compile_side_by_side(listing).ok();
        let side_by_side = side_by_side(model, &setup, &[], compile, |_| None).ok_or("no runs side by side")?;
        Ok(Self { runs, side_by_side, step: setup.step })
    }

    /// Makes at least `steps` steps, those of all runs together. Returns the last displacement of the first run, SI; NaN if it has
    /// failed.
    pub fn steps(&mut self, steps: u32) -> f64 {
        let until = f64::from(steps.div_ceil(LANES as u32)) * self.step;
        self.side_by_side.begin(&self.runs, until, &mut |_, _, _| ());
        while !self.side_by_side.advance(&mut { u64::MAX }, &mut |_, _, _| ()) {}
        self.side_by_side.end(0).map_or(f64::NAN, |(_, state)| state[0])
    }
}

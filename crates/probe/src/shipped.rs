//! Speed of the rows of any document with its own method, interpreted and in emitted code.

use crate::golden::setup;
use engine::{LANES, Readings, Run, Setup, SideBySide, Stepper, side_by_side};
use program::{Model, NodeId};
use units::split_mix::scramble;
use wasm_bindgen::prelude::wasm_bindgen;

/// Number of rows after which a run begins again: damped motions would otherwise become subnormal numbers.
const ROWS_OF_A_RUN: u32 = 2000;

/// A document at the start of its run.
#[wasm_bindgen]
pub struct Shipped {
    stepper: Stepper,
    model: Model,
    setup: Setup,
    side_by_side: Option<Box<dyn SideBySide>>,
}

#[wasm_bindgen]
impl Shipped {
    /// Opens a document and compiles its model.
    ///
    /// # Errors
    /// The document has errors or cannot start.
    #[wasm_bindgen(constructor)]
    pub fn new(text: &str) -> Result<Shipped, String> {
        let (document, setup) = setup(text)?;
        let stepper = Stepper::new(&document.program.model, &setup).map_err(|error| error.to_string())?;
        Ok(Self { stepper, model: document.program.model, setup, side_by_side: None })
    }

    /// Makes the steps in emitted code from now on; in WebAssembly only.
    ///
    /// # Errors
    /// The reason why they are interpreted.
    pub fn emit(&mut self) -> Result<(), String> {
        let code = host::compile(self.stepper.listing()).map_err(|reason| format!("{reason:?}"))?;
        self.stepper.use_compiled(code);
        Ok(())
    }

    /// The rate of the first state.
    fn rate(&self) -> Result<NodeId, String> {
        self.model.states.first().map(|state| state.derivative).ok_or_else(|| "no states".to_owned())
    }

    /// Computes about `rows` rows in emitted code, of runs one after the other that differ as those of
    /// [`Shipped::rows_side_by_side`], and reads the same at each row, as a plot over a parameter does. Returns the greatest of
    /// what is read.
    ///
    /// # Errors
    /// The document has no states, or a run cannot start.
    pub fn rows_one_by_one(&self, rows: u32) -> Result<f64, String> {
        let mut readings = Readings::new(&self.model, &[self.rate()?]);
        let code = host::compile(self.stepper.listing()).map_err(|reason| format!("{reason:?}"))?;
        let mut most = f64::NEG_INFINITY;
        let mut left = rows;
        let mut number = 0;
        while left > 0 {
            let count = left.min(ROWS_OF_A_RUN);
            let mut setup = self.setup.clone();
            setup.parameters = self.parameters(number);
            let mut run = Run::start(&self.model, setup).map_err(|error| error.to_string())?;
            run.use_compiled(code.clone());
            let mut row = 0;
            let last = f64::from(count) * self.setup.step;
            while run.time() < last && run.advance().is_ok() {
                for row in row..run.history().len() {
                    most = most.max(readings.at_row(run.history(), row)[0]);
                }
                run.forget();
                row = run.history().len();
            }
            left -= count;
            number += 1;
        }
        Ok(most)
    }

    /// Parameters of one of several runs: the first one differs a little.
    fn parameters(&self, run: usize) -> Vec<f64> {
        let mut parameters = self.setup.parameters.clone();
        parameters.iter_mut().take(1).for_each(|parameter| *parameter *= 1.0 + 0.0001 * run as f64);
        parameters
    }

    /// Makes steps of runs side by side from now on, in which the rate of the first state is read; in WebAssembly only.
    ///
    /// # Errors
    /// They are made one by one.
    pub fn emit_side_by_side(&mut self) -> Result<(), String> {
        let rate = self.rate()?;
        let compile = |listing: &_| host::compile_side_by_side(listing).ok();
        let runs = side_by_side(&self.model, &self.setup, &[rate], compile, |listing| host::compile(Ok(listing)).ok())
            .ok_or("runs are made one by one")?;
        self.side_by_side = Some(runs);
        Ok(())
    }

    /// Computes about `rows` rows, those of all runs side by side together; the first parameter differs a little. Returns the greatest of
    /// what is read.
    pub fn rows_side_by_side(&mut self, rows: u32) -> f64 {
        let begun: Vec<_> = (0..LANES).map(|run| [self.parameters(run), self.stepper.initial().to_vec()]).collect();
        let Some(runs) = &mut self.side_by_side else { return f64::NAN };
        let mut left = rows.div_ceil(LANES as u32);
        let mut most = f64::NEG_INFINITY;
        while left > 0 {
            let count = left.min(ROWS_OF_A_RUN);
            let mut take = |_: usize, _: f64, values: &[f64]| most = most.max(values[0]);
            runs.begin(&begun, f64::from(count) * self.setup.step, &mut take);
            while !runs.advance(&mut { u64::MAX }, &mut take) {}
            left -= count;
        }
        most
    }

    /// Computes `rows` rows without recording. A run that ends begins again. Returns a hash of all states.
    pub fn rows(&self, rows: u32) -> String {
        let mut stepper = self.stepper.clone();
        let mut hash = 0;
        for row in 1..=rows {
            let note = |_: f64, state: &[f64], _: bool| {
                hash = state.iter().fold(hash, |hash, value| scramble(hash ^ value.to_bits()));
            };
            if stepper.advance(note).is_err() || row.is_multiple_of(ROWS_OF_A_RUN) {
                stepper.clone_from(&self.stepper);
            }
        }
        format!("{hash:016x}")
    }
}

//! Speed of the rows of any document with its own method, interpreted and in emitted code.

use crate::golden::setup;
use engine::{Compiled, LANES, Readings, Run, RunError, Setup, SideBySide, Stepper, side_by_side};
use program::{Model, NodeId};
use std::rc::Rc;
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
    /// End of the document's run, SI.
    end: f64,
    beside: Option<Beside>,
}

/// Code of runs side by side.
struct Beside {
    runs: Box<dyn SideBySide>,
    /// Code of a single run.
    alone: Rc<dyn Compiled>,
    /// Evaluates the initial state of a run.
    initial: Readings,
    /// The rate of the first state.
    read: Readings,
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
        let end = document.program.end();
        Ok(Self { stepper, model: document.program.model, setup, end, beside: None })
    }

    /// Makes the steps in emitted code from now on; in WebAssembly only.
    ///
    /// # Errors
    /// The reason why they are interpreted.
    pub fn emit(&mut self) -> Result<(), String> {
        self.stepper.use_compiled(self.code()?);
        Ok(())
    }

    fn code(&self) -> Result<Rc<dyn Compiled>, String> {
        host::compile(self.stepper.listing()).map_err(|reason| format!("{reason:?}"))
    }

    /// Prepares runs side by side, in which the rate of the first state is read; in WebAssembly only.
    ///
    /// # Errors
    /// They are made one by one.
    pub fn emit_side_by_side(&mut self) -> Result<(), String> {
        let rate: NodeId = self.model.states.first().map(|state| state.derivative).ok_or("no states")?;
        let compile = |listing: &_| host::compile_side_by_side(listing).ok();
        let runs = side_by_side(&self.model, &self.setup, &[rate], compile, |listing| host::compile(Ok(listing)).ok())
            .ok_or("runs are made one by one")?;
        let starts: Vec<NodeId> = self.model.states.iter().map(|state| state.initial).collect();
        let [initial, read] = [&starts[..], &[rate]].map(|nodes| Readings::new(&self.model, nodes));
        self.beside = Some(Beside { runs, alone: self.code()?, initial, read });
        Ok(())
    }

    /// Number of rows of the document's own run.
    pub fn rows_of_run(&self) -> u32 {
        (self.end / self.setup.step) as u32
    }

    /// Makes 64 runs of at most `rows` rows, whose first parameters differ a little, one after the other in emitted code, and reads
    /// each row, as a plot over a parameter does. Returns the greatest of what is read.
    ///
    /// # Errors
    /// A run cannot start or fails.
    pub fn runs_one_by_one(&mut self, rows: u32) -> Result<f64, String> {
        (0..LANES).try_fold(f64::NEG_INFINITY, |most, run| Ok(most.max(self.run(run, rows)?)))
    }

    /// Greatest value that is read in one of these runs.
    fn run(&mut self, number: usize, rows: u32) -> Result<f64, String> {
        let Some(Beside { alone, read, .. }) = &mut self.beside else { return Ok(f64::NAN) };
        let until = f64::from(rows) * self.setup.step;
        let mut setup = self.setup.clone();
        vary(&mut setup.parameters, number);
        let mut run = Run::start(&self.model, setup).map_err(|error| error.to_string())?;
        run.use_compiled(alone.clone());
        let mut most = f64::NEG_INFINITY;
        let mut next = 0;
        let mut goes_on = true;
        while goes_on && run.time() < until {
            goes_on = match run.advance() {
                Ok(_) => true,
                Err(error) if error.is_end() => false,
                Err(error) => return Err(RunError::to_string(&error)),
            };
            for row in next..run.history().len() {
                most = most.max(read.at_row(run.history(), row)[0]);
            }
            run.forget();
            next = run.history().len();
        }
        Ok(most)
    }

    /// Makes the runs of [`Shipped::runs_one_by_one`] side by side; one that fails is made again alone, as for a plot. Returns the
    /// same.
    ///
    /// # Errors
    /// A run cannot start or fails.
    pub fn runs_side_by_side(&mut self, rows: u32) -> Result<f64, String> {
        let until = f64::from(rows) * self.setup.step;
        let Some(Beside { runs, initial, .. }) = &mut self.beside else { return Ok(f64::NAN) };
        let nothing = vec![0.0; self.model.states.len()];
        let begun = |run: usize| {
            let mut parameters = self.setup.parameters.clone();
            vary(&mut parameters, run);
            let initial = initial.at(&parameters, &nothing, 0.0, &nothing).to_vec();
            [parameters, initial]
        };
        let begun: Vec<_> = (0..LANES).map(begun).collect();
        let mut most = f64::NEG_INFINITY;
        let mut take = |_: usize, _: f64, values: &[f64]| most = most.max(values[0]);
        runs.begin(&begun, until, &mut take);
        while !runs.advance(&mut { u64::MAX }, &mut take) {}
        let failed: Vec<usize> = (0..LANES).filter(|run| runs.end(*run).is_none()).collect();
        failed.into_iter().try_fold(most, |most, run| Ok(most.max(self.run(run, rows)?)))
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

/// Changes the first parameter a little, for the run of this number.
fn vary(parameters: &mut [f64], run: usize) {
    parameters.iter_mut().take(1).for_each(|parameter| *parameter *= 1.0 + 0.0001 * run as f64);
}

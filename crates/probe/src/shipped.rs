//! Speed of the rows of any document with its own method, interpreted and in emitted code.

use crate::golden::setup;
use engine::Stepper;
use units::split_mix::scramble;
use wasm_bindgen::prelude::wasm_bindgen;

/// Number of rows after which a run begins again: damped motions would otherwise become subnormal numbers.
const ROWS_OF_A_RUN: u32 = 2000;

/// A document at the start of its run.
#[wasm_bindgen]
pub struct Shipped {
    stepper: Stepper,
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
        Ok(Self { stepper })
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

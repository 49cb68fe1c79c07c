//! Speed of fits of a measured record by a formula and by the equation of motion.

use analysis::fit::{Fit, Observation, Outcome, Record, Task, Varied};
use document::Document;
use wasm_bindgen::prelude::wasm_bindgen;

const FORMULA: &str = include_str!("../../../simulations/theories/cosine.md");
const MOTION: &str = include_str!("../../../simulations/theories/linear.md");

/// Tasks to fit a record of a level by the damped cosine and by the linear equation of motion, starting from the values
/// in the documents.
#[wasm_bindgen]
pub struct Fits {
    documents: [Document; 2],
    tasks: [Task; 2],
    /// True if the equations of motion are solved in emitted code.
    emits: bool,
}

#[wasm_bindgen]
impl Fits {
    /// Opens the documents. `times` in s, `level` in m, one value per time.
    ///
    /// # Errors
    /// A document has errors, or has no level `y`.
    #[wasm_bindgen(constructor)]
    pub fn new(times: &[f64], level: &[f64]) -> Result<Fits, String> {
        let open = |source: &str| {
            let document = document::open(source, &[]).document.ok_or("the document has errors")?;
            let observed = document.program.model.lookup("y", 0).ok_or("the document has no y")?;
            let observation = Observation {
                name: "y".to_owned(),
                observed,
                times: times.to_vec(),
                values: level.to_vec(),
                errors: None,
                derived_from: None,
            };
            let record = Record { name: "record".to_owned(), observations: vec![observation], ..Record::default() };
            let task = Task {
                parameters: document.program.model.parameters.iter().map(|parameter| parameter.value).collect(),
                records: vec![record],
                varied: document.program.vary.iter().map(|&index| Varied::parameter(index)).collect(),
                ..Task::default()
            };
            Ok::<_, String>((document, task))
        };
        let (formula, motion) = (open(FORMULA)?, open(MOTION)?);
        Ok(Self { documents: [formula.0, motion.0], tasks: [formula.1, motion.1], emits: false })
    }

    /// Solves the equations of motion in emitted code from now on; in WebAssembly only.
    pub fn emit(&mut self) {
        self.emits = true;
    }

    /// Fits the formula `count` times. Returns the root mean square of the residuals, in m.
    ///
    /// # Errors
    /// The fit does not converge.
    pub fn formula(&self, count: u32) -> Result<f64, String> {
        self.fit(0, count)
    }

    /// Fits the equation of motion `count` times. Returns the root mean square of the residuals, in m.
    ///
    /// # Errors
    /// The fit does not converge.
    pub fn motion(&self, count: u32) -> Result<f64, String> {
        self.fit(1, count)
    }
}

impl Fits {
    /// Result of a fit of the formula.
    pub(crate) fn formula_outcome(&self) -> Result<Outcome, String> {
        self.outcome(0)
    }

    /// Result of a fit of the equation of motion.
    pub(crate) fn motion_outcome(&self) -> Result<Outcome, String> {
        self.outcome(1)
    }

    fn fit(&self, which: usize, count: u32) -> Result<f64, String> {
        (0..count).try_fold(0.0, |_, _| Ok(self.outcome(which)?.rmse))
    }

    fn outcome(&self, which: usize) -> Result<Outcome, String> {
        let task = self.tasks[which].clone();
        let mut fit = Fit::new(&self.documents[which].program.model, task).map_err(|error| error.to_string())?;
        if self.emits {
            fit.compile(|listing| host::compile(Ok(listing)).ok());
        }
        fit.complete();
        Ok(fit.outcome().filter(|outcome| outcome.converged).ok_or("no end")?)
    }
}

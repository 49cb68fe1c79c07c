//! Data of a fit, from its definition to its result.

use crate::opened::OpenedDocuments;
use crate::records::record::Use;
use analysis::fit::{Loss, Outcome, Rival, Target, Task, Trace, Varied};
use document::Document;

/// Definition of a fit, without the text of its theory and the data of its records.
#[derive(Clone, Debug)]
pub(crate) struct Definition {
    /// File name of the theory.
    pub file: String,
    /// The records, in the order of the task.
    pub parts: Vec<Part>,
    pub varied: Vec<Varied>,
    /// Values of all parameters, SI; NaN for those that readers do not see. Varied ones start there.
    pub parameters: Vec<f64>,
    /// Start and end of the fitted time window on the record clocks, SI; `None` is open.
    pub window: [Option<f64>; 2],
    /// Loss function of the residuals.
    pub loss: Loss,
}

/// Participation of one record in a fit.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Part {
    pub record: u32,
    /// Name of the record.
    pub name: String,
    /// Use of each column.
    pub uses: Vec<Use>,
    /// Clock reading at which the model begins, SI, if an earlier fit has found it. `None`: the model begins with the
    /// fitted part, or at clock 0 if the equations depend on time.
    pub origin: Option<f64>,
    /// Parameters with a fixed value of their own in this record: index and value, SI.
    pub fixed: Vec<(usize, f64)>,
    /// Standard errors stated on the command line, by column.
    pub errors: Vec<(usize, StatedError)>,
    /// Rows of the record that are left out, ascending.
    pub excluded: Vec<usize>,
}

/// Standard errors that replace those of the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum StatedError {
    /// One standard error for all values, SI.
    Value(f64),
    /// Index of the column with the standard errors.
    Column(usize),
}

/// A fit that is to be made.
#[derive(Debug)]
pub(crate) struct Job {
    pub definition: Definition,
    pub document: Document,
    /// True if the theory is the open document, so that the result is applied to the sliders.
    pub own: bool,
    /// Result of an earlier visit, from which the fit is reconstructed. `None` for a new fit.
    pub found: Option<Found>,
}

/// Stored result of a fit.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    /// Fitted values in the order of the search. The fit is reconstructed from them.
    pub values: Vec<f64>,
    /// Number of starts of the search.
    pub starts: usize,
    /// Another minimum found by the search.
    pub rival: Option<Rival>,
}

impl Found {
    /// The stored result of a finished fit.
    pub fn of(outcome: &Outcome) -> Self {
        let values = outcome.parameters.iter().map(|estimate| estimate.value).collect();
        Self { values, starts: outcome.starts, rival: outcome.rival.clone() }
    }

    /// Restores the facts that a reconstructed fit cannot find, because it searches from a single start.
    pub fn complete(&self, outcome: &mut Outcome) {
        // Without stored values the full search was repeated.
        if !self.values.is_empty() {
            (outcome.starts, outcome.rival) = (self.starts, self.rival.clone());
        }
    }
}

/// A fit of an earlier visit that is to be reconstructed.
#[derive(Clone, Debug)]
pub(crate) struct Waiting {
    pub definition: Definition,
    /// Text of the document and of its translations.
    pub texts: Vec<String>,
    pub found: Found,
}

impl Waiting {
    /// Converts an interrupted reconstruction back; `None` for a new fit.
    pub fn of(job: Job) -> Option<Self> {
        Some(Self { texts: texts(&job.document), definition: job.definition, found: job.found? })
    }

    /// Job of the reconstruction; `None` if the document cannot be opened or does not match the fit.
    pub fn job(self, documents: &mut OpenedDocuments) -> Option<Job> {
        let document = documents.open(&self.texts)?;
        let parameters = document.program.model.parameters.len();
        let exists = |varied: &Varied| !matches!(varied.target, Target::Parameter(index) if index >= parameters);
        let fits = self.definition.parameters.len() == parameters && self.definition.varied.iter().all(exists);
        fits.then_some(Job { definition: self.definition, document, own: false, found: Some(self.found) })
    }
}

/// Text of a document and of its translations.
pub(crate) fn texts(document: &Document) -> Vec<String> {
    std::iter::once(&document.source).chain(&document.translations).cloned().collect()
}

/// A finished fit.
#[derive(Debug)]
pub(crate) struct Fitted {
    pub id: u32,
    pub definition: Definition,
    /// The theory.
    pub document: Document,
    /// The task of the fit.
    pub task: Task,
    /// The fitted curves.
    pub traces: Vec<Trace>,
    pub outcome: Outcome,
}

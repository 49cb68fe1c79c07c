//! A fit, from what is asked for to what has come of it.

use crate::records::record::Use;
use analysis::fit::{Loss, Outcome, Rival, Target, Task, Trace, Varied};
use document::Document;

/// What a fit is made of, besides its theory and the numbers of the records.
#[derive(Clone, Debug)]
pub(crate) struct Definition {
    /// The file of its theory.
    pub file: String,
    /// The records, in the order of the task.
    pub parts: Vec<Part>,
    pub varied: Vec<Varied>,
    /// All parameters where they are not varied, SI.
    pub parameters: Vec<f64>,
    /// What part of the records is fitted: readings of their clocks, SI.
    pub window: [Option<f64>; 2],
    /// What residuals cost.
    pub loss: Loss,
}

/// What a fit follows of a record.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Part {
    pub record: u32,
    /// The record's name.
    pub name: String,
    /// What its columns are taken for.
    pub uses: Vec<Use>,
    /// The reading of its clock at which the model begins, SI, if an earlier fit has found it. Otherwise it begins with the
    /// fitted part, or with the clock where the equations depend on the time.
    pub origin: Option<f64>,
    /// Parameters that have a value of their own in it.
    pub fixed: Vec<(usize, f64)>,
}

/// A fit to be made.
#[derive(Debug)]
pub(crate) struct Job {
    pub definition: Definition,
    pub document: Document,
    /// Whether it is the document that is open: what is found is shown.
    pub own: bool,
    /// What an earlier visit has found.
    pub found: Option<Found>,
}

/// What a fit has found.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    /// The numbers, in the order of the search: from them the fit is made again.
    pub values: Vec<f64>,
    /// From how many starts was searched.
    pub starts: usize,
    /// Another minimum that a search has met.
    pub rival: Option<Rival>,
}

impl Found {
    /// By a fit that is finished.
    pub fn of(outcome: &Outcome) -> Self {
        let values = outcome.parameters.iter().map(|estimate| estimate.value).collect();
        Self { values, starts: outcome.starts, rival: outcome.rival.clone() }
    }

    /// Puts back what a fit that is made again does not find out: it is searched from one start alone.
    pub fn complete(&self, outcome: &mut Outcome) {
        // Without its numbers the search was made from the beginning.
        if !self.values.is_empty() {
            (outcome.starts, outcome.rival) = (self.starts, self.rival.clone());
        }
    }
}

/// A fit of an earlier visit.
#[derive(Clone, Debug)]
pub(crate) struct Waiting {
    pub definition: Definition,
    /// The document and its translations.
    pub texts: Vec<String>,
    pub found: Found,
}

impl Waiting {
    /// Back from being made, if it was such a fit.
    pub fn of(job: Job) -> Option<Self> {
        Some(Self { texts: texts(&job.document), definition: job.definition, found: job.found? })
    }

    /// What is to be made, if the document can still be opened.
    pub fn job(self) -> Option<Job> {
        let (source, translations) = self.texts.split_first()?;
        let translations: Vec<&str> = translations.iter().map(String::as_str).collect();
        let document = document::open(source, &translations).sound()?;
        let parameters = document.program.model.parameters.len();
        let exists = |varied: &Varied| !matches!(varied.target, Target::Parameter(index) if index >= parameters);
        let fits = self.definition.parameters.len() == parameters && self.definition.varied.iter().all(exists);
        fits.then_some(Job { definition: self.definition, document, own: false, found: Some(self.found) })
    }
}

/// The text of a document, and those of its translations.
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
    /// What was asked for.
    pub task: Task,
    /// The fitted curves.
    pub traces: Vec<Trace>,
    pub outcome: Outcome,
}

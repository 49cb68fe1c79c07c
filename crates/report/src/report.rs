//! Input of a report.

use crate::film::Film;
use analysis::fit::{Interval, Outcome, Task, Trace};
use document::Document;
use units::{Language, Unit};

/// A finished fit and its origin.
#[derive(Clone, Copy, Debug)]
pub struct Report<'a> {
    /// The theory.
    pub document: &'a Document,
    /// File name, such as `linear.md`.
    pub document_name: &'a str,
    /// The language of the report.
    pub language: Language,
    /// Task of the fit.
    pub task: &'a Task,
    /// Result of the fit.
    pub outcome: &'a Outcome,
    /// Fitted curves from [`analysis::fit::Fit::traces`]. If empty, the figures connect the fitted values at the
    /// measured times.
    pub traces: &'a [Trace],
    /// Profile intervals of each parameter, in the order of [`Outcome::parameters`]; empty if none were requested.
    pub intervals: &'a [Option<[Interval; 2]>],
    /// Findings about the data of each record, in sentences.
    pub notes: &'a [Vec<String>],
    /// Films from which the records were made, in the order of the records.
    pub films: &'a [Film],
    /// Command that repeats the fit, or instructions; may be empty.
    pub command: &'a str,
    /// Version of the program.
    pub version: &'a str,
    /// Date of the report as text; may be empty.
    pub date: &'a str,
}

impl Report<'_> {
    /// Name and unit of the independent variable.
    pub(crate) fn independent(&self) -> (&str, &Unit) {
        let independent = &self.document.program.model.independent;
        (&independent.name, &independent.unit)
    }
}

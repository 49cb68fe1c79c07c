//! What a report is made of.

use crate::film::Film;
use crate::{doubt, remarks};
use analysis::fit::{Interval, Outcome, Task, Trace};
use document::Document;
use units::{Language, Unit};

/// A finished fit and where it comes from.
#[derive(Clone, Copy, Debug)]
pub struct Report<'a> {
    /// The theory.
    pub document: &'a Document,
    /// Its file, such as `linear.md`.
    pub document_name: &'a str,
    /// The language of the report.
    pub language: Language,
    /// What was asked for.
    pub task: &'a Task,
    /// What came of it.
    pub outcome: &'a Outcome,
    /// The fitted curves, from [`analysis::fit::Fit::traces`]. Without them the figures join the values at the measured
    /// times.
    pub traces: &'a [Trace],
    /// The profile of each parameter, in the order of [`Outcome::parameters`]; empty if none were asked for.
    pub intervals: &'a [Option<[Interval; 2]>],
    /// What was noticed about the data of each record, in sentences.
    pub notes: &'a [Vec<String>],
    /// The films from which records come, in the order of these.
    pub films: &'a [Film],
    /// The command that repeats the fit, or a sentence that says how; may be empty.
    pub command: &'a str,
    /// The version of the program.
    pub version: &'a str,
    /// When it was made, as it is to be read; may be empty.
    pub date: &'a str,
}

impl Report<'_> {
    /// Doubts about the numbers.
    pub(crate) fn doubts(&self) -> Vec<String> {
        doubt::doubts(self.outcome, self.task, self.independent(), self.language)
    }

    /// What has to be known beside the numbers, without the doubts.
    pub(crate) fn remarks(&self) -> Vec<String> {
        remarks::beside(self.outcome, self.task, self.independent(), self.language)
    }

    /// The name and the unit of the independent variable.
    fn independent(&self) -> (&str, &Unit) {
        let independent = &self.document.program.model.independent;
        (&independent.name, &independent.unit)
    }
}

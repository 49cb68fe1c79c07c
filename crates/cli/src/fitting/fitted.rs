//! Result of a fit on the command line.

use super::prepare::Theory;
use analysis::fit::{Interval, Outcome, Task, Trace};
use report::Report;
use units::Language;

/// A fitted theory.
pub struct Fitted {
    /// The theory.
    pub theory: Theory,
    /// The task of the fit.
    pub task: Task,
    /// The result of the fit.
    pub outcome: Outcome,
    /// The fitted curves.
    pub traces: Vec<Trace>,
    /// Profile intervals at 68 % and 95 %, one pair per varied parameter; empty without `--profile`.
    pub intervals: Vec<Option<[Interval; 2]>>,
}

impl Fitted {
    /// Remarks about the result, in sentences.
    pub fn remarks(&self) -> Vec<String> {
        let independent = &self.theory.document.program.model.independent;
        report::remarks(&self.outcome, &self.task, (&independent.name, &independent.unit), Language::English)
    }

    /// The fit as input of a report.
    pub fn report<'a>(&'a self, notes: &'a [Vec<String>], command: &'a str) -> Report<'a> {
        let name = self.theory.sources.path().file_name().and_then(|name| name.to_str());
        Report {
            document: &self.theory.document,
            document_name: name.unwrap_or("the document"),
            language: Language::of(&self.theory.document.program.language),
            task: &self.task,
            outcome: &self.outcome,
            traces: &self.traces,
            intervals: &self.intervals,
            notes,
            films: &[],
            command,
            version: env!("CARGO_PKG_VERSION"),
            date: "",
        }
    }
}

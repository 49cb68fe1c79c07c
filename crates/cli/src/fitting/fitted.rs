//! A theory that has been fitted.

use super::prepare::Theory;
use analysis::fit::{Interval, Outcome, Task, Trace};
use report::Report;
use units::Language;

/// A theory that has been fitted.
pub struct Fitted {
    /// The theory.
    pub theory: Theory,
    /// What was asked for.
    pub task: Task,
    /// What came of it.
    pub outcome: Outcome,
    /// The fitted curves.
    pub traces: Vec<Trace>,
    /// Profile intervals by parameter, where they were asked for.
    pub intervals: Vec<Option<[Interval; 2]>>,
}

impl Fitted {
    /// What has to be known beside the numbers, in sentences.
    pub fn remarks(&self) -> Vec<String> {
        let independent = &self.theory.document.program.model.independent;
        report::remarks(&self.outcome, &self.task, (&independent.name, &independent.unit), Language::English)
    }

    /// As the report shows it.
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

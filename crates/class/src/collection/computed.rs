//! What follows from the work of a hand-in. It is computed here in small steps, or elsewhere from an order.

use super::work::{Work, equal_runs};
use crate::grading::{GivenAnswer, Grader};
use crate::verify::{Recomputation, compare};
use desk::{FittedCurve, MeasuredCurve, OpenedDocuments, TheoryCurve};
use document::page::Source;
use saved::hand_in::{Fact, HandIn};
use saved::project::Project;
use serde::{Deserialize, Serialize};

/// The work of a hand-in that is to be computed again, with all that it needs.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct WorkOrder {
    /// Text of the project.
    project: String,
    /// Text of a project with the teacher's document, if that of the work is not the same.
    reference: Option<String>,
    /// Tag of the language of the questions.
    language: String,
}

/// Values, curves and answers that follow from the work of a hand-in.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Computed {
    /// The computed values.
    #[serde(with = "as_text")]
    pub(super) facts: Vec<Fact>,
    /// Number of parts of the work that could not be restored.
    pub(super) refused: usize,
    /// The measured columns in use.
    pub(super) curves: Vec<MeasuredCurve>,
    /// The fitted columns.
    pub(super) fits: Vec<FittedCurve>,
    /// The questions of the document with their answers.
    pub(super) answers: Vec<GivenAnswer>,
    /// Greatest number of kept runs with the same time, parameters and state.
    pub(super) equal_runs: usize,
    /// Curves of the theories that were not known.
    pub(super) theories: Vec<TheoryCurve>,
}

/// Computes orders, and keeps what hand-ins have in common.
#[derive(Debug, Default)]
pub struct Calculator {
    documents: OpenedDocuments,
    /// Titles of the theories whose curves are computed.
    theories: Vec<String>,
}

impl WorkOrder {
    pub(super) fn new(work: &Project, reference: Option<&[Source]>, language: &str) -> Self {
        let reference = reference.map(|files| Project { documents: files.to_vec(), ..Project::default() }.write());
        Self { project: work.write(), reference, language: language.to_owned() }
    }
}

impl Computed {
    /// Values, curves and answers of a finished recomputation. `given`: the items of the work, and the teacher's document by which its
    /// answers are graded, if it has another one. Curves are computed of theories that are not `known`, by their titles.
    pub(super) fn of(
        recomputation: Recomputation,
        given: (&[(String, String)], Option<&[Source]>),
        language: &str,
        known: impl Fn(&str) -> bool,
    ) -> Self {
        let refused = recomputation.refused();
        let (desk, facts) = recomputation.finish(language);
        let (program, (items, reference)) = (desk.play().program(), given);
        let teacher = reference.and_then(|files| Grader::open(files, language));
        let mut grader = teacher.unwrap_or_else(|| Grader::new(program.clone(), language));
        Self {
            facts,
            refused,
            curves: desk.measured().curves(desk.play()),
            fits: desk.fits().fitted_curves(),
            answers: grader.answers(program.seat, items),
            equal_runs: equal_runs(desk.play()),
            theories: desk.fits().theory_curves(|theory| !known(theory)),
        }
    }

    /// The work of a hand-in, compared with what it states.
    pub(super) fn work_of(self, hand_in: &HandIn) -> Work {
        let Self { facts, refused, curves, fits, answers, equal_runs, theories: _ } = self;
        let verdict = compare(hand_in, &facts, refused);
        Work { verdict, facts, curves, fits, answers, equal_runs }
    }
}

impl Calculator {
    /// Computes an order; `None` if its document has errors.
    pub fn compute(&mut self, order: &WorkOrder) -> Option<Computed> {
        let work = Project::read(&order.project).ok()?;
        let mut recomputation = Recomputation::begin_with(&work, &mut self.documents)?;
        while recomputation.advance_with(&mut self.documents) {}
        let reference = order.reference.as_deref().and_then(|text| Project::read(text).ok());
        let reference = reference.map(|project| project.documents);
        let is_known = |theory: &str| self.theories.iter().any(|known| known == theory);
        let computed = Computed::of(recomputation, (&work.items, reference.as_deref()), &order.language, is_known);
        self.theories.extend(computed.theories.iter().map(|curve| curve.theory.clone()));
        Some(computed)
    }
}

/// Facts as in the file of a hand-in: their form needs a format that describes itself.
mod as_text {
    use saved::hand_in::{Fact, facts_text};
    use serde::de::Error as _;
    use serde::{Deserialize, Deserializer, Serializer};

    pub fn serialize<S: Serializer>(facts: &[Fact], serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&facts_text(facts))
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Fact>, D::Error> {
        let text = String::deserialize(deserializer)?;
        serde_json::from_str(&text).map_err(D::Error::custom)
    }
}

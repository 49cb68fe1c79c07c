//! Questions of a document as written, for the teacher's editor.

use super::questions;
use crate::{BlockKind, Outline};
use model::{Span, StatementKind};
use program::Program;

/// A question as written. Missing parts are empty texts.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Asked {
    /// Place without its fence.
    pub place: Span,
    /// Question text.
    pub prompt: String,
    /// Questions that must be answered before it appears.
    pub after: String,
    /// Parameter values that it assumes.
    pub set: String,
    /// Quantities whose values are hidden until it is answered.
    pub hide: String,
    /// Expression of the answer, with its tolerance.
    pub answer: String,
    /// Expected wrong answers with their remarks, one a line.
    pub wrong: String,
    /// Number of options that can be chosen, `one` or `several`.
    pub choose: String,
    /// Options of a choice, one a line.
    pub options: String,
    /// Number of attempts that it allows.
    pub attempts: String,
    /// The hint.
    pub hint: String,
    /// Explanation shown with the right answer.
    pub explanation: String,
}

/// A part of a question.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QuestionPart {
    /// Question text.
    Prompt,
    /// Questions that must be answered before.
    After,
    /// Assumed parameter values.
    Set,
    /// Hidden quantities.
    Hide,
    /// Answer with its tolerance.
    Answer,
    /// Expected wrong answers.
    Wrong,
    /// Number of options that can be chosen.
    Choose,
    /// Options of a choice.
    Options,
    /// Number of attempts.
    Attempts,
    /// The hint.
    Hint,
    /// The explanation.
    Explanation,
}

impl QuestionPart {
    /// All parts, in the usual order.
    pub const ALL: [Self; 11] = [
        Self::Prompt,
        Self::After,
        Self::Set,
        Self::Hide,
        Self::Answer,
        Self::Wrong,
        Self::Choose,
        Self::Options,
        Self::Attempts,
        Self::Hint,
        Self::Explanation,
    ];

    /// Keyword of the part; `None` for the prompt, which comes first.
    pub fn word(self) -> Option<&'static str> {
        match self {
            Self::Prompt => None,
            Self::After => Some("after"),
            Self::Set => Some("set"),
            Self::Hide => Some("hide"),
            Self::Answer => Some("answer"),
            Self::Wrong => Some("wrong"),
            Self::Choose => Some("choose"),
            Self::Options => Some("option"),
            Self::Attempts => Some("attempts"),
            Self::Hint => Some("hint"),
            Self::Explanation => Some("explanation"),
        }
    }
}

impl Asked {
    /// Text of a part.
    pub fn text(&self, part: QuestionPart) -> &str {
        match part {
            QuestionPart::Prompt => &self.prompt,
            QuestionPart::After => &self.after,
            QuestionPart::Set => &self.set,
            QuestionPart::Hide => &self.hide,
            QuestionPart::Answer => &self.answer,
            QuestionPart::Wrong => &self.wrong,
            QuestionPart::Choose => &self.choose,
            QuestionPart::Options => &self.options,
            QuestionPart::Attempts => &self.attempts,
            QuestionPart::Hint => &self.hint,
            QuestionPart::Explanation => &self.explanation,
        }
    }
}

/// Questions of a document, in text order.
pub fn asked(outline: &Outline) -> Vec<Asked> {
    let source = outline.source();
    let read = |block: &crate::Block| {
        let text = |word| {
            let place = questions::part(source, block.content.range(), word);
            place.map(|place| source[place].to_owned()).unwrap_or_default()
        };
        let raw = questions::split(source, block.content.range(), &mut Vec::new());
        let entries = |word| {
            let lines = raw.entries(source, word).into_iter();
            let lines = lines.map(|place| source[place].lines().map(str::trim).collect::<Vec<_>>().join(" "));
            lines.collect::<Vec<_>>().join(if source.contains("\r\n") { "\r\n" } else { "\n" })
        };
        Asked {
            place: block.content,
            prompt: text(None),
            after: text(Some("after")),
            set: text(Some("set")),
            hide: text(Some("hide")),
            answer: text(Some("answer")),
            wrong: entries("wrong"),
            choose: text(Some("choose")),
            options: entries("option"),
            attempts: text(Some("attempts")),
            hint: text(Some("hint")),
            explanation: text(Some("explanation")),
        }
    };
    outline.blocks_of(BlockKind::Question).map(read).collect()
}

/// Quantities that can be the answer of a question, with their labels: those computed from parameters alone.
pub fn possible_answers(outline: &Outline, program: &Program) -> Vec<(String, Option<String>)> {
    let model = &program.model;
    let shown = model.quantities.iter().filter(|quantity| !quantity.hidden && !quantity.remembered);
    let constant = shown.filter(|quantity| {
        let dependence = model.depends(quantity.value.node);
        dependence.states.is_empty() && !dependence.independent
    });
    let declared = |name: &str| {
        let mut statements = outline.blocks().iter().flat_map(|block| &block.statements);
        statements.any(|one| matches!(&one.kind, StatementKind::Definition { name: own, .. } if own.text == name))
    };
    let named = constant.filter(|quantity| declared(&quantity.name));
    named.map(|quantity| (quantity.name.clone(), quantity.label.clone())).collect()
}

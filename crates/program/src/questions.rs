//! Questions and the evaluation of answers.

use crate::{Assignment, Compiled};
use serde::{Deserialize, Serialize};
use units::Unit;

/// A question.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Question {
    /// Parameter values that the question assumes. Its answer is computed with them instead of the current ones, and the
    /// laboratory offers to set them.
    pub setup: Vec<Assignment>,
    /// Quantities that would reveal the answer, as indices in [`crate::Model::quantities`]: hidden until it is given.
    pub hides: Vec<usize>,
    /// Indices of the earlier questions that must be answered before this one appears.
    pub after: Vec<usize>,
    /// Number of attempts that count; `None` for any number. From 1 to [`Question::MOST_ATTEMPTS`].
    pub attempts: Option<u32>,
    /// Kind of the question, with what is needed to grade an answer.
    pub kind: QuestionKind,
}

/// Kind of a question.
// The variants are smaller where addresses are.
#[cfg_attr(
    target_pointer_width = "64",
    expect(clippy::large_enum_variant, reason = "most questions ask for a number, and a document has at most 200")
)]
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum QuestionKind {
    /// A number with a unit.
    Number(NumberAnswer),
    /// One or several of the options in [`QuestionText::options`].
    Choice(ChoiceAnswer),
}

/// A number that the document computes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NumberAnswer {
    /// Correct answer; depends on parameters only and is always a number.
    pub right: Compiled,
    /// Unit in which the answer is asked for.
    pub unit: Unit,
    /// Allowed error of an answer.
    pub tolerance: Tolerance,
    /// Expected wrong answers; each has its remark in [`QuestionText::wrong`]. At most [`Question::MOST_WRONG`].
    pub wrong: Vec<WrongValue>,
}

/// A wrong answer that the author expects.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WrongValue {
    /// The value, of the dimension of the answer.
    pub value: Compiled,
    /// Difference up to which an answer is taken for this one.
    pub tolerance: Tolerance,
}

/// Options of a choice.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ChoiceAnswer {
    /// True if several options can be chosen.
    pub several: bool,
    /// For each option, true if it is right. From 2 to [`Question::MOST_OPTIONS`]; at least one is right, and exactly one if only one
    /// can be chosen.
    pub right: Vec<bool>,
}

impl Question {
    /// Maximum limit of the attempts at a question.
    pub const MOST_ATTEMPTS: u32 = 50;
    /// Maximum number of options of a choice; each has a letter as its name.
    pub const MOST_OPTIONS: usize = 20;
    /// Maximum number of expected wrong answers.
    pub const MOST_WRONG: usize = 20;

    /// The number that is asked for; `None` for other kinds.
    pub fn number(&self) -> Option<&NumberAnswer> {
        match &self.kind {
            QuestionKind::Number(number) => Some(number),
            QuestionKind::Choice(_) => None,
        }
    }

    /// All values that decide the grade: the right answer, then the expected wrong ones. None for kinds without numbers.
    pub fn values(&self) -> impl Iterator<Item = &Compiled> {
        self.number()
            .into_iter()
            .flat_map(|number| std::iter::once(&number.right).chain(number.wrong.iter().map(|wrong| &wrong.value)))
    }

    /// True if the text has the words for the kind, and the kind is consistent.
    pub(crate) fn is_sound(&self, text: &QuestionText) -> bool {
        match &self.kind {
            QuestionKind::Number(number) => {
                number.wrong.len() <= Self::MOST_WRONG
                    && text.wrong.len() == number.wrong.len()
                    && text.options.is_empty()
            }
            QuestionKind::Choice(choice) => choice.is_sound() && text.options.len() == choice.right.len(),
        }
    }
}

impl ChoiceAnswer {
    /// True if the options are consistent.
    pub fn is_sound(&self) -> bool {
        let right = self.right.iter().filter(|right| **right).count();
        (2..=Question::MOST_OPTIONS).contains(&self.right.len()) && right > 0 && (self.several || right == 1)
    }

    /// Name of the option with this index: `A`, `B`.
    pub fn letter(option: usize) -> char {
        u8::try_from(option).ok().and_then(|option| b'A'.checked_add(option)).map_or('?', char::from)
    }

    /// Names of options, as answers are written: `A, C`.
    pub fn letters(options: impl IntoIterator<Item = usize>) -> String {
        options.into_iter().map(|option| Self::letter(option).to_string()).collect::<Vec<_>>().join(", ")
    }

    /// Options named in an answer, for each option true if it is chosen; `None` if the text is not such a list, names no option, or names
    /// several where one can be chosen.
    pub fn chosen(&self, typed: &str) -> Option<Vec<bool>> {
        let mut chosen = vec![false; self.right.len()];
        for name in typed.split(',') {
            let mut letters = name.trim().chars();
            let letter = letters.next().filter(|_| letters.next().is_none())?;
            let option = (0..chosen.len()).find(|option| Self::letter(*option) == letter)?;
            chosen[option] = true;
        }
        let count = chosen.iter().filter(|chosen| **chosen).count();
        (self.several || count == 1).then_some(chosen)
    }

    /// Share of the credit for chosen options: the right ones among them less the wrong ones, divided by all right ones; from 0 to 1.
    pub fn credit(&self, chosen: &[bool]) -> f64 {
        let among =
            |right: bool| self.right.iter().zip(chosen).filter(|(own, chosen)| **own == right && **chosen).count();
        let all = self.right.iter().filter(|right| **right).count().max(1);
        among(true).saturating_sub(among(false)) as f64 / all as f64
    }
}

/// Allowed difference between two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Tolerance {
    /// Fraction of the correct number: 0.02 for `within 2 %`.
    Relative(f64),
    /// Amount in SI units: `within 0.1 [s]`.
    Absolute(f64),
}

impl Tolerance {
    /// True if `given` is close enough to `right`, both in SI units.
    pub fn accepts(self, given: f64, right: f64) -> bool {
        let allowed = match self {
            Self::Relative(fraction) => fraction * right.abs(),
            Self::Absolute(amount) => amount,
        };
        (given - right).abs() <= allowed
    }
}

/// Texts of a question, as HTML.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct QuestionText {
    /// The question.
    pub prompt: String,
    /// Help for finding the answer, if any.
    pub hint: Option<String>,
    /// Explanation shown after answering, if any.
    pub explanation: Option<String>,
    /// Options of a choice, in the order of [`ChoiceAnswer::right`].
    pub options: Vec<OptionText>,
    /// Remarks on expected wrong answers, in the order of [`NumberAnswer::wrong`].
    pub wrong: Vec<String>,
}

/// Texts of an option, as HTML.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct OptionText {
    /// The option.
    pub text: String,
    /// Remark that is shown when the option has been chosen, if any.
    pub remark: Option<String>,
}

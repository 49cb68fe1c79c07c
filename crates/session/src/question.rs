//! Questions: what an answer is worth.

use crate::{Refusal, Session};

/// What an answer is worth, and in words.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// The grade.
    pub grade: Grade,
    /// In the session's language.
    pub text: String,
}

/// The grades.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grade {
    /// Within the tolerance.
    Correct,
    /// Within five times the tolerance.
    Close,
    /// The magnitude is right, the sign is not.
    WrongSign,
    /// The number is right by a power of ten or two: most likely the unit.
    WrongScale,
    /// Off.
    Wrong,
    /// Not an answer: no number, an unknown unit, or a unit of something else.
    Unreadable,
}

impl Session {
    /// Judges an answer: a number in the unit asked for, or with a unit of the same dimension.
    pub fn check_answer(&mut self, question: usize, text: &str) -> Verdict {
        let _ = (question, text);
        Verdict {
            grade: Grade::Unreadable,
            text: String::new(),
        }
    }

    /// The right answer with its unit, for the parameters as they are (or as the question supposes).
    pub fn reveal_answer(&mut self, question: usize) -> String {
        let _ = question;
        String::new()
    }

    /// The unit in which an answer is asked for, for people.
    pub fn question_unit(&self, question: usize) -> String {
        let _ = question;
        String::new()
    }

    /// The parameter values a question supposes, `b = 0 kg/s, h_l = 3 m`, and whether they are set now; `None` if it
    /// supposes none.
    pub fn question_setup(&self, question: usize) -> Option<(String, bool)> {
        let _ = question;
        None
    }

    /// Sets the parameters that a question supposes.
    pub fn apply_question_setup(&mut self, question: usize) -> Result<(), Refusal> {
        let _ = question;
        Ok(())
    }
}

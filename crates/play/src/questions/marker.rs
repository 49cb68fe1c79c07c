//! Grades without a run: a teacher's document, the seat of a student and the student's answers.

use crate::Basis;
use crate::questions::answered::{AnswerView, Answers, question_names};
use crate::questions::given::Answer;
use program::{Program, Seat};

/// The questions of a document and the values of a seat.
#[derive(Debug)]
pub struct Marker {
    basis: Basis,
    answers: Answers,
    /// Names of the questions.
    names: Vec<String>,
}

impl Marker {
    /// The questions of a program. `language`: tag of the language of its texts and of right answers.
    pub fn new(program: Program, language: &str) -> Self {
        let (answers, names) = (Answers::new(&program), question_names(&program));
        let mut basis = Basis::new(program);
        basis.set_language(language);
        Self { basis, answers, names }
    }

    /// The program.
    pub fn program(&self) -> &Program {
        self.basis.program()
    }

    /// Tag of the language of the texts.
    pub fn language(&self) -> &str {
        self.basis.tag()
    }

    /// Index of the question with this name.
    pub fn question(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|own| own == name)
    }

    /// An answer to the question with this index, with its grades for a seat; without a seat for the stated values.
    pub fn marked(&mut self, seat: Option<Seat>, question: usize, answer: &Answer) -> AnswerView {
        if self.basis.program().seat != seat {
            self.basis.set_seat(seat);
        }
        self.answers.marked(&self.basis, question, &answer.bounded())
    }
}

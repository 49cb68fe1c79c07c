//! Conversion between answers to questions and stored items.

use crate::Desk;
use play::{Answer, Grade};
use saved::Item;
use saved::format::{self, Content};

impl Desk {
    /// The answers to store, with the names of their questions.
    pub fn saved_answers(&self) -> Vec<(String, Item)> {
        let item = |(name, Answer { typed, grade, revealed }): (String, Answer)| {
            let grade = grade.map(|grade| grade.code().to_owned());
            (name, Item(Content::Answer(format::Answer { typed, grade, revealed })))
        };
        self.play.answers().saved(self.play.basis()).into_iter().map(item).collect()
    }

    /// Restores the answer to the question of this name. Returns true if the item is an answer and the question exists.
    pub fn restore_answer(&mut self, question: &str, item: &Item) -> bool {
        let Content::Answer(format::Answer { typed, grade, revealed }) = &item.0 else { return false };
        let grade = grade.as_deref().and_then(Grade::from_code);
        self.play.restore_answer(question, &Answer { typed: typed.clone(), grade, revealed: *revealed })
    }
}

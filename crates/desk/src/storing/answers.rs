//! Conversion between answers to questions and stored items.

use play::{Answer, Attempt, Grade, Play};
use saved::Item;
use saved::format::{self, Content};

/// The answers to store, with the names of their questions.
pub fn saved_answers(play: &Play) -> Vec<(String, Item)> {
    let saved = play.answers().saved(play.basis()).into_iter();
    saved.map(|(name, answer)| (name, Item(Content::Answer(stored(answer))))).collect()
}

/// Restores the answer to the question of this name. Returns true if the item is an answer and the question exists.
pub fn restore_answer(play: &mut Play, question: &str, item: &Item) -> bool {
    let Content::Answer(answer) = &item.0 else { return false };
    play.change_answers(|answers, run| answers.restore(run, question, &restored(answer)))
}

fn stored(answer: Answer) -> format::Answer {
    let Answer { typed, grade, revealed, found, attempts } = answer;
    let attempt = |Attempt { typed, grade }: Attempt| format::Attempt { typed, grade: grade.code().to_owned() };
    let attempts = attempts.into_iter().map(attempt).collect();
    format::Answer { typed, grade: grade.map(|grade| grade.code().to_owned()), revealed, found, attempts }
}

/// An attempt without a known grade is left out.
fn restored(answer: &format::Answer) -> Answer {
    let attempt =
        |one: &format::Attempt| Some(Attempt { typed: one.typed.clone(), grade: Grade::from_code(&one.grade)? });
    Answer {
        typed: answer.typed.clone(),
        grade: answer.grade.as_deref().and_then(Grade::from_code),
        revealed: answer.revealed,
        found: answer.found,
        attempts: answer.attempts.iter().filter_map(attempt).collect(),
    }
}

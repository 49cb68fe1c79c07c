//! Answers to questions as stored items.

use play::{Answer, Play};
use saved::Item;
use saved::format::Content;

/// The answers to store, with the names of their questions.
pub fn saved_answers(play: &Play) -> Vec<(String, Item)> {
    let saved = play.answers().saved(play.basis()).into_iter();
    saved.map(|(name, answer)| (name, Item(Content::Answer(answer.stored())))).collect()
}

/// Restores the answer to the question of this name. Returns true if the item is an answer and the question exists.
pub fn restore_answer(play: &mut Play, question: &str, item: &Item) -> bool {
    let Some(answer) = answer_of_item(item) else { return false };
    play.change_answers(|answers, run| answers.restore(run, question, &answer))
}

/// The answer that an item holds.
pub fn answer_of_item(item: &Item) -> Option<Answer> {
    match &item.0 {
        Content::Answer(answer) => Some(Answer::of_stored(answer)),
        _ => None,
    }
}

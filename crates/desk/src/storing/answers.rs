//! Conversion between answers to questions and stored items.

use play::{Answer, Attempt, Conditions, Grade, Play};
use saved::format::{self, Content};
use saved::{Item, Number};

/// The answers to store, with the names of their questions.
pub fn saved_answers(play: &Play) -> Vec<(String, Item)> {
    let saved = play.answers().saved(play.basis()).into_iter();
    saved.map(|(name, answer)| (name, Item(Content::Answer(stored(answer))))).collect()
}

/// Restores the answer to the question of this name. Returns true if the item is an answer and the question exists.
pub fn restore_answer(play: &mut Play, question: &str, item: &Item) -> bool {
    let Some(answer) = answer_of_item(item) else { return false };
    play.change_answers(|answers, run| answers.restore(run, question, &answer))
}

/// The answer that an item holds.
pub fn answer_of_item(item: &Item) -> Option<Answer> {
    match &item.0 {
        Content::Answer(answer) => Some(restored(answer)),
        _ => None,
    }
}

fn stored(answer: Answer) -> format::Answer {
    let Answer { typed, grade, shown, attempts } = answer;
    let attempt = |Attempt { typed, grade, conditions }: Attempt| {
        let Conditions { language, values } = conditions.clone().unwrap_or_default();
        format::Attempt {
            typed,
            grade: grade.code().to_owned(),
            language: conditions.map(|_| language),
            values: values.into_iter().map(|(name, value)| (name, Number(value))).collect(),
        }
    };
    format::Answer {
        typed,
        grade: grade.map(|grade| grade.code().to_owned()),
        shown,
        revealed: shown.is_some(),
        found: false,
        attempts: attempts.into_iter().map(attempt).collect(),
    }
}

/// An attempt without a known grade is left out.
fn restored(answer: &format::Answer) -> Answer {
    let attempt = |one: &format::Attempt| {
        let values = || one.values.iter().map(|(name, Number(value))| (name.clone(), *value)).collect();
        let conditions = one.language.clone().map(|language| Conditions { language, values: values() });
        Some(Attempt { typed: one.typed.clone(), grade: Grade::from_code(&one.grade)?, conditions })
    };
    let attempts: Vec<Attempt> = answer.attempts.iter().filter_map(attempt).collect();
    Answer {
        typed: answer.typed.clone(),
        grade: answer.grade.as_deref().and_then(Grade::from_code),
        shown: answer.shown.or_else(|| Answer::shown_of_0_2(answer.revealed, answer.found, attempts.len())),
        attempts,
    }
}

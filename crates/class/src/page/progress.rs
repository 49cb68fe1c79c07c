//! Sentences about the computation of a class.

use crate::collection::{Collection, State};
use units::{Language, say};

/// Number of groups, of hand-ins that are still to be computed, and of files that do not count.
pub fn count_text(collection: &Collection, language: Language) -> String {
    let (groups, waiting) = (collection.works().count(), collection.waiting());
    let counts_not = |state: &State| matches!(state, State::Repeated(_) | State::Unreadable(_));
    let more = collection.entries().iter().filter(|entry| counts_not(entry.state())).count();
    let mut text = match groups {
        1 => language.say("1 group").to_owned(),
        _ => say!(language, "{groups} groups"),
    };
    if waiting > 0 {
        text += &say!(language, ", {waiting} still to be computed");
    }
    let uncompared = collection.uncompared();
    if waiting == 0 && uncompared > 0 {
        text += &say!(language, ", looking for shared data: {uncompared} to go");
    }
    match more {
        0 => {}
        1 => text += language.say(", 1 further file that does not count"),
        _ => text += &say!(language, ", {more} further files that do not count"),
    }
    text
}

/// Sentence about the computation while hand-ins are still to be computed: how many are done.
pub fn progress_text(collection: &Collection, language: Language) -> Option<String> {
    let (done, waiting) = (collection.computed(), collection.waiting());
    let all = done + waiting;
    let text = || say!(language, "Being computed: {done} of {all} hand-ins are done.");
    (waiting > 0).then(text)
}

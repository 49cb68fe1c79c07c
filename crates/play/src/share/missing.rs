//! Parts of the state that a link leaves out.

use super::state::MOST_CHANGES;
use crate::Play;

/// Parts of the state that a link does not contain, in the chosen language.
pub fn missing_in_link(play: &Play) -> Vec<&'static str> {
    let (basis, language) = (play.basis(), play.basis().language());
    [
        (!play.answers().saved(basis).is_empty(), language.say("answers")),
        (play.course().recipe().changes.len() > MOST_CHANGES, language.say("the run before the moment shown")),
    ]
    .into_iter()
    .filter_map(|(missing, name)| missing.then_some(name))
    .collect()
}

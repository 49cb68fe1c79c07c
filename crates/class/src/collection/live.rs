//! Hand-ins of a running lesson: later forms of a file replace earlier ones.

use super::{Collection, Entry, State, Step};
use saved::hand_in::{HandIn, HandInError};

impl Collection {
    /// Adds a file, or replaces the content of the file of this name and sender. The work of the former content counts until the
    /// new one is computed.
    pub fn update(&mut self, file: &str, content: Result<HandIn, HandInError>) {
        let is_former = |entry: &Entry| {
            let (former, new) = (entry.hand_in(), content.as_ref().ok());
            entry.file == file
                && !matches!(entry.state, State::Repeated(_))
                && former.zip(new).is_some_and(|(former, new)| former.sender == new.sender)
        };
        let Some(index) = self.entries.iter().position(is_former) else { return self.add(file, content) };
        let entry = &mut self.entries[index];
        entry.content = content;
        self.are_documents_compared = false;
        entry.state = match std::mem::replace(&mut entry.state, State::Waiting(None)) {
            State::Done(work) => State::Waiting(Some(work)),
            State::Waiting(work) => State::Waiting(work),
            State::Unreadable(_) | State::Repeated(_) => State::Waiting(None),
        };
        let is_computed_here = matches!(self.step, Some(Step::Fitting(own, _)) if own == index);
        if is_computed_here || self.ordered.contains(&index) {
            self.superseded.insert(index);
        }
    }
}

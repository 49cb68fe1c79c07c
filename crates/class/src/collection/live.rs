//! Hand-ins of a running lesson: later forms of a file replace earlier ones.

use super::{Collection, Entry, State};
use saved::hand_in::{HandIn, HandInError};

impl Collection {
    /// Adds a file, or a later form of the file of this name. The former one is left out of lists, and its content is dropped.
    pub fn update(&mut self, file: &str, content: Result<HandIn, HandInError>) {
        let former = self.entries.iter().rposition(|entry| entry.file == file && !entry.is_outdated);
        self.add(file, content);
        if let Some(former) = former.and_then(|former| self.entries.get_mut(former))
            && matches!(former.state, State::Repeated(_))
        {
            former.is_outdated = true;
            former.content = Ok(HandIn::default());
        }
    }

    /// The files with their indices, without former forms of files that were updated.
    pub fn listed(&self) -> impl Iterator<Item = (usize, &Entry)> {
        self.entries.iter().enumerate().filter(|(_, entry)| !entry.is_outdated)
    }
}

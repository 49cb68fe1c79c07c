//! Ids of the elements of a scene, and the attributes that refer to them.

use std::collections::BTreeSet;
use std::ops::Range;

/// Ids and references of one scene.
#[derive(Default)]
pub struct Ids {
    known: BTreeSet<String>,
    /// Ids to which attributes refer, with the places of the references.
    references: Vec<(String, Range<usize>)>,
}

impl Ids {
    /// Adds the id of an element. Returns false if another element has it.
    pub fn add(&mut self, id: String) -> bool {
        self.known.insert(id)
    }

    /// Records a reference to an id.
    pub fn refer(&mut self, id: &str, place: Range<usize>) {
        self.references.push((id.to_owned(), place));
    }

    /// Takes the references to ids that no element has.
    pub fn take_unknown(&mut self) -> Vec<(String, Range<usize>)> {
        let mut references = std::mem::take(&mut self.references);
        references.retain(|(id, _)| !self.known.contains(id));
        references
    }
}

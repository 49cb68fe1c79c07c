//! Work that the teacher has collected to be shown without names.

use super::{Collection, Member};
use std::collections::BTreeMap;

/// A piece of work of a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Snapshot {
    /// A measured curve with its fit.
    Curve(Member),
    /// The answer to a question.
    Answer {
        /// Index of the hand-in.
        hand_in: usize,
        /// Index of the answer in [`super::Work::answers`].
        answer: usize,
    },
}

/// Collected work in the order in which it is shown.
#[derive(Clone, Debug, Default)]
pub struct Snapshots {
    list: Vec<Snapshot>,
}

impl Snapshot {
    /// Index of the hand-in.
    pub fn hand_in(self) -> usize {
        match self {
            Self::Curve(member) => member.hand_in,
            Self::Answer { hand_in, .. } => hand_in,
        }
    }
}

impl Snapshots {
    /// The list.
    pub fn list(&self) -> &[Snapshot] {
        &self.list
    }

    /// Adds a snapshot at the end, or removes it if it is in the list. Returns true if it was added.
    pub fn toggle(&mut self, snapshot: Snapshot) -> bool {
        let before = self.list.len();
        self.list.retain(|own| *own != snapshot);
        let is_new = self.list.len() == before;
        if is_new {
            self.list.push(snapshot);
        }
        is_new
    }

    /// Exchanges a snapshot with the one before it.
    pub fn move_up(&mut self, place: usize) {
        if place > 0 && place < self.list.len() {
            self.list.swap(place - 1, place);
        }
    }

    /// Removes the snapshots of work that does not count any more.
    pub fn retain(&mut self, collection: &Collection) {
        self.list.retain(|snapshot| match *snapshot {
            Snapshot::Curve(member) => collection.curve(member).is_some(),
            Snapshot::Answer { hand_in, answer } => collection.answer(hand_in, answer).is_some(),
        });
    }

    /// Name of each snapshot for a view without names: `A`, `B` .. for each group in the order of its first snapshot, from the
    /// 27th group on with a number.
    pub fn letters(&self) -> Vec<String> {
        let mut letters: BTreeMap<usize, String> = BTreeMap::new();
        let mut name = |hand_in: usize| {
            let number = letters.len();
            let letter = char::from(b'A' + (number % 26) as u8);
            let round = number / 26;
            let new = if round == 0 { letter.to_string() } else { format!("{letter}{}", round + 1) };
            letters.entry(hand_in).or_insert(new).clone()
        };
        self.list.iter().map(|snapshot| name(snapshot.hand_in())).collect()
    }
}

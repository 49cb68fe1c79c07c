//! Values of a scene so far, as they are computed for every frame.

use program::{Compiled, NodeId};
use std::collections::BTreeMap;
use units::{Words, words};

/// Maximum number of values of a scene; all are computed for every frame.
const VALUES: usize = 10_000;

/// Values of a scene so far; equal values share one index.
#[derive(Default)]
pub struct ValueList {
    list: Vec<Compiled>,
    /// Indices of the values of each node.
    of_node: BTreeMap<NodeId, Vec<usize>>,
}

impl ValueList {
    /// Index of a value, which is added if it is new. `None` if there are too many.
    pub fn add(&mut self, compiled: Compiled) -> Option<usize> {
        let same = self.of_node.entry(compiled.node).or_default();
        let known = same.iter().copied().find(|index| self.list.get(*index) == Some(&compiled));
        if known.is_some() {
            return known;
        }
        if self.list.len() == VALUES {
            return None;
        }
        same.push(self.list.len());
        self.list.push(compiled);
        Some(self.list.len() - 1)
    }

    /// Node of a value, by its index.
    pub fn node(&self, index: usize) -> Option<NodeId> {
        self.list.get(index).map(|value| value.node)
    }

    /// Message about too many values.
    pub fn too_many() -> Words {
        words!("a scene cannot have more than {VALUES} values")
    }

    /// The values, by index.
    pub fn into_list(self) -> Vec<Compiled> {
        self.list
    }
}

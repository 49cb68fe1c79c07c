//! Linear systems among the nodes of a graph.

use super::{Entry, LinearSystem, NodeId};
use crate::bandwidth::{band_width, banded_order, bandwidth, places};

impl LinearSystem {
    /// Unknowns of a system whose matrix is dense.
    pub const MOST_DENSE: usize = 32;
    /// Numbers that the elimination of all systems of a model may take.
    pub const MOST_NUMBERS: usize = 1_000_000;

    /// A system of entries, each with its row and column, and of the right side.
    pub fn new(entries: impl IntoIterator<Item = ((usize, usize), NodeId)>, right: Vec<NodeId>) -> Self {
        let entry = |((row, column), node)| Entry { row: row as u32, column: column as u32, node };
        let mut entries: Vec<Entry> = entries.into_iter().map(entry).collect();
        entries.sort_unstable_by_key(|entry| (entry.row, entry.column));
        Self { entries, right }
    }

    /// All that it is computed from.
    pub fn operands(&self) -> impl Iterator<Item = NodeId> {
        self.entries.iter().map(|entry| entry.node).chain(self.right.iter().copied())
    }

    /// The same with other nodes in the places of those that it is computed from.
    pub fn map(&self, mut other: impl FnMut(NodeId) -> NodeId) -> Self {
        let entries = self.entries.iter().map(|entry| Entry { node: other(entry.node), ..*entry }).collect();
        Self { entries, right: self.right.iter().map(|&node| other(node)).collect() }
    }

    /// [`LinearSystem::map`]; `None` if one of them has no other.
    pub fn try_map(&self, mut other: impl FnMut(NodeId) -> Option<NodeId>) -> Option<Self> {
        let entries = self.entries.iter().map(|entry| Some(Entry { node: other(entry.node)?, ..*entry }));
        let entries = entries.collect::<Option<_>>()?;
        let right = self.right.iter().map(|&node| other(node)).collect::<Option<_>>()?;
        Some(Self { entries, right })
    }

    /// Row and column of each entry.
    pub fn pattern(&self) -> Vec<(usize, usize)> {
        self.entries.iter().map(|entry| (entry.row as usize, entry.column as usize)).collect()
    }

    /// How many numbers its elimination takes; `None` if it would take too much work, since it has many unknowns and no order of them
    /// in which all entries stand near the diagonal.
    pub fn numbers(&self) -> Option<usize> {
        let size = self.right.len();
        let pattern = self.pattern();
        match banded_order(size, &pattern) {
            Some(order) => {
                let (lower, upper) = bandwidth(&pattern, &places(&order));
                Some(size * band_width(lower, upper))
            }
            None => (size <= Self::MOST_DENSE).then_some(size * size),
        }
    }

    /// Whether each entry stands in the matrix, once and in order.
    pub(super) fn is_sound(&self) -> bool {
        let size = self.right.len();
        let place = |entry: &Entry| (entry.row, entry.column);
        self.entries.iter().all(|entry| (entry.row.max(entry.column) as usize) < size)
            && self.entries.is_sorted_by(|one, other| place(one) < place(other))
    }
}

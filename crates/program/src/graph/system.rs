//! Linear systems among the nodes of a graph.

use super::{Entry, LinearSystem, NodeId};
use crate::bandwidth::{band_width, banded_order, bandwidth, places};
use units::order::sort_by_key;

impl LinearSystem {
    /// Maximum number of unknowns of a system with a dense matrix.
    pub const MOST_DENSE: usize = 32;
    /// Maximum storage for the elimination of all systems of a model, in numbers.
    pub const MOST_NUMBERS: usize = 1_000_000;

    /// System from entries with (row, column), in any order, and the right-hand side.
    pub fn new(entries: impl IntoIterator<Item = ((usize, usize), NodeId)>, right: Vec<NodeId>) -> Self {
        let entry = |((row, column), node)| Entry { row: row as u32, column: column as u32, node };
        let mut entries: Vec<Entry> = entries.into_iter().map(entry).collect();
        sort_by_key(&mut entries, |entry| (entry.row, entry.column));
        Self { entries, right }
    }

    /// All nodes of the matrix and of the right-hand side.
    pub fn operands(&self) -> impl Iterator<Item = NodeId> {
        self.entries.iter().map(|entry| entry.node).chain(self.right.iter().copied())
    }

    /// Copy with every operand `n` replaced by `other(n)`.
    pub fn map(&self, mut other: impl FnMut(NodeId) -> NodeId) -> Self {
        let entries = self.entries.iter().map(|entry| Entry { node: other(entry.node), ..*entry }).collect();
        Self { entries, right: self.right.iter().map(|&node| other(node)).collect() }
    }

    /// [`LinearSystem::map`]; `None` if `other` returns `None` for any operand.
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

    /// Storage for the elimination, in numbers. `None` if it would be too much work: the system has many unknowns and no
    /// order of small bandwidth.
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

    /// True if all entries are inside the matrix, sorted and unique.
    pub(super) fn is_sound(&self) -> bool {
        let size = self.right.len();
        let place = |entry: &Entry| (entry.row, entry.column);
        self.entries.iter().all(|entry| (entry.row.max(entry.column) as usize) < size)
            && self.entries.is_sorted_by(|one, other| place(one) < place(other))
    }
}

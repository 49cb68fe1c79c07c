//! Finds what repeats among operations that do not need each other.

use super::column::{Column, Operand};
use super::instruction::{Operation, Register};

/// Shorter columns cost more than instructions of their own.
const LEAST: usize = 8;

/// An operation that has no register yet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Entry {
    pub operation: Operation,
    /// Those that it does not have are 0.
    pub operands: [Register; 3],
    /// The node that it computes.
    pub node: usize,
}

/// Operations as columns, and what is left of them.
#[derive(Debug, Default)]
pub(crate) struct Columns {
    /// All operations in the order of their targets.
    pub order: Vec<Entry>,
    pub columns: Vec<Column>,
    /// The places in `order` of those that are in no column.
    pub alone: Vec<usize>,
}

/// Makes columns of `entries`, whose targets are the registers from `first` on.
///
/// Equal operations are sorted by their operands and cut into the longest runs in which every operand goes on by a constant
/// number of registers. If enough remain, they are one more column, whose operands may stand anywhere.
pub(crate) fn columns(mut entries: Vec<Entry>, first: Register) -> Columns {
    for entry in &mut entries {
        if matches!(entry.operation, Operation::Add | Operation::Multiply) && entry.operands[0] > entry.operands[1] {
            entry.operands.swap(0, 1);
        }
        if entry.operation == Operation::MultiplyAdd && entry.operands[0] > entry.operands[1] {
            entry.operands.swap(0, 1);
        }
    }
    entries.sort_unstable_by_key(|entry| (entry.operation.number(), entry.operands, entry.node));
    let mut found = Columns::default();
    for group in entries.chunk_by(|a, b| a.operation == b.operation) {
        found.add(group, first);
    }
    found
}

impl Columns {
    fn add(&mut self, group: &[Entry], first: Register) {
        let mut runs = Vec::new();
        let mut alone = Vec::new();
        let mut at = 0;
        while at < group.len() {
            let length = run(&group[at..]);
            if length >= LEAST {
                runs.push((at, length));
                at += length;
            } else {
                alone.push(at);
                at += 1;
            }
        }
        let begin = self.order.len();
        let listed = alone.len() >= LEAST;
        if listed {
            // What is in no run stands behind the runs.
            for &(at, length) in &runs {
                self.column(&group[at..at + length], first);
            }
            let rest: Vec<Entry> = alone.iter().map(|&at| group[at]).collect();
            self.column(&rest, first);
        } else {
            // What is in no run keeps its place between them: what is computed from the whole group may be one run again.
            self.order.extend(group);
            for (at, length) in runs {
                self.columns.push(column(&group[at..at + length], first + (begin + at) as Register));
            }
            self.alone.extend(alone.into_iter().map(|at| begin + at));
        }
    }

    fn column(&mut self, entries: &[Entry], first: Register) {
        self.columns.push(column(entries, first + self.order.len() as Register));
        self.order.extend(entries);
    }
}

/// How many entries from the first on have operands that go on by constant numbers of registers.
fn run(entries: &[Entry]) -> usize {
    let distances = |pair: &[Entry]| {
        let distance = |which: usize| i64::from(pair[1].operands[which]) - i64::from(pair[0].operands[which]);
        [distance(0), distance(1), distance(2)]
    };
    let mut pairs = entries.windows(2).map(distances);
    match pairs.next() {
        Some(first) => 2 + pairs.take_while(|pair| *pair == first).count(),
        None => entries.len(),
    }
}

fn column(entries: &[Entry], to: Register) -> Column {
    let operand = |which: usize| {
        let registers: Vec<Register> = entries.iter().map(|entry| entry.operands[which]).collect();
        Operand::of(&registers)
    };
    let operation = entries.first().map_or(Operation::Negate, |entry| entry.operation);
    Column { operation, to, count: entries.len() as u32, operands: [operand(0), operand(1), operand(2)] }
}

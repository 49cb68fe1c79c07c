//! Finds columns among independent operations.

use super::column::{Column, Operand};
use super::instruction::{Operation, Register};
use units::order::sort_by_key;

/// Minimum length of a column: shorter ones cost more than single instructions.
const LEAST: usize = 8;

/// An operation without a target register.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Entry {
    pub operation: Operation,
    /// Operand registers; unused ones are 0.
    pub operands: [Register; 3],
    /// Index of the node that it computes.
    pub node: usize,
}

/// Operations grouped into columns, and the rest.
#[derive(Debug, Default)]
pub(crate) struct Columns {
    /// All operations in the order of their target registers.
    pub order: Vec<Entry>,
    pub columns: Vec<Column>,
    /// Indices in `order` of the operations outside all columns.
    pub alone: Vec<usize>,
}

/// Groups `entries` into columns; their targets are the registers from `first` on.
///
/// Equal operations are sorted by their operands and cut into the longest runs in which every operand has a constant
/// stride. If enough remain, they form one more column with operands in any registers.
pub(crate) fn columns(mut entries: Vec<Entry>, first: Register) -> Columns {
    for entry in &mut entries {
        if matches!(entry.operation, Operation::Add | Operation::Multiply) && entry.operands[0] > entry.operands[1] {
            entry.operands.swap(0, 1);
        }
        if entry.operation == Operation::MultiplyAdd && entry.operands[0] > entry.operands[1] {
            entry.operands.swap(0, 1);
        }
    }
    sort_by_key(&mut entries, |entry| (entry.operation.number(), entry.operands, entry.node));
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
            // Operations in no run follow the runs.
            for &(at, length) in &runs {
                self.column(&group[at..at + length], first);
            }
            let rest: Vec<Entry> = alone.iter().map(|&at| group[at]).collect();
            self.column(&rest, first);
        } else {
            // Operations in no run keep their place between the runs: results of the whole group are then one run of
            // registers.
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

/// Number of entries from the first on whose operands have constant strides.
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

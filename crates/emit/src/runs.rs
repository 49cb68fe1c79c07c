//! Runs of equal operations whose registers are consecutive.

use crate::sink::lists::LEAST;
use engine::{Line, Operation, Register};

/// Equal operations for consecutive targets, or a single one.
#[derive(Debug)]
pub(crate) struct Run {
    pub operation: Operation,
    /// Register of the first result.
    pub to: Register,
    pub count: usize,
    /// Registers of the first operation.
    first: [Register; 3],
    /// For each operand 0, if all elements have the same one, or 1, if they have consecutive ones.
    strides: [usize; 3],
    /// Number of operations for an element, with those that are done where their results are read.
    pub operations: usize,
}

impl Run {
    /// Register and stride of each operand of the first operation.
    pub fn operands(&self) -> impl Iterator<Item = (Register, usize)> {
        self.first.into_iter().zip(self.strides).take(self.operation.operands())
    }
}

/// All runs of formulas.
#[derive(Debug)]
pub(crate) struct Runs {
    pub list: Vec<Run>,
    /// Index of the run that computes a register.
    by: Vec<Option<usize>>,
    /// True for registers that are computed where they are read.
    passed: Vec<bool>,
}

/// Maximum number of operations of an element.
const MOST_OPERATIONS: usize = 32;

impl Runs {
    /// `roots`: registers that are read afterwards.
    pub fn of(lines: &[Line], roots: &[Register]) -> Self {
        let list = list(lines);
        let registers =
            lines.iter().flat_map(|line| line.operands.into_iter().chain([line.to])).chain(roots.iter().copied());
        let count = 1 + registers.max().unwrap_or_default() as usize;
        let mut by = vec![None; count];
        for (number, run) in list.iter().enumerate() {
            by[run.to as usize..][..run.count].fill(Some(number));
        }
        let mut uses = vec![0; count];
        let read = lines.iter().flat_map(|line| line.operands.into_iter().take(line.operation.operands()));
        read.for_each(|register| uses[register as usize] += 1);
        // They are kept however often they are read.
        roots.iter().for_each(|&root| uses[root as usize] = usize::MAX / 2);
        let mut runs = Self { list, by, passed: vec![false; count] };
        (0..runs.list.len()).for_each(|number| runs.pass(number, &uses));
        runs
    }

    /// Finds the operands of a run that nothing else reads.
    fn pass(&mut self, number: usize, uses: &[usize]) {
        let run = &self.list[number];
        let (count, operands) = (run.count, run.operands().collect::<Vec<_>>());
        for &(operand, stride) in &operands {
            let registers = operand as usize..operand as usize + count;
            let Some(from) = self.by[registers.start].filter(|_| stride == 1 || count == 1) else { continue };
            let times = operands.iter().filter(|other| **other == (operand, stride)).count();
            let of_run = registers.clone().all(|register| self.by[register] == Some(from));
            let only_here = registers.clone().all(|register| uses[register] == times && !self.passed[register]);
            let operations = self.list[from].operations + self.list[number].operations;
            let is_loop = |run: &Run| run.count > 1;
            let alike = is_loop(&self.list[from]) == is_loop(&self.list[number]);
            if of_run && only_here && alike && operations <= MOST_OPERATIONS {
                self.list[number].operations = operations;
                self.passed[registers].fill(true);
            }
        }
    }

    /// True for a register that is kept in the block.
    pub fn is_kept(&self, register: Register) -> bool {
        !self.passed[register as usize]
    }

    /// Run and element that compute a register where it is read; `None` if it is kept in the block.
    pub fn computed_where_read(&self, register: Register) -> Option<(&Run, usize)> {
        let run = &self.list[self.by[register as usize].filter(|_| !self.is_kept(register))?];
        Some((run, (register - run.to) as usize))
    }
}

/// Number of runs.
pub(crate) fn count(lines: &[Line]) -> usize {
    list(lines).len()
}

fn list(mut lines: &[Line]) -> Vec<Run> {
    let mut list = Vec::new();
    while let Some(line) = lines.first() {
        let (length, strides) = first_run(lines);
        let (count, strides) = if length >= LEAST { (length, strides) } else { (1, [0; 3]) };
        let Line { operation, to, operands: first } = *line;
        list.push(Run { operation, to, count, first, strides, operations: 1 });
        lines = &lines[count..];
    }
    list
}

/// Number of lines from the first one on that are the same operation of consecutive or constant registers for consecutive targets, none
/// of which is an operand, and the distances of the operands.
fn first_run(lines: &[Line]) -> (usize, [usize; 3]) {
    let [first, second, ..] = lines else { return (lines.len(), [0; 3]) };
    let operands = first.operation.operands();
    let strides: [usize; 3] = std::array::from_fn(|which| {
        if which < operands { second.operands[which].wrapping_sub(first.operands[which]) as usize } else { 0 }
    });
    if strides.iter().any(|stride| *stride > 1) {
        return (1, strides);
    }
    let is_next = |pair: &&[Line]| {
        let [one, next] = pair else { return false };
        let mut found = one.operands.into_iter().zip(next.operands).zip(strides).take(operands);
        one.operation == next.operation
            && one.to + 1 == next.to
            && found.all(|((one, next), stride)| one as usize + stride == next as usize)
            // Operands are registers below the targets.
            && next.operands.into_iter().take(operands).all(|operand| operand < first.to)
    };
    (1 + lines.windows(2).take_while(is_next).count(), strides)
}

//! Register code in lanes: each instruction is executed for all runs.

use crate::functions::{binary, unary};
use crate::grid::{Block, Grid, one, three, two};
use crate::width::{Lanewise, Width};
use engine::{Formulas, Line, Operation, Preparation, Register, Routine};
use program::Interpolation;
use std::sync::Arc;

/// Formulas with their registers in all lanes. Register 0 holds the independent variable.
#[derive(Clone, Debug, Default)]
pub struct Body {
    lines: Vec<Line>,
    preparation: Preparation,
    /// Register of each state, in the order of the model.
    states: Vec<Register>,
    /// Register of each value.
    roots: Vec<Register>,
    interpolations: Arc<[Arc<Interpolation>]>,
    /// True if the independent variable is read.
    reads_time: bool,
    width: Width,
    grid: Grid,
}

impl Body {
    /// Formulas of a listing.
    pub fn new(
        (lines, preparation): (Vec<Line>, Preparation),
        (states, roots): (Vec<Register>, Vec<Register>),
        interpolations: Arc<[Arc<Interpolation>]>,
    ) -> Self {
        debug_assert!(is_ascending(&lines) && is_ascending(&preparation.lines));
        let reads_time =
            roots.contains(&0) || lines.iter().any(|line| line.operands[..arity(line.operation)].contains(&0));
        Self {
            lines,
            preparation,
            states,
            roots,
            interpolations,
            reads_time,
            width: Width::default(),
            grid: Grid::default(),
        }
    }

    /// Formulas of the states of a model; none, with the preparation of none, give a body that does nothing.
    pub fn of_formulas(
        formulas: Formulas,
        preparation: Preparation,
        states: usize,
        interpolations: Arc<[Arc<Interpolation>]>,
    ) -> Self {
        let states = if formulas.roots.is_empty() { Vec::new() } else { (1..).take(states).collect() };
        Self::new((formulas.lines, preparation), (states, formulas.roots), interpolations)
    }

    /// The formulas of a routine; `None` if it solves linear systems.
    pub fn of_routine(routine: &Routine, states: usize) -> Option<Self> {
        let mut interpolations = Vec::new();
        let formulas = routine.formulas(&mut interpolations)?;
        Some(Self::of_formulas(formulas, routine.preparation(0)?, states, interpolations.into()))
    }

    /// True if the values depend on the independent variable itself.
    #[inline(always)]
    pub fn reads_time(&self) -> bool {
        self.reads_time
    }

    /// Number of registers.
    pub fn registers(&self) -> usize {
        self.preparation.registers.len()
    }

    /// Number of operations.
    pub fn operations(&self) -> usize {
        self.lines.len()
    }

    /// Number of values.
    pub fn len(&self) -> usize {
        self.roots.len()
    }

    /// True if there are no values.
    pub fn is_empty(&self) -> bool {
        self.roots.is_empty()
    }

    /// Register of each value.
    pub fn roots(&self) -> &[Register] {
        &self.roots
    }

    /// Register of each state.
    pub fn states(&self) -> &[Register] {
        &self.states
    }

    /// The registers.
    #[inline(always)]
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// The registers.
    #[inline(always)]
    pub fn grid_mut(&mut self) -> &mut Grid {
        &mut self.grid
    }

    /// Makes room for so many blocks of lanes, computed with these features.
    pub fn resize(&mut self, blocks: usize, width: Width) {
        self.width = width;
        if self.grid.blocks() != blocks {
            self.grid = Grid::of(&self.preparation.registers, blocks);
        }
    }

    /// Takes over parameters, with the held values of switches, and initial values: one row for each.
    pub fn prepare(&mut self, parameters: &Grid, initial: &Grid) {
        for (numbers, from) in [(&self.preparation.parameters, parameters), (&self.preparation.initial, initial)] {
            for &(index, register) in numbers {
                self.grid.row_mut(register as usize).copy_from_slice(from.row(index));
            }
        }
        run_in(self.width, &self.preparation.lines, &self.interpolations, &mut self.grid);
    }

    /// Copies the state of all lanes: one row for each.
    #[inline(always)]
    pub fn set_states(&mut self, states: &Grid) {
        for (row, &register) in self.states.iter().enumerate() {
            self.grid.row_mut(register as usize).copy_from_slice(states.row(row));
        }
    }

    /// Copies the independent variable of all lanes, a row of another grid.
    #[inline(always)]
    pub fn set_time(&mut self, times: &Grid, row: usize) {
        if self.reads_time {
            self.grid.row_mut(0).copy_from_slice(times.row(row));
        }
    }

    /// Sets the independent variable of all lanes, block by block.
    #[inline(always)]
    pub fn set_times(&mut self, times: impl Iterator<Item = Block>) {
        if self.reads_time {
            for (to, time) in self.grid.row_mut(0).iter_mut().zip(times) {
                *to = time;
            }
        }
    }

    /// Computes the values at the independent variable and the states that are set.
    pub fn evaluate(&mut self) {
        run_in(self.width, &self.lines, &self.interpolations, &mut self.grid);
    }

    /// A value of a lane.
    #[inline(always)]
    pub fn value(&self, number: usize, lane: usize) -> f64 {
        self.grid.get(self.roots[number] as usize, lane)
    }
}

/// Number of operands of an operation.
fn arity(operation: Operation) -> usize {
    match operation {
        Operation::Negate | Operation::Unary(_) | Operation::Piece(_) => 1,
        Operation::Add | Operation::Subtract | Operation::Multiply | Operation::Divide => 2,
        Operation::Binary(_) | Operation::Interpolated(_) => 2,
        Operation::MultiplyAdd | Operation::MultiplySubtract | Operation::SubtractProduct => 3,
        Operation::Select | Operation::Binomial => 3,
    }
}

/// True if each operation reads registers before its own only, as [`run`] needs it.
fn is_ascending(lines: &[Line]) -> bool {
    lines.iter().all(|line| line.operands.iter().all(|&operand| operand < line.to))
}

/// [`run`] with these features. Not inlined: it is long.
#[inline(never)]
fn run_in(width: Width, lines: &[Line], interpolations: &[Arc<Interpolation>], grid: &mut Grid) {
    width.call::<Run>((lines, interpolations, grid));
}

/// Executes operations in all lanes, each with the bits of [`engine::Routine`].
#[inline(always)]
fn run((lines, interpolations, grid): (&[Line], &[Arc<Interpolation>], &mut Grid)) {
    let blocks = grid.blocks();
    for line in lines {
        let (known, rest) = grid.split(line.to as usize);
        let to = &mut rest[..blocks];
        let known = &*known;
        let row = |which: usize| &known[line.operands[which] as usize * blocks..][..blocks];
        match line.operation {
            Operation::Add => two(to, row(0), row(1), |a, b| a + b),
            Operation::Subtract => two(to, row(0), row(1), |a, b| a - b),
            Operation::Multiply => two(to, row(0), row(1), |a, b| a * b),
            Operation::Divide => two(to, row(0), row(1), |a, b| a / b),
            Operation::Negate => one(to, row(0), |a| -a),
            Operation::MultiplyAdd => three(to, [row(0), row(1), row(2)], |a, b, c| a * b + c),
            Operation::MultiplySubtract => three(to, [row(0), row(1), row(2)], |a, b, c| a * b - c),
            Operation::SubtractProduct => three(to, [row(0), row(1), row(2)], |a, b, c| c - a * b),
            Operation::Select => {
                three(to, [row(0), row(1), row(2)], |condition, a, b| if condition != 0.0 { a } else { b });
            }
            Operation::Binomial => three(to, [row(0), row(1), row(2)], program::binomial),
            Operation::Unary(function) => unary(function, to, row(0)),
            Operation::Binary(function) => binary(function, to, row(0), row(1)),
            Operation::Piece(number) => {
                let interpolation = &interpolations[number as usize];
                one(to, row(0), |x| interpolation.piece(x));
            }
            Operation::Interpolated(number) => {
                let interpolation = &interpolations[number as usize];
                two(to, row(0), row(1), |x, piece| interpolation.value(x, piece));
            }
        }
    }
}

/// [`run`] for all features.
struct Run;

impl Lanewise for Run {
    type Arguments<'a> = (&'a [Line], &'a [Arc<Interpolation>], &'a mut Grid);

    #[inline(always)]
    fn call(arguments: Self::Arguments<'_>) {
        run(arguments);
    }
}

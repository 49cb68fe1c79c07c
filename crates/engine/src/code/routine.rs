//! Compiles expressions of a model to register code and evaluates them.

use super::compile::compile;
use crate::code::instruction::Operation;
use crate::code::lines::{Line, lines};
use crate::code::{Code, Register, run, run_inline};
use crate::compiled::listing::{Formulas, Preparation};
use crate::wide::{Wide, run_wide};
use program::{Graph, Interpolation, Model, NodeId};
use std::sync::Arc;

/// Number of rows computed at once.
const ROWS: usize = 16;

/// Register code for a set of expressions, the roots. [`Routine::prepare`] computes the part that depends on parameters and
/// initial values only; [`Routine::evaluate`] computes the rest and allocates nothing.
#[derive(Clone, Debug)]
pub struct Routine {
    code: Code,
    /// Registers of [`Routine::evaluate_rows`], empty before its first call.
    rows: Vec<[f64; ROWS]>,
    states: usize,
    /// Approximate floating-point operations per evaluation.
    work: u64,
}

impl Routine {
    /// Compiles `roots`, nodes of the model's graph.
    pub fn compile(model: &Model, roots: &[NodeId]) -> Self {
        Self::from_graph(&model.graph, model.states.len(), roots)
    }

    /// Compiles `roots` of a graph with `states` states.
    pub fn from_graph(graph: &Graph, states: usize, roots: &[NodeId]) -> Self {
        Self::of(compile(graph, (0..states as u32).collect(), roots), states)
    }

    /// Compiles `roots` of a graph for states in another order: `order` has the model's state index at each position.
    pub(crate) fn with_order(graph: &Graph, order: &[u32], roots: &[NodeId]) -> Self {
        let mut places = vec![0; order.len()];
        for (place, &state) in (0..).zip(order) {
            places[state as usize] = place;
        }
        Self::of(compile(graph, places, roots), order.len())
    }

    fn of(code: Code, states: usize) -> Self {
        let systems: usize = code.systems.iter().map(|system| system.matrix.work(1)).sum();
        let work = (code.operations() + code.roots.len() + states + systems) as u64;
        Self { code, rows: Vec::new(), states, work }
    }

    /// Sets parameters and initial values: one value per parameter and per state, in the model's order, SI units.
    pub fn prepare(&mut self, parameters: &[f64], initial: &[f64]) {
        let code = &mut self.code;
        for &(index, register) in &code.parameters {
            code.registers[register as usize] = parameters[index];
        }
        for &(index, register) in &code.initial {
            code.registers[register as usize] = initial[index];
        }
        run(
            &code.prologue,
            code.registers.as_chunks_mut::<1>().0,
            &code.columns,
            &code.interpolations,
            &mut code.systems,
        );
    }

    /// Computes all roots at `time` and `state` (one value per state), SI units; `out[i]` becomes the value of `roots[i]`.
    #[inline]
    pub fn evaluate(&mut self, time: f64, state: &[f64], out: &mut [f64]) {
        self.evaluate_at(time, out, |registers| {
            registers.iter_mut().zip(state).for_each(|(register, value)| *register = *value);
        });
    }

    /// [`Routine::evaluate`] at `time` (SI) with a state that `set` writes directly into the registers; this avoids a copy between the
    /// stages of a method.
    #[inline]
    pub(crate) fn evaluate_at(&mut self, time: f64, out: &mut [f64], set: impl FnOnce(&mut [f64])) {
        let Code { body, columns, interpolations, systems, registers, .. } = &mut self.code;
        if let Some((clock, rest)) = registers.split_first_mut() {
            *clock = time;
            set(&mut rest[..self.states]);
        }
        run(body, registers.as_chunks_mut::<1>().0, columns, interpolations, systems);
        self.code.copy_roots(out);
    }

    /// Registers of the state, one per state, which [`Routine::evaluate_at`] reads.
    pub(crate) fn state_mut(&mut self) -> &mut [f64] {
        &mut self.code.registers[1..=self.states]
    }

    /// Computes all roots at many times and one state, SI units. The values of root `i` start at `out[i * times.len()]` and
    /// have the bits of [`Routine::evaluate`].
    pub fn evaluate_rows(&mut self, times: &[f64], state: &[f64], out: &mut [f64]) {
        let registers = &mut self.code.registers;
        registers[1..=self.states].copy_from_slice(&state[..self.states]);
        self.rows.clear();
        self.rows.extend(registers.iter().map(|&value| [value; ROWS]));
        run_wide(Rows { code: &mut self.code, rows: &mut self.rows, times, out });
    }

    /// The operations of an evaluation; `None` if it solves linear systems.
    pub(crate) fn lines(&self) -> Option<Vec<Line>> {
        lines(&self.code.body, &self.code.columns)
    }

    /// The operations as formulas whose interpolations are appended to `interpolations`; `None` if they solve linear systems.
    pub fn formulas(&self, interpolations: &mut Vec<Arc<Interpolation>>) -> Option<Formulas> {
        let mut lines = self.lines()?;
        renumber(&mut lines, interpolations.len());
        interpolations.extend(self.interpolations().iter().cloned());
        Some(Formulas { lines, roots: self.roots().to_vec(), registers: self.registers().len() })
    }

    /// The part of the code that runs when parameters or initial values change, for [`Routine::formulas`] whose interpolations
    /// begin at the index `first`; `None` if it solves linear systems.
    pub fn preparation(&self, first: usize) -> Option<Preparation> {
        let Code { prologue, columns, parameters, initial, registers, .. } = &self.code;
        let mut lines = lines(prologue, columns)?;
        renumber(&mut lines, first);
        let (parameters, initial) = (parameters.clone(), initial.clone());
        Some(Preparation { lines, parameters, initial, registers: registers.clone() })
    }

    /// Values of the registers, those of constants, parameters and initial values prepared.
    pub(crate) fn registers(&self) -> &[f64] {
        &self.code.registers
    }

    /// Registers of the roots.
    pub(crate) fn roots(&self) -> &[Register] {
        &self.code.roots
    }

    /// Interpolations of the code.
    pub(crate) fn interpolations(&self) -> &[Arc<Interpolation>] {
        &self.code.interpolations
    }

    /// Number of roots.
    pub fn len(&self) -> usize {
        self.code.roots.len()
    }

    /// True if there are no roots.
    pub fn is_empty(&self) -> bool {
        self.code.roots.is_empty()
    }

    /// Number of operations per evaluation; a column counts once per element.
    pub fn instructions(&self) -> usize {
        self.code.operations()
    }

    /// Approximate number of floating-point operations per evaluation, copying included.
    pub(crate) fn work(&self) -> u64 {
        self.work
    }

    /// True if the last evaluation met a singular linear system.
    pub(crate) fn singular(&self) -> bool {
        self.code.systems.iter().any(|system| system.matrix.singular())
    }
}

/// Evaluation at many times: the code, its registers by row, the times, and what [`Routine::evaluate_rows`] finds.
struct Rows<'a> {
    code: &'a mut Code,
    rows: &'a mut [[f64; ROWS]],
    times: &'a [f64],
    out: &'a mut [f64],
}

impl Wide for Rows<'_> {
    #[inline(always)]
    fn run(self) {
        let Self { code: Code { body, columns, interpolations, systems, roots, .. }, rows, times, out } = self;
        for (chunk, some) in times.chunks(ROWS).enumerate() {
            rows[0][..some.len()].copy_from_slice(some);
            run_inline(body, rows, columns, interpolations, systems);
            for (column, &register) in out.chunks_mut(times.len()).zip(&*roots) {
                let values = &rows[register as usize][..some.len()];
                column[chunk * ROWS..][..some.len()].copy_from_slice(values);
            }
        }
    }
}

/// Numbers the interpolations of `lines` from `first` on.
fn renumber(lines: &mut [Line], first: usize) {
    for line in lines {
        if let Operation::Piece(number) | Operation::Interpolated(number) = &mut line.operation {
            *number += first as u32;
        }
    }
}

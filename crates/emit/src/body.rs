//! Formulas, with their registers in local variables or in the block.

use crate::operation::operation;
use crate::routine;
use crate::sink::lists::ranges;
use crate::sink::{Local, Sink};
use crate::states::States;
use engine::{Formulas, Line, Listing, Register};
use std::ops::Range;

/// Maximum number of operations of formulas that are straight code in the function that evaluates them, if lists are in the block.
const MOST_STRAIGHT: usize = 200;

/// Formulas with a local variable for each register, or with registers in the block.
#[derive(Debug)]
pub(crate) struct Body<'a> {
    lines: &'a [Line],
    /// Register of each state.
    states: Vec<Register>,
    /// Ranges of states that are read and have consecutive registers.
    read: Vec<Range<usize>>,
    /// Index and register of each value.
    roots: Vec<(usize, Register)>,
    /// Ranges of roots with consecutive indices and registers.
    rows: Vec<Range<usize>>,
    registers: Vec<Local>,
    /// Functions that compute the lines, if registers are in the block.
    routines: Option<Range<usize>>,
}

impl<'a> Body<'a> {
    /// The right-hand side. The rates of constant states are left out.
    pub fn of_rates(listing: &'a Listing, states: &States, sink: &mut Sink) -> Self {
        let roots = states.moving.iter().flat_map(|range| range.clone().map(|k| (k, states.rates[k]))).collect();
        let in_block = sink.in_block();
        Self::new(&listing.lines, states.registers.clone(), roots, (0, listing.layout.registers), in_block, sink)
    }

    /// Formulas of a model, whose registers begin at number `place` of the block. `states`: index of each state in the model.
    pub fn of_formulas(formulas: &'a Formulas, states: &[usize], place: usize, sink: &mut Sink) -> Self {
        let registers = states.iter().map(|&k| 1 + k as Register).collect();
        let roots = formulas.roots.iter().copied().enumerate().collect();
        let in_block = sink.in_block() && formulas.lines.len() > MOST_STRAIGHT;
        Self::new(&formulas.lines, registers, roots, (place, formulas.registers), in_block, sink)
    }

    /// Loads the registers that are read and not written, if they are local variables.
    fn new(
        lines: &'a [Line],
        states: Vec<Register>,
        roots: Vec<(usize, Register)>,
        (first, count): (usize, usize),
        in_block: bool,
        sink: &mut Sink,
    ) -> Self {
        let mut read = vec![false; count];
        let operands = lines.iter().flat_map(|line| line.operands).chain(roots.iter().map(|root| root.1));
        operands.for_each(|register| read[register as usize] = true);
        // Formulas without roots have no registers.
        let is_read = |k: usize| read.get(states[k] as usize).is_some_and(|read| *read);
        let follows = |a: usize, b: usize| states[a] + 1 == states[b] && is_read(a) == is_read(b);
        let mut read_states = ranges(states.len(), follows);
        read_states.retain(|range| is_read(range.start));
        let rows = ranges(roots.len(), |a, b| (roots[a].0 + 1, roots[a].1 + 1) == roots[b]);
        let mut body = Self { lines, states, read: read_states, roots, rows, registers: Vec::new(), routines: None };
        if in_block {
            let read: Vec<Register> = body.roots.iter().map(|root| root.1).collect();
            let functions = routine::functions(lines, &read, first, sink.calls());
            body.registers = (first..first + count).map(Local::Place).collect();
            body.routines = Some(sink.add_routines(functions));
            return body;
        }
        let mut given = vec![true; count];
        let written = lines.iter().map(|line| line.to).chain(body.states.iter().copied()).chain([0]);
        written.for_each(|register| {
            given.get_mut(register as usize).into_iter().for_each(|given| *given = false);
        });
        body.registers = sink.locals(count);
        for (place, &local) in body.registers.iter().enumerate().filter(|(place, _)| given[*place]) {
            sink.load(first + place);
            sink.set(local);
        }
        body
    }

    /// Independent variable.
    pub fn time(&self) -> Local {
        self.registers[0]
    }

    /// State `k` as an argument of the right-hand side.
    pub fn state(&self, k: usize) -> Local {
        self.register(self.states[k])
    }

    /// True if the formulas depend on state `k`.
    pub fn reads(&self, k: usize) -> bool {
        self.read.iter().any(|range| range.contains(&k))
    }

    /// Evaluates the formulas and copies the values to `values`.
    pub fn evaluate(&self, sink: &mut Sink, values: &[Local]) {
        match &self.routines {
            Some(routines) => sink.call_routines(routines),
            None => self.lines.iter().for_each(|line| {
                let operands = line.operands.map(|operand| self.register(operand));
                operation(sink, line.operation, operands, self.register(line.to));
            }),
        }
        sink.copy(&self.rows, |place| self.register(self.roots[place].1), |place| values[self.roots[place].0]);
    }

    /// [`Body::evaluate`] at this time and these states.
    pub fn evaluate_at(&self, sink: &mut Sink, time: Local, states: &[Local], values: &[Local]) {
        if self.roots.is_empty() {
            return;
        }
        sink.get(time);
        sink.set(self.time());
        sink.copy(&self.read, |k| states[k], |k| self.state(k));
        self.evaluate(sink, values);
    }

    fn register(&self, register: Register) -> Local {
        self.registers[register as usize]
    }
}

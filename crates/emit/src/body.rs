//! Formulas: operations of the register machine on local variables.

use crate::function::Function;
use crate::sink::{Local, Sink};
use engine::{Formulas, Line, Listing, Operation, Register};
use program::{Binary, Unary};

/// Formulas with a local variable for each register.
#[derive(Debug)]
pub(crate) struct Body<'a> {
    lines: &'a [Line],
    /// Register of each state.
    states: Vec<Register>,
    /// Index and register of each value.
    roots: Vec<(usize, Register)>,
    registers: Vec<Local>,
}

impl<'a> Body<'a> {
    /// The right-hand side. The rates of constant states are left out.
    pub fn of_rates(listing: &'a Listing, sink: &mut Sink) -> Self {
        let Listing { lines, states, rates, .. } = listing;
        let roots = rates.iter().copied().enumerate().filter(|(k, _)| listing.still[*k].is_none()).collect();
        Self::new(lines, states.clone(), roots, (0, listing.layout.registers), sink)
    }

    /// Formulas of a model with `states` states, whose registers begin at number `place` of the block.
    pub fn of_formulas(formulas: &'a Formulas, states: usize, place: usize, sink: &mut Sink) -> Self {
        let registers = (1..).take(states).collect();
        let roots = formulas.roots.iter().copied().enumerate().collect();
        Self::new(&formulas.lines, registers, roots, (place, formulas.registers), sink)
    }

    /// Loads the registers that are read and not written.
    fn new(
        lines: &'a [Line],
        states: Vec<Register>,
        roots: Vec<(usize, Register)>,
        (first, count): (usize, usize),
        sink: &mut Sink,
    ) -> Self {
        let mut given = vec![true; count];
        let written = lines.iter().map(|line| line.to).chain(states.iter().copied()).chain([0]);
        written.for_each(|register| {
            given.get_mut(register as usize).into_iter().for_each(|given| *given = false);
        });
        let registers = sink.locals(count);
        for (place, &local) in registers.iter().enumerate().filter(|(place, _)| given[*place]) {
            sink.load(first + place);
            sink.set(local);
        }
        Self { lines, states, roots, registers }
    }

    /// Local variable of the independent variable.
    pub fn time(&self) -> Local {
        self.registers[0]
    }

    /// Local variable of state `k` as an argument of the right-hand side.
    pub fn state(&self, k: usize) -> Local {
        self.register(self.states[k])
    }

    /// Evaluates the formulas and copies the values to `values`.
    pub fn evaluate(&self, sink: &mut Sink, values: &[Local]) {
        for line in self.lines {
            self.line(sink, line);
        }
        for &(number, root) in &self.roots {
            sink.get(self.register(root));
            sink.set(values[number]);
        }
    }

    /// [`Body::evaluate`] at the time and the states in these local variables.
    pub fn evaluate_at(&self, sink: &mut Sink, time: Local, states: &[Local], values: &[Local]) {
        if self.roots.is_empty() {
            return;
        }
        sink.get(time);
        sink.set(self.time());
        for (k, &state) in states.iter().enumerate() {
            sink.get(state);
            sink.set(self.state(k));
        }
        self.evaluate(sink, values);
    }

    fn register(&self, register: Register) -> Local {
        self.registers[register as usize]
    }

    fn line(&self, sink: &mut Sink, line: &Line) {
        let [a, b, c] = line.operands.map(|operand| self.register(operand));
        match line.operation {
            Operation::Add => drop(sink.instructions().local_get(a).local_get(b).f64_add()),
            Operation::Subtract => drop(sink.instructions().local_get(a).local_get(b).f64_sub()),
            Operation::Multiply => drop(sink.instructions().local_get(a).local_get(b).f64_mul()),
            Operation::Divide => drop(sink.instructions().local_get(a).local_get(b).f64_div()),
            Operation::Negate => drop(sink.instructions().local_get(a).f64_neg()),
            Operation::MultiplyAdd => {
                sink.instructions().local_get(a).local_get(b).f64_mul().local_get(c).f64_add();
            }
            Operation::MultiplySubtract => {
                sink.instructions().local_get(a).local_get(b).f64_mul().local_get(c).f64_sub();
            }
            Operation::SubtractProduct => {
                sink.instructions().local_get(c).local_get(a).local_get(b).f64_mul().f64_sub();
            }
            Operation::Select => {
                sink.instructions().local_get(b).local_get(c).local_get(a).f64_const(0.0.into()).f64_ne().select();
            }
            Operation::Unary(function) => unary(sink, function, a),
            Operation::Binary(function) => binary(sink, function, a, b),
            Operation::Piece(number) => call(sink, Function::Piece(number), [a, b, c]),
            Operation::Interpolated(number) => call(sink, Function::Interpolated(number), [a, b, c]),
            Operation::Binomial => call(sink, Function::Binomial, [a, b, c]),
        }
        sink.set(self.register(line.to));
    }
}

fn call(sink: &mut Sink, function: Function, operands: [Local; 3]) {
    for &operand in &operands[..function.operands()] {
        sink.get(operand);
    }
    sink.call(function);
}

/// A function of one operand, as [`Unary::evaluate`] has it.
fn unary(sink: &mut Sink, function: Unary, a: Local) {
    let mut instructions = sink.instructions();
    match function {
        Unary::Negate => drop(instructions.local_get(a).f64_neg()),
        Unary::Not => drop(instructions.local_get(a).f64_const(0.0.into()).f64_eq().f64_convert_i32_u()),
        Unary::Absolute => drop(instructions.local_get(a).f64_abs()),
        Unary::SquareRoot => drop(instructions.local_get(a).f64_sqrt()),
        Unary::Floor => drop(instructions.local_get(a).f64_floor()),
        Unary::Ceil => drop(instructions.local_get(a).f64_ceil()),
        _ => call(sink, Function::Unary(function), [a; 3]),
    }
}

/// A function of two operands, as [`Binary::evaluate`] has it.
fn binary(sink: &mut Sink, function: Binary, a: Local, b: Local) {
    let mut instructions = sink.instructions();
    match function {
        Binary::Add => drop(instructions.local_get(a).local_get(b).f64_add()),
        Binary::Subtract => drop(instructions.local_get(a).local_get(b).f64_sub()),
        Binary::Multiply => drop(instructions.local_get(a).local_get(b).f64_mul()),
        Binary::Divide => drop(instructions.local_get(a).local_get(b).f64_div()),
        Binary::Less => drop(instructions.local_get(a).local_get(b).f64_lt().f64_convert_i32_u()),
        Binary::LessOrEqual => drop(instructions.local_get(a).local_get(b).f64_le().f64_convert_i32_u()),
        Binary::Equal => drop(instructions.local_get(a).local_get(b).f64_eq().f64_convert_i32_u()),
        Binary::NotEqual => drop(instructions.local_get(a).local_get(b).f64_ne().f64_convert_i32_u()),
        Binary::And => {
            instructions.local_get(a).f64_const(0.0.into()).f64_ne();
            instructions.local_get(b).f64_const(0.0.into()).f64_ne().i32_and().f64_convert_i32_u();
        }
        Binary::Or => {
            instructions.local_get(a).f64_const(0.0.into()).f64_ne();
            instructions.local_get(b).f64_const(0.0.into()).f64_ne().i32_or().f64_convert_i32_u();
        }
        _ => call(sink, Function::Binary(function), [a, b, b]),
    }
}

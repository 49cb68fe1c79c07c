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
        let operands @ [a, b, c] = line.operands.map(|operand| self.register(operand));
        match line.operation {
            Operation::Add => binary(sink, Binary::Add, a, b),
            Operation::Subtract => binary(sink, Binary::Subtract, a, b),
            Operation::Multiply => binary(sink, Binary::Multiply, a, b),
            Operation::Divide => binary(sink, Binary::Divide, a, b),
            Operation::Negate => unary(sink, Unary::Negate, a),
            Operation::MultiplyAdd => {
                binary(sink, Binary::Multiply, a, b);
                sink.get(c);
                sink.add();
            }
            Operation::MultiplySubtract => {
                binary(sink, Binary::Multiply, a, b);
                sink.get(c);
                sink.subtract();
            }
            Operation::SubtractProduct => {
                sink.get(c);
                binary(sink, Binary::Multiply, a, b);
                sink.subtract();
            }
            Operation::Select => {
                sink.get(b);
                sink.get(c);
                is_true(sink, a);
                sink.choose();
            }
            Operation::Unary(function) => unary(sink, function, a),
            Operation::Binary(function) => binary(sink, function, a, b),
            Operation::Piece(number) => call(sink, Function::Piece(number), operands),
            Operation::Interpolated(number) => call(sink, Function::Interpolated(number), operands),
            Operation::Binomial => call(sink, Function::Binomial, operands),
        }
        sink.set(self.register(line.to));
    }
}

fn call(sink: &mut Sink, function: Function, operands: [Local; 3]) {
    sink.call_at(function, &operands[..function.operands()]);
}

/// Pushes the condition that a number is not 0.
fn is_true(sink: &mut Sink, a: Local) {
    sink.get(a);
    sink.constant(0.0);
    sink.not_equal();
}

/// A function of one operand, as [`Unary::evaluate`] has it.
fn unary<'c>(sink: &mut Sink<'c>, function: Unary, a: Local) {
    let operation: fn(&mut Sink<'c>) = match function {
        Unary::Negate => Sink::negate,
        Unary::Not => |sink| {
            sink.constant(0.0);
            sink.equal();
            sink.truth();
        },
        Unary::Absolute => Sink::absolute,
        Unary::SquareRoot => Sink::square_root,
        Unary::Floor => Sink::floor,
        Unary::Ceil => Sink::ceil,
        _ => return call(sink, Function::Unary(function), [a; 3]),
    };
    sink.get(a);
    operation(sink);
}

/// A function of two operands, as [`Binary::evaluate`] has it.
fn binary<'c>(sink: &mut Sink<'c>, function: Binary, a: Local, b: Local) {
    let compares = matches!(function, Binary::Less | Binary::LessOrEqual | Binary::Equal | Binary::NotEqual);
    let joins = matches!(function, Binary::And | Binary::Or);
    let operation: fn(&mut Sink<'c>) = match function {
        Binary::Add => Sink::add,
        Binary::Subtract => Sink::subtract,
        Binary::Multiply => Sink::multiply,
        Binary::Divide => Sink::divide,
        Binary::Less => Sink::less,
        Binary::LessOrEqual => Sink::less_or_equal,
        Binary::Equal => Sink::equal,
        Binary::NotEqual => Sink::not_equal,
        Binary::And => Sink::both,
        Binary::Or => Sink::either,
        _ => return call(sink, Function::Binary(function), [a, b, b]),
    };
    let operand: fn(&mut Sink<'c>, Local) = if joins { is_true } else { Sink::get };
    operand(sink, a);
    operand(sink, b);
    operation(sink);
    if compares || joins {
        sink.truth();
    }
}

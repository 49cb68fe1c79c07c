//! Operations of the register machine.

use crate::function::Function;
use crate::sink::{Local, Sink};
use engine::Operation;
use program::{Binary, Unary};

/// An operation whose result is kept in `to`.
pub(crate) fn operation(sink: &mut Sink, operation: Operation, operands: [Local; 3], to: Local) {
    let [a, b, c] = operands;
    match operation {
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
    sink.set(to);
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

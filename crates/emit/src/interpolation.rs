//! Functions of a module for tables: the index of a piece and its polynomial, as [`Interpolation::piece`] and
//! [`Interpolation::value`] have them. Knots and coefficients are constants between which comparisons choose.

use program::Interpolation;
use wasm_encoder::{BlockType, Function, InstructionSink, ValType};

/// Maximum number of knots of a table that is emitted.
pub(crate) const MOST_KNOTS: usize = 200;

const RESULT: BlockType = BlockType::Result(ValType::F64);
/// Argument of both functions.
const X: u32 = 0;
/// Number of the piece, the second operand of the polynomial.
const PIECE: u32 = 1;
/// Distance from the knot.
const DISTANCE: u32 = 2;

/// The index of the piece in which the argument lies.
pub(crate) fn piece(interpolation: &Interpolation) -> Function {
    let mut code = Vec::new();
    let mut sink = InstructionSink::new(&mut code);
    let knots = interpolation.knots();
    sink.local_get(X).local_get(X).f64_ne().if_(RESULT).local_get(X).else_();
    count(&mut sink, knots, 0, knots.len());
    sink.end().end();
    finish([], &code)
}

/// Pushes the number of knots at or before the argument, which is at least `low` and at most `high`.
fn count(sink: &mut InstructionSink, knots: &[f64], low: usize, high: usize) {
    if low == high {
        sink.f64_const((low as f64).into());
        return;
    }
    let middle = usize::midpoint(low, high);
    sink.local_get(X).f64_const(knots[middle].into()).f64_ge().if_(RESULT);
    count(sink, knots, middle + 1, high);
    sink.else_();
    count(sink, knots, low, middle);
    sink.end();
}

/// The value of the polynomial of a piece.
pub(crate) fn value(interpolation: &Interpolation) -> Function {
    let mut code = Vec::new();
    let mut sink = InstructionSink::new(&mut code);
    sink.local_get(PIECE).local_get(PIECE).f64_ne().if_(RESULT).local_get(PIECE).else_();
    choose(&mut sink, interpolation, 0, interpolation.knots().len());
    sink.end().end();
    finish([(1, ValType::F64)], &code)
}

/// Pushes the value of the piece, whose number is at least `low` and at most `high`.
fn choose(sink: &mut InstructionSink, interpolation: &Interpolation, low: usize, high: usize) {
    if low < high {
        let middle = low + (high - low).div_ceil(2);
        sink.local_get(PIECE).f64_const((middle as f64).into()).f64_ge().if_(RESULT);
        choose(sink, interpolation, middle, high);
        sink.else_();
        choose(sink, interpolation, low, middle - 1);
        sink.end();
        return;
    }
    let [a, b, c, d] = interpolation.pieces()[low];
    if b == 0.0 && c == 0.0 && d == 0.0 {
        sink.f64_const(a.into());
        return;
    }
    let begin = interpolation.knots()[low.saturating_sub(1)];
    sink.local_get(X).f64_const(begin.into()).f64_sub().local_set(DISTANCE);
    // a + distance * (b + distance * (c + distance * d))
    for coefficient in [a, b, c] {
        sink.f64_const(coefficient.into()).local_get(DISTANCE);
    }
    sink.f64_const(d.into());
    sink.f64_mul().f64_add().f64_mul().f64_add().f64_mul().f64_add();
}

fn finish<const KINDS: usize>(locals: [(u32, ValType); KINDS], code: &[u8]) -> Function {
    let mut function = Function::new(locals);
    function.raw(code.iter().copied());
    function
}

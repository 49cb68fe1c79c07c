//! Operations on the values of a function, numbers or pairs of numbers. They pop their operands and push the result.

use crate::sink::{Local, Sink, Values};

/// Where a value is assigned: in both runs of a pair, or in those for which a condition holds, a local variable. Code for numbers
/// assigns everywhere.
pub(crate) type Where = Option<Local>;

/// Methods that push one instruction for numbers and another one for pairs. `magnitude` is the maximum of two magnitudes, which are not
/// negative; of NaN it may be either operand, and processors have an instruction for it.
macro_rules! operations {
    ($($name:ident: $number:ident $pair:ident)*) => {
        impl Sink<'_> {
            $(pub fn $name(&mut self) {
                match self.values() {
                    Values::Numbers => self.instructions().$number(),
                    Values::Pairs => self.instructions().$pair(),
                };
            })*
        }
    };
}

operations! {
    add: f64_add f64x2_add
    subtract: f64_sub f64x2_sub
    multiply: f64_mul f64x2_mul
    divide: f64_div f64x2_div
    negate: f64_neg f64x2_neg
    absolute: f64_abs f64x2_abs
    square_root: f64_sqrt f64x2_sqrt
    floor: f64_floor f64x2_floor
    ceil: f64_ceil f64x2_ceil
    less: f64_lt f64x2_lt
    less_or_equal: f64_le f64x2_le
    equal: f64_eq f64x2_eq
    not_equal: f64_ne f64x2_ne
    greater: f64_gt f64x2_gt
    maximum: f64_max f64x2_max
    magnitude: f64_max f64x2_pmax
    minimum: f64_min f64x2_min
    both: i32_and v128_and
    either: i32_or v128_or
    choose: select v128_bitselect
}

impl Sink<'_> {
    /// Negates the result of a comparison.
    pub fn negate_condition(&mut self) {
        match self.values() {
            Values::Numbers => self.instructions().i32_eqz(),
            Values::Pairs => self.instructions().v128_not(),
        };
    }

    /// Pops two conditions of pairs and pushes that the first one holds and the second one does not.
    pub fn unless(&mut self) {
        self.instructions().v128_andnot();
    }

    /// Pops two conditions of pairs and pushes that one of them holds and the other one does not.
    pub fn differs(&mut self) {
        self.instructions().v128_xor();
    }

    /// Pops a value and assigns it.
    pub fn assign(&mut self, local: Local, condition: Where) {
        if let Some(condition) = condition {
            self.get(local);
            self.get(condition);
            self.choose();
        }
        self.set(local);
    }

    /// Turns the result of a comparison into 1 or 0.
    pub fn truth(&mut self) {
        match self.values() {
            Values::Numbers => drop(self.instructions().f64_convert_i32_u()),
            Values::Pairs => {
                self.constant(1.0);
                self.instructions().v128_and();
            }
        }
    }
}

//! Functions that `run` calls: those that a module imports, and those of its own for tables.

use crate::function::Function;
use crate::interpolation;
use engine::{Line, Listing, Operation, WindowListing};
use program::{Binary, Interpolation, Unary};
use std::sync::Arc;

/// Functions by their numbers in a module: first the imported ones, then `run`, then those of the module's own.
#[derive(Debug, Default)]
pub(crate) struct Calls {
    pub imported: Vec<Function>,
    pub own: Vec<Function>,
}

impl Calls {
    /// The functions that the steps of a listing call, and operations that are done besides.
    pub fn of(listing: &Listing, besides: &[Line]) -> Self {
        let mut calls = Self::default();
        let formulas = listing.window.iter().flat_map(|window| &window.formulas);
        let lines = listing.lines.iter().chain(formulas.flat_map(|formulas| &formulas.lines)).chain(besides);
        for function in lines.filter_map(called) {
            let list = if is_own(&listing.interpolations, function) { &mut calls.own } else { &mut calls.imported };
            if !list.contains(&function) {
                list.push(function);
            }
        }
        listing.window.iter().for_each(|window| calls.control_steps(window));
        calls
    }

    /// Adds the functions of the step control of a window.
    fn control_steps(&mut self, window: &WindowListing) {
        self.imported.extend([Function::Growth, Function::Shrinkage]);
        if window.layout.compared > 0 {
            self.imported.push(Function::SignChanges);
        }
    }

    /// Number of a function in the module.
    pub fn number(&self, function: Function) -> u32 {
        let place = |list: &[Function]| list.iter().position(|&known| known == function);
        let own = || self.imported.len() + 1 + place(&self.own).unwrap_or_default();
        place(&self.imported).unwrap_or_else(own) as u32
    }
}

/// True if a module has the function itself.
fn is_own(interpolations: &[Arc<Interpolation>], function: Function) -> bool {
    match function {
        Function::Piece(number) | Function::Interpolated(number) => {
            let interpolation = interpolations.get(number as usize);
            interpolation.is_some_and(|interpolation| interpolation.knots().len() <= interpolation::MOST_KNOTS)
        }
        _ => false,
    }
}

/// The function that an operation calls; `None` for an operation that is an instruction or some.
pub(crate) fn called(line: &Line) -> Option<Function> {
    match line.operation {
        Operation::Unary(
            Unary::Negate | Unary::Not | Unary::Absolute | Unary::SquareRoot | Unary::Floor | Unary::Ceil,
        )
        | Operation::Binary(
            Binary::Add
            | Binary::Subtract
            | Binary::Multiply
            | Binary::Divide
            | Binary::Less
            | Binary::LessOrEqual
            | Binary::Equal
            | Binary::NotEqual
            | Binary::And
            | Binary::Or,
        ) => None,
        Operation::Unary(function) => Some(Function::Unary(function)),
        Operation::Binary(function) => Some(Function::Binary(function)),
        Operation::Piece(number) => Some(Function::Piece(number)),
        Operation::Interpolated(number) => Some(Function::Interpolated(number)),
        Operation::Binomial => Some(Function::Binomial),
        _ => None,
    }
}

//! Keys of expressions for the check of dimensions. Corresponding expressions of all members of a family have equal keys.

use crate::components::vector_or_family;
use crate::names::{Meaning, Unknown};
use crate::{BinaryOperator, ExpressionKind, UnaryOperator};
use std::collections::{HashMap, HashSet};
use std::mem::Discriminant;
use units::Dimension;

/// A node of an expression, reduced to the data that affect dimensions. Expressions with equal lists of parts, in text
/// order, have the same dimension under the same conditions.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Part {
    /// An expression without further data; the number of operands if it varies, otherwise 0.
    Kind(Discriminant<ExpressionKind>, usize),
    Unary(UnaryOperator),
    Binary(BinaryOperator),
    /// Dimension of a number. The bits of its value are included where the value affects dimensions: in exponents, and for
    /// a bare zero, which fits every dimension.
    Number(Option<Dimension>, Option<u64>),
    /// Meaning of a name, derivative order, and the bits of its value in exponents. Members of a family, components of a
    /// vector and definitions with equal keys have the meaning of the first one.
    Name(Meaning, u32, Option<u64>),
    /// Name of a function, a table or an undeclared name, and the number of arguments.
    Call(String, usize),
    Component(usize),
    /// A call of a user-defined function, and its stated dimension.
    Expansion(String, Option<Dimension>),
}

/// Unknowns and definitions with equal dimensions, and the keys that have been checked.
#[derive(Debug, Default)]
pub(crate) struct Alike {
    /// For each unknown, the index of the first unknown of its family or vector.
    pub(super) unknowns: Vec<usize>,
    /// For definitions with the same key as an earlier one, the index of the first.
    pub(super) definitions: HashMap<usize, usize>,
    pub(super) checked: HashSet<Vec<Part>>,
    pub(super) defined: HashMap<Vec<Part>, usize>,
}

impl Alike {
    /// Groups these unknowns by family and vector.
    pub fn of(unknowns: &[Unknown]) -> Self {
        let mut first: HashMap<&str, usize> = HashMap::new();
        let families = unknowns.iter().map(|unknown| vector_or_family(unknown.name)).enumerate();
        let of_family =
            families.map(|(index, family)| family.map_or(index, |family| *first.entry(family).or_insert(index)));
        Self { unknowns: of_family.collect(), ..Self::default() }
    }

    /// Index of the first unknown of the same family or vector.
    pub fn first(&self, unknown: usize) -> usize {
        self.unknowns.get(unknown).copied().unwrap_or(unknown)
    }
}

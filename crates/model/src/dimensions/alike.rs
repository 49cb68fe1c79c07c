//! The parts of expressions that decide their dimensions: they are equal in all members of a family.

use crate::components::vector_or_family;
use crate::names::{Meaning, Unknown};
use crate::{BinaryOperator, ExpressionKind, UnaryOperator};
use std::collections::{HashMap, HashSet};
use std::mem::Discriminant;
use units::Dimension;

/// A part of an expression, as far as it decides a dimension. Expressions with equal parts, in the order of the text, have the same
/// dimension under the same conditions.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Part {
    /// What has no further properties, and how many operands it has if their number varies.
    Kind(Discriminant<ExpressionKind>, usize),
    Unary(UnaryOperator),
    Binary(BinaryOperator),
    /// The dimension of a number; the bits of its value where it decides: in exponents, and of a bare zero, which fits any dimension.
    Number(Option<Dimension>, Option<u64>),
    /// A name with its primes; the bits of its value where it decides. Members of a family, components of a vector and definitions that are alike
    /// have the meaning of the first.
    Name(Meaning, u32, Option<u64>),
    /// A function or a table, or a name without a meaning, and the number of arguments.
    Call(String, usize),
    Component(usize),
    /// A call of a function of the author's own, and the dimension stated for it.
    Expansion(String, Option<Dimension>),
}

/// Which unknowns and definitions have the same dimension, and what has been checked.
#[derive(Debug, Default)]
pub(crate) struct Alike {
    /// Of each unknown the first one of its family.
    pub(super) unknowns: Vec<usize>,
    /// Of definitions the first one that is alike, if it is another.
    pub(super) definitions: HashMap<usize, usize>,
    pub(super) checked: HashSet<Vec<Part>>,
    pub(super) defined: HashMap<Vec<Part>, usize>,
}

impl Alike {
    /// With the families and vectors of these unknowns.
    pub fn of(unknowns: &[Unknown]) -> Self {
        let mut first: HashMap<&str, usize> = HashMap::new();
        let families = unknowns.iter().map(|unknown| vector_or_family(unknown.name)).enumerate();
        let of_family =
            families.map(|(index, family)| family.map_or(index, |family| *first.entry(family).or_insert(index)));
        Self { unknowns: of_family.collect(), ..Self::default() }
    }

    /// The first unknown of the family or vector of one.
    pub fn first(&self, unknown: usize) -> usize {
        self.unknowns.get(unknown).copied().unwrap_or(unknown)
    }
}

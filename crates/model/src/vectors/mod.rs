//! Vectors: what is written once for a vector is written out for each of its components. `r'' = -G*M*r/norm(r)^3` becomes two or
//! three equations of the unknowns `r.x`, `r.y` and `r.z`. All that follows (names, dimensions, lowering) then has to do with
//! numbers only.
//!
//! Families and functions of the author's own are written out before. A name is a vector if it is defined by one or begins as
//! one; see `find.rs`.

mod expressions;
mod faults;
mod find;
mod operations;
mod statements;

use crate::components::{AXES, split_component};
use crate::{Diagnostic, Expression, ExpressionKind, Statement};
use expressions::Writer;
use std::collections::{BTreeMap, BTreeSet};

/// The operations with vectors. The words are free as names, and as functions of the author's own.
const NORM: &str = "norm";
const DOT: &str = "dot";
const CROSS: &str = "cross";

/// Which names are vectors.
#[derive(Clone, Debug, Default)]
pub(crate) struct Vectors {
    /// The number of components, of families by their names.
    dimensions: BTreeMap<String, usize>,
    /// The names of events: `landing.r` is a vector if `r` is one.
    events: BTreeSet<String>,
    /// The author's functions.
    functions: BTreeSet<String>,
    /// Whether vectors stand anywhere, with a name or without.
    occur: bool,
}

impl Vectors {
    /// The vectors among the quantities of a checked model, which are there by their components.
    pub fn of_names<'a>(names: impl Iterator<Item = &'a str> + Clone) -> Self {
        let mut dimensions: BTreeMap<String, usize> = BTreeMap::new();
        let mut first: BTreeSet<&str> = BTreeSet::new();
        let mut events: BTreeSet<&str> = BTreeSet::new();
        for name in names.clone() {
            if let Some(event) = name.strip_suffix(".count") {
                events.insert(event);
            }
        }
        for name in names {
            let Some((vector, axis)) = split_component(name) else { continue };
            let vector = vector.split('[').next().unwrap_or(vector);
            if axis == 0 {
                first.insert(vector);
            } else if first.contains(vector) && !events.contains(vector) {
                let dimension = dimensions.entry(vector.to_owned()).or_insert(axis + 1);
                *dimension = (*dimension).max(axis + 1);
            }
        }
        let occur = !dimensions.is_empty();
        Self { dimensions, occur, ..Self::default() }
    }

    /// Whether there is nothing to write out.
    pub fn is_empty(&self) -> bool {
        !self.occur
    }

    /// How many components a name has, with the numbers of a member of a family or without; none if it is no vector.
    pub fn dimension(&self, name: &str) -> Option<usize> {
        let family = match name.split_once('[') {
            Some((family, numbers)) if numbers.ends_with(']') => family,
            Some(_) => return None,
            None => name,
        };
        self.dimensions.get(family).copied().or_else(|| {
            let (event, member) = family.split_once('.')?;
            if self.events.contains(event) { self.dimensions.get(member).copied() } else { None }
        })
    }

    /// Whether a name with a point in it is a component, and not something that an event remembers.
    pub fn is_component(&self, name: &str) -> bool {
        name.split_once('.').is_some_and(|(vector, _)| self.dimension(vector).is_some())
    }

    /// Whether a function is one of vectors, and none of the author's own.
    pub fn is_operation(&self, function: &str) -> bool {
        self.occur && [NORM, DOT, CROSS].contains(&function) && !self.functions.contains(function)
    }

    /// The statements with all vectors written out.
    pub fn write_out(&self, statements: &[Statement], diagnostics: &mut Vec<Diagnostic>) -> Vec<Statement> {
        statements::write_out(self, statements, diagnostics)
    }

    /// An expression that stands for itself, in its components; a number is its only one.
    ///
    /// # Errors
    /// What cannot be done with vectors.
    pub fn components(&self, expression: &Expression) -> Result<Vec<Expression>, Vec<Diagnostic>> {
        if !self.occur && !has_tuple(expression) {
            return Ok(vec![expression.clone()]);
        }
        let mut writer = Writer::new(self);
        let value = writer.value(expression);
        let components = writer.components(value);
        let found = writer.finish();
        if found.is_empty() { Ok(components) } else { Err(found) }
    }

    /// The number that an expression is.
    ///
    /// # Errors
    /// Vectors, and what cannot be done with them.
    pub fn number(&self, expression: &Expression) -> Result<Expression, Vec<Diagnostic>> {
        let mut components = self.components(expression)?;
        match (components.pop(), components.len()) {
            (Some(only), 0) => Ok(only),
            _ => Err(vec![faults::vector_for_number(expression)]),
        }
    }
}

/// Whether an expression has vectors without a name in it.
fn has_tuple(expression: &Expression) -> bool {
    let mut found = false;
    crate::names::for_each(expression, |part| {
        found |= matches!(part.kind, ExpressionKind::Tuple { .. } | ExpressionKind::Component { .. });
    });
    found
}

/// `x, y` or `x, y, z`
fn axes(dimension: usize) -> String {
    AXES.iter().take(dimension).copied().collect::<Vec<_>>().join(", ")
}

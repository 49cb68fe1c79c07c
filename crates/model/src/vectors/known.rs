//! Which names are vectors, and how many components they have.

use crate::components::{AXES, split_component};
use crate::{Expression, ExpressionKind};
use std::collections::{BTreeMap, BTreeSet};

/// The operations with vectors. The words are free as names, and as functions of the author's own.
pub(super) const NORM: &str = "norm";
pub(super) const DOT: &str = "dot";
pub(super) const CROSS: &str = "cross";

/// Which names are vectors.
#[derive(Clone, Debug, Default)]
pub(crate) struct Vectors {
    /// The number of components, of families by their names.
    pub(super) dimensions: BTreeMap<String, usize>,
    /// The names of events: `landing.r` is a vector if `r` is one.
    pub(super) events: BTreeSet<String>,
    /// The author's functions.
    pub(super) functions: BTreeSet<String>,
    /// Whether vectors stand anywhere, with a name or without.
    pub(super) occur: bool,
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
}

/// Whether an expression has vectors without a name in it.
pub(super) fn has_tuple(expression: &Expression) -> bool {
    let mut found = false;
    crate::names::for_each(expression, |part| {
        found |= matches!(part.kind, ExpressionKind::Tuple { .. } | ExpressionKind::Component { .. });
    });
    found
}

/// `x, y` or `x, y, z`
pub(super) fn axes(dimension: usize) -> String {
    AXES.iter().take(dimension).copied().collect::<Vec<_>>().join(", ")
}

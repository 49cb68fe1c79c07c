//! Vectors of a model and their numbers of components.

use crate::components::{AXES, split_component};
use crate::{Expression, ExpressionKind};
use std::collections::{BTreeMap, BTreeSet};

/// Functions of vectors. The words are not reserved: an author may use them as names and define functions with them.
pub(super) const NORM: &str = "norm";
pub(super) const DOT: &str = "dot";
pub(super) const CROSS: &str = "cross";

/// Names that are vectors.
#[derive(Clone, Debug, Default)]
pub(crate) struct Vectors {
    /// Number of components by name; of a family by the name of the family.
    pub(super) dimensions: BTreeMap<String, usize>,
    /// Names of events: `landing.r` is a vector if `r` is one.
    pub(super) events: BTreeSet<String>,
    /// Names of the user-defined functions.
    pub(super) functions: BTreeSet<String>,
    /// True if the model contains vectors, with or without a name.
    pub(super) occur: bool,
}

impl Vectors {
    /// Vectors of a checked model, recognized from the names of their components.
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

    /// True if there is nothing to expand.
    pub fn is_empty(&self) -> bool {
        !self.occur
    }

    /// Number of components of a name, with or without the indices of a member; `None` if it is not a vector.
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

    /// True if a name with a point is a component, and not a value remembered by an event.
    pub fn is_component(&self, name: &str) -> bool {
        name.split_once('.').is_some_and(|(vector, _)| self.dimension(vector).is_some())
    }

    /// True if a function is a vector function and not user-defined.
    pub fn is_operation(&self, function: &str) -> bool {
        self.occur && [NORM, DOT, CROSS].contains(&function) && !self.functions.contains(function)
    }
}

/// True if an expression contains unnamed vectors.
pub(super) fn has_tuple(expression: &Expression) -> bool {
    let mut found = false;
    crate::names::for_each(expression, |part| {
        found |= matches!(part.kind, ExpressionKind::Tuple { .. } | ExpressionKind::Component { .. });
    });
    found
}

/// Axes of a vector as text: `x, y` or `x, y, z`.
pub(super) fn axes(dimension: usize) -> String {
    AXES.iter().take(dimension).copied().collect::<Vec<_>>().join(", ")
}

//! An unknown function of the model.

use super::declarations::InitialEntry;
use crate::Span;
use std::collections::BTreeMap;

/// An unknown function of the independent variable.
#[derive(Clone, Debug)]
pub(crate) struct Unknown<'a> {
    /// Its name.
    pub name: &'a str,
    /// How many primes its highest derivative has; as many states belong to it.
    pub highest: u32,
    /// The index of the first of its states.
    pub first_state: usize,
    /// Where its highest derivative stands in an equation.
    pub span: Span,
    /// Its initial values, by their primes.
    pub initial: Vec<Option<InitialEntry<'a>>>,
}

/// How often each unknown is primed at most.
pub(super) type Orders<'a> = BTreeMap<&'a str, (u32, Span)>;

//! An unknown function of the model.

use super::declarations::InitialEntry;
use crate::Span;
use std::collections::BTreeMap;

/// An unknown function of the independent variable.
#[derive(Clone, Debug)]
pub(crate) struct Unknown<'a> {
    /// Its name.
    pub name: &'a str,
    /// Order of its highest derivative, which is also the number of its states.
    pub highest: u32,
    /// Index of the first of its states.
    pub first_state: usize,
    /// Place of its highest derivative in an equation.
    pub span: Span,
    /// Its initial values, by derivative order.
    pub initial: Vec<Option<InitialEntry<'a>>>,
}

/// Highest derivative order of each unknown, and a place where it occurs.
pub(super) type Orders<'a> = BTreeMap<&'a str, (u32, Span)>;

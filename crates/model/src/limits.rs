//! Limits of models. Documents come from strangers, and a short text can cause an enormous computation. Real models stay
//! far below these limits.

/// Bytes of the text of a model.
pub(crate) const SOURCE: usize = 200_000;
/// Statements of a model.
pub(crate) const STATEMENTS: usize = 20_000;
/// Value of a size, and number of members of a family.
pub(crate) const MEMBERS: u32 = 10_000;
/// Operations of all expressions after the members of families are expanded.
pub(crate) const MEMBER_OPERATIONS: usize = 1_000_000;
/// Derivative order of a name: its primes.
pub(crate) const ORDER: u32 = 16;
/// States of a model.
pub(crate) const STATES: usize = 4096;
/// Dry frictions of a model.
pub(crate) const FRICTIONS: usize = 16;
/// Nodes of all calls of user-defined functions together, after expansion.
pub(crate) const WRITTEN_OUT: usize = 50_000;
/// Nodes of all calls in the expressions of a document outside its model, after expansion.
pub(crate) const WRITTEN_OUT_IN_DOCUMENT: usize = 1_000_000;
/// Nesting depth of an expression after the expansion of user-defined functions; the parser has the same limit.
pub(crate) const NESTING: usize = 64;
/// Height of an expression tree, long sums and products included.
pub(crate) const HEIGHT: usize = 400;
/// Alternatives of a choice.
pub(crate) const ALTERNATIVES: usize = 40;
/// Points of a table.
pub(crate) const TABLE_POINTS: usize = 10_000;
/// Nodes of the expression graph.
pub(crate) const NODES: usize = 200_000;

/// Coefficients of highest derivatives in all expressions that contain such derivatives.
pub(crate) const COEFFICIENTS: usize = 1_000_000;
/// Reported errors of one kind.
pub(crate) const TOLD: usize = 50;
/// Further places shown by one diagnostic.
pub(crate) const PLACES: usize = 3;
/// Terms or factors into which one expression is split for simplification.
pub(crate) const TERMS: usize = 64;

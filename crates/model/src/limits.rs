//! Bounds on models. Documents come from strangers, and a short text can ask for an enormous computation; no honest
//! model comes near these.

/// Bytes of a model's text.
pub(crate) const SOURCE: usize = 200_000;
/// Statements of a model.
pub(crate) const STATEMENTS: usize = 20_000;
/// The greatest size, and the greatest number of members of a family.
pub(crate) const MEMBERS: u32 = 10_000;
/// Operations of expressions with all members of families written out.
pub(crate) const MEMBER_OPERATIONS: usize = 1_000_000;
/// Primes of one name.
pub(crate) const ORDER: u32 = 16;
/// States of a model.
pub(crate) const STATES: usize = 4096;
/// Dry frictions of a model.
pub(crate) const FRICTIONS: usize = 16;
/// Parts that all calls of the author's functions together may have when they are written out.
pub(crate) const WRITTEN_OUT: usize = 50_000;
/// The same in all expressions of a document outside its model together.
pub(crate) const WRITTEN_OUT_IN_DOCUMENT: usize = 1_000_000;
/// How deeply an expression may be nested when the calls of the author's functions are written out, as deeply as one that
/// is read.
pub(crate) const NESTING: usize = 64;
/// Levels of an expression, those of long sums and products counted.
pub(crate) const HEIGHT: usize = 400;
/// Alternatives of a choice.
pub(crate) const ALTERNATIVES: usize = 40;
/// Points of a table.
pub(crate) const TABLE_POINTS: usize = 10_000;
/// Nodes of the expression graph.
pub(crate) const NODES: usize = 200_000;

/// Coefficients of highest derivatives in all expressions that contain such.
pub(crate) const COEFFICIENTS: usize = 1_000_000;
/// Errors of one kind that are reported; an author reads no more of them.
pub(crate) const TOLD: usize = 50;
/// Further places that one diagnostic shows.
pub(crate) const PLACES: usize = 3;
/// Terms or factors into which one expression is taken apart to be simplified.
pub(crate) const TERMS: usize = 64;

//! Bounds on what a file may hold.

/// Greatest size of a file, in bytes.
pub(super) const MOST_BYTES: usize = 20 << 20;
/// Greatest number of elements of a view.
pub(super) const MOST_ELEMENTS: usize = 2000;
/// Greatest depth of nesting.
pub(super) const DEEPEST: usize = 64;

//! The names of the tabs of the laboratory.

/// The tab of records and cycles.
pub const MEASURE: &str = "measure";
/// The tab of fits.
pub const FIT: &str = "fit";
/// The tab of the editor.
pub const WRITE: &str = "write";

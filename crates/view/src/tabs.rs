//! Ids of the tabs.

/// Tab of parameters, presets and values.
pub const PLAY: &str = "play";
/// Tab of the questions.
pub const ACTIVITIES: &str = "activities";
/// Tab of prose and equations.
pub const THEORY: &str = "theory";
/// Tab of records and cycles, in the laboratory.
pub const MEASURE: &str = "measure";
/// Tab of fits, in the laboratory.
pub const FIT: &str = "fit";
/// Tab of the editor, in the laboratory.
pub const WRITE: &str = "write";

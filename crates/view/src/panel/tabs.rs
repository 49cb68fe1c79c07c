//! Ids of the tabs.

/// Tab of parameters, presets and values.
pub const EXPLORE: &str = "explore";
/// Tab of the questions.
pub const QUESTIONS: &str = "questions";
/// Tab of prose and equations.
pub const THEORY: &str = "theory";
/// Tab of records, cycles and fits, in the laboratory.
pub const MEASURE: &str = "measure";
/// Tab of the editor, in the laboratory.
pub const WRITE: &str = "write";
/// Tab of a class, in the laboratory.
pub const CLASS: &str = "class";

//! Ids of the tabs that every page has.

/// Tab of parameters, presets and values.
pub const PLAY: &str = "play";
/// Tab of the questions.
pub const ACTIVITIES: &str = "activities";
/// Tab of prose and equations.
pub const THEORY: &str = "theory";

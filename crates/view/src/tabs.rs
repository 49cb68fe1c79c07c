//! The names of the tabs that every page has.

/// The tab of parameters, presets and values.
pub const PLAY: &str = "play";
/// The tab of the questions.
pub const ACTIVITIES: &str = "activities";
/// The tab of prose and equations.
pub const THEORY: &str = "theory";

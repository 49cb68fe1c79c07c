//! Settings of a class.

use serde::{Deserialize, Serialize};

/// Settings of the teacher. The latest event of the teacher counts.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Settings {
    /// Hand-ins are accepted.
    pub open: bool,
    /// The pages of the students are covered.
    pub paused: bool,
    /// Document at which the class works; `None` if each student chooses.
    pub pace: Option<String>,
    /// Time at which the class closes, by the server's clock, in milliseconds since 1970.
    pub closes: Option<u64>,
    /// New seats are given.
    pub joining: bool,
    /// Students who join from now on wait until the teacher lets them in.
    pub approve: bool,
    /// Students see how many have answered each question, and how many of them rightly.
    pub results: bool,
    /// Students see the answers of others to a question that they have answered themselves.
    pub others: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            open: true,
            paused: false,
            pace: None,
            closes: None,
            joining: true,
            approve: false,
            results: false,
            others: false,
        }
    }
}

impl Settings {
    /// True if hand-ins are accepted at this time.
    pub fn accepts(&self, now: u64) -> bool {
        self.open && self.closes.is_none_or(|closes| now < closes)
    }
}

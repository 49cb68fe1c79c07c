//! Why input was not taken.

/// Why input was not taken; nothing has changed then, except as [`Refusal::PartlyRestored`] says.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// There is no number in it.
    NotANumber {
        /// What was typed.
        typed: String,
    },
    /// The unit is unknown.
    UnknownUnit {
        /// The unit typed.
        typed: String,
    },
    /// The unit measures something else.
    WrongUnit {
        /// The unit typed.
        typed: String,
        /// A unit that would do; empty for a pure number.
        expected: String,
    },
    /// A frequency where an angular frequency is needed, or the other way round.
    OtherFrequency {
        /// What was typed, with its unit.
        typed: String,
        /// The same as it would have to be, with its unit.
        meant: String,
        /// Whether an angular frequency is needed.
        angular: bool,
    },
    /// An answer names a quantity of the document instead of giving a number.
    NameInAnswer {
        /// The name.
        name: String,
    },
    /// The value is below the least allowed one.
    TooSmall {
        /// The label of what was to be set.
        name: String,
        /// The least value, with its unit.
        least: String,
    },
    /// The value is above the greatest allowed one.
    TooLarge {
        /// The label of what was to be set.
        name: String,
        /// The greatest value, with its unit.
        greatest: String,
    },
    /// The value is not finite: an expression of a preset has no value here.
    NoValue {
        /// The label of what was to be set.
        name: String,
    },
    /// It must be greater than zero.
    NotPositive,
    /// The state can be set only while the run stands still.
    NotPaused,
    /// The run has ended, or cannot go on: nothing can be pressed there.
    RunEnded,
    /// No more presses fit into a run.
    TooManyPresses {
        /// How many there may be.
        most: usize,
    },
    /// The method is for equations of second order only.
    Method {
        /// Which.
        method: engine::Method,
    },
    /// No more runs can be kept.
    TooManyRuns {
        /// How many there may be.
        most: usize,
    },
    /// Nothing of that number or name exists.
    Unknown {
        /// What was asked for.
        name: String,
    },
    /// A saved state was not written by this program, or by a later version of it.
    UnreadableState,
    /// The document inside a link is too long.
    DocumentTooLong,
    /// A link is about a document that is neither in it nor in the page.
    DocumentNeeded {
        /// The name of its file.
        name: String,
    },
    /// Parts of a saved state do not fit this document and were left out.
    PartlyRestored {
        /// Which, as written in it.
        left_out: Vec<String>,
    },
}

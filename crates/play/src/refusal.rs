//! Reasons for which input is refused.

use units::number::typed::NotRead;

/// Reason for which input is refused. The state is unchanged, except for [`Refusal::PartlyRestored`].
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// The input is not a number with a suitable unit.
    NotRead(NotRead),
    /// A frequency where an angular frequency is expected, or vice versa.
    OtherFrequency {
        /// Input with its unit.
        typed: String,
        /// Equivalent value in the expected kind of unit, with its unit.
        meant: String,
        /// True if an angular frequency is expected.
        angular: bool,
    },
    /// An answer contains the name of a quantity of the document.
    NameInAnswer {
        /// Name.
        name: String,
    },
    /// The value is below the range.
    TooSmall {
        /// Label of the parameter.
        name: String,
        /// Least value, with its unit.
        least: String,
    },
    /// The value is above the range.
    TooLarge {
        /// Label of the parameter.
        name: String,
        /// Greatest value, with its unit.
        greatest: String,
    },
    /// The value is not finite or not allowed, for instance because an expression of a preset has no value.
    NoValue {
        /// Label of the parameter or state.
        name: String,
    },
    /// The value must be greater than zero.
    NotPositive,
    /// The state can be set only while the run is paused.
    NotPaused,
    /// The run has ended or failed: buttons cannot be pressed.
    RunEnded,
    /// Maximum number of presses in one run reached.
    TooManyPresses {
        /// Maximum number.
        most: usize,
    },
    /// The method applies to equations of second order only.
    Method {
        /// The method.
        method: engine::Method,
    },
    /// Maximum number of kept runs reached.
    TooManyRuns {
        /// Maximum number.
        most: usize,
    },
    /// No object with that number or name exists.
    Unknown {
        /// Name or number that was requested.
        name: String,
    },
    /// The input is no seat of a class.
    NoSeat,
    /// A saved state was not written by this program or was written by a later version.
    UnreadableState,
    /// The document in a link is too long.
    DocumentTooLong,
    /// A link refers to a document that is neither in the link nor in the page.
    DocumentNeeded {
        /// File name of the document.
        name: String,
    },
    /// Parts of a saved state do not fit this document and were omitted.
    PartlyRestored {
        /// Omitted parts, as written in the saved state.
        left_out: Vec<String>,
    },
}

impl From<NotRead> for Refusal {
    fn from(why: NotRead) -> Self {
        Self::NotRead(why)
    }
}

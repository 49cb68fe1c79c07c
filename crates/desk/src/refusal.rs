//! Reasons to reject input.

/// Reason to reject input. The state is then unchanged, except after [`play::Refusal::PartlyRestored`].
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// Rejected by the simulation.
    Play(play::Refusal),
    /// The maximum number of records is reached.
    TooManyRecords {
        /// Maximum number of records.
        most: usize,
    },
    /// The file of a record is too large for the page.
    RecordTooLong {
        /// Maximum size in MiB.
        most: usize,
    },
    /// The file of a record is not a table.
    UnreadableRecord {
        /// Name of the record.
        name: String,
        /// Reason and remedy, in the chosen language.
        why: String,
        /// True if nothing in it tells day and month of its dates apart: a person can state their order.
        asks_dates: bool,
    },
    /// No smoothing polynomial exists for this window and degree.
    NoSuchPolynomial,
    /// No row of the column has the neighbours that a derivative needs.
    NoDerivative,
    /// The model cannot be built with a requested size.
    Size {
        /// Reason, in the chosen language.
        why: String,
    },
    /// A film cannot be opened, tracked or measured as requested.
    Film {
        /// Reason and remedy, in the chosen language.
        why: String,
    },
    /// A fit cannot be made.
    Fit {
        /// Reason, in the chosen language.
        why: String,
    },
}

impl Refusal {
    /// No item of this number or name exists.
    pub(crate) fn unknown(name: impl ToString) -> Self {
        Self::Play(play::Refusal::Unknown { name: name.to_string() })
    }

    /// True if a file is read once a person has stated the order of day and month in its dates.
    pub fn asks_dates(&self) -> bool {
        matches!(self, Self::UnreadableRecord { asks_dates: true, .. })
    }
}

impl From<play::Refusal> for Refusal {
    fn from(refusal: play::Refusal) -> Self {
        Self::Play(refusal)
    }
}

//! Why input was not taken.

/// Why input was not taken; nothing has changed then, except as [`play::Refusal::PartlyRestored`] says.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// What concerns the simulation itself.
    Play(play::Refusal),
    /// No more records can be held.
    TooManyRecords {
        /// How many there may be.
        most: usize,
    },
    /// The text of a record is too long for the page.
    RecordTooLong {
        /// How many mebibytes there may be.
        most: usize,
    },
    /// The text of a record is no table.
    UnreadableRecord {
        /// What it is called.
        name: String,
        /// Where and why, in the chosen language.
        why: String,
    },
    /// There is no smoothing polynomial of this window and degree.
    NoSuchPolynomial,
    /// No row of the column has the neighbours that a derivative needs.
    NoDerivative,
    /// The model cannot be built with a size.
    Size {
        /// Why, in the chosen language.
        why: String,
    },
    /// A film cannot be opened, tracked or measured so.
    Film {
        /// Why and what to do, in the chosen language.
        why: String,
    },
    /// A fit cannot be made.
    Fit {
        /// Why, in the chosen language.
        why: String,
    },
}

impl Refusal {
    /// Nothing of that number or name exists.
    pub(crate) fn unknown(name: impl ToString) -> Self {
        Self::Play(play::Refusal::Unknown { name: name.to_string() })
    }
}

impl From<play::Refusal> for Refusal {
    fn from(refusal: play::Refusal) -> Self {
        Self::Play(refusal)
    }
}

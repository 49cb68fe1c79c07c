//! Why input was not taken.

use analysis::fit::FitError;
use units::Language;

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
        /// Where and why, in the session's language.
        why: String,
    },
    /// There is no smoothing polynomial of this window and degree.
    NoSuchPolynomial,
    /// No row of the column has the neighbours that a derivative needs.
    NoDerivative,
    /// A fit cannot be made.
    Fit {
        /// Why, in the session's language.
        why: String,
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

/// Why a fit cannot be made.
pub(crate) fn fit_error(language: Language, error: &FitError) -> String {
    let text = match error {
        FitError::NothingVaried => language.pick("Tick what is to be varied.", "Marca lo que debe variar."),
        FitError::NothingObserved => language.pick(
            "No column is ticked for the fit, or none of its values lies between the two times.",
            "Ninguna columna está marcada para el ajuste, o ninguno de sus valores cae entre los dos tiempos.",
        ),
        FitError::TooFew { values, varied } => {
            return language.pick(
                format!("{values} values cannot determine {varied} numbers."),
                format!("{values} valores no pueden determinar {varied} números."),
            );
        }
        FitError::TooLarge => language.pick(
            "There are too many values or too many varied numbers.",
            "Hay demasiados valores o demasiados números que varían.",
        ),
        FitError::VariedTwice(_) | FitError::BadBounds(_) => {
            language.pick("The ranges leave no room.", "Los intervalos no dejan sitio.")
        }
        FitError::BadStart(_) | FitError::BadValue(_) => language.pick(
            "The value of a parameter is not a finite number.",
            "El valor de un parámetro no es un número finito.",
        ),
        FitError::BadErrors { count, .. } => {
            return language.pick(
                format!("{count} values have a standard error that is missing or not greater than 0."),
                format!("{count} valores tienen un error típico que falta o no es mayor que 0."),
            );
        }
        FitError::RecordEmpty(_) => language.pick(
            "None of its values lies between the two times.",
            "Ninguno de sus valores cae entre los dos tiempos.",
        ),
        FitError::Model(message) => return message.text(language).to_owned(),
    };
    text.to_owned()
}

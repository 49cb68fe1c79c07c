//! Remarks on the reading of an instrument's file, as text.

use units::number::plain;
use units::{Language, say};

/// Remark on how the file of an instrument was read.
#[derive(Clone, Debug, PartialEq)]
pub enum Remark {
    /// The file was recognised.
    Recognised {
        /// Instrument or program.
        name: &'static str,
    },
    /// The times follow from the step in the header.
    Increment {
        /// Time step, in `unit`.
        step: f64,
        /// Time of the first row, in `unit`.
        start: f64,
        /// Unit of both.
        unit: String,
        /// True if the first column counts the rows and was replaced.
        index: bool,
    },
    /// The header states no time step, and the first column only counts the rows.
    NoIncrement,
    /// The channels have different steps, and the file has the times of one.
    OneClock,
    /// The numbers were points of the screen.
    Divisions {
        /// Height of a division.
        height: f64,
        /// Number of points of a division.
        points: u32,
    },
    /// The numbers were multiplied by a power of ten.
    Power {
        /// Text of the power: `1.0e+03`.
        text: String,
    },
    /// Settings beside the rows were left out.
    Beside,
}

impl Remark {
    /// Remark as a sentence.
    pub fn text(&self, language: Language) -> String {
        let decimal = |value: f64| plain(value, 9, language.style());
        match self {
            Self::Recognised { name } => say!(language, "the file was read as a file of {name}, with the settings of its header"),
            Self::Increment { step, start, unit, index } => {
                let (step, start) = (decimal(*step), decimal(*start));
                if *index {
                    say!(
                        language,
                        "the times are from the header's increment of {step} {unit}, from {start} {unit} on; the first column only counts the rows"
                    )
                } else {
                    say!(language, "the times are from the header's increment of {step} {unit}, from {start} {unit} on")
                }
            }
            Self::NoIncrement => language
                .say("the header states no time between two rows: the rows are counted by `index`, which is no time; export the file again with times")
                .to_owned(),
            Self::OneClock => language
                .say("the header states a different time step for some channels; the times in the file are certain only for the first channel")
                .to_owned(),
            Self::Divisions { height, points } => {
                let height = decimal(*height);
                say!(
                    language,
                    "the numbers count points of the screen from its centre line: {points} points are one division of {height}"
                )
            }
            Self::Power { text } => {
                say!(language, "all numbers were multiplied by {text}, as the line above them states")
            }
            Self::Beside => language
                .say("the first columns hold settings of the instrument and were left out")
                .to_owned(),
        }
    }
}

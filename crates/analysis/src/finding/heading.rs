//! Decisions about the header of a file, with their reasons.

use super::words::{called, decimal};
use crate::conversion::UnitReading;
use units::{Language, say};

/// Decision about names, units or errors in the header.
#[derive(Clone, Debug, PartialEq)]
pub enum Heading {
    /// Lines of names and units, if other lines could have them too.
    Lines {
        /// Line of names, from 1.
        names: usize,
        /// Line of units, from 1, if there is one.
        units: Option<usize>,
        /// Lines taken as comments, from 1.
        comments: Vec<usize>,
    },
    /// The header has one name less than the table has columns.
    FewNames {
        /// Number of names.
        names: usize,
        /// True if the first column has no name, because it counts or names the rows; false if it is the last one.
        first: bool,
    },
    /// The line of units has no unit for these columns.
    NoUnit(Vec<String>),
    /// The reading of a unit depends on the name of the column.
    Unit {
        /// The column.
        column: String,
        /// Text of the unit.
        written: String,
        /// Reading of the unit.
        reading: UnitReading,
    },
    /// The heading has a power of ten.
    Power {
        /// The column.
        column: String,
        /// Text of the heading.
        heading: String,
        /// Exponent of ten by which the numbers are multiplied.
        tens: i32,
        /// Certainty of this reading.
        certainty: Certainty,
    },
    /// The cells have another unit than the header.
    CellUnit {
        /// The column.
        column: String,
        /// Unit of the header.
        header: String,
        /// Unit of the cells, which is used.
        cells: String,
    },
    /// Some cells of a column have a unit, others have none; all were read in this unit.
    BareNumbers {
        /// The column.
        column: String,
        /// The unit.
        unit: String,
        /// Number of cells without a unit.
        count: usize,
    },
    /// A column holds the standard errors of another one.
    Errors {
        /// The column.
        column: String,
        /// Column to which they belong.
        of: String,
        /// True if that is an independent variable, whose errors are not used.
        unused: bool,
    },
    /// A column is named as standard errors and is not used as such.
    NotErrors {
        /// The column.
        column: String,
        /// Column to which the errors would belong, if there is one.
        of: Option<String>,
    },
}

/// Certainty of the meaning of a power of ten.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Certainty {
    /// There is only one meaning.
    Clear,
    /// The usual one of several meanings.
    Usual,
    /// Both meanings are usual; none was applied.
    Open,
}

impl Heading {
    /// Decision as one or two sentences in English or Spanish.
    pub(super) fn text(&self, language: Language) -> String {
        let list = |lines: &[usize]| lines.iter().map(usize::to_string).collect::<Vec<_>>().join(", ");
        match self {
            Self::Lines { names, units, comments } => {
                let comments = list(comments);
                match units {
                    None => {
                        say!(language, "line {names} of the file has the names; taken for a comment: line {comments}")
                    }
                    Some(units) => say!(
                        language,
                        "line {names} of the file has the names, line {units} the units; taken for a comment: line {comments}"
                    ),
                }
            }
            Self::FewNames { names, first: true } => say!(
                language,
                "{names} names stand over {} columns: the first column counts or names the rows and has no name",
                names + 1
            ),
            Self::FewNames { names, first: false } => say!(
                language,
                "{names} names stand over {} columns: the last column has no name, as the first does not count the rows",
                names + 1
            ),
            Self::NoUnit(columns) => {
                let columns = columns.join(", ");
                say!(language, "the line of units has none for {columns}: its numbers are taken without one")
            }
            Self::Unit { column, written, reading } => {
                let (column, reading) = (called(column, language), unit_text(*reading, language));
                say!(language, "{column}: `{written}` is {reading}")
            }
            Self::Power { column, heading, tens, certainty } => power(column, heading, *tens, *certainty, language),
            Self::CellUnit { column, header, cells } => {
                say!(language, "{column}: the header says {header}, the cells say {cells}, which counts")
            }
            Self::BareNumbers { column, unit, count } => {
                say!(language, "{column}: {count} cells have no unit and were read in {unit}, as the others")
            }
            Self::Errors { column, of, unused: false } => say!(
                language,
                "{column} is taken for the standard errors of {of}, by its name and numbers; fits use them, cycles do not"
            ),
            Self::Errors { column, of, unused: true } => say!(
                language,
                "{column} is called like the standard errors of {of}; errors of an independent variable are not used"
            ),
            Self::NotErrors { column, of: Some(of) } => say!(
                language,
                "{column} is not taken for standard errors of {of}: not all its numbers are positive and small, or its unit is another"
            ),
            Self::NotErrors { column, of: None } => say!(
                language,
                "{column} is called like standard errors, but no column has the name that it would belong to; it is not used as such"
            ),
        }
    }
}

fn power(column: &str, heading: &str, tens: i32, certainty: Certainty, language: Language) -> String {
    let (column, factor) = (
        called(column, language),
        if tens.abs() <= 4 { decimal(libm::exp10(f64::from(tens)), 4, language) } else { format!("10^{tens}") },
    );
    match certainty {
        Certainty::Clear => {
            say!(language, "{column}: the numbers were multiplied by {factor}, as the heading `{heading}` says")
        }
        Certainty::Usual => say!(
            language,
            "{column}: the numbers were multiplied by {factor}, the usual sense of `{heading}`; if they hold the product already, write the power before the name"
        ),
        Certainty::Open => say!(
            language,
            "{column}: the power of ten in `{heading}` can mean that the numbers hold the product, or that they are to be multiplied by it; none was applied, and the unit must be stated"
        ),
    }
}

fn unit_text(reading: UnitReading, language: Language) -> &'static str {
    match reading {
        UnitReading::Celsius => language.say("a temperature in °C: 273.15 was added, the column is in K"),
        UnitReading::Fahrenheit => {
            language.say("a temperature in °F: the column was converted to K")
        }
        UnitReading::CelsiusDifference => language.say("a difference of temperatures, which is the same in K, as the name says"),
        UnitReading::FahrenheitDifference => language.say("a difference of temperatures in °F, as the name says: the column was converted to K"),
        UnitReading::Gravity { thousandth: false } => language.say("multiples of 9.80665 m/s^2 and not gram, as the name is that of an acceleration: the column was converted to m/s^2"),
        UnitReading::Gravity { thousandth: true } => language.say("thousandths of 9.80665 m/s^2 and not milligram, as the name is that of an acceleration: the column was converted to m/s^2"),
        UnitReading::Seconds => language.say("seconds and not siemens, as the name is that of a time"),
    }
}

//! Findings: notes for the user on a file and on its measurements, as text.

mod heading;
mod words;

use crate::sampling::Gap;
use crate::stencil::Stencil;
use crate::tracker::Remark;
use crate::{data_sets, import, roles};
pub use heading::{Certainty, Heading};
use units::{Language, say};
pub(crate) use words::readings;
use words::{
    backwards, called, clock, decimal, json, labels, missing, nuls, overflow, reading, repeated, rounded_step, runs,
    separator, word,
};

/// Note for the user on their data. Lines and rows count from 1; times are in SI.
#[derive(Clone, Debug, PartialEq)]
pub enum Finding {
    /// The workbook has several sheets; the one with this name was read.
    Sheet(String),
    /// Remark on a Tracker project.
    Project(Remark),
    /// Remark on data sets that were exported together.
    DataSets(data_sets::Remark),
    /// The table was read from JSON; these lists of another length were left out.
    Json(Vec<String>),
    /// The table was read from a text in a markup language, which has this number of other tables.
    Markup {
        /// The language.
        markup: import::Markup,
        /// Number of other tables.
        others: usize,
    },
    /// The numbers of each line stand behind their names.
    Labelled {
        /// Number of lines with other names or none.
        left_out: usize,
    },
    /// This number of NUL bytes was left out.
    Nuls(usize),
    /// Overflows of the counter of a clock were undone.
    Overflow {
        /// The column.
        column: String,
        /// Width of the counter in bits.
        bits: i32,
        /// Number of overflows.
        count: usize,
    },
    /// Remark on the file of an instrument.
    Device(import::DeviceRemark),
    /// A cell holds a word, or a number too large for a double, instead of a number; it became a gap.
    Word {
        /// The line of the file.
        line: usize,
        /// Label of the column.
        column: String,
        /// Text of the cell.
        text: String,
    },
    /// Number of further words that are not listed.
    MoreWords(usize),
    /// Lines of words between the rows were ignored.
    WordLines {
        /// Line of the first.
        line: usize,
        /// Number of lines.
        count: usize,
    },
    /// Headers between the rows have other names or units than the first one; the rows below are read with them.
    OtherHeader {
        /// Line of the first.
        line: usize,
        /// Number of such headers.
        count: usize,
    },
    /// A column of words was left out.
    WordColumn(String),
    /// A column has a name but no number.
    EmptyColumn(String),
    /// Rows have more cells than the table can have columns; the excess cells were left out.
    ExtraCells {
        /// Line of the first.
        line: usize,
        /// Number of rows.
        count: usize,
    },
    /// Decision about names, units and errors in the header.
    Heading(Heading),
    /// The text in brackets in a header is not a known unit.
    UnknownUnit {
        /// The column.
        column: String,
        /// Text in brackets.
        unit: String,
    },
    /// A comma or a point is ambiguous, and a column contradicts one of the readings.
    Separator {
        /// Line of the first number with the sign.
        line: usize,
        /// This number: `1,295`.
        text: String,
        /// Number without the sign in the same column: `926`.
        beside: String,
        /// True if it was read as a separator of groups, false as a decimal sign.
        thousands: bool,
    },
    /// All commas are followed by three digits; they were read as decimal signs.
    DecimalSign {
        /// Line of the first number.
        line: usize,
        /// Number: `1,295`.
        text: String,
    },
    /// All points or commas in the numbers of a column are followed by three digits, and the decimal sign of the file is
    /// the other one; they were read as separators of groups.
    GroupSign {
        /// Line of the first number.
        line: usize,
        /// Number: `1.295`.
        text: String,
    },
    /// A column has another decimal sign than the rest of the file, and was read with its own.
    OtherSign {
        /// The column.
        column: String,
        /// True if its numbers have a point, and the others a comma.
        point: bool,
    },
    /// Clock times or dates were read as seconds from the first row.
    Clock {
        /// The column.
        column: String,
        /// True if it holds only dates.
        days: bool,
        /// Number of times the clock restarted at zero.
        wrapped: usize,
        /// True if `12:30` was read as minutes and seconds without an indication in the file.
        minutes: bool,
        /// True if the month is the first number of its dates, `None` if their notation states the order.
        month_first: Option<bool>,
    },
    /// Serial days of a spreadsheet were read as seconds from the first row.
    SerialDays(String),
    /// A number has an unusual notation, such as `(0.15)` for -0.15.
    Notation {
        /// The line of the file.
        line: usize,
        /// Label of the column.
        column: String,
        /// Text of the cell.
        text: String,
        /// Number that was read.
        value: String,
    },
    /// The time stamps of a serial monitor were replaced by the times of the device itself.
    Stamps {
        /// Unit of these times.
        unit: String,
    },
    /// The runs of a logger, each with its own clock.
    Runs(Vec<String>),
    /// A column of words names the run of each row.
    Labels {
        /// The column.
        column: String,
        /// Names of the runs.
        runs: Vec<String>,
    },
    /// Role of columns, where it is unclear.
    Role(roles::Remark),
    /// No unit is stated for a time; it is taken as seconds, or in a fit as the unit of the model's time.
    AssumedSeconds(String),
    /// The times of a column are missing or all equal.
    NoTimes(String),
    /// Relative standard error common to all lengths, from the scale of their film.
    Scale(f64),
    /// Frames are missing.
    Missing {
        /// The gaps.
        gaps: Vec<Gap>,
        /// Unit of the times, `s`.
        unit: &'static str,
    },
    /// Rows with the time of the row before.
    Doubled {
        /// Time of the first such row.
        time: f64,
        /// Unit of the time.
        unit: &'static str,
        /// Number of rows.
        count: usize,
    },
    /// Rows that repeat the values of the row before in a pattern, as in a film that was converted to another frame rate.
    Repeated {
        /// Labels of the columns.
        columns: Vec<String>,
        /// Number of these rows.
        count: usize,
        /// Number of rows.
        of: usize,
    },
    /// Rows with an earlier time than the row before.
    Backwards {
        /// Time of the first such row.
        time: f64,
        /// Unit of the time.
        unit: &'static str,
        /// Number of rows.
        count: usize,
    },
    /// Standard deviation of the distances of the rows, as a part of their mean.
    Uneven(f64),
    /// All times are rounded.
    RoundedTimes {
        /// Rounding unit.
        to: f64,
        /// Unit of the times.
        unit: &'static str,
    },
    /// The time step is rounded, so that the error of the times grows.
    RoundedStep {
        /// Step in the file, s.
        interval: f64,
        /// Frame rate, 1/s.
        rate: f64,
    },
    /// A column was computed from another one by finite differences.
    Derived {
        /// The column.
        column: String,
        /// Column from which it was computed.
        of: String,
        /// Formula of the finite differences.
        stencil: Stencil,
        /// Factor by which the result is too small at the frequency of this record; `None` if unknown.
        attenuation: Option<f64>,
    },
}

impl Finding {
    /// Finding as one or two sentences in English or Spanish.
    pub fn text(&self, language: Language) -> String {
        match self {
            Self::Sheet(name) => {
                say!(language, "the workbook has several sheets; the first with a table was read: `{name}`")
            }
            Self::Project(remark) => remark.text(language),
            Self::DataSets(remark) => remark.text(language),
            Self::Device(remark) => remark.text(language),
            Self::Json(left_out) => json(left_out, language),
            Self::Markup { markup, others: 0 } => say!(language, "the table was read from {}", markup.name()),
            Self::Markup { markup, others } => say!(
                language,
                "the table was read from {}: the one with the most cells; other tables left out: {others}",
                markup.name()
            ),
            Self::Labelled { left_out: 0 } => {
                language.say("the names before the numbers of each line became the heads of the columns").to_owned()
            }
            Self::Labelled { left_out } => say!(
                language,
                "the names before the numbers of each line became the heads of the columns; lines with other names or none, left out: {left_out}"
            ),
            Self::Nuls(count) => nuls(*count, language),
            Self::Overflow { column, bits, count } => overflow(column, *bits, *count, language),
            Self::Word { line, column, text } => word(*line, column, text, language),
            Self::MoreWords(count) => say!(language, "{count} more cells are not numbers and became gaps"),
            Self::WordLines { line, count: 1 } => say!(language, "line {line} has no number and was passed over"),
            Self::WordLines { line, count } => {
                say!(language, "{count} lines have no number and were passed over; the first is line {line}")
            }
            Self::OtherHeader { line, count: 1 } => say!(
                language,
                "a second header stands in line {line}: the rows below it are read with its names and units"
            ),
            Self::OtherHeader { line, count } => say!(
                language,
                "{count} further headers stand between the rows, the first in line {line}: the rows below each are read with its names and units"
            ),
            Self::WordColumn(column) => say!(language, "column {column} holds words and was left out"),
            Self::EmptyColumn(column) => {
                say!(language, "column {column} is empty")
            }
            Self::ExtraCells { line, count } => say!(
                language,
                "{count} rows are longer than the others, the first in line {line}; the cells beyond were left out"
            ),
            Self::Heading(heading) => heading.text(language),
            Self::UnknownUnit { column, unit } => say!(
                language,
                "`{unit}`, the unit of {column}, is not known; until one is stated, its numbers have none"
            ),
            Self::Separator { line, text, beside, thousands } => separator(*line, text, beside, *thousands, language),
            Self::DecimalSign { line, text } => {
                let [decimal, thousands] = readings(text, language);
                say!(
                    language,
                    "line {line}: the comma of `{text}` is taken for a decimal sign: {decimal}, not {thousands}"
                )
            }
            Self::GroupSign { line, text } => {
                let [decimal, thousands] = readings(text, language);
                say!(
                    language,
                    "line {line}: `{text}` is read as {thousands} and not as {decimal}, as other numbers of the file have the other sign for their decimals"
                )
            }
            Self::OtherSign { column, point } => {
                let column = called(column, language);
                if *point {
                    say!(
                        language,
                        "{column} has a decimal point, other columns have a decimal comma; each is read with its own sign"
                    )
                } else {
                    say!(
                        language,
                        "{column} has a decimal comma, other columns have a decimal point; each is read with its own sign"
                    )
                }
            }
            Self::Clock { column, days, wrapped, minutes, month_first } => {
                clock(column, (*days, *wrapped, *minutes, *month_first), language)
            }
            Self::SerialDays(column) => {
                let column = called(column, language);
                say!(
                    language,
                    "{column} holds the serial days of a spreadsheet; they are read as seconds from the first row"
                )
            }
            Self::Notation { line, column, text, value } => {
                let column = called(column, language);
                say!(language, "line {line}, {column}: `{text}` is read as {value}, and other cells like it likewise")
            }
            Self::Stamps { unit } => say!(
                language,
                "each line has a time stamp; the column behind it shows the same times in {unit} and is used instead, as \
                     it was not delayed on the way"
            ),
            Self::Runs(names) => runs(names, language),
            Self::Labels { column, runs } => labels(column, runs, language),
            Self::Role(remark) => remark.text(language),
            Self::AssumedSeconds(column) => {
                let column = called(column, language);
                say!(
                    language,
                    "no unit is stated for the times of {column}: they are taken for seconds, or in a fit for the unit of \
                         the model's time; the header `t [ms]` states one"
                )
            }
            Self::NoTimes(column) => {
                let column = called(column, language);
                say!(
                    language,
                    "the times in {column} are missing or all the same: nothing can be measured against them"
                )
            }
            Self::Scale(error) => {
                let percent = decimal(100.0 * error, 2, language);
                say!(
                    language,
                    "all lengths share the standard error of the film's scale, {percent} %, which fits take into account"
                )
            }
            Self::Missing { gaps, unit } => missing(gaps, unit, language),
            Self::Doubled { time, unit, count: 1 } => {
                say!(language, "the time {} stands twice", reading(*time, unit, language))
            }
            Self::Doubled { time, unit, count } => say!(
                language,
                "{count} rows repeat the time of the row before, the first at {}",
                reading(*time, unit, language)
            ),
            Self::Repeated { columns, count, of } => repeated(columns, *count, *of, language),
            Self::Backwards { time, unit, count } => backwards(*time, unit, *count, language),
            Self::Uneven(jitter) => say!(
                language,
                "the rows are unevenly spaced: their distances vary by {} %",
                decimal(100.0 * jitter, 2, language)
            ),
            Self::RoundedTimes { to, unit } => {
                say!(language, "the times are rounded to {}", reading(*to, unit, language))
            }
            Self::RoundedStep { interval, rate } => rounded_step(*interval, *rate, language),
            Self::Derived { column, of, stencil, attenuation } => {
                let numbered = of.bytes().all(|byte| byte.is_ascii_digit());
                let formula = stencil.formula(if numbered { "x" } else { of });
                let (column, of) = (called(column, language), called(of, language));
                let made =
                    say!(language, "{column} was computed from {of}, {formula}: it adds no independent information");
                let Some(factor) = attenuation else { return made };
                let percent = decimal(100.0 * (1.0 - factor), 2, language);
                made + &say!(language, "; at the frequency of this record that makes it too small by {percent} %")
            }
        }
    }
}

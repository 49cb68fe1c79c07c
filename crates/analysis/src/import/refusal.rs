//! Errors of the import of a file as a table.

use super::program::Program;
use super::times::date::DateOrder;
use crate::finding::readings;
use std::fmt;
use units::{Language, Words, say};

/// Reason why a file was not read, with its line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ImportError {
    /// Line, from 1; `None` if the error belongs to no line.
    pub line: Option<usize>,
    /// The reason.
    pub reason: Refusal,
}

/// Reason why a file was not read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// The file is empty.
    Empty,
    /// The file is of a known type that is not text, such as a ZIP archive.
    Kind {
        /// Name of the type.
        name: Words,
    },
    /// The file contains bytes that do not occur in text.
    Binary,
    /// The file is XML, and not a Tracker project, or HTML without a table.
    Markup,
    /// The file is one of a program that can export text.
    Program(Program),
    /// The file is JSON without a table.
    Json,
    /// No line contains a number.
    NoNumbers {
        /// First line.
        text: String,
    },
    /// Each line contains only one number.
    OneColumn,
    /// There are fewer than two rows.
    FewRows,
    /// A comma or a point is ambiguous: decimal sign or separator of groups of digits.
    Separator {
        /// Column, from 1.
        column: usize,
        /// Number with the sign: `1,295`.
        text: String,
        /// Number without it in the same column: `926`.
        beside: String,
    },
    /// A column is named as a time, and none of its cells can be read as one.
    Times {
        /// Name of the column.
        column: String,
        /// Text of its first cell.
        text: String,
    },
    /// Day and month cannot be told apart in the dates of a column.
    Dates {
        /// Name of the column.
        column: String,
    },
    /// A date has another order than the stated one.
    OtherOrder {
        /// The date.
        date: String,
        /// The stated order.
        order: DateOrder,
    },
    /// More than a tenth of the cells of a column hold digits and cannot be read.
    Unread {
        /// Name of the column.
        column: String,
        /// Text of the first.
        text: String,
        /// Number of these cells.
        count: usize,
        /// Number of cells of the column.
        cells: usize,
    },
    /// More than a tenth of the lines between the rows hold numbers and cannot be read.
    UnreadLines {
        /// Number of these lines.
        count: usize,
        /// Number of rows.
        rows: usize,
    },
    /// Commas are both delimiters and decimal signs.
    Commas {
        /// Number of names in the header.
        names: usize,
        /// Number of numbers in a row.
        cells: usize,
    },
    /// No line has two numbers; this cell beside a number is not one.
    Cell {
        /// Column, from 1.
        column: usize,
        /// Text of the cell.
        text: String,
    },
    /// The rows contain more words than numbers.
    Words {
        /// Column of the first word, from 1.
        column: usize,
        /// Text of the word.
        text: String,
    },
}

impl ImportError {
    pub(super) fn new(line: Option<usize>, reason: Refusal) -> Self {
        Self { line, reason }
    }

    /// Message for users: the line, and what is wrong.
    pub fn message(&self, language: Language) -> String {
        let text = match &self.reason {
            Refusal::Empty => language.say("the file is empty").to_owned(),
            // The beginning of the file says it, and no line.
            Refusal::Kind { name } => return say!(language, "this is not text but {name}"),
            Refusal::Binary => language.say("this is not text: it has bytes that no text has").to_owned(),
            Refusal::Markup => language.say("this is XML, or HTML without a table").to_owned(),
            Refusal::Program(program) => {
                return say!(language, "this is a file of {}, which only that program reads", program.name());
            }
            Refusal::Json => language
                .say("this is JSON without a table: neither a list of records nor lists of numbers of one length")
                .to_owned(),
            Refusal::NoNumbers { text } => {
                say!(language, "there is no table: no line has numbers; the first is `{text}`")
            }
            Refusal::OneColumn => language
                .say("there is only one column of numbers; a measurement needs the time and a quantity")
                .to_owned(),
            Refusal::FewRows => language.say("there are fewer than two rows of numbers").to_owned(),
            Refusal::Separator { column, text, beside } => {
                let [decimal, thousands] = readings(text, language);
                say!(
                    language,
                    "column {column}: `{text}` can be {decimal} or {thousands}, as `{beside}` stands in the same column"
                )
            }
            Refusal::Times { column, text } => {
                say!(language, "the times in column {column} cannot be read; the first is `{text}`")
            }
            Refusal::Dates { column } => say!(
                language,
                "the dates in column {column} can have the day first or the month first, and nothing in the file decides"
            ),
            Refusal::OtherOrder { date, order: DateOrder::DayFirst } => {
                say!(language, "`{date}` has the month first, and the stated order is the day first")
            }
            Refusal::OtherOrder { date, order: DateOrder::MonthFirst } => {
                say!(language, "`{date}` has the day first, and the stated order is the month first")
            }
            Refusal::Unread { column, text, count, cells } => say!(
                language,
                "{count} of {cells} cells of column {column} cannot be read as numbers; the first is `{text}`"
            ),
            Refusal::UnreadLines { count, rows } => {
                say!(language, "{count} lines between the {rows} rows hold digits and cannot be read")
            }
            Refusal::Commas { names, cells } => say!(
                language,
                "{cells} numbers for {names} names: the comma seems to be both delimiter and decimal sign"
            ),
            Refusal::Cell { column, text } => {
                say!(language, "column {column}: `{text}` is not a number, and no line has two numbers")
            }
            Refusal::Words { column, text } => {
                say!(language, "`{text}` in column {column} is not a number, and there are more words than numbers")
            }
        };
        match self.line {
            Some(line) => say!(language, "line {line}: {text}"),
            None => text,
        }
    }

    /// Advice for users.
    pub fn hint(&self, language: Language) -> &'static str {
        match &self.reason {
            Refusal::Program(program) => program.export(language),
            Refusal::Json => language.say("write a list of records, `[{\"t\": 0, \"x\": 1}, …]`, or lists by name, `{\"t\": […], \"x\": […]}`"),
            Refusal::Commas { .. } => language.say("export it again with tabs or semicolons between the columns"),
            Refusal::Separator { .. } => language.say("export it again without signs between the thousands"),
            Refusal::Dates { .. } => language.say("state the order with --dates day-first or --dates month-first, or write the dates as 2026-01-02"),
            Refusal::OtherOrder { .. } => language.say("state the other order, or write this date as 2026-01-02"),
            Refusal::Unread { .. } | Refusal::UnreadLines { .. } => language.say("write plain numbers into these cells, or leave them empty"),
            Refusal::Times { .. } => language.say("write the times as numbers, or as 10:00:00.050 or 2026-01-02T10:00:00.050"),
            Refusal::Empty | Refusal::Kind { .. } | Refusal::Binary | Refusal::Markup => language.say("export the table as text: in Tracker, File > Export > Data File; in a spreadsheet, save as CSV"),
            _ => language.say("a table has one row a line: the time, then one or more quantities, with tabs, commas, semicolons or blanks between"),
        }
    }
}

impl fmt::Display for ImportError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.message(Language::English))
    }
}

impl std::error::Error for ImportError {}

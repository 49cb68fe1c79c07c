//! Origin of a column: its place in the file, its unit and its role.

use crate::conversion::Conversion;
use units::{Language, say};

/// Origin of a column in its file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Origin {
    /// Text of the header cell, `Time (ms) Run #1`; empty without one.
    pub heading: String,
    /// Source of its unit.
    pub unit: UnitOrigin,
    /// Conversion of the numbers of the cells; `None` if they are the values.
    pub conversion: Option<Conversion>,
    /// Number of cells that hold a word instead of a number; each became a gap.
    pub words: usize,
    /// Line and text of the first of these words.
    pub first_word: Option<(usize, String)>,
    /// Number of the column in the file, from 1, counting columns of words too; 0 for a column that is not from a file.
    pub number: usize,
    /// Role, with its reason.
    pub role: Role,
}

/// Role of a column in its table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Role {
    /// Measured quantity, or a property of one.
    #[default]
    Measured,
    /// Independent variable of other columns.
    Independent(Reason),
    /// Number of a row or frame; no column is measured against it.
    Counter,
}

/// Reason why a column is an independent variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// Its name is that of a time.
    Name,
    /// It has a unit of time.
    Unit,
    /// It is the first column.
    First,
    /// It increases or decreases strictly, and the column before it numbers the rows.
    Increases,
    /// No other column can be the independent variable.
    Alone,
    /// The document has an independent variable of this name or unit.
    Document,
    /// The user has chosen it.
    Person,
}

impl Role {
    /// Role in a few words, in English or Spanish; empty for a measured quantity.
    pub fn text(self, language: Language) -> &'static str {
        let reason = match self {
            Self::Measured => return "",
            Self::Counter => return language.say("counts the rows"),
            Self::Independent(reason) => reason,
        };
        match reason {
            Reason::Name => language.say("independent: named as a time"),
            Reason::Unit => language.say("independent: in a unit of time"),
            Reason::First => language.say("independent: the first column"),
            Reason::Increases => language.say("independent: increases or decreases throughout"),
            Reason::Alone => language.say("independent: nothing else can be it"),
            Reason::Document => language.say("independent: that of the document"),
            Reason::Person => language.say("independent: chosen by you"),
        }
    }
}

/// Source of the unit of a column.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum UnitOrigin {
    /// The file states none.
    #[default]
    NotStated,
    /// The header states this text, which is not a known unit.
    Unknown(String),
    /// In the place of a unit is this text in parentheses, which is not a known unit and may be a remark: `y (left)`.
    Remark(String),
    /// Header cell: `t [ms]`, `t (ms)`, `t / ms`, `t in ms`, `Time: ms`.
    Heading,
    /// Line of units below the names.
    UnitLine,
    /// End of the name: `time_ms`.
    Suffix,
    /// Whole name: `millis`.
    Name,
    /// Cells: `12.3 cm`.
    Cells,
    /// Cells with times of day or dates, read as seconds.
    Clock,
    /// Another column that shows the same times in a known unit.
    Compared,
    /// The user.
    Person,
    /// Stated nowhere: it is assumed for the theories.
    Assumed,
}

impl UnitOrigin {
    /// Source in a few words, in English or Spanish.
    pub fn text(&self, language: Language) -> String {
        let text = match self {
            Self::NotStated => language.say("no unit stated"),
            Self::Unknown(text) | Self::Remark(text) => return say!(language, "unknown unit: `{text}`"),
            Self::Heading => language.say("from the header"),
            Self::UnitLine => language.say("from the line of units"),
            Self::Suffix => language.say("from the end of the name"),
            Self::Name => language.say("from the name"),
            Self::Cells => language.say("from the cells"),
            Self::Clock => language.say("clock times, in seconds from the first row"),
            Self::Compared => language.say("from the time stamps beside it"),
            Self::Person => language.say("stated by you"),
            Self::Assumed => language.say("assumed: the file states none"),
        };
        text.to_owned()
    }

    /// True if the file or the user states the unit.
    pub fn is_stated(&self) -> bool {
        !matches!(self, Self::NotStated | Self::Unknown(_) | Self::Remark(_) | Self::Assumed)
    }

    /// Text in the place of the unit that is not a known unit.
    pub fn unknown(&self) -> Option<&str> {
        match self {
            Self::Unknown(text) | Self::Remark(text) => Some(text),
            _ => None,
        }
    }

    /// Short name for programs.
    pub fn code(&self) -> &'static str {
        match self {
            Self::NotStated => "not stated",
            Self::Unknown(_) | Self::Remark(_) => "unknown",
            Self::Heading => "header",
            Self::UnitLine => "line of units",
            Self::Suffix => "end of the name",
            Self::Name => "name",
            Self::Cells => "cells",
            Self::Clock => "clock",
            Self::Compared => "time stamps",
            Self::Person => "stated",
            Self::Assumed => "assumed",
        }
    }
}

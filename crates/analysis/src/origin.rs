//! Where what is known of a column comes from.

use crate::conversion::Conversion;
use units::Language::{self, Spanish};

/// How a column stood in its file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Origin {
    /// The cell of the header as it is written, `Time (ms) Run #1`; empty without one.
    pub heading: String,
    /// Where its unit comes from.
    pub unit: UnitOrigin,
    /// What the numbers of the cells were converted by, if they are not the values.
    pub conversion: Option<Conversion>,
    /// How many cells hold a word instead of a number; each became a gap.
    pub words: usize,
    /// The first of these words, and its line.
    pub first_word: Option<(usize, String)>,
    /// Which column of the file it is, from 1, counting also those of words; 0 for what is in no file.
    pub number: usize,
    /// Its role, and what has decided it.
    pub role: Role,
}

/// The role of a column in its table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Role {
    /// A measured quantity, or something about one.
    #[default]
    Measured,
    /// The independent variable of other columns.
    Independent(Reason),
    /// It numbers rows or frames, and nothing is measured against it.
    Counter,
}

/// The reason why a column is an independent variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// It is called a time.
    Name,
    /// It is in a unit of time.
    Unit,
    /// It comes first.
    First,
    /// It increases or decreases throughout, and the column before it numbers the rows.
    Increases,
    /// Nothing else can be it.
    Alone,
    /// The document has an independent variable of this name or unit.
    Document,
    /// A person has chosen it.
    Person,
}

impl Role {
    /// It in a few words, in English or Spanish; empty for a measured quantity.
    pub fn text(self, language: Language) -> &'static str {
        let reason = match self {
            Self::Measured => return "",
            Self::Counter => return language.pick("counts the rows", "cuenta las filas"),
            Self::Independent(reason) => reason,
        };
        match reason {
            Reason::Name => language.pick("independent: named as a time", "independiente: se llama como un tiempo"),
            Reason::Unit => language.pick("independent: in a unit of time", "independiente: en una unidad de tiempo"),
            Reason::First => language.pick("independent: the first column", "independiente: la primera columna"),
            Reason::Increases => language
                .pick("independent: increases or decreases throughout", "independiente: crece o decrece siempre"),
            Reason::Alone => language.pick("independent: nothing else can be it", "independiente: no puede serlo otra"),
            Reason::Document => language.pick("independent: that of the document", "independiente: la del documento"),
            Reason::Person => language.pick("independent: chosen by you", "independiente: elegida por ti"),
        }
    }
}

/// Where the unit of a column comes from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum UnitOrigin {
    /// The file states none.
    #[default]
    NotStated,
    /// The header states this, and it is not a known unit.
    Unknown(String),
    /// In the place of a unit stands this, in parentheses; it is not a known unit and may be a remark: `y (left)`.
    Remark(String),
    /// Beside the name: `t [ms]`, `t (ms)`, `t / ms`, `t in ms`, `Time: ms`.
    Heading,
    /// A line of units under the names.
    UnitLine,
    /// The end of the name: `time_ms`.
    Suffix,
    /// The name itself: `millis`.
    Name,
    /// The cells: `12.3 cm`.
    Cells,
    /// The cells hold times of day or dates, which are read as seconds.
    Clock,
    /// It follows from another column, which shows the same time in a known unit.
    Compared,
    /// A person has stated it.
    Person,
}

impl UnitOrigin {
    /// It in a few words, in English or Spanish.
    pub fn text(&self, language: Language) -> String {
        let (english, other) = match self {
            Self::NotStated => ("no unit stated", "sin unidad indicada"),
            Self::Unknown(text) | Self::Remark(text) if language == Spanish => {
                return format!("unidad desconocida: «{text}»");
            }
            Self::Unknown(text) | Self::Remark(text) => return format!("unknown unit: `{text}`"),
            Self::Heading => ("from the header", "del encabezado"),
            Self::UnitLine => ("from the line of units", "de la línea de unidades"),
            Self::Suffix => ("from the end of the name", "del final del nombre"),
            Self::Name => ("from the name", "del nombre"),
            Self::Cells => ("from the cells", "de las celdas"),
            Self::Clock => ("clock times, in seconds from the first row", "horas, en segundos desde la primera fila"),
            Self::Compared => ("from the time stamps beside it", "de las marcas de tiempo a su lado"),
            Self::Person => ("stated by you", "indicada por ti"),
        };
        (if language == Spanish { other } else { english }).to_owned()
    }

    /// Whether the file, or a person, says what the unit is.
    pub fn is_stated(&self) -> bool {
        !matches!(self, Self::NotStated | Self::Unknown(_) | Self::Remark(_))
    }

    /// What stands in the place of the unit and is not a known one.
    pub fn unknown(&self) -> Option<&str> {
        match self {
            Self::Unknown(text) | Self::Remark(text) => Some(text),
            _ => None,
        }
    }

    /// A name for programs.
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
        }
    }
}

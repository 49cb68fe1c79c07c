//! Errors of reading a workbook.

use crate::import::Program;
use packed::Defect;
use units::{Language, say};

/// Reason why a workbook was not read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum WorkbookError {
    /// The file is not an archive, or a part is truncated, changed or contradicts the directory.
    Damaged,
    /// The workbook needs a password.
    Protected,
    /// The file is an archive without a sheet or a table.
    NoSheets {
        /// Names of its first few files.
        found: Vec<String>,
    },
    /// The archive is a file of a program that can export text.
    Program(Program),
    /// The workbook has no sheet with cells, or the file is a text document or a presentation.
    NoCells,
    /// The workbook was written by Excel 4 or older.
    TooOld,
    /// A part would expand too much.
    Expands {
        /// Size in the file, in bytes.
        packed: u64,
        /// Expanded size, in bytes.
        expanded: u64,
    },
    /// A cell lies beyond the limits of a sheet, or is not in the order of rows and columns.
    Place {
        /// Reference of the cell in the sheet.
        cell: String,
    },
    /// A sheet, or the shared texts of the workbook, exceed the limit.
    TooLarge {
        /// Limit, in megabytes.
        most: usize,
    },
}

impl WorkbookError {
    /// Message for users.
    pub fn message(&self, language: Language) -> String {
        match self {
            Self::Damaged => language.say("the workbook is damaged or incomplete").to_owned(),
            Self::Protected => language.say("the workbook is protected by a password").to_owned(),
            Self::NoSheets { found } if found.is_empty() => language.say("this is an empty ZIP archive").to_owned(),
            Self::NoSheets { found } => {
                let names: Vec<String> = found.iter().map(|name| say!(language, "`{name}`")).collect();
                say!(language, "this ZIP archive holds no spreadsheet and no table, but {}", names.join(", "))
            }
            Self::Program(program) => {
                say!(language, "this is a file of {}, which only that program reads", program.name())
            }
            Self::NoCells => language.say("this is an Office file without a sheet of cells").to_owned(),
            Self::TooOld => {
                language.say("the workbook is of a format before Excel 5 (1993), which is not read").to_owned()
            }
            Self::Expands { packed, expanded } => {
                let (packed, expanded) = (size(*packed), size(*expanded));
                say!(language, "{packed} of the workbook would expand to {expanded}, more than a measurement needs")
            }
            Self::Place { cell } => say!(
                language,
                "the sheet has a cell `{cell}` that is out of order or beyond 1048576 rows and 16384 columns"
            ),
            Self::TooLarge { most } => say!(language, "the sheet holds more than {most} MB of text and numbers"),
        }
    }

    /// Advice for users.
    pub fn hint(&self, language: Language) -> &'static str {
        match self {
            Self::Damaged | Self::Place { .. } | Self::TooOld => language.say("open it in the spreadsheet program and save it again, or save the sheet as CSV"),
            Self::Protected => language.say("save it without a password, or save the sheet as CSV"),
            Self::NoSheets { .. } | Self::NoCells => language.say("measured data can be text, XLSX, ODS, a ZIP archive of text files as phyphox writes it, or a project of Tracker (TRK, TRZ)"),
            Self::Program(program) => program.export(language),
            Self::Expands { .. } | Self::TooLarge { .. } => language.say("save the sheet with the measurement alone, or save it as CSV"),
        }
    }
}

impl From<Defect> for WorkbookError {
    fn from(defect: Defect) -> Self {
        match defect {
            Defect::Damaged => Self::Damaged,
            Defect::Protected => Self::Protected,
            Defect::Expands { packed, expanded } => Self::Expands { packed, expanded },
        }
    }
}

/// Number of bytes, formatted for users.
fn size(bytes: u64) -> String {
    match bytes {
        0..10_000 => format!("{bytes} B"),
        10_000..10_000_000 => format!("{} kB", bytes / 1000),
        _ => format!("{} MB", bytes / 1_000_000),
    }
}

//! Errors of reading a workbook.

use crate::packed::Defect;
use units::Language::{self, English, Spanish};

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
        let say = |english: &str, other: &str| (if language == Spanish { other } else { english }).to_owned();
        match self {
            Self::Damaged => say("the workbook is damaged or incomplete", "el libro está dañado o incompleto"),
            Self::Protected => say("the workbook is protected by a password", "el libro está protegido por contraseña"),
            Self::NoSheets { found } if found.is_empty() => {
                say("this is an empty ZIP archive", "es un archivo ZIP vacío")
            }
            Self::NoSheets { found } => {
                let list = |open: &str, close: &str| {
                    let names: Vec<String> = found.iter().map(|name| format!("{open}{name}{close}")).collect();
                    names.join(", ")
                };
                say(
                    &format!("this ZIP archive holds no spreadsheet and no table, but {}", list("`", "`")),
                    &format!("este archivo ZIP no contiene hojas de cálculo ni tablas, sino {}", list("«", "»")),
                )
            }
            Self::NoCells => {
                say("this is an Office file without a sheet of cells", "es un archivo de Office sin hojas con celdas")
            }
            Self::TooOld => say(
                "the workbook is of a format before Excel 5 (1993), which is not read",
                "el libro tiene un formato anterior a Excel 5 (1993), que no se lee",
            ),
            Self::Expands { packed, expanded } => {
                let (packed, expanded) = (size(*packed), size(*expanded));
                say(
                    &format!("{packed} of the workbook would expand to {expanded}, more than a measurement needs"),
                    &format!("{packed} del libro se convertirían en {expanded}, más de lo que necesita una medición"),
                )
            }
            Self::Place { cell } => say(
                &format!("the sheet has a cell `{cell}` that is out of order or beyond 1048576 rows and 16384 columns"),
                &format!(
                    "la hoja tiene una celda «{cell}» fuera de orden o más allá de 1048576 filas y 16384 columnas"
                ),
            ),
            Self::TooLarge { most } => say(
                &format!("the sheet holds more than {most} MB of text and numbers"),
                &format!("la hoja contiene más de {most} MB de texto y números"),
            ),
        }
    }

    /// Advice for users.
    pub fn hint(&self, language: Language) -> &'static str {
        match (self, language) {
            (Self::Damaged | Self::Place { .. } | Self::TooOld, English) => {
                "open it in the spreadsheet program and save it again, or save the sheet as CSV"
            }
            (Self::Damaged | Self::Place { .. } | Self::TooOld, Spanish) => {
                "ábrelo en la hoja de cálculo y guárdalo de nuevo, o guarda la hoja como CSV"
            }
            (Self::Protected, English) => "save it without a password, or save the sheet as CSV",
            (Self::Protected, Spanish) => "guárdalo sin contraseña, o guarda la hoja como CSV",
            (Self::NoSheets { .. } | Self::NoCells, English) => {
                "measured data can be text, XLSX, ODS, a ZIP archive of text files as phyphox writes it, or a project of Tracker (TRK, TRZ)"
            }
            (Self::NoSheets { .. } | Self::NoCells, Spanish) => {
                "los datos pueden ser texto, XLSX, ODS, un archivo ZIP de textos como los de phyphox o un proyecto de Tracker (TRK, TRZ)"
            }
            (Self::Expands { .. } | Self::TooLarge { .. }, English) => {
                "save the sheet with the measurement alone, or save it as CSV"
            }
            (Self::Expands { .. } | Self::TooLarge { .. }, Spanish) => {
                "guarda solo la hoja de la medición, o guárdala como CSV"
            }
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

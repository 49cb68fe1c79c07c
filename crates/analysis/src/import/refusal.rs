//! Errors of the import of a file as a table.

use crate::finding::readings;
use std::fmt;
use units::Language::{self, English, Spanish};

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
        /// Name of the type in English.
        english: &'static str,
        /// Name of the type in Spanish.
        spanish: &'static str,
    },
    /// The file contains bytes that do not occur in text.
    Binary,
    /// The file is XML or HTML, and not a Tracker project.
    Markup,
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
        let at = |text: String| match (self.line, language) {
            (Some(line), English) => format!("line {line}: {text}"),
            (Some(line), Spanish) => format!("línea {line}: {text}"),
            (None, _) => text,
        };
        let say = |english: &str, other: &str| at((if language == Spanish { other } else { english }).to_owned());
        match &self.reason {
            Refusal::Empty => say("the file is empty", "el archivo está vacío"),
            Refusal::Kind { english, spanish: other } if language == Spanish => format!("no es texto, sino {other}"),
            Refusal::Kind { english, .. } => format!("this is not text but {english}"),
            Refusal::Binary => say(
                "this is not text: it has bytes that no text has",
                "no es texto: tiene bytes que ningún texto tiene",
            ),
            Refusal::Markup => say("this is XML or HTML, not a table", "esto es XML o HTML, no una tabla"),
            Refusal::NoNumbers { text } if language == Spanish => {
                at(format!("no hay tabla: ninguna línea tiene números; la primera es «{text}»"))
            }
            Refusal::NoNumbers { text } => at(format!("there is no table: no line has numbers; the first is `{text}`")),
            Refusal::OneColumn => say(
                "there is only one column of numbers; a measurement needs the time and a quantity",
                "solo hay una columna de números; una medición necesita el tiempo y una magnitud",
            ),
            Refusal::FewRows => say("there are fewer than two rows of numbers", "hay menos de dos filas de números"),
            Refusal::Separator { column, text, beside } => {
                let [decimal, thousands] = readings(text, language);
                at(if language == Spanish {
                    format!(
                        "columna {column}: «{text}» puede ser {decimal} o {thousands}, pues en la misma columna está «{beside}»"
                    )
                } else {
                    format!(
                        "column {column}: `{text}` can be {decimal} or {thousands}, as `{beside}` stands in the same column"
                    )
                })
            }
            Refusal::Times { column, text } if language == Spanish => {
                at(format!("los tiempos de la columna {column} no se entienden; el primero es «{text}»"))
            }
            Refusal::Times { column, text } => {
                at(format!("the times in column {column} cannot be read; the first is `{text}`"))
            }
            Refusal::Commas { names, cells } if language == Spanish => at(format!(
                "{cells} números para {names} nombres: la coma parece ser a la vez separador y signo decimal"
            )),
            Refusal::Commas { names, cells } => {
                at(format!("{cells} numbers for {names} names: the comma seems to be both delimiter and decimal sign"))
            }
            Refusal::Cell { column, text } if language == Spanish => {
                at(format!("columna {column}: «{text}» no es un número, y ninguna línea tiene dos números"))
            }
            Refusal::Cell { column, text } => {
                at(format!("column {column}: `{text}` is not a number, and no line has two numbers"))
            }
            Refusal::Words { column, text } if language == Spanish => {
                at(format!("«{text}» en la columna {column} no es un número, y hay más palabras que números"))
            }
            Refusal::Words { column, text } => {
                at(format!("`{text}` in column {column} is not a number, and there are more words than numbers"))
            }
        }
    }

    /// Advice for users.
    pub fn hint(&self, language: Language) -> &'static str {
        match (&self.reason, language) {
            (Refusal::Commas { .. }, English) => "export it again with tabs or semicolons between the columns",
            (Refusal::Commas { .. }, Spanish) => {
                "expórtalo de nuevo con tabuladores o puntos y comas entre las columnas"
            }
            (Refusal::Separator { .. }, English) => "export it again without signs between the thousands",
            (Refusal::Separator { .. }, Spanish) => "expórtalo de nuevo sin signos entre los millares",
            (Refusal::Times { .. }, English) => {
                "write the times as numbers, or as 10:00:00.050 or 2026-01-02T10:00:00.050"
            }
            (Refusal::Times { .. }, Spanish) => {
                "escribe los tiempos como números, o como 10:00:00.050 o 2026-01-02T10:00:00.050"
            }
            (Refusal::Empty | Refusal::Kind { .. } | Refusal::Binary | Refusal::Markup, English) => {
                "export the table as text: in Tracker, File > Export > Data File; in a spreadsheet, save as CSV"
            }
            (Refusal::Empty | Refusal::Kind { .. } | Refusal::Binary | Refusal::Markup, Spanish) => {
                "exporta la tabla como texto: en Tracker, Archivo > Exportar > Archivo de datos; en una hoja de cálculo, guarda como CSV"
            }
            (_, English) => {
                "a table has one row a line: the time, then one or more quantities, with tabs, commas, semicolons or blanks between"
            }
            (_, Spanish) => {
                "una tabla tiene una fila por línea: el tiempo y luego una o más magnitudes, con tabuladores, comas, puntos y comas o espacios entre ellas"
            }
        }
    }
}

impl fmt::Display for ImportError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.message(English))
    }
}

impl std::error::Error for ImportError {}

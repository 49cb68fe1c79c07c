//! Why a file cannot be read as a table.

use crate::finding::readings;
use std::fmt;
use units::Language::{self, English, Spanish};

/// Why a file was not read. Nothing of it is lost: it was not touched.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ImportError {
    /// The line, from 1, where there is one to show.
    pub line: Option<usize>,
    /// The reason.
    pub reason: Refusal,
}

/// The reasons.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// There is nothing in it.
    Empty,
    /// It is of a kind that is known, and not text: `a ZIP archive (XLSX, ODS, TRZ)`.
    Kind {
        /// In English.
        english: &'static str,
        /// In Spanish.
        spanish: &'static str,
    },
    /// It contains bytes that no text has.
    Binary,
    /// It is XML or HTML, and no project of Tracker.
    Markup,
    /// No line has a number.
    NoNumbers {
        /// The first line.
        text: String,
    },
    /// Each line has one number only.
    OneColumn,
    /// There are fewer than two rows.
    FewRows,
    /// A comma or a point can be a decimal sign or group digits.
    Separator {
        /// The column, from 1.
        column: usize,
        /// A number with it: `1,295`.
        text: String,
        /// One without it in the same column: `926`.
        beside: String,
    },
    /// A column is called a time, and none of its cells can be read as one.
    Times {
        /// Its name.
        column: String,
        /// What stands in the first cell.
        text: String,
    },
    /// Commas stand between the cells and are decimal signs too.
    Commas {
        /// How many names the header has.
        names: usize,
        /// How many numbers the row has.
        cells: usize,
    },
    /// No line has two numbers; this cell beside a number is none.
    Cell {
        /// The column, from 1.
        column: usize,
        /// What stands there.
        text: String,
    },
    /// More words than numbers among the data.
    Words {
        /// The column of the first word, from 1.
        column: usize,
        /// The word.
        text: String,
    },
}

impl ImportError {
    pub(super) fn new(line: Option<usize>, reason: Refusal) -> Self {
        Self { line, reason }
    }

    /// What is wrong, where and why.
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

    /// What to do.
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

//! The one writer of CSV: cells for programs, and for spreadsheets of both kinds.

use std::fmt::{self, Write};
use units::number::shortest;

/// How a CSV file is written. Numbers have the fewest digits that read back exactly; what is not finite is an empty cell.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dialect {
    /// Commas between the cells, decimal points, lines that end in `\n`: what programs in a pipe read.
    Lines,
    /// Commas between the cells, decimal points, lines that end in `\r\n`: RFC 4180.
    #[default]
    Commas,
    /// Semicolons between the cells, decimal commas, and a byte-order mark: what a spreadsheet opens correctly where the
    /// decimal sign is a comma.
    Semicolons,
}

impl Dialect {
    /// What a file begins with.
    pub fn start(self) -> &'static str {
        if self == Self::Semicolons { "\u{feff}" } else { "" }
    }

    /// What stands between two cells.
    pub fn separator(self) -> char {
        if self == Self::Semicolons { ';' } else { ',' }
    }

    /// What ends a line.
    pub fn line_end(self) -> &'static str {
        if self == Self::Lines { "\n" } else { "\r\n" }
    }

    /// Writes a number.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn number(self, out: &mut impl Write, value: f64) -> fmt::Result {
        let text = shortest(value);
        match self {
            Self::Lines => out.write_str(&text),
            Self::Commas => out.write_str(&text.replace('e', "E")),
            Self::Semicolons => out.write_str(&text.replace('e', "E").replace('.', ",")),
        }
    }

    /// Writes a text, in quotation marks where it needs them. A spreadsheet must not take a name for a formula.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn text(self, out: &mut impl Write, text: &str) -> fmt::Result {
        let guarded = text.starts_with(['=', '+', '-', '@', '\t', '\r']);
        let quoted = guarded || text.contains([',', '"', '\n', '\r']) || (self != Self::Lines && text.contains(';'));
        if !quoted {
            return out.write_str(text);
        }
        write!(out, "\"{}{}\"", if guarded { "'" } else { "" }, text.replace('"', "\"\""))
    }
}

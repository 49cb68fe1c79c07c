//! Writer for all CSV files: cells for programs and for spreadsheets.

use std::fmt::{self, Write};
use units::number::shortest;

/// CSV dialect. Numbers have the fewest digits that read back exactly; a value that is not finite is an empty cell.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dialect {
    /// Commas, decimal points and line ends `\n`: for programs in a pipe.
    Lines,
    /// Commas, decimal points and line ends `\r\n`: RFC 4180.
    #[default]
    Commas,
    /// Semicolons, decimal commas, line ends `\r\n` and a byte-order mark: for spreadsheets in regions
    /// with a decimal comma.
    Semicolons,
}

impl Dialect {
    /// Start of a file: the byte-order mark or nothing.
    pub fn start(self) -> &'static str {
        if self == Self::Semicolons { "\u{feff}" } else { "" }
    }

    /// Separator between two cells.
    pub fn separator(self) -> char {
        if self == Self::Semicolons { ';' } else { ',' }
    }

    /// End of a line.
    pub fn line_end(self) -> &'static str {
        if self == Self::Lines { "\n" } else { "\r\n" }
    }

    /// Writes a number; nothing if it is not finite.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn number(self, out: &mut impl Write, value: f64) -> fmt::Result {
        let text = shortest(value);
        match self {
            Self::Lines => out.write_str(&text),
            Self::Commas => out.write_str(&text.replace('e', "E")),
            Self::Semicolons => out.write_str(&text.replace('e', "E").replace('.', ",")),
        }
    }

    /// Writes a text, quoted if necessary. An apostrophe in front keeps a spreadsheet from taking it for a formula.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn text(self, out: &mut impl Write, text: &str) -> fmt::Result {
        let guarded = text.starts_with(['=', '+', '-', '@', '\t', '\r']);
        let quoted = guarded || text.contains([',', '"', '\n', '\r']) || (self != Self::Lines && text.contains(';'));
        if !quoted {
            return out.write_str(text);
        }
        write!(out, "\"{}{}\"", if guarded { "'" } else { "" }, text.replace('"', "\"\""))
    }
}

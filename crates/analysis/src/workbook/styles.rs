//! Number formats of Excel: recognition of dates, times and percentages.

use super::moment::Meaning;
use super::refusal::WorkbookError;
use crate::import;
use packed::{Token, Xml};
use std::collections::BTreeMap;

/// Upper bound of the cell formats; Excel allows 65490.
const MOST_STYLES: usize = 70_000;

/// Format in which a cell shows its number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum NumberFormat {
    /// Plain number, perhaps rounded.
    #[default]
    Plain,
    /// Multiplied by a hundred, with a percent sign.
    Percent,
    /// Date or time.
    Moment(Meaning),
    /// Number followed by a unit: `0.00" ms"`.
    Unit(UnitText),
}

impl NumberFormat {
    /// Format of a number from the text that its cell shows: with the unit behind the last digit, `3.1 ms`.
    pub fn shown(text: &str) -> Self {
        let behind =
            text.rsplit(|letter: char| letter.is_ascii_digit()).next().filter(|behind| behind.len() < text.len());
        behind.and_then(UnitText::of).map_or(Self::Plain, Self::Unit)
    }
}

/// Text of a unit in a number format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct UnitText {
    bytes: [u8; LONGEST_UNIT],
    length: usize,
}

/// Greatest length of a unit in a number format, in bytes.
const LONGEST_UNIT: usize = 12;

impl UnitText {
    /// Unit in the text behind the digits of a format; `None` if it is no known unit. A percent sign that multiplies nothing
    /// is left to the header.
    fn of(text: &str) -> Option<Self> {
        let text = text.trim();
        if text.is_empty() || text == "%" || text.len() > LONGEST_UNIT || !import::is_unit(text) {
            return None;
        }
        let mut bytes = [0; LONGEST_UNIT];
        bytes.get_mut(..text.len())?.copy_from_slice(text.as_bytes());
        Some(Self { bytes, length: text.len() })
    }

    pub fn text(&self) -> &str {
        self.bytes.get(..self.length).and_then(|bytes| core::str::from_utf8(bytes).ok()).unwrap_or_default()
    }
}

/// Formats of the cells of the workbook (`cellXfs`), in their order.
pub(super) fn read(mut xml: Xml) -> Result<Vec<NumberFormat>, WorkbookError> {
    let mut formats: BTreeMap<u32, NumberFormat> = BTreeMap::new();
    let mut styles = Vec::new();
    let mut in_cells = false;
    loop {
        match xml.next_token()? {
            Token::Open(tag) => match tag.name() {
                "cellXfs" => in_cells = true,
                "numFmt" if formats.len() < MOST_STYLES => {
                    let code = tag.attribute("formatCode").unwrap_or_default();
                    formats.extend(tag.number("numFmtId").map(|id| (id, of_code(&code))));
                }
                "xf" if in_cells && styles.len() < MOST_STYLES => {
                    let id = tag.number("numFmtId").unwrap_or(0);
                    styles.push(formats.get(&id).copied().unwrap_or_else(|| of_builtin(id)));
                }
                _ => {}
            },
            token if token.closes("cellXfs") => in_cells = false,
            Token::End => return Ok(styles),
            _ => {}
        }
    }
}

/// Built-in format of this id (ECMA-376, 18.8.30), including those of East Asia.
pub(super) fn of_builtin(id: u32) -> NumberFormat {
    match id {
        9 | 10 => NumberFormat::Percent,
        14..=17 | 22 | 27..=31 | 36 | 50..=58 => NumberFormat::Moment(Meaning::Date),
        18..=21 | 32..=35 | 45..=47 => NumberFormat::Moment(Meaning::Time),
        _ => NumberFormat::Plain,
    }
}

/// Format with a code such as `yyyy-mm-dd h:mm:ss` or `[h]:mm:ss;@`.
pub(super) fn of_code(code: &str) -> NumberFormat {
    let mut letters = String::new();
    // Literal text behind the digits.
    let mut behind = String::new();
    let mut rest = code.chars();
    while let Some(character) = rest.next() {
        match character {
            '"' => behind.extend(rest.by_ref().take_while(|next| *next != '"')),
            '\\' => behind.extend(rest.next()),
            // The next character gives a width or fills the cell.
            '_' | '*' => drop(rest.next()),
            '[' => {
                let inside: String = rest.by_ref().take_while(|next| *next != ']').collect();
                let elapsed =
                    |unit: char| !inside.is_empty() && inside.chars().all(|one| one.eq_ignore_ascii_case(&unit));
                if ['h', 'm', 's'].into_iter().any(elapsed) {
                    return NumberFormat::Moment(Meaning::Time);
                }
            }
            // The following sections are for other signs of the number.
            ';' => break,
            '0' | '#' | '?' => {
                letters.push(character);
                behind.clear();
            }
            _ => letters.extend(character.to_lowercase()),
        }
    }
    let letters = letters.replace("general", "");
    if letters.contains('%') {
        NumberFormat::Percent
    } else if letters.contains(['y', 'd']) {
        NumberFormat::Moment(Meaning::Date)
    } else if letters.contains(['h', 's']) || letters.contains("am/pm") {
        NumberFormat::Moment(Meaning::Time)
    } else if letters.contains('m') {
        NumberFormat::Moment(Meaning::Date)
    } else {
        let digits = letters.contains(['0', '#', '?']);
        UnitText::of(&behind).filter(|_| digits).map_or(NumberFormat::Plain, NumberFormat::Unit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formats_of_dates_times_and_percentages_are_told_from_those_of_numbers() {
        let unit = |text: &str| UnitText::of(text).map_or(NumberFormat::Plain, NumberFormat::Unit);
        let cases = [
            ("yyyy-mm-dd h:mm:ss", NumberFormat::Moment(Meaning::Date)),
            ("[$-409]d/m/yy h:mm AM/PM;@", NumberFormat::Moment(Meaning::Date)),
            ("mmm\\-yy", NumberFormat::Moment(Meaning::Date)),
            ("mmm", NumberFormat::Moment(Meaning::Date)),
            ("h:mm:ss.000", NumberFormat::Moment(Meaning::Time)),
            ("mm:ss.0", NumberFormat::Moment(Meaning::Time)),
            ("[hh]:mm:ss", NumberFormat::Moment(Meaning::Time)),
            ("[s].00", NumberFormat::Moment(Meaning::Time)),
            ("General", NumberFormat::Plain),
            ("0.00%", NumberFormat::Percent),
            ("#,##0 %;[Red]-0%", NumberFormat::Percent),
            ("0\\%", NumberFormat::Plain),
            ("0\"%\"", NumberFormat::Plain),
            ("0.00E+00", NumberFormat::Plain),
            ("#,##0.00 \"s\"", unit("s")),
            ("0.0\\ \\m\\s", unit("ms")),
            ("0.00\" °C\"", unit("°C")),
            ("0.00\" apples\"", NumberFormat::Plain),
            ("\"m\"0.00", NumberFormat::Plain),
            ("[Red]0.00;[Blue]-0.00", NumberFormat::Plain),
            ("_-* #,##0.00 [$€-407]_-;-* \"d\"", NumberFormat::Plain),
            ("@", NumberFormat::Plain),
            ("", NumberFormat::Plain),
            ("[", NumberFormat::Plain),
            ("\"", NumberFormat::Plain),
        ];
        for (code, expected) in cases {
            assert_eq!(of_code(code), expected, "{code}");
        }
        assert_eq!(
            (of_builtin(0), of_builtin(10), of_builtin(49)),
            (NumberFormat::Plain, NumberFormat::Percent, NumberFormat::Plain)
        );
    }
}

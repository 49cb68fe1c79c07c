//! Number formats of Office Open XML: which of them show a number as a date or time.

use super::moment::Meaning;
use super::refusal::WorkbookError;
use crate::packed::{Token, Xml};
use std::collections::BTreeMap;

/// Excel allows 65490 cell formats.
const MOST_STYLES: usize = 70_000;

/// What a number means in each of the workbook's cell formats (`cellXfs`), in their order.
pub(super) fn read(mut xml: Xml) -> Result<Vec<Option<Meaning>>, WorkbookError> {
    let mut formats: BTreeMap<u32, Option<Meaning>> = BTreeMap::new();
    let mut styles = Vec::new();
    let mut in_cells = false;
    loop {
        match xml.next()? {
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

/// The formats that every spreadsheet has (ECMA-376, 18.8.30), those of East Asia included.
fn of_builtin(id: u32) -> Option<Meaning> {
    match id {
        14..=17 | 22 | 27..=31 | 36 | 50..=58 => Some(Meaning::Date),
        18..=21 | 32..=35 | 45..=47 => Some(Meaning::Time),
        _ => None,
    }
}

/// A format such as `yyyy-mm-dd h:mm:ss` or `[h]:mm:ss;@`.
fn of_code(code: &str) -> Option<Meaning> {
    let mut letters = String::new();
    let mut rest = code.chars();
    while let Some(character) = rest.next() {
        match character {
            '"' => drop(rest.by_ref().find(|next| *next == '"')),
            // The next character stands for itself, for its width, or fills the cell.
            '\\' | '_' | '*' => drop(rest.next()),
            '[' => {
                let inside: String = rest.by_ref().take_while(|next| *next != ']').collect();
                let elapsed =
                    |unit: char| !inside.is_empty() && inside.chars().all(|one| one.eq_ignore_ascii_case(&unit));
                if ['h', 'm', 's'].into_iter().any(elapsed) {
                    return Some(Meaning::Time);
                }
            }
            // What follows is for other signs.
            ';' => break,
            _ => letters.extend(character.to_lowercase()),
        }
    }
    let letters = letters.replace("general", "");
    if letters.contains(['y', 'd']) {
        Some(Meaning::Date)
    } else if letters.contains(['h', 's']) || letters.contains("am/pm") {
        Some(Meaning::Time)
    } else {
        letters.contains('m').then_some(Meaning::Date)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formats_of_dates_and_times_are_told_from_those_of_numbers() {
        let cases = [
            ("yyyy-mm-dd h:mm:ss", Some(Meaning::Date)),
            ("[$-409]d/m/yy h:mm AM/PM;@", Some(Meaning::Date)),
            ("mmm\\-yy", Some(Meaning::Date)),
            ("mmm", Some(Meaning::Date)),
            ("h:mm:ss.000", Some(Meaning::Time)),
            ("mm:ss.0", Some(Meaning::Time)),
            ("[hh]:mm:ss", Some(Meaning::Time)),
            ("[s].00", Some(Meaning::Time)),
            ("General", None),
            ("0.00%", None),
            ("0.00E+00", None),
            ("#,##0.00 \"s\"", None),
            ("0.0\\ \\m\\s", None),
            ("[Red]0.00;[Blue]-0.00", None),
            ("_-* #,##0.00 [$€-407]_-;-* \"d\"", None),
            ("@", None),
            ("", None),
            ("[", None),
            ("\"", None),
        ];
        for (code, expected) in cases {
            assert_eq!(of_code(code), expected, "{code}");
        }
        assert_eq!((of_builtin(0), of_builtin(10), of_builtin(49)), (None, None, None));
    }
}

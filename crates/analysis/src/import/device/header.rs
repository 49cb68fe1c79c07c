//! Header of a section: settings, names and units.

use super::description::{Cells as Place, Description, Settings};
use crate::import::cells::{Cells, Delimiter};
use crate::import::head::{self, meant_unit};
use crate::import::number::{self, Cell, Signs};
use units::Unit;

/// Upper bound of the lines and bytes of a header that are kept.
const MOST_LINES: usize = 2000;
const MOST_BYTES: usize = 1 << 20;

/// Header of a section.
#[derive(Clone, Debug, Default)]
pub(super) struct Header {
    /// Cells of each line that is not blank.
    lines: Vec<Vec<String>>,
    bytes: usize,
}

/// Number with its unit, if it states one: `0.08uS`, `2.0e-6`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Quantity {
    pub value: f64,
    pub unit: Option<Unit>,
}

impl Header {
    /// Adds a line.
    pub fn push(&mut self, line: &str, delimiter: Delimiter) {
        self.push_cells(Cells::of(line, delimiter).map(str::to_owned).collect());
    }

    /// Adds the cells of a line.
    pub fn push_cells(&mut self, cells: Vec<String>) {
        self.bytes += cells.iter().map(|cell| cell.len() + 24).sum::<usize>();
        if self.lines.len() < MOST_LINES && self.bytes < MOST_BYTES {
            self.lines.push(cells);
        }
    }

    /// Cells above the columns of the rows. The key of a line stands above the first column if that holds no values of a
    /// channel, `aligned`; a key that shares its cell with a value, `#UNITS:V`, never does.
    pub fn above(&self, place: Place, aligned: bool) -> Vec<String> {
        let line = |index: usize| self.lines.get(index).cloned().unwrap_or_default();
        match place {
            Place::Nowhere => Vec::new(),
            Place::Line(index) => line(index),
            Place::FromEnd(index) => self.line_from_end(index),
            Place::Key(keys) => {
                let Some((cells, shared)) = self.setting(keys) else { return Vec::new() };
                let is_key = |cell: &String| keys.contains(&key(cell).as_str());
                let cells = cells.into_iter().map(|cell| if is_key(&cell) { String::new() } else { cell });
                cells.skip(usize::from(shared || !aligned)).collect()
            }
        }
    }

    /// Line of this index from the end; the one below it if it has a single text, because a line between is blank.
    fn line_from_end(&self, index: usize) -> Vec<String> {
        let line = |index: usize| self.lines.len().checked_sub(index + 1).and_then(|place| self.lines.get(place));
        let single = |line: &&Vec<String>| line.iter().filter(|cell| !cell.is_empty()).count() < 2;
        let below = index.checked_sub(1).and_then(line);
        let own = line(index).filter(|own| below.is_none() || !single(own));
        own.or(below).cloned().unwrap_or_default()
    }

    /// Line of a key, with the key in its first cell, and true if the key shared its cell with the first value.
    fn setting(&self, keys: &[&str]) -> Option<(Vec<String>, bool)> {
        keys.iter().find_map(|wanted| {
            self.lines.iter().find_map(|cells| {
                let first = cells.first()?;
                if key(first) == *wanted {
                    return Some((cells.clone(), false));
                }
                let (name, value) = divided(first)?;
                (key(name) == *wanted).then(|| {
                    let rest = cells.iter().skip(1).cloned();
                    ([name.to_owned(), value.to_owned()].into_iter().chain(rest).collect(), true)
                })
            })
        })
    }

    /// Texts of a setting, without its key.
    pub fn texts(&self, keys: &[&str], settings: Settings) -> Vec<String> {
        if settings == Settings::Columns {
            let column =
                self.lines.first().and_then(|names| names.iter().position(|name| keys.contains(&key(name).as_str())));
            let value = column.and_then(|column| self.lines.get(1)?.get(column).cloned());
            return value.into_iter().collect();
        }
        let cells = self.setting(keys).map(|(cells, _)| cells.into_iter().skip(1).collect::<Vec<_>>());
        // For `CH1V,t0 = -5e-06, tInc = 2e-10`.
        let inside = || {
            let cells = self.lines.iter().flatten();
            let found = cells.filter_map(|cell| divided(cell)).find(|(name, _)| keys.contains(&key(name).as_str()));
            found.map(|(_, value)| vec![value.to_owned()])
        };
        cells.or_else(inside).unwrap_or_default()
    }

    /// Numbers of a setting, by the columns of its line; `None` for a cell without a number.
    pub fn quantities(&self, keys: &[&str], settings: Settings) -> Vec<Option<Quantity>> {
        self.texts(keys, settings).iter().map(|text| quantity(text)).collect()
    }

    /// Exponent and text of a line `1.0e+03 *`.
    pub fn power(&self) -> Option<(i32, String)> {
        self.lines.iter().find_map(|cells| match cells.as_slice() {
            [number, star] if star == "*" => Some((power_of_ten(number)?, number.clone())),
            _ => None,
        })
    }

    /// True if a line begins a matrix: `A =`.
    pub fn begins_matrix(&self) -> bool {
        self.lines.iter().any(|cells| cells.last().is_some_and(|cell| cell.ends_with('=')))
    }

    /// First single text that names a run.
    pub fn run(&self) -> Option<String> {
        let single = |cells: &Vec<String>| {
            let mut filled = cells.iter().filter(|cell| !cell.is_empty());
            filled.next().filter(|_| filled.next().is_none()).and_then(|text| crate::run_name::name(text))
        };
        self.lines.iter().find_map(single)
    }
}

/// True if a cell of the line of names holds a setting of the description and no name.
pub(super) fn is_setting(cell: &str, description: &Description) -> bool {
    let own = |name: &str| description.step.contains(&name) || description.start.contains(&name);
    own(&key(cell)) || divided(cell).is_some_and(|(name, _)| own(&key(name)))
}

/// Key in lower case, without signs around it: `Time interval\t:` becomes `time interval`.
fn key(cell: &str) -> String {
    cell.trim_matches(|sign: char| sign.is_whitespace() || matches!(sign, ':' | '=' | '#' | '"' | '$')).to_lowercase()
}

/// Key and value of a cell that holds both: `#CLOCK=20.0uS`, `UNITS:V`.
fn divided(cell: &str) -> Option<(&str, &str)> {
    let (name, value) = cell.split_once(['=', ':'])?;
    let value = value.trim();
    (!value.is_empty()).then_some((name, value))
}

/// Number with or without a unit; a comma is a decimal sign.
pub(super) fn quantity(text: &str) -> Option<Quantity> {
    let text = text.trim().trim_matches('"').replace(',', ".");
    let signs = Signs::plain(b'.');
    if let Cell::Number(value) = number::cell(&text, signs) {
        return Some(Quantity { value, unit: None });
    }
    let (value, unit) = number::with_unit(&text, signs)?;
    // Over times, capitals do not select another unit: `uS` does not mean microsiemens.
    Some(Quantity { value, unit: meant_unit(unit, "t").map(|meant| meant.unit).or_else(|| head::unit_of(unit)) })
}

/// Exponent of a power of ten: 3 for `1.0e+03`.
fn power_of_ten(text: &str) -> Option<i32> {
    let (mantissa, exponent) = text.split_once(['e', 'E'])?;
    let one = mantissa.parse::<f64>().ok()? == 1.0;
    exponent.parse().ok().filter(|exponent: &i32| one && exponent.abs() <= 300)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_are_found_in_any_notation() {
        for (line, delimiter, keys, expected) in [
            ("Sample Interval,2.0e-05,,", Delimiter::Comma, "sample interval", "2e-5"),
            ("Time interval\t\t  :,0.08uS", Delimiter::Comma, "time interval", "0.08 µs"),
            ("# CLOCK=20.0uS", Delimiter::Blanks, "clock", "20 µs"),
            ("#CLOCK=20.0uS", Delimiter::Comma, "clock", "20 µs"),
            ("CH1V,CH2V,t0 =-5e-06, tInc = 2e-10,", Delimiter::Comma, "tinc", "2e-10"),
            ("Delta_X\t3,906250E-5\t3,906250E-5", Delimiter::Tab, "delta_x", "0.0000390625"),
            ("\"HResolution\",\"1.0E-5\"", Delimiter::Comma, "hresolution", "1e-5"),
        ] {
            let mut header = Header::default();
            header.push(line, delimiter);
            let found = header.quantities(&[keys], Settings::Above).into_iter().flatten().next();
            let expected = quantity(expected);
            assert_eq!(found.is_some(), expected.is_some(), "{line}");
            if let (Some(found), Some(expected)) = (found, expected) {
                assert_eq!(found.value, expected.value, "{line}");
                assert_eq!(found.unit.map(|unit| unit.factor), expected.unit.map(|unit| unit.factor), "{line}");
            }
        }
    }
}

//! Meaning of a comma or a point in the numbers, decimal sign or separator of groups, in a column that contradicts itself:
//! `1,295` beside `926`.

use super::cells::{COLUMNS, Cells, Delimiter};
use super::first::First;
use super::format::Format;
use super::number::{self, Cell, Signs};
use super::refusal::{ImportError, Refusal};
use super::rows;
use crate::finding::Finding;

/// Least ratio of the roughness of the two readings for a decision. A wrong reading jumps wherever the values pass 1000.
const SMOOTHER: f64 = 1.5;

/// Properties of the cells of one column that contain the sign.
#[derive(Clone, Debug, Default)]
struct ColumnEvidence {
    /// Line and text of the first number like `1,295`.
    grouped: Option<(usize, String)>,
    /// True if one of these ends with a zero, `1,290`: a program that omits trailing zeros does not write it as a decimal.
    zero: bool,
    /// Line and text of the first whole number below 1000 without the sign, `926`.
    plain: Option<(usize, String)>,
    /// True if there is a whole number of more digits without the sign, which grouping would have divided.
    long: bool,
    /// All numbers by both readings: (as a decimal sign, as groups).
    values: Vec<(f64, f64)>,
}

/// Evidence for either reading in each column, collected while the rows are read.
#[derive(Debug, Default)]
pub(super) struct Survey {
    columns: Vec<ColumnEvidence>,
    /// Number of lines read.
    lines: usize,
    /// True if a number has shown that the sign is decimal.
    decimal: bool,
}

/// True if the decimal sign may also group digits: it occurs in the rows, and the format does not decide it.
pub(super) fn is_open(rows: &str, format: &Format) -> bool {
    // If the sign is the delimiter, it only occurs in quotation marks.
    let quoted = format.delimiter.byte() != Some(format.decimal) || rows.as_bytes().contains(&b'"');
    format.thousands.is_none() && quoted && rows.as_bytes().contains(&format.decimal)
}

impl Survey {
    /// Reads the lines in about `budget` bytes of the rows. Returns the number of bytes read.
    pub fn read(&mut self, rows: &str, budget: usize, first: First, format: &Format) -> usize {
        let mut at = 0;
        for line in rows.split_inclusive('\n') {
            if at >= budget || self.decimal {
                break;
            }
            at += line.len();
            self.decimal = self.line(line.trim_end_matches(['\n', '\r']), first.line, format).is_none();
            self.lines += 1;
        }
        at
    }

    /// True if no more rows need to be read.
    pub fn is_settled(&self) -> bool {
        self.decimal
    }

    /// Reads a line. Returns `None` if a number shows that the sign is decimal.
    fn line(&mut self, line: &str, header_lines: usize, format: &Format) -> Option<()> {
        let sign = format.decimal;
        let other = if sign == b',' { b'.' } else { b',' };
        let groups = Signs { decimal: other, thousands: Some(sign) };
        for (place, cell) in Cells::of(line, format.delimiter).enumerate().take(COLUMNS) {
            let Cell::Number(value) = number::cell(cell, format.signs()) else { continue };
            if self.columns.len() <= place {
                self.columns.resize_with(place + 1, ColumnEvidence::default);
            }
            let column = self.columns.get_mut(place)?;
            let here = || (header_lines + self.lines + 1, rows::excerpt(cell));
            if !cell.as_bytes().contains(&sign) {
                let digits = cell.bytes().filter(u8::is_ascii_digit).count();
                if digits > 3 {
                    column.long = true;
                } else {
                    column.plain.get_or_insert_with(here);
                }
                column.values.push((value, value));
            } else if number::could_be_grouped(cell, sign)
                && let Cell::Number(large) = number::cell(cell, groups)
            {
                column.grouped.get_or_insert_with(here);
                column.zero |= cell.ends_with('0');
                column.values.push((value, large));
            } else {
                return None;
            }
        }
        Some(())
    }

    /// Format with the meaning of the sign decided. Notes for the user are added to `findings`.
    ///
    /// Most files decide it at once: `0,5`, `1,25` and `12,3456` have a decimal sign. If all numbers with the sign have the
    /// form `1,295`, a column of only these has a decimal sign: some programs always write three decimals. A column that
    /// also has whole numbers without it contradicts itself. Then the much smoother reading wins; or the one with groups,
    /// if it is smoother at all and one of the numbers ends with a zero. Otherwise the column is ambiguous.
    ///
    /// # Errors
    /// Both readings are possible.
    pub fn settle(self, format: Format, findings: &mut Vec<Finding>) -> Result<Format, ImportError> {
        let columns = if self.decimal { Vec::new() } else { self.columns };
        let decimal = if format.decimal == b',' { b'.' } else { b',' };
        let grouped = Format { decimal, thousands: Some(format.decimal), ..format };
        let mut said = None;
        for (index, column) in columns.iter().enumerate() {
            let (Some((line, text)), Some((_, plain))) = (&column.grouped, &column.plain) else { continue };
            if column.long {
                continue;
            }
            let [decimal, thousands] = [0, 1].map(|reading| roughness(&column.values, reading));
            let finding = |is_thousands: bool| Finding::Separator {
                line: *line,
                text: text.clone(),
                beside: plain.clone(),
                thousands: is_thousands,
            };
            if SMOOTHER * thousands < decimal || (column.zero && thousands < decimal) {
                findings.push(finding(true));
                return Ok(grouped);
            }
            if SMOOTHER * decimal < thousands {
                said.get_or_insert(finding(false));
                continue;
            }
            return Err(ImportError::new(
                Some(*line),
                Refusal::Separator { column: index + 1, text: text.clone(), beside: plain.clone() },
            ));
        }
        // A column of only `1,295` is read as decimal. A comma is reported, unless semicolons are the delimiters: then a
        // decimal comma is usual.
        let alone = columns
            .into_iter()
            .filter(|column| column.plain.is_none() && !column.long)
            .find_map(|column| column.grouped);
        let unusual = format.decimal == b',' && format.delimiter != Delimiter::Semicolon;
        let alone = alone.filter(|_| unusual).map(|(line, text)| Finding::DecimalSign { line, text });
        findings.extend(said.or(alone));
        Ok(format)
    }
}

/// Sum of squared steps over the sum of squared deviations from the mean: von Neumann's ratio, small for smooth values.
fn roughness(values: &[(f64, f64)], reading: usize) -> f64 {
    let value = |pair: &(f64, f64)| if reading == 0 { pair.0 } else { pair.1 };
    let mean = values.iter().map(value).sum::<f64>() / values.len() as f64;
    let square = |number: f64| number * number;
    let steps: f64 = values.windows(2).map(|pair| square(value(&pair[1]) - value(&pair[0]))).sum();
    steps / values.iter().map(|pair| square(value(pair) - mean)).sum::<f64>()
}

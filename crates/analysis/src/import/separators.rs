//! Whether a comma or a point in the numbers is the decimal sign or groups their digits, where a column contradicts itself:
//! `1,295` beside `926`.

use super::cells::{COLUMNS, Cells, Delimiter};
use super::first::First;
use super::format::Format;
use super::number::{self, Cell, Signs};
use super::refusal::{ImportError, Refusal};
use super::rows;
use crate::finding::Finding;

/// One reading is the smoother one if its roughness is so many times less. A wrong reading leaps wherever the values pass 1000.
const SMOOTHER: f64 = 1.5;

/// What the cells of one column with the sign in them look like.
#[derive(Clone, Debug, Default)]
struct Column {
    /// `1,295`: line and text of the first.
    grouped: Option<(usize, String)>,
    /// Whether one of those ends with a zero, `1,290`, which no program writes that leaves zeros out.
    zero: bool,
    /// A whole number below 1000 without the sign, `926`: line and text of the first.
    plain: Option<(usize, String)>,
    /// A whole number of more digits without the sign, which grouping would have divided.
    long: bool,
    /// All of them by both readings: with a decimal sign, with groups.
    values: Vec<(f64, f64)>,
}

/// The columns with what speaks for either reading, while the rows are read.
#[derive(Debug, Default)]
pub(super) struct Survey {
    columns: Vec<Column>,
    /// How many lines have been read.
    lines: usize,
    /// Whether a number has settled that the sign is decimal.
    decimal: bool,
}

/// Whether the sign of the decimals can group digits as well: it stands in the rows, and the format does not settle it.
pub(super) fn is_open(rows: &str, format: &Format) -> bool {
    // A comma between commas stands in quotation marks alone.
    let quoted = format.delimiter.byte() != Some(format.decimal) || rows.as_bytes().contains(&b'"');
    format.thousands.is_none() && quoted && rows.as_bytes().contains(&format.decimal)
}

impl Survey {
    /// Reads the lines in about `budget` bytes of the rows; how many bytes that were.
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

    /// Whether nothing more need be read.
    pub fn is_settled(&self) -> bool {
        self.decimal
    }

    /// `None` as soon as a number settles that the sign is decimal.
    fn line(&mut self, line: &str, header_lines: usize, format: &Format) -> Option<()> {
        let sign = format.decimal;
        let other = if sign == b',' { b'.' } else { b',' };
        let groups = Signs { decimal: other, thousands: Some(sign) };
        for (place, cell) in Cells::of(line, format.delimiter).enumerate().take(COLUMNS) {
            let Cell::Number(value) = number::cell(cell, format.signs()) else { continue };
            if self.columns.len() <= place {
                self.columns.resize_with(place + 1, Column::default);
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

    /// The format with the sign read as it must be, and what is to be said of it.
    ///
    /// Nearly every file settles it at once: `0,5`, `1,25` and `12,3456` have a decimal sign. Where all numbers with the sign have
    /// the form `1,295`, a column of those alone has a decimal sign, as programs write that always give three decimals. A
    /// column that also has whole numbers without it contradicts itself. Then the reading counts by which the values follow each
    /// other far more smoothly, or the one with groups if it is smoother at all and one of the numbers ends with a zero. Otherwise
    /// the column is ambiguous.
    ///
    /// # Errors
    /// When both readings are possible.
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
        // A column of `1,295` alone is read as usual. Of a comma it is said, which is no decimal sign everywhere; where semicolons
        // divide the cells it is one.
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

/// The squares of the steps over the squares of the deviations from the mean: von Neumann's ratio, small for what moves smoothly.
fn roughness(values: &[(f64, f64)], reading: usize) -> f64 {
    let value = |pair: &(f64, f64)| if reading == 0 { pair.0 } else { pair.1 };
    let mean = values.iter().map(value).sum::<f64>() / values.len() as f64;
    let square = |number: f64| number * number;
    let steps: f64 = values.windows(2).map(|pair| square(value(&pair[1]) - value(&pair[0]))).sum();
    steps / values.iter().map(|pair| square(value(pair) - mean)).sum::<f64>()
}

//! Sheet as text: a line for each row, and tabs between the cells. So a workbook is read by the same rules as a text, and
//! the line of a message is the row.

use super::moment::Moment;
use super::refusal::WorkbookError;
use super::styles::NumberFormat;

/// Limits of a sheet (ECMA-376, 18.3.1.73; the same in LibreOffice).
pub(super) const MOST_ROWS: u32 = 1_048_576;
pub(super) const MOST_COLUMNS: u32 = 16_384;

/// Greatest length of the text of a cell, in bytes: 32767 characters.
pub(super) const LONGEST_VALUE: usize = 4 * 32_767;

/// Text under construction, with cells in the order of reading.
#[derive(Debug)]
pub(super) struct Lines {
    text: String,
    row: u32,
    column: u32,
    /// Upper bound of the length of the text, in bytes.
    most: usize,
}

impl Lines {
    pub fn new(most: usize) -> Self {
        Self { text: String::new(), row: 0, column: 0, most }
    }

    /// Moves forward to a cell, with row and column from 0. `called` gives its reference for the error if that is not
    /// possible.
    pub fn go_to(&mut self, row: u32, column: u32, called: &dyn Fn() -> String) -> Result<(), WorkbookError> {
        if row >= MOST_ROWS || column >= MOST_COLUMNS || (row, column) < (self.row, self.column) {
            return Err(WorkbookError::Place { cell: called().chars().take(40).collect() });
        }
        if row > self.row {
            self.text.extend(std::iter::repeat_n('\n', (row - self.row) as usize));
            (self.row, self.column) = (row, 0);
        }
        self.text.extend(std::iter::repeat_n('\t', (column - self.column) as usize));
        self.column = column;
        if self.text.len() > self.most { Err(self.too_large()) } else { Ok(()) }
    }

    fn too_large(&self) -> WorkbookError {
        WorkbookError::TooLarge { most: self.most >> 20 }
    }

    /// Writes a number with the digits of the file.
    pub fn number(&mut self, digits: &str) {
        self.word(digits.trim());
    }

    /// Writes a text; characters that would end the cell or its line become blanks.
    pub fn word(&mut self, text: &str) {
        let kept = |character: char| if matches!(character, '\t' | '\n' | '\r' | '"') { ' ' } else { character };
        self.text.extend(text.chars().map(kept));
    }

    /// Writes a number as shown by a cell of this format.
    pub fn formatted(&mut self, digits: &str, format: NumberFormat, from_1904: bool) {
        let moment = match format {
            NumberFormat::Plain => None,
            NumberFormat::Percent => return self.percent(digits),
            NumberFormat::Unit(unit) => {
                self.number(digits);
                self.text.push(' ');
                return self.word(unit.text());
            }
            NumberFormat::Moment(meaning) => {
                digits.trim().parse().ok().and_then(|serial| Moment::of_serial(serial, meaning, from_1904))
            }
        };
        match moment {
            Some(moment) => self.moment(moment),
            None => self.number(digits),
        }
    }

    /// Writes a fraction as a percentage: 0.05 as `5%`.
    pub fn percent(&mut self, digits: &str) {
        match digits.trim().parse::<f64>() {
            Ok(fraction) if fraction.is_finite() => {
                self.text.push_str(&hundredfold(fraction));
                self.text.push('%');
            }
            _ => self.number(digits),
        }
    }

    /// Writes a date, a time or a duration.
    pub fn moment(&mut self, moment: Moment) {
        moment.write(&mut self.text);
    }

    /// Repeats the last row `times` times.
    pub fn repeat_row(&mut self, times: u32) -> Result<(), WorkbookError> {
        let start = self.text.rfind('\n').map_or(0, |end| end + 1);
        let line = format!("\n{}", self.text.get(start..).unwrap_or_default());
        let rows = u64::from(self.row) + u64::from(times);
        let length = (times as usize).checked_mul(line.len()).and_then(|more| more.checked_add(self.text.len()));
        if rows >= u64::from(MOST_ROWS) || length.is_none_or(|length| length > self.most) {
            return Err(self.too_large());
        }
        self.text.extend(std::iter::repeat_n(line.as_str(), times as usize));
        self.row += times;
        Ok(())
    }

    /// Returns the text.
    pub fn finish(self) -> String {
        self.text
    }
}

/// Digits of a number with the decimal point moved two places to the right, so that no digit changes.
fn hundredfold(number: f64) -> String {
    let digits = format!("{number:e}");
    let (mantissa, exponent) = digits.split_once('e').unwrap_or((&digits, "0"));
    let exponent = exponent.parse::<i32>().unwrap_or_default() + 2;
    let behind = mantissa.split_once('.').map_or("", |(_, behind)| behind);
    match usize::try_from(exponent) {
        Ok(shift @ 0..=15) => {
            let before = mantissa.split('.').next().unwrap_or_default();
            if number == 0.0 {
                return before.to_owned();
            }
            let (moved, rest) = behind.split_at(shift.min(behind.len()));
            let zeros = "0".repeat(shift - moved.len());
            let point = if rest.is_empty() { "" } else { "." };
            format!("{before}{moved}{zeros}{point}{rest}")
        }
        _ => format!("{mantissa}e{exponent}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentages_keep_the_digits_of_their_fractions() {
        for (fraction, shown) in [
            (0.05, "5"),
            (0.0525, "5.25"),
            (0.29, "29"),
            (0.07, "7"),
            (-0.123_456_789, "-12.3456789"),
            (1.0, "100"),
            (12.5, "1250"),
            (0.0, "0"),
            (1e-4, "1e-2"),
            (0.1 + 0.2, "30.000000000000004"),
            (1e300, "1e302"),
        ] {
            assert_eq!(hundredfold(fraction), shown, "{fraction}");
            let mut lines = Lines::new(100);
            lines.formatted(&format!("{fraction:?}"), NumberFormat::Percent, false);
            assert_eq!(lines.finish(), format!("{shown}%"));
        }
    }
}

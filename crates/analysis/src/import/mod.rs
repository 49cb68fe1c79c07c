//! Import of delimited text as a table. Delimiter, decimal sign, header, units, clock times, bodies and independent
//! variables are recognised automatically.
//!
//! `head` reads the lines before the first row. Which of them has names, which has units and which is a comment
//! (`head/block.rs`) follows from the lines and the numbers below together. A heading is a name, a power of ten and a unit
//! (`label.rs`, `power.rs`); a unit that depends on the name is chosen by it (`meant.rs`). Headers and titles between the
//! rows begin sections, which are joined or become runs (`sections.rs`). `times` reads dates and clocks; `doubts.rs` refuses
//! what may mean something else. Texts in another form (`forms`) are first rewritten as rows. Files of instruments are a
//! layer of their own (`device`): `known` describes each by data, a few rules read them all into sections, and
//! `device/table.rs` joins these.
//!
//! Each [`Column`](crate::table::Column) carries its [`Origin`](crate::origin::Origin): heading, number in the file, source
//! of the unit, text cells, role.

mod between;
mod cells;
mod decode;
mod device;
mod doubts;
mod first;
mod format;
mod forms;
mod head;
mod labels;
mod lines;
mod mixed;
mod notation;
mod notes;
mod number;
mod others;
mod program;
mod refusal;
mod rows;
mod runs;
mod sections;
mod separators;
#[cfg(test)]
mod slices;
mod stated;
mod times;

pub use cells::Delimiter;
pub(crate) use cells::cells_of;
pub(crate) use decode::characters;
pub use decode::look;
pub use device::Remark as DeviceRemark;
pub use format::Format;
pub use forms::Markup;
pub use program::Program;
pub use refusal::{ImportError, Refusal};
pub(crate) use stated::is_unit;
pub use stated::{state_dates, stated_unit, unit};
pub use times::date::DateOrder;

use crate::finding::Finding;
use crate::table::Table;
use crate::{roles, scale_line};
use device::Device;
use first::First;
use forms::Form;
use head::Head;
use notes::{FINDINGS, clock_finding, errors, runs_finding};
use number::Signs;
use rows::Rows;
use std::borrow::Cow;
use times::stamp::Stamped;
use times::{clock, overflow, serial_days, settle, stamp};

/// Imported table, with notes on how it was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Import {
    /// Table; cells without a number are NaN.
    pub table: Table,
    /// Notes on the file for the user.
    pub findings: Vec<Finding>,
    /// Notation of the file.
    pub format: Format,
}

/// Reads delimited text.
///
/// # Errors
/// The bytes are not text, the text is not a table of at least two columns and rows of numbers, or the meaning of its
/// numbers or times is ambiguous.
pub fn text(bytes: &[u8]) -> Result<Import, ImportError> {
    let mut importer = Importer::new(decode::decode(bytes)?)?;
    while !importer.advance(usize::MAX) {}
    Ok(importer.finish()?.0)
}

/// Decodes bytes to a text with line ends `\n` or `\r\n`, without a copy if possible.
///
/// # Errors
/// The bytes are not text.
pub fn decode(bytes: Vec<u8>) -> Result<String, ImportError> {
    decode::decode_owned(bytes)
}

/// Import of a text in slices; the result does not depend on the slices.
#[derive(Debug)]
pub struct Importer<'a> {
    text: Cow<'a, str>,
    /// Original text, if its time stamps were moved to a column.
    original: Option<Cow<'a, str>>,
    /// True for a spreadsheet, whose texts can have any form.
    sheet: bool,
    format: Format,
    first: First,
    pass: Pass,
    /// Notes on the signs in its numbers.
    findings: Vec<Finding>,
    /// Number of bytes of the rows read in this pass; of the whole text in the pass of time stamps.
    read: usize,
}

/// One pass over all rows. Its result selects the next pass.
#[derive(Debug)]
enum Pass {
    Stamps(Stamped),
    Separators(separators::Survey),
    Mixed(mixed::Survey),
    Rows(Rows),
    /// The file of a known instrument.
    Device(Box<Device>),
    Refused(ImportError),
}

impl<'a> Importer<'a> {
    /// Begins to read a text as returned by [`decode()`]: recognises its notation and the first row.
    ///
    /// # Errors
    /// There are no rows of numbers.
    pub fn new(text: Cow<'a, str>) -> Result<Self, ImportError> {
        let nuls = text.bytes().filter(|byte| *byte == 0).count();
        if nuls > 0 {
            let mut importer = Self::new(Cow::Owned(text.replace('\0', "")))?;
            importer.findings.push(Finding::Nuls(nuls));
            return Ok(importer);
        }
        if let Some(device) = device::recognise(&text) {
            return Ok(Self::of_device(text, device));
        }
        match forms::read(&text) {
            Some(form) => Self::of_form(text, form.map_err(|reason| ImportError::new(None, reason))?),
            None => Self::of_rows(text),
        }
    }

    /// Begins to read a text of rows.
    fn of_rows(text: Cow<'a, str>) -> Result<Self, ImportError> {
        if let Some(bare) = stamp::without(&text) {
            let stamped = Stamped::new(format::recognise(&bare).0);
            let format = Format { delimiter: stamped.delimiter, decimal: b'.', thousands: None, header_lines: 0 };
            let (first, pass) = (First { line: 0, offset: 0 }, Pass::Stamps(stamped));
            return Ok(Self { text, original: None, sheet: false, format, first, pass, findings: Vec::new(), read: 0 });
        }
        let (delimiter, signs) = format::recognise(&text);
        Self::begin(text, delimiter, signs, None).map_err(|(error, _)| error)
    }

    /// Begins to read the cells of a spreadsheet, in the format of [`sheet`].
    ///
    /// # Errors
    /// As for [`Importer::new`].
    pub fn of_sheet(cells: Cow<'a, str>) -> Result<Self, ImportError> {
        if cells.trim_start().is_empty() {
            return Err(ImportError::new(None, Refusal::Empty));
        }
        if let Some(device) = device::recognise(&cells) {
            return Ok(Self::of_device(cells, device));
        }
        // If that fails: numbers stored as texts in a sheet can have any form.
        Self::begin(cells, Delimiter::Tab, Signs::plain(b'.'), None)
            .map(|importer| Self { sheet: true, ..importer })
            .or_else(|(_, cells)| Self::new(cells))
    }

    /// Begins to read the rows that were made from a text in another form.
    fn of_form(text: Cow<'a, str>, form: Form) -> Result<Self, ImportError> {
        let rows = Cow::Owned(form.rows);
        let begun = match form.is_plain {
            true => Self::begin(rows, Delimiter::Tab, Signs::plain(b'.'), None).map_err(|(error, _)| error),
            false => Self::of_rows(rows),
        };
        let mut importer = begun.map_err(|error| ImportError { line: None, ..error })?;
        (importer.original, importer.sheet) = (Some(text), true);
        importer.findings.push(form.finding);
        Ok(importer)
    }

    /// Begins to read the file of a known instrument.
    fn of_device(text: Cow<'a, str>, device: Device) -> Self {
        let format = Format { delimiter: Delimiter::Tab, decimal: b'.', thousands: None, header_lines: 0 };
        let (first, pass) = (First { line: 0, offset: 0 }, Pass::Device(Box::new(device)));
        Self { text, original: None, sheet: false, format, first, pass, findings: Vec::new(), read: 0 }
    }

    /// Begins to read a text with known delimiter and signs; returns the text with the error if there are no rows.
    fn begin(
        text: Cow<'a, str>,
        delimiter: Delimiter,
        signs: Signs,
        original: Option<Cow<'a, str>>,
    ) -> Result<Self, (ImportError, Cow<'a, str>)> {
        let format = Format { delimiter, decimal: signs.decimal, thousands: signs.thousands, header_lines: 0 };
        let first = match first::row(&text, &format) {
            Ok(first) => first,
            Err(error) => return Err((error, text)),
        };
        let format = Format { header_lines: first.line, ..format };
        let pass = if separators::is_open(&text[first.offset..], &format) {
            Pass::Separators(separators::Survey::default())
        } else {
            Pass::after_separators(&text[first.offset..], &format)
        };
        Ok(Self { text, original, sheet: false, format, first, pass, findings: Vec::new(), read: 0 })
    }

    /// Reads about `budget` more bytes of the rows. Returns true if all have been read.
    pub fn advance(&mut self, budget: usize) -> bool {
        let (header, rows) = self.text.split_at(self.first.offset);
        let rest = rows.get(self.read..).unwrap_or_default();
        let (first, format) = (self.first, self.format);
        self.read += match &mut self.pass {
            Pass::Stamps(stamped) => stamped.read(rest, budget),
            Pass::Separators(survey) => survey.read(rest, budget, first, &format),
            Pass::Mixed(survey) => survey.read(rest, budget, first, &format),
            Pass::Rows(table) => {
                let header: Vec<&str> = header.lines().collect();
                table.read(rest, budget, &format, &header)
            }
            Pass::Device(device) => device.read(rest, budget),
            Pass::Refused(_) => return true,
        };
        let settled = matches!(&self.pass, Pass::Separators(survey) if survey.is_settled());
        if self.read < rows.len() && !settled {
            return false;
        }
        if matches!(self.pass, Pass::Rows(_) | Pass::Device(_)) {
            return true;
        }
        self.next_pass();
        false
    }

    /// Begins the next pass after the present one has ended.
    fn next_pass(&mut self) {
        self.read = 0;
        let refused = Pass::Refused(ImportError::new(None, Refusal::Empty));
        let next = match std::mem::replace(&mut self.pass, refused) {
            Pass::Stamps(stamped) => {
                let original = std::mem::take(&mut self.text);
                let signs = format::recognise(&stamped.columns).1;
                match Self::begin(Cow::Owned(stamped.columns), stamped.delimiter, signs, Some(original)) {
                    Ok(importer) => {
                        *self = importer;
                        return;
                    }
                    Err((error, _)) => Err(error),
                }
            }
            Pass::Separators(survey) => survey.settle(self.format, &mut self.findings).map(|format| {
                self.format = format;
                Pass::after_separators(&self.text[self.first.offset..], &format)
            }),
            Pass::Mixed(survey) => survey
                .settle(&mut self.findings)
                .map(|mixed| Pass::Rows(Rows::of(&self.text[self.first.offset..], mixed))),
            other => Ok(other),
        };
        match next {
            Ok(next) => self.pass = next,
            Err(_) if self.sheet => match Self::new(std::mem::take(&mut self.text)) {
                Ok(importer) => *self = importer,
                Err(error) => self.pass = Pass::Refused(error),
            },
            Err(error) => self.pass = Pass::Refused(error),
        }
    }

    /// Progress, from 0 to 1.
    pub fn progress(&self) -> f64 {
        let part = (self.first.offset + self.read) as f64 / self.text.len().max(1) as f64;
        let (from, to) = match self.pass {
            Pass::Stamps(_) => (0.0, 0.1),
            Pass::Separators(_) => (0.1, 0.2),
            Pass::Mixed(_) => (0.2, 0.4),
            Pass::Device(_) => (0.0, 1.0),
            Pass::Rows(_) | Pass::Refused(_) => (0.4, 1.0),
        };
        from + (to - from) * part.min(1.0)
    }

    /// Table and text; reads the remaining rows first.
    ///
    /// # Errors
    /// It is not a table of at least two columns and rows of numbers, its times cannot be read, or a comma or a point in
    /// its numbers is ambiguous.
    pub fn finish(mut self) -> Result<(Import, Cow<'a, str>), ImportError> {
        while !self.advance(usize::MAX) {}
        let Self { text, original, sheet, format, first, pass, mut findings, .. } = self;
        let mut rows = match pass {
            Pass::Rows(rows) => rows,
            Pass::Device(device) => {
                let (table, of_device, format) = device.finish()?;
                findings.extend(of_device);
                return Ok((Import { table, findings, format }, text));
            }
            Pass::Refused(error) => return Err(error),
            _ => return Err(ImportError::new(None, Refusal::Empty)),
        };
        rows.leave_out_codes();
        let head_lines: Vec<&str> = text[..first.offset].lines().collect();
        let mut heads = head::read(&head_lines, format.delimiter, &rows.below(), &mut findings);
        rows.widen(heads.len(), &text);
        heads.resize(rows.columns.len(), Head::default());
        let clocks = settle::columns(&mut rows, &mut heads, &mut findings);
        findings.truncate(FINDINGS);
        let serial = serial_days::to_seconds(&mut rows, &mut heads);
        let sections = sections::read(&mut rows, &heads, format.delimiter);
        if sections.len() == 1 {
            doubts::commas(&heads, &rows, &format, clocks.len())?;
        }
        sections::convert(&sections, &mut rows);
        findings.extend(sections::finding(&sections, &heads));
        let sections = sections::join(sections, &mut rows, &mut heads);
        rows.refuse_words(first.line)?;
        doubts::times(&heads, &rows)?;
        doubts::dates(&clocks, &heads, first.line + 1)?;
        doubts::unread(&rows, &heads)?;
        let apart = if sections.len() > 1 { sections::apart(&sections, &mut rows) } else { Default::default() };
        let names: Vec<String> = heads.iter().map(|head| head.name.clone()).collect();
        let (mut columns, mut kept) =
            if apart.0.is_empty() { sections::whole(heads, &mut rows, &mut findings) } else { apart };
        if columns.iter().filter(|column| column.filled() > 0).count() < 2 {
            return Err(ImportError::new(Some(first.line + 1), Refusal::OneColumn));
        }
        if original.is_some()
            && !sheet
            && let Some(unit) = stamp::prefer_own_times(&mut columns)
        {
            kept.remove(0);
            columns.iter_mut().for_each(|column| column.origin.number = column.origin.number.saturating_sub(1));
            findings.push(Finding::Stamps { unit: unit.text });
        }
        let overflows = overflow::undo(&mut columns);
        let scale_error = scale_line::read(head_lines.iter().copied());
        findings.extend(scale_error.map(Finding::Scale));
        let mut table = Table { columns, scale_error, sets: false, readings: Vec::new() };
        findings.extend(overflows.iter().map(|overflow| Finding::Overflow {
            column: table.label(overflow.column),
            bits: overflow.bits,
            count: overflow.count,
        }));
        let roles = roles::assign(&mut table);
        findings.extend(errors(&table).into_iter().take(FINDINGS).map(Finding::Heading));
        if table.readings.is_empty() {
            runs::by_words(&mut table, &rows.others, &names, &mut findings);
            runs::side_by_side(&mut table, &rows.repeats, &rows.titles);
        }
        let labels = table.labels();
        let label = |index| kept.binary_search(&index).ok().and_then(|place| labels.get(place).cloned());
        findings.extend(serial.into_iter().filter_map(|column| Some(Finding::SerialDays(label(column)?))));
        findings.extend(clocks.iter().filter_map(|clock| Some(clock_finding(clock, label(clock.column)?))));
        let other_sign =
            |column: &usize| Some(Finding::OtherSign { column: label(*column)?, point: format.decimal == b',' });
        findings.extend(rows.mixed.iter().filter_map(other_sign));
        findings.extend(rows.findings(label));
        findings.extend(runs_finding(&table));
        findings.extend(roles.into_iter().map(Finding::Role));
        Ok((Import { table, findings, format }, original.unwrap_or(text)))
    }
}

impl Pass {
    /// Pass after the meaning of the signs is known.
    fn after_separators(rows: &str, format: &Format) -> Self {
        if mixed::is_open(rows, format) {
            Self::Mixed(mixed::Survey::default())
        } else {
            Self::Rows(Rows::of(rows, Vec::new()))
        }
    }
}

/// Reads the cells of a spreadsheet, by the same rules as a text.
///
/// The cells come as text. A row is a line; cells are separated by tabs and keep their columns in the sheet. Numbers have a
/// decimal point and no other sign (`{:?}` of an `f64`). Texts have no tabs, line ends or quotation marks. An error is
/// written as the sheet shows it, `#DIV/0!`. A date with a time is `2026-01-02T10:00:00.050`, a time of day or a duration
/// `10:00:00.050` (hours may exceed 24), a date `2026-01-02`: such a column is read in seconds from its first row.
///
/// # Errors
/// As for [`text`].
pub fn sheet(cells: &str) -> Result<Import, ImportError> {
    let mut importer = Importer::of_sheet(Cow::Borrowed(cells))?;
    while !importer.advance(usize::MAX) {}
    Ok(importer.finish()?.0)
}

//! Files of measuring instruments and their programs: oscilloscopes, LabVIEW, Vernier, CASSY, MATLAB.
//!
//! Each is described by data ([`known`]); a few rules read them all. Settings of the instrument are no rows, an index is no
//! time, and the time step of the header is used and reported.

mod description;
mod header;
mod known;
mod remark;
mod section;
mod table;

pub use remark::Remark;

use super::cells::{COLUMNS, Cells, Delimiter};
use super::number::{self, Cell, Signs};
use super::{Format, ImportError, Refusal, clock};
use crate::finding::Finding;
use crate::table::Table;
use description::{Description, Sections, Settings};
use header::Header;
use section::Section;

/// Upper bound of the beginning of a file that is searched for the texts of a description, in bytes.
const LOOK: usize = 8192;
/// Number of lines from which the decimal sign is recognised.
const SAMPLE: usize = 300;
/// Upper bound of the number of cells, or the size of the file in bytes if that is greater.
const CELLS: usize = 4_000_000;
/// Upper bound of the number of sections.
const MOST_SECTIONS: usize = 1000;

/// Reading of an instrument's file, line by line.
#[derive(Debug)]
pub(super) struct Device {
    description: &'static Description,
    delimiter: Delimiter,
    signs: Signs,
    sections: Vec<Section>,
    /// Header that is being read; `None` inside the rows.
    header: Option<Header>,
    /// Number of lines before the first row.
    header_lines: usize,
    /// Number of lines read.
    lines: usize,
    /// Greatest number of columns.
    width: usize,
    /// Number of cells of a channel, if settings stand beside the rows.
    period: usize,
    /// Lines of words between the rows: line of the first, and their number.
    word_lines: Option<(usize, usize)>,
    /// Rows with too many cells: line of the first, and their number.
    long: Option<(usize, usize)>,
}

/// Recognises the file of a known instrument.
pub(super) fn recognise(text: &str) -> Option<Device> {
    let start = &text[..text.floor_char_boundary(LOOK)];
    let start = start.trim_start_matches('\u{feff}').trim_start();
    // Excel declares the delimiter in the first line.
    let start = match start.split_once('\n') {
        Some((first, rest)) if super::cells::declared(first).is_some() => rest,
        _ => start,
    };
    let lower = start.to_lowercase().replace([';', '\t'], ",");
    let matches = |description: &&Description| {
        description.first.iter().any(|first| lower.starts_with(first))
            && description.also.iter().all(|text| lower.contains(text))
    };
    let matlab = || Some(&known::MATLAB).filter(|_| begins_with_power(start));
    let description = known::KNOWN.iter().find(matches).or_else(matlab)?;
    Some(Device::new(description, text))
}

/// True if a line `1.0e+03 *` stands before the first row, as MATLAB displays matrices.
fn begins_with_power(start: &str) -> bool {
    let mut lines = start.lines().map(str::trim).filter(|line| !line.is_empty()).take(4);
    lines.any(|line| {
        line.strip_suffix('*')
            .is_some_and(|number| number.trim().starts_with("1.0e") && number.trim().parse::<f64>().is_ok())
    })
}

impl Device {
    fn new(description: &'static Description, text: &str) -> Self {
        let sample: Vec<&str> = text.lines().take(SAMPLE).collect();
        let occurs = |delimiter: &&Delimiter| match delimiter.byte() {
            Some(byte) => sample.iter().any(|line| line.as_bytes().contains(&byte)),
            None => true,
        };
        let delimiter = description.delimiters.iter().find(occurs).copied().unwrap_or(Delimiter::Comma);
        let lines = text.bytes().filter(|byte| *byte == b'\n').count() + 1;
        let mut device = Self {
            description,
            delimiter,
            signs: Signs::plain(b'.'),
            sections: Vec::new(),
            header: Some(Header::default()),
            header_lines: 0,
            lines: 0,
            width: COLUMNS.min(CELLS.max(text.len()) / lines).max(2),
            period: COLUMNS,
            word_lines: None,
            long: None,
        };
        if delimiter != Delimiter::Comma {
            let rows = |decimal: u8| {
                let signs = Signs::plain(decimal);
                let of_row = |line: &&str| device.is_row(line, signs) && line.as_bytes().contains(&decimal);
                sample.iter().filter(|line| of_row(line)).count()
            };
            if rows(b',') > rows(b'.') {
                device.signs = Signs::plain(b',');
            }
        }
        device
    }

    /// True if the first filled cell of a line is a number or a time.
    fn is_row(&self, line: &str, signs: Signs) -> bool {
        let first = Cells::of(line, self.delimiter).find(|cell| !cell.is_empty());
        let Some(first) = first.filter(|_| !line.trim_end().ends_with('*')) else { return false };
        matches!(number::cell(first, signs), Cell::Number(_) | Cell::Gap) || clock::read(first).is_some()
    }

    /// Reads the lines in about `budget` bytes of the text. Returns the number of bytes read.
    pub fn read(&mut self, text: &str, budget: usize) -> usize {
        let mut at = 0;
        for line in text.split_inclusive('\n') {
            if at >= budget {
                break;
            }
            at += line.len();
            self.lines += 1;
            let line = line.trim_end_matches(['\n', '\r']);
            if line.trim().is_empty() || (self.lines == 1 && super::cells::declared(line).is_some()) {
                continue;
            }
            match self.description.settings {
                Settings::Beside => self.beside(line),
                _ => self.line(line),
            }
        }
        at
    }

    fn line(&mut self, line: &str) {
        if !self.is_row(line, self.signs) {
            let begins = self.description.sections != Sections::One
                && self.sections.len() < MOST_SECTIONS
                && Cells::of(line, self.delimiter).next().is_some_and(|first| !first.is_empty());
            match &mut self.header {
                Some(header) => header.push(line, self.delimiter),
                None if begins => {
                    let mut header = Header::default();
                    header.push(line, self.delimiter);
                    self.header = Some(header);
                }
                // A remark without numbers.
                None => self.word_lines.get_or_insert((self.lines, 0)).1 += 1,
            }
            return;
        }
        if let Some(header) = self.header.take() {
            if self.sections.is_empty() {
                self.header_lines = self.lines - 1;
            }
            self.sections.push(Section { header, ..Section::default() });
        }
        let (signs, width) = (self.signs, self.width);
        let cells = Cells::of(line, self.delimiter).take(COLUMNS).map(|cell| value(cell, signs));
        if let Some(section) = self.sections.last_mut()
            && !section.push(cells, width)
        {
            self.long.get_or_insert((self.lines, 0)).1 += 1;
        }
    }

    /// Reads a line with settings in front of its row: of each channel a key, a value, a gap, the time and the value.
    fn beside(&mut self, line: &str) {
        const BEFORE: usize = 3;
        let cells: Vec<&str> = Cells::of(line, self.delimiter).take(COLUMNS).collect();
        if self.sections.is_empty() {
            self.sections.push(Section::default());
            let next = cells.iter().skip(1).position(|cell| Some(cell) == cells.first());
            self.period = next.map_or(COLUMNS, |place| place + 1);
        }
        let Some(section) = self.sections.last_mut() else { return };
        let channels = cells.chunks(self.period).filter(|channel| channel.len() > BEFORE);
        let settings: Vec<String> =
            channels.clone().flat_map(|channel| channel.iter().take(2)).map(|cell| (*cell).to_owned()).collect();
        if settings.first().is_some_and(|key| !key.is_empty()) {
            section.header.push_cells(settings);
        }
        let signs = self.signs;
        let row = channels.flat_map(|channel| channel.iter().skip(BEFORE).take(2)).map(|cell| value(cell, signs));
        if !section.push(row, self.width) {
            self.long.get_or_insert((self.lines, 0)).1 += 1;
        }
    }

    /// Table, findings and notation; reads nothing more.
    ///
    /// # Errors
    /// There are fewer than two rows or no numbers.
    pub fn finish(self) -> Result<(Table, Vec<Finding>, Format), ImportError> {
        let format = Format {
            delimiter: self.delimiter,
            decimal: self.signs.decimal,
            thousands: None,
            header_lines: self.header_lines,
        };
        let rows = self.sections.iter().map(|section| section.rows).max().unwrap_or(0);
        if rows < 2 {
            return Err(ImportError::new(Some(self.header_lines + 1), Refusal::FewRows));
        }
        let (table, mut findings) = table::of(self.description, self.sections);
        if table.columns.iter().filter(|column| column.filled() > 0).count() < 2 {
            return Err(ImportError::new(Some(self.header_lines + 1), Refusal::OneColumn));
        }
        findings.extend(self.word_lines.map(|(line, count)| Finding::WordLines { line, count }));
        findings.extend(self.long.map(|(line, count)| Finding::ExtraCells { line, count }));
        Ok((table, findings, format))
    }
}

/// Number of a cell, NaN for an empty one; `None` for a word.
fn value(cell: &str, signs: Signs) -> Option<f64> {
    match number::cell(cell, signs) {
        Cell::Number(value) => Some(value),
        Cell::Gap => Some(f64::NAN),
        Cell::Word => None,
    }
}

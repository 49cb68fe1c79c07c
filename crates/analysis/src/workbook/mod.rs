//! Workbooks as other programs write them, XLSX (Office Open XML) and ODS (OpenDocument), as text: the one reader of page
//! and program.
//!
//! A workbook is read in slices and as a stream: what it expands to is never in memory, only the lines of one sheet. What it
//! may expand to is bounded before anything is expanded, where a cell may be before anything is written.

mod moment;
mod ods;
mod refusal;
mod sheet;
mod styles;
mod xlsx;

pub use refusal::WorkbookError;

use crate::packed::{self, Archive, Xml};
use moment::{Meaning, Moment};
use ods::{SheetsReader, Step};
use xlsx::{Book, Inside, SheetReader, Texts};

/// A workbook that is being read, sheet after sheet: those that are shown before those that are hidden.
#[derive(Debug)]
pub struct Workbook {
    form: Form,
    /// No sheet may become a longer text, in bytes.
    most: usize,
}

/// A sheet as text: a line for each row, tabs between the cells, numbers with a decimal point, dates and times as
/// `2024-05-01T12:00:00.05` and `00:00:00.05`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SheetText {
    /// The name on its tab.
    pub name: String,
    /// Its lines.
    pub text: String,
}

#[derive(Debug)]
enum Form {
    Xlsx(Box<Xlsx>),
    Ods(Box<SheetsReader>),
}

#[derive(Debug)]
struct Xlsx {
    archive: Archive,
    book: Book,
    texts: Texts,
    /// The texts, while they are being read.
    reading: Option<(Xml, Inside)>,
    /// The sheet that is being read, after how many others.
    sheet: Option<SheetReader>,
    passed: usize,
}

/// Whether a file begins as a workbook of these forms does.
pub fn is_workbook(start: &[u8]) -> bool {
    packed::is_archive(start)
}

/// A serial number that is shown as a date, a time or a duration, as it stands in a [`SheetText`]; the number itself where it
/// is no day of any calendar.
pub fn moment(serial: f64, is_duration: bool) -> String {
    let meaning = if is_duration { Meaning::Time } else { Meaning::Date };
    let mut text = String::new();
    match Moment::of_serial(serial, meaning, false) {
        Some(moment) => moment.write(&mut text),
        None => text.push_str(&serial.to_string()),
    }
    text
}

impl Workbook {
    /// Begins to read a workbook, whose sheets may become `most` bytes of text.
    ///
    /// # Errors
    /// What is no workbook, needs a password or would expand too much.
    pub fn open(bytes: Vec<u8>, most: usize) -> Result<Self, WorkbookError> {
        Self::of_archive(Archive::open(bytes)?, most)
    }

    /// The same for an archive.
    pub(crate) fn of_archive(archive: Archive, most: usize) -> Result<Self, WorkbookError> {
        let is_xlsx = archive.has("[Content_Types].xml");
        let form = if !is_xlsx && archive.has(ods::CONTENT) {
            Form::Ods(Box::new(SheetsReader::new(Xml::new(archive.part(ods::CONTENT, None)?), most)))
        } else {
            let book = Book::open(&archive)?;
            let texts = book.texts.as_deref().map(|path| archive.part(path, None)).transpose()?;
            let reading = texts.map(|part| (Xml::new(part), Inside::default()));
            Form::Xlsx(Box::new(Xlsx { archive, book, texts: Texts::default(), reading, sheet: None, passed: 0 }))
        };
        Ok(Self { form, most })
    }

    /// Reads on for about `budget` bytes of what the workbook expands to. The next sheet, once it is complete.
    ///
    /// # Errors
    /// What is damaged or too large.
    pub fn advance(&mut self, budget: u64) -> Result<Progress, WorkbookError> {
        match &mut self.form {
            Form::Ods(sheets) => Ok(match sheets.read(budget)? {
                Step::More => Progress::More,
                Step::Sheet(name, text) => Progress::Sheet(SheetText { name, text }),
                Step::End => Progress::End,
            }),
            Form::Xlsx(xlsx) => xlsx.advance(budget, self.most),
        }
    }

    /// Whether another sheet follows the one that was completed last.
    pub fn has_more(&mut self) -> bool {
        match &mut self.form {
            Form::Ods(sheets) => sheets.has_more(),
            Form::Xlsx(xlsx) => xlsx.passed < xlsx.book.sheets.len(),
        }
    }

    /// Which part of the present sheet has been read, from 0 to 1.
    pub fn progress(&self) -> f64 {
        match &self.form {
            Form::Ods(sheets) => sheets.progress(),
            Form::Xlsx(xlsx) => xlsx.sheet.as_ref().map_or(0.0, SheetReader::progress),
        }
    }
}

/// What a slice of reading has come to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Progress {
    /// There is more to read.
    More,
    /// A sheet is complete.
    Sheet(SheetText),
    /// There are no more sheets.
    End,
}

impl Xlsx {
    fn advance(&mut self, budget: u64, most: usize) -> Result<Progress, WorkbookError> {
        if let Some((xml, inside)) = &mut self.reading {
            if self.texts.read(xml, budget, inside)? {
                self.reading = None;
            }
            return Ok(Progress::More);
        }
        let Some(entry) = self.book.sheets.get(self.passed) else { return Ok(Progress::End) };
        let sheet = match &mut self.sheet {
            Some(sheet) => sheet,
            None => {
                let xml = Xml::new(self.archive.part(&entry.part, None)?);
                self.sheet.insert(SheetReader::new(xml, most))
            }
        };
        if !sheet.read(budget, &self.book, &self.texts)? {
            return Ok(Progress::More);
        }
        self.passed += 1;
        let text = self.sheet.take().map(SheetReader::finish).unwrap_or_default();
        Ok(Progress::Sheet(SheetText { name: entry.name.clone(), text }))
    }
}

//! Workbooks of other programs as text: XLSX (Office Open XML), ODS (OpenDocument) and XLS (Excel 5 to 2003). Page and
//! command line share this reader.
//!
//! A workbook is read in slices and as a stream: only the lines of one sheet are in memory. The expanded size is bounded
//! before anything is expanded, and the position of a cell is checked before anything is written.
//!
//! XLS is read from a copy of its stream; no chain of sectors and no text outgrows the file. Only the program constructs that
//! reader, so the page does not contain it. `calamine` checks our files in tests.

mod files;
mod moment;
mod ods;
mod refusal;
mod sheet;
mod source;
mod styles;
mod texts;
mod xls;
mod xlsx;

pub use refusal::WorkbookError;
pub use source::{Progress, SheetText};

use crate::data_sets::{DEVICE, EVENTS};
use files::Files;
use ods::SheetsReader;
use packed::{Archive, Xml};
use source::SheetSource;
use texts::Texts;
use xlsx::{Book, Inside, SheetReader};

/// Reading of a workbook, sheet after sheet: visible sheets before hidden ones.
#[derive(Debug)]
pub struct Workbook {
    sheets: Box<dyn SheetSource>,
}

#[derive(Debug)]
struct Xlsx {
    archive: Archive,
    book: Book,
    texts: Texts,
    /// Shared texts while they are being read.
    reading: Option<(Xml, Inside)>,
    /// Present sheet, and the number of sheets completed before it.
    sheet: Option<SheetReader>,
    passed: usize,
    /// Upper bound of the text of a sheet, in bytes.
    most: usize,
}

/// True if a file begins like a workbook: XLSX, ODS or XLS.
pub fn is_workbook(start: &[u8]) -> bool {
    packed::is_archive(start) || is_old(start)
}

/// True if a file begins like an old workbook: XLS.
pub(crate) fn is_old(start: &[u8]) -> bool {
    xls::begins(start)
}

impl Workbook {
    /// Begins to read a workbook; each sheet may become at most `most` bytes of text.
    ///
    /// # Errors
    /// The file is not a workbook, is damaged or too old, needs a password or would expand too much.
    pub fn open(bytes: Vec<u8>, most: usize) -> Result<Self, WorkbookError> {
        if is_old(&bytes) {
            return Ok(Self { sheets: Box::new(xls::Sheets::open(bytes, most)?) });
        }
        Self::of_archive(Archive::open(bytes)?, most)
    }

    /// Begins to read a workbook in an archive, or an archive of text files.
    pub(crate) fn of_archive(archive: Archive, most: usize) -> Result<Self, WorkbookError> {
        let is_xlsx = archive.has("[Content_Types].xml");
        if !is_xlsx && archive.has(ods::CONTENT) {
            let xml = Xml::new(archive.part(ods::CONTENT, None)?);
            return Ok(Self { sheets: Box::new(SheetsReader::new(xml, most)) });
        }
        if !is_xlsx && !archive.has("_rels/.rels") && !archive.has(xlsx::BOOK) {
            return Ok(Self { sheets: Box::new(Files::open(archive, most)?) });
        }
        let book = Book::open(&archive)?;
        let texts = book.texts.as_deref().map(|path| archive.part(path, None)).transpose()?;
        let reading = texts.map(|part| (Xml::new(part), Inside::default()));
        let xlsx = Xlsx { archive, book, texts: Texts::default(), reading, sheet: None, passed: 0, most };
        Ok(Self { sheets: Box::new(xlsx) })
    }

    /// Reads about `budget` more bytes of the expanded workbook. Returns the next sheet when it is complete.
    ///
    /// # Errors
    /// The workbook is damaged or too large.
    pub fn advance(&mut self, budget: u64) -> Result<Progress, WorkbookError> {
        self.sheets.advance(budget)
    }

    /// True if another sheet follows the one that was completed last.
    pub fn has_more(&mut self) -> bool {
        self.sheets.has_more()
    }

    /// Progress in the present sheet, from 0 to 1.
    pub fn progress(&self) -> f64 {
        self.sheets.progress()
    }

    /// True if each sheet is a text in any form, false if it was made from cells.
    pub(crate) fn holds_texts(&self) -> bool {
        self.sheets.holds_texts()
    }

    /// True if each sheet is a data set exported together with the others.
    pub(crate) fn holds_data_sets(&self) -> bool {
        self.sheets.holds_texts() || [DEVICE, EVENTS].into_iter().any(|name| self.sheets.lists(name))
    }
}

impl SheetSource for Xlsx {
    fn advance(&mut self, budget: u64) -> Result<Progress, WorkbookError> {
        if let Some((xml, inside)) = &mut self.reading {
            if xlsx::read_texts(&mut self.texts, xml, budget, inside)? {
                self.reading = None;
            }
            return Ok(Progress::More);
        }
        let Some(entry) = self.book.sheets.get(self.passed) else { return Ok(Progress::End) };
        let sheet = match &mut self.sheet {
            Some(sheet) => sheet,
            None => {
                let xml = Xml::new(self.archive.part(&entry.part, None)?);
                self.sheet.insert(SheetReader::new(xml, self.most))
            }
        };
        if !sheet.read(budget, &self.book, &self.texts)? {
            return Ok(Progress::More);
        }
        self.passed += 1;
        let text = self.sheet.take().map(SheetReader::finish).unwrap_or_default();
        Ok(Progress::Sheet(SheetText { name: entry.name.clone(), text }))
    }

    fn has_more(&mut self) -> bool {
        self.passed < self.book.sheets.len()
    }

    fn progress(&self) -> f64 {
        self.sheet.as_ref().map_or(0.0, SheetReader::progress)
    }

    fn lists(&self, name: &str) -> bool {
        self.book.sheets.iter().any(|sheet| sheet.name == name)
    }
}

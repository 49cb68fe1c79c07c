//! Old workbooks (XLS, Excel 5 to 2003): records (BIFF5 and BIFF8) in a stream of a compound file. Sizes are checked before
//! memory is allocated, so that it is bounded by a few times the size of the file.

mod book;
mod cfb;
mod record;
mod sheet;

use super::refusal::WorkbookError;
use super::source::{Progress, SheetSource, SheetText};
use book::Book;
use cfb::{CompoundFile, MAGIC};
use sheet::SheetReader;

/// Upper bound of the size of a file, in bytes: five million numbers.
const LONGEST: usize = 32 << 20;
/// Upper bound of the text of all sheets together: a fixed number of bytes, plus a multiple of the stream. A number has at
/// least 6 bytes in the stream and at most 25 in the text.
const ALWAYS_ALLOWED: usize = 8 << 20;
const MOST_EXPANSION: usize = 4;

/// Sheets of an old workbook.
#[derive(Debug)]
pub(super) struct Sheets {
    stream: Vec<u8>,
    book: Book,
    sheet: Option<SheetReader>,
    passed: usize,
    /// Remaining bytes of text for the further sheets.
    left: usize,
    most: usize,
}

/// True if a file begins like an old workbook, with or without a compound file around it.
pub(super) fn begins(start: &[u8]) -> bool {
    start.starts_with(MAGIC) || matches!(start, [0x09, 0x08, 0x08 | 0x10, 0x00, ..]) || book::is_too_old(start)
}

impl Sheets {
    /// Reads the description of the workbook.
    pub fn open(bytes: Vec<u8>, most: usize) -> Result<Self, WorkbookError> {
        if bytes.len() > LONGEST {
            return Err(WorkbookError::TooLarge { most: LONGEST >> 20 });
        }
        let stream = if bytes.starts_with(MAGIC) { stream(&bytes)? } else { bytes };
        let book = Book::read(&stream)?;
        let most = most.min(ALWAYS_ALLOWED + MOST_EXPANSION * stream.len());
        Ok(Self { stream, book, sheet: None, passed: 0, left: most, most })
    }
}

/// Stream of the workbook in a compound file.
fn stream(bytes: &[u8]) -> Result<Vec<u8>, WorkbookError> {
    let file = CompoundFile::open(bytes).ok_or(WorkbookError::Damaged)?;
    // Files written for two versions have both streams.
    match ["Workbook", "Book"].into_iter().find(|name| file.has(name)) {
        Some(name) => file.stream(name).ok_or(WorkbookError::Damaged),
        // Newer workbook with a password.
        None if file.has("EncryptedPackage") => Err(WorkbookError::Protected),
        None => Err(WorkbookError::NoCells),
    }
}

impl SheetSource for Sheets {
    fn advance(&mut self, budget: u64) -> Result<Progress, WorkbookError> {
        let Some(entry) = self.book.sheets.get(self.passed) else { return Ok(Progress::End) };
        let sheet = self.sheet.get_or_insert_with(|| SheetReader::new(entry.at, self.left));
        let finished = sheet.read(&self.stream, &self.book, budget).map_err(|error| match error {
            WorkbookError::TooLarge { .. } => WorkbookError::TooLarge { most: self.most >> 20 },
            error => error,
        })?;
        if !finished {
            return Ok(Progress::More);
        }
        self.passed += 1;
        let text = self.sheet.take().map(SheetReader::finish).unwrap_or_default();
        self.left = self.left.saturating_sub(text.len());
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

//! Properties of the whole workbook from its stream: sheets, shared texts and number formats (MS-XLS, 2.1.7.20.3).

use super::record::{Content, Record};
use crate::workbook::refusal::WorkbookError;
use crate::workbook::styles::{self, NumberFormat};
use crate::workbook::texts::Texts;
use packed::bytes::{double, word};
use std::collections::BTreeMap;
use units::order::sort_by_key;

/// Record at the begin of a substream.
pub(super) const BOF: u16 = 0x0809;
/// Record at the end of a substream.
pub(super) const EOF: u16 = 0x000a;
const VERSION_8: u16 = 0x0600;
const VERSION_5: u16 = 0x0500;
const FILEPASS: u16 = 0x002f;
const DATEMODE: u16 = 0x0022;
const BOUNDSHEET: u16 = 0x0085;
const FORMAT: u16 = 0x041e;
const XF: u16 = 0x00e0;
const SST: u16 = 0x00fc;
/// Upper bounds of the cell formats and of the sheets; more occur only in damaged files.
const MOST_STYLES: usize = 70_000;
const MOST_SHEETS: usize = 1000;

/// Properties common to all sheets.
#[derive(Debug, Default)]
pub(super) struct Book {
    /// True for BIFF8 (Excel 97 and later) with Unicode texts, false for BIFF5 (Excel 5 and 95).
    pub unicode: bool,
    /// Sheets, hidden ones last.
    pub sheets: Vec<SheetEntry>,
    pub texts: Texts,
    pub from_1904: bool,
    styles: Vec<NumberFormat>,
}

/// Entry in the list of sheets.
#[derive(Debug)]
pub(super) struct SheetEntry {
    pub name: String,
    /// Offset of its substream.
    pub at: usize,
    hidden: bool,
}

impl Book {
    /// Reads the first substream.
    pub fn read(stream: &[u8]) -> Result<Self, WorkbookError> {
        if is_too_old(stream) {
            return Err(WorkbookError::TooOld);
        }
        let first = Record::at(stream, 0).ok_or(WorkbookError::Damaged)?;
        let version = word(first.content(stream), 0).unwrap_or_default();
        if first.kind != BOF || !matches!(version, VERSION_5 | VERSION_8) {
            return Err(WorkbookError::Damaged);
        }
        let mut book = Self { unicode: version == VERSION_8, ..Self::default() };
        let mut formats: BTreeMap<u16, NumberFormat> = BTreeMap::new();
        let mut styles = Vec::new();
        let mut at = first.end;
        loop {
            let record = Record::at(stream, at).ok_or(WorkbookError::Damaged)?;
            at = record.end;
            match record.kind {
                EOF => break,
                FILEPASS => return Err(WorkbookError::Protected),
                DATEMODE => book.from_1904 = word(record.content(stream), 0) == Some(1),
                BOUNDSHEET if book.sheets.len() < MOST_SHEETS => {
                    let entry = book.sheet(stream, record).ok_or(WorkbookError::Damaged)?;
                    // Two sheets at one offset occur only in damaged files.
                    if entry.as_ref().is_some_and(|entry| book.sheets.iter().any(|other| other.at == entry.at)) {
                        return Err(WorkbookError::Damaged);
                    }
                    book.sheets.extend(entry);
                }
                FORMAT if formats.len() < MOST_STYLES => formats.extend(book.format(stream, record)),
                XF if styles.len() < MOST_STYLES => styles.extend(word(record.content(stream), 2)),
                SST => book.texts = texts(stream, record)?,
                _ => {}
            }
        }
        let format = |id: u16| formats.get(&id).copied().unwrap_or_else(|| styles::of_builtin(id.into()));
        book.styles = styles.into_iter().map(format).collect();
        sort_by_key(&mut book.sheets, |sheet| sheet.hidden);
        if book.sheets.is_empty() { Err(WorkbookError::NoCells) } else { Ok(book) }
    }

    /// Number format of cells with this style.
    pub fn style(&self, index: u16) -> NumberFormat {
        self.styles.get(usize::from(index)).copied().unwrap_or_default()
    }

    /// Appends a text with `count` characters; `None` if the stream ends within it.
    pub fn text(&self, content: &mut Content<'_>, count: usize, out: &mut String) -> Option<()> {
        if self.unicode {
            return content.text(count, out);
        }
        out.push_str(&content.bytes(count)?);
        Some(())
    }

    /// Entry of a sheet with cells; `Some(None)` for a chart or a macro.
    fn sheet(&self, stream: &[u8], record: Record) -> Option<Option<SheetEntry>> {
        let bytes = record.content(stream);
        let (at, state, kind) = (double(bytes, 0)? as usize, bytes.get(4)?, bytes.get(5)?);
        let mut content = Content::of(stream, record);
        content.skip(6)?;
        let count = usize::from(content.byte()?);
        let mut name = String::new();
        self.text(&mut content, count, &mut name)?;
        Some((*kind == 0).then_some(SheetEntry { name, at, hidden: state & 3 != 0 }))
    }

    fn format(&self, stream: &[u8], record: Record) -> Option<(u16, NumberFormat)> {
        let mut content = Content::of(stream, record);
        let id = content.word()?;
        let count = if self.unicode { content.word()? } else { content.byte()?.into() };
        let mut code = String::new();
        self.text(&mut content, count.into(), &mut code)?;
        Some((id, styles::of_code(&code)))
    }
}

/// True for a stream of Excel 2, 3 or 4, which has other records.
pub(super) fn is_too_old(stream: &[u8]) -> bool {
    matches!(stream, [0x09, 0x00 | 0x02 | 0x04, 0x04 | 0x06, 0x00, ..])
}

/// Texts shared by cells.
fn texts(stream: &[u8], record: Record) -> Result<Texts, WorkbookError> {
    let count = double(record.content(stream), 4).ok_or(WorkbookError::Damaged)? as usize;
    let mut content = Content::of(stream, record);
    let mut texts = Texts::default();
    content.skip(8).ok_or(WorkbookError::Damaged)?;
    while texts.len() < count && !content.is_at_end() {
        let length = content.word().ok_or(WorkbookError::Damaged)?;
        content.text(length.into(), texts.open()).ok_or(WorkbookError::Damaged)?;
        texts.close();
        texts.check()?;
    }
    Ok(texts)
}

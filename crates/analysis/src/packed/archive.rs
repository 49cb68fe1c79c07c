//! The directory of a ZIP archive (PKWARE, APPNOTE.TXT 6.3.3), and what a part may expand to before it is opened.

use super::Defect;
use super::part::Part;
use std::ops::Range;
use std::rc::Rc;

/// More files than any workbook or project has.
const MOST_FILES: usize = 10_000;
/// No part may expand to more bytes. A sheet of a million rows and five columns has half of it.
const MOST_EXPANDED: u64 = 512 << 20;
/// Nor to more than this many times its compressed size, apart from the first megabyte. Sheets of measurements expand by
/// 5 to 30; Deflate itself reaches 1032, which is what a bomb needs.
const MOST_EXPANSION: u64 = 200;
const ALWAYS_ALLOWED: u64 = 1 << 20;

/// An archive in memory.
#[derive(Clone, Debug)]
pub(crate) struct Archive {
    bytes: Rc<Vec<u8>>,
    files: Vec<File>,
}

/// Where the content of a file is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Stored {
    /// The bytes of the archive that hold it.
    pub range: Range<usize>,
    /// Whether they are compressed (Deflate); otherwise they are the content.
    pub deflated: bool,
    /// The size of the content in bytes, as the directory states it.
    pub expanded: u64,
}

/// A file as the directory lists it.
#[derive(Clone, Debug)]
struct File {
    name: String,
    encrypted: bool,
    deflated: bool,
    checksum: u32,
    packed: u64,
    expanded: u64,
    header: u64,
}

/// Reads little-endian numbers; `None` beyond the end.
fn word(bytes: &[u8], at: usize) -> Option<u16> {
    Some(u16::from_le_bytes(bytes.get(at..at.checked_add(2)?)?.try_into().ok()?))
}

fn double(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_le_bytes(bytes.get(at..at.checked_add(4)?)?.try_into().ok()?))
}

fn quad(bytes: &[u8], at: usize) -> Option<u64> {
    Some(u64::from_le_bytes(bytes.get(at..at.checked_add(8)?)?.try_into().ok()?))
}

impl Archive {
    /// Reads the directory.
    ///
    /// # Errors
    /// When there is none, or it points outside the file.
    pub fn open(bytes: Vec<u8>) -> Result<Self, Defect> {
        let files = directory(&bytes).ok_or(Defect::Damaged)?;
        Ok(Self { bytes: Rc::new(bytes), files })
    }

    /// Whether there is a file of this name.
    pub fn has(&self, name: &str) -> bool {
        self.find(name).is_some()
    }

    /// The names of all files, in the order of the directory.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.files.iter().map(|file| file.name.as_str())
    }

    /// Where a file is, unless it is encrypted.
    pub fn stored(&self, name: &str) -> Option<Stored> {
        let file = self.find(name).filter(|file| !file.encrypted)?;
        Some(Stored { range: self.content(file)?, deflated: file.deflated, expanded: file.expanded })
    }

    fn find(&self, name: &str) -> Option<&File> {
        let name = name.trim_start_matches('/');
        self.files.iter().find(|file| file.name.eq_ignore_ascii_case(name))
    }

    /// Opens a file; `most` bytes at most may come out of it.
    ///
    /// # Errors
    /// When there is no such file, it is encrypted, or it would expand too much.
    pub fn part(&self, name: &str, most: Option<u64>) -> Result<Part, Defect> {
        let file = self.find(name).ok_or(Defect::Damaged)?;
        if file.encrypted {
            return Err(Defect::Protected);
        }
        let allowed = MOST_EXPANDED.min(ALWAYS_ALLOWED.saturating_add(file.packed.saturating_mul(MOST_EXPANSION)));
        if file.expanded > allowed.min(most.unwrap_or(u64::MAX)) {
            return Err(Defect::Expands { packed: file.packed, expanded: file.expanded });
        }
        let range = self.content(file).ok_or(Defect::Damaged)?;
        Ok(Part::new(Rc::clone(&self.bytes), range, file.deflated, file.expanded, file.checksum))
    }

    /// Where the content of a file is: behind a header of its own.
    fn content(&self, file: &File) -> Option<Range<usize>> {
        let header = usize::try_from(file.header).ok()?;
        let bytes = self.bytes.get(header..)?;
        if !bytes.starts_with(b"PK\x03\x04") {
            return None;
        }
        let before = 30 + usize::from(word(bytes, 26)?) + usize::from(word(bytes, 28)?);
        let start = header.checked_add(before)?;
        let end = start.checked_add(usize::try_from(file.packed).ok()?)?;
        (end <= self.bytes.len()).then_some(start..end)
    }
}

/// The files that the directory at the end of the archive lists.
fn directory(bytes: &[u8]) -> Option<Vec<File>> {
    // The record of the end is followed by a comment of at most 65535 bytes.
    let last = bytes.len().checked_sub(22)?;
    let end = (last.saturating_sub(65_535)..=last).rev().find(|at| bytes.get(*at..).is_some_and(is_end))?;
    let files = usize::from(word(bytes, end + 10)?).min(MOST_FILES);
    let mut at = usize::try_from(double(bytes, end + 16)?).ok()?;
    let mut found = Vec::new();
    for _ in 0..files {
        let entry = bytes.get(at..)?;
        if !entry.starts_with(b"PK\x01\x02") {
            return None;
        }
        let (name, extra, comment) =
            (usize::from(word(entry, 28)?), usize::from(word(entry, 30)?), usize::from(word(entry, 32)?));
        let method = word(entry, 10)?;
        let mut file = File {
            // Some programs write their names with the separator of Windows.
            name: String::from_utf8_lossy(entry.get(46..46 + name)?).replace('\\', "/"),
            encrypted: word(entry, 8)? & 1 == 1,
            deflated: method == 8,
            checksum: double(entry, 16)?,
            packed: double(entry, 20)?.into(),
            expanded: double(entry, 24)?.into(),
            header: double(entry, 42)?.into(),
        };
        large_sizes(&mut file, entry.get(46 + name..46 + name + extra)?);
        // Other methods are in no workbook.
        if method == 0 || method == 8 {
            found.push(file);
        }
        at += 46 + name + extra + comment;
    }
    Some(found)
}

fn is_end(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PK\x05\x06")
}

/// Sizes that do not fit into 32 bits stand in an extra field; some programs always write them there.
fn large_sizes(file: &mut File, mut extra: &[u8]) {
    const LARGE: u64 = 0xffff_ffff;
    while let (Some(kind), Some(length)) = (word(extra, 0), word(extra, 2)) {
        let Some(content) = extra.get(4..4 + usize::from(length)) else { return };
        if kind == 1 {
            let mut at = 0;
            for size in [&mut file.expanded, &mut file.packed, &mut file.header] {
                if *size == LARGE
                    && let Some(large) = quad(content, at)
                {
                    *size = large;
                    at += 8;
                }
            }
        }
        extra = extra.get(4 + usize::from(length)..).unwrap_or_default();
    }
}

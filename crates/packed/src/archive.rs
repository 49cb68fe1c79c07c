//! Directory of a ZIP archive (PKWARE, APPNOTE.TXT 6.3.3), with bounds on the expansion of its files.

use crate::Defect;
use crate::bytes::{double, quad, word};
use crate::part::Part;
use std::ops::Range;
use std::rc::Rc;

/// Greatest length of the comment after the end record, in bytes.
pub(super) const LONGEST_COMMENT: usize = 65_535;
/// Length of the fixed part of the header before the content of a file, in bytes.
pub(super) const HEADER: u64 = 30;
/// Upper bound of the number of files.
const MOST_FILES: usize = 10_000;
/// Upper bound of the expanded size of a file, in bytes. A sheet of a million rows and five columns has half of it.
const MOST_EXPANDED: u64 = 512 << 20;
/// Upper bound of the expansion ratio, apart from the first megabyte. Sheets of measurements expand by 5 to 30; Deflate can
/// reach 1032, which a decompression bomb uses.
const MOST_EXPANSION: u64 = 200;
const ALWAYS_ALLOWED: u64 = 1 << 20;

/// Archive in memory, or the needed pieces of it.
#[derive(Clone, Debug)]
pub struct Archive {
    pieces: Vec<Piece>,
    /// Length in bytes.
    size: u64,
    files: Vec<File>,
}

/// Range of bytes of an archive.
#[derive(Clone, Debug)]
struct Piece {
    /// Offset in the archive.
    start: u64,
    bytes: Rc<Vec<u8>>,
}

/// Location of the content of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stored {
    /// Range of bytes in the archive.
    pub range: Range<u64>,
    /// True if they are compressed (Deflate), false if they are the content.
    pub deflated: bool,
    /// Size of the content in bytes, as stated by the directory.
    pub expanded: u64,
}

/// File as listed in the directory.
#[derive(Clone, Debug)]
pub(super) struct File {
    pub name: String,
    encrypted: bool,
    deflated: bool,
    checksum: u32,
    pub packed: u64,
    expanded: u64,
    /// Date and time of the last change, in the order of time (MS-DOS format).
    modified: u32,
    /// Offset of the header of its content.
    pub header: u64,
}

/// Location of the directory, from the end record.
#[derive(Clone, Debug)]
pub(super) struct End {
    files: usize,
    /// Range of bytes of the directory.
    pub directory: Range<u64>,
}

impl Archive {
    /// Reads the directory.
    ///
    /// # Errors
    /// There is no directory, or it points outside the file.
    pub fn open(bytes: Vec<u8>) -> Result<Self, Defect> {
        let end = end(&bytes).ok_or(Defect::Damaged)?;
        let directory = usize::try_from(end.directory.start).ok().and_then(|start| bytes.get(start..));
        let files = directory.and_then(|directory| files(directory, &end)).ok_or(Defect::Damaged)?;
        Ok(Self::of_pieces(bytes.len() as u64, vec![(0, bytes)], files))
    }

    /// Archive of this length of which only these pieces are known, as (offset, bytes).
    pub(super) fn of_pieces(size: u64, pieces: Vec<(u64, Vec<u8>)>, files: Vec<File>) -> Self {
        let piece = |(start, bytes)| Piece { start, bytes: Rc::new(bytes) };
        Self { pieces: pieces.into_iter().map(piece).collect(), size, files }
    }

    /// True if there is a file of this name.
    pub fn has(&self, name: &str) -> bool {
        self.find(name).is_some()
    }

    /// Names of all files, in the order of the directory.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.files.iter().map(|file| file.name.as_str())
    }

    /// Date and time of the last change of a file, as a number that grows with time; 0 if there is no such file.
    pub fn modified(&self, name: &str) -> u32 {
        self.find(name).map_or(0, |file| file.modified)
    }

    /// Length in bytes.
    pub fn size(&self) -> u64 {
        self.size
    }

    /// Names of the first few files, for a message.
    pub fn first_names(&self) -> Vec<String> {
        const SHOWN: usize = 5;
        let short = |name: &str| name.chars().take(60).collect::<String>();
        let mut names: Vec<String> = self.names().take(SHOWN).map(short).collect();
        if self.files.len() > SHOWN {
            names.push("…".to_owned());
        }
        names
    }

    /// Location of a file; `None` if it does not exist or is encrypted.
    pub fn stored(&self, name: &str) -> Option<Stored> {
        let file = self.find(name).filter(|file| !file.encrypted)?;
        Some(Stored { range: self.content(file)?, deflated: file.deflated, expanded: file.expanded })
    }

    fn find(&self, name: &str) -> Option<&File> {
        let name = name.trim_start_matches('/');
        self.files.iter().find(|file| file.name.eq_ignore_ascii_case(name))
    }

    /// Opens a file that expands to at most `most` bytes.
    ///
    /// # Errors
    /// There is no such file, it is encrypted, or it would expand too much.
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
        let (piece, range) = self.piece(range).ok_or(Defect::Damaged)?;
        Ok(Part::new(Rc::clone(&piece.bytes), range, file.deflated, file.expanded, file.checksum))
    }

    /// Piece that contains a range of bytes, and the range in it.
    fn piece(&self, range: Range<u64>) -> Option<(&Piece, Range<usize>)> {
        self.pieces.iter().find_map(|piece| {
            let [start, end] = [range.start, range.end].map(|at| usize::try_from(at.checked_sub(piece.start)?).ok());
            let range = start?..end?;
            (range.end <= piece.bytes.len()).then_some((piece, range))
        })
    }

    /// Location of the content of a file, after its own header.
    fn content(&self, file: &File) -> Option<Range<u64>> {
        let (piece, range) = self.piece(file.header..file.header.checked_add(HEADER)?)?;
        let bytes = piece.bytes.get(range)?;
        if !bytes.starts_with(b"PK\x03\x04") {
            return None;
        }
        let before = HEADER + u64::from(word(bytes, 26)?) + u64::from(word(bytes, 28)?);
        let start = file.header.checked_add(before)?;
        let end = start.checked_add(file.packed)?;
        (end <= self.size).then_some(start..end)
    }
}

/// End record of an archive, from its last bytes.
pub(super) fn end(bytes: &[u8]) -> Option<End> {
    let last = bytes.len().checked_sub(22)?;
    let end = (last.saturating_sub(LONGEST_COMMENT)..=last).rev().find(|at| bytes.get(*at..).is_some_and(is_end))?;
    let (length, start) = (u64::from(double(bytes, end + 12)?), u64::from(double(bytes, end + 16)?));
    Some(End { files: usize::from(word(bytes, end + 10)?).min(MOST_FILES), directory: start..start + length })
}

/// Files listed in the directory of an archive.
pub(super) fn files(directory: &[u8], end: &End) -> Option<Vec<File>> {
    let mut at = 0_usize;
    let mut found = Vec::new();
    for _ in 0..end.files {
        let entry = directory.get(at..)?;
        if !entry.starts_with(b"PK\x01\x02") {
            return None;
        }
        let (name, extra, comment) =
            (usize::from(word(entry, 28)?), usize::from(word(entry, 30)?), usize::from(word(entry, 32)?));
        let method = word(entry, 10)?;
        let mut file = File {
            // Some programs write Windows separators.
            name: String::from_utf8_lossy(entry.get(46..46 + name)?).replace('\\', "/"),
            encrypted: word(entry, 8)? & 1 == 1,
            deflated: method == 8,
            checksum: double(entry, 16)?,
            packed: double(entry, 20)?.into(),
            expanded: double(entry, 24)?.into(),
            modified: double(entry, 12)?,
            header: double(entry, 42)?.into(),
        };
        large_sizes(&mut file, entry.get(46 + name..46 + name + extra)?);
        // Workbooks use no other methods.
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

/// Reads sizes that do not fit into 32 bits from the extra field; some programs always write them there.
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

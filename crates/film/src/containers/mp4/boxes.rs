//! Boxes of MP4 and QuickTime files (ISO/IEC 14496-12, 4.2).

use super::super::FilmError;
use super::super::bytes::Bytes;

/// Type of a box.
pub(super) type Kind = [u8; 4];

/// Header of a box.
#[derive(Clone, Copy, Debug)]
pub(super) struct Header {
    pub(super) kind: Kind,
    /// Size of the header in bytes.
    pub(super) length: u64,
    /// Size of the box in bytes, with its header; `None` if it extends to the end of its parent.
    pub(super) size: Option<u64>,
}

impl Header {
    /// Maximum size of a header in bytes.
    pub(super) const MOST: u64 = 16;

    /// Reads a header from the start of a box. `None` if bytes are missing or the size is invalid.
    pub(super) fn read(bytes: &[u8]) -> Option<Self> {
        let mut bytes = Bytes(bytes);
        let size = bytes.u32()?;
        let kind = bytes.four()?;
        let (length, size) = match size {
            0 => (8, None),
            1 => (16, Some(bytes.u64()?)),
            size => (8, Some(u64::from(size))),
        };
        size.is_none_or(|size| size >= length).then_some(Self { kind, length, size })
    }
}

/// Iterator over type and content of the boxes in `.0`. Ends at an incomplete box.
#[derive(Clone, Debug)]
pub(super) struct Boxes<'a>(pub(super) &'a [u8]);

impl<'a> Iterator for Boxes<'a> {
    type Item = (Kind, &'a [u8]);

    fn next(&mut self) -> Option<Self::Item> {
        let header = Header::read(self.0)?;
        let size = header.size.map_or(Some(self.0.len()), |size| usize::try_from(size).ok())?;
        let (this, rest) = self.0.split_at_checked(size)?;
        self.0 = rest;
        Some((header.kind, this.get(usize::try_from(header.length).ok()?..)?))
    }
}

/// Content of the first box of type `kind`.
pub(super) fn find<'a>(content: &'a [u8], kind: &Kind) -> Option<&'a [u8]> {
    Boxes(content).find(|(other, _)| other == kind).map(|(_, content)| content)
}

/// Content of the box at the end of a path of nested box types.
pub(super) fn follow<'a>(content: &'a [u8], path: &[&Kind]) -> Option<&'a [u8]> {
    path.iter().try_fold(content, |content, kind| find(content, kind))
}

/// Version and flags at the start of a full box.
pub(super) fn version_and_flags(bytes: &mut Bytes<'_>) -> Option<(u8, u32)> {
    let word = bytes.u32()?;
    Some(((word >> 24) as u8, word & 0x00ff_ffff))
}

/// Rows of a table, `row` bytes each, after version, flags and row count.
///
/// # Errors
///
/// [`FilmError::Damaged`] if the rows do not fit into the box.
pub(super) fn rows<'a>(content: &'a [u8], row: usize, part: &'static str) -> Result<&'a [u8], FilmError> {
    let table = || {
        let mut bytes = Bytes(content);
        bytes.take(4)?;
        let count = usize::try_from(bytes.u32()?).ok()?;
        bytes.take(count.checked_mul(row)?)
    };
    table().ok_or(FilmError::Damaged { part })
}

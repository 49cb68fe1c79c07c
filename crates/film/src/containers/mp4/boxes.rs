//! The boxes of which MP4 and QuickTime files are made (ISO/IEC 14496-12, 4.2).

use super::super::FilmError;
use super::super::bytes::Bytes;

/// The type of a box.
pub(super) type Kind = [u8; 4];

/// The start of a box.
#[derive(Clone, Copy, Debug)]
pub(super) struct Header {
    pub(super) kind: Kind,
    /// Bytes of the header itself.
    pub(super) length: u64,
    /// Bytes of the box with its header; `None` if it goes on to the end of what it is in.
    pub(super) size: Option<u64>,
}

impl Header {
    /// At most so many bytes are needed.
    pub(super) const MOST: u64 = 16;

    /// Reads it from the front of a box.
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

/// The boxes in the content of another one: their types and contents. Ends where no further box fits.
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

/// The content of the first box of this type.
pub(super) fn find<'a>(content: &'a [u8], kind: &Kind) -> Option<&'a [u8]> {
    Boxes(content).find(|(other, _)| other == kind).map(|(_, content)| content)
}

/// The content of the box at the end of a path of types.
pub(super) fn follow<'a>(content: &'a [u8], path: &[&Kind]) -> Option<&'a [u8]> {
    path.iter().try_fold(content, |content, kind| find(content, kind))
}

/// The start of a full box: its version and flags.
pub(super) fn version_and_flags(bytes: &mut Bytes<'_>) -> Option<(u8, u32)> {
    let word = bytes.u32()?;
    Some(((word >> 24) as u8, word & 0x00ff_ffff))
}

/// The rows of a table of `row` bytes each: after version and flags their number, which must fit into the box.
pub(super) fn rows<'a>(content: &'a [u8], row: usize, part: &'static str) -> Result<&'a [u8], FilmError> {
    let table = || {
        let mut bytes = Bytes(content);
        bytes.take(4)?;
        let count = usize::try_from(bytes.u32()?).ok()?;
        bytes.take(count.checked_mul(row)?)
    };
    table().ok_or(FilmError::Damaged { part })
}

//! Coding of the frames of a track: the sample entry in `stsd` (ISO/IEC 14496-12, 8.5.2 and 12.1.3).

use super::super::FilmError;
use super::super::bytes::Bytes;
use super::super::codec::Codec;
use super::super::film::lowest_terms;
use super::boxes::{Boxes, find};

/// Size in bytes of a visual sample entry before its boxes.
const FIXED: usize = 78;
/// Object type of Motion JPEG in `esds` (ISO/IEC 14496-1, table 5).
const OBJECT_JPEG: u8 = 0x6c;

/// Content of a sample entry. Size in px.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub(super) codec: Codec,
    pub(super) size: [u32; 2],
    pub(super) pixel_aspect: [u32; 2],
}

/// Reads the first entry in the content of `stsd`. Cameras do not change the format within a film, so that further
/// entries are ignored.
pub(super) fn entry(content: &[u8]) -> Result<Entry, FilmError> {
    let damaged = FilmError::Damaged { part: "stsd" };
    let Some((kind, content)) = content.get(8..).and_then(|entries| Boxes(entries).next()) else { return Err(damaged) };
    let Some((fixed, boxes)) = content.split_at_checked(FIXED) else { return Err(damaged) };
    let mut fixed = Bytes(fixed);
    let size = fixed.take(24).and_then(|_| fixed.u16().zip(fixed.u16())).unwrap_or_default();
    let codec = match &kind {
        b"avc1" | b"avc3" | b"avc2" | b"avc4" => {
            find(boxes, b"avcC").and_then(|record| Codec::h264(if kind[3] % 2 == 1 { "avc1" } else { "avc3" }, record))
        }
        b"hvc1" | b"dvh1" => find(boxes, b"hvcC").and_then(|record| Codec::hevc("hvc1", record)),
        b"hev1" | b"dvhe" => find(boxes, b"hvcC").and_then(|record| Codec::hevc("hev1", record)),
        b"vp08" => Some(Codec::vp8()),
        b"vp09" => find(boxes, b"vpcC").and_then(Codec::vp9_of_box),
        b"av01" => find(boxes, b"av1C").and_then(Codec::av1),
        b"mp4v" if find(boxes, b"esds").and_then(object_type) == Some(OBJECT_JPEG) => Some(Codec::jpeg()),
        b"encv" | b"drmi" => return Err(FilmError::Encrypted),
        _ => Some(Codec::of_four(kind)),
    };
    let pixel_aspect = find(boxes, b"pasp").and_then(|content| {
        let mut content = Bytes(content);
        lowest_terms(content.u32()?.into(), content.u32()?.into())
    });
    Ok(Entry {
        codec: codec.ok_or(damaged)?,
        size: [size.0.into(), size.1.into()],
        pixel_aspect: pixel_aspect.unwrap_or([1, 1]),
    })
}

/// Object type in the decoder configuration of `esds` (ISO/IEC 14496-1, 7.2.6.5 and 7.2.6.6).
fn object_type(content: &[u8]) -> Option<u8> {
    let mut bytes = Bytes(content.get(4..)?);
    descriptor(&mut bytes, 3)?;
    bytes.take(2)?;
    let flags = bytes.u8()?;
    if flags & 0x80 != 0 {
        bytes.take(2)?;
    }
    if flags & 0x40 != 0 {
        let length = bytes.u8()?;
        bytes.take(length.into())?;
    }
    if flags & 0x20 != 0 {
        bytes.take(2)?;
    }
    descriptor(&mut bytes, 4)?;
    bytes.u8()
}

/// Skips the start of a descriptor: its tag, and its length in at most four bytes of seven bits. `None` for another
/// tag.
fn descriptor(bytes: &mut Bytes<'_>, tag: u8) -> Option<()> {
    (bytes.u8()? == tag).then_some(())?;
    for _ in 0..4 {
        if bytes.u8()? & 0x80 == 0 {
            break;
        }
    }
    Some(())
}

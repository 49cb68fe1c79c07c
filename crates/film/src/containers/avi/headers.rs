//! AVI headers: chunks, the video stream and its OpenDML index.

use super::super::FilmError;
use super::super::bytes::Bytes;
use super::super::codec::Codec;
use super::super::limits::MOST_SAMPLES;

/// Headers of the video stream.
#[derive(Debug)]
pub(super) struct Stream {
    /// Two digits with which the identifiers of its chunks begin.
    pub(super) number: [u8; 2],
    pub(super) codec: Codec,
    /// Width and height in pixels.
    pub(super) size: [u32; 2],
    /// Frame interval in seconds: `scale / rate`.
    pub(super) scale: u32,
    pub(super) rate: u32,
    /// Number of frames of the whole film with missed ones; 0 if the headers state none, or more than [`MOST_SAMPLES`].
    pub(super) length: u32,
    /// Number of further video streams in the file.
    pub(super) further: usize,
    /// Offset and size in bytes of each part of the OpenDML index.
    pub(super) index: Vec<(u64, u32)>,
}

/// Header of a chunk.
pub(super) struct Chunk {
    pub(super) id: [u8; 4],
    pub(super) size: u64,
    /// Type of a list (`LIST` or `RIFF`).
    pub(super) kind: Option<[u8; 4]>,
}

impl Chunk {
    pub(super) fn read(bytes: &[u8]) -> Option<Self> {
        let mut bytes = Bytes(bytes);
        let (id, size) = (bytes.four()?, bytes.u32_le()?.into());
        Some(Self { id, size, kind: if [*b"LIST", *b"RIFF"].contains(&id) { bytes.four() } else { None } })
    }

    /// Offset of the chunk after this one, which begins at `at`. Chunks begin at even offsets.
    pub(super) fn next(&self, at: u64) -> u64 {
        at.saturating_add(8 + self.size + self.size % 2)
    }

    /// Lower bound of the file size in bytes, if this list begins at `at`. Unfinished recordings and those written to a
    /// pipe state 0 or the largest number as size.
    pub(super) fn least_end(&self, at: u64) -> u64 {
        if self.size == u64::from(u32::MAX) { 0 } else { at.saturating_add(8 + self.size) }
    }
}

/// Identifier, list type and content of each chunk in a list.
fn chunks(mut content: &[u8]) -> impl Iterator<Item = ([u8; 4], Option<[u8; 4]>, &[u8])> {
    std::iter::from_fn(move || {
        let chunk = Chunk::read(content)?;
        let (_, rest) = content.split_at_checked(8)?;
        let (this, after) = rest.split_at_checked(usize::try_from(chunk.size).ok()?)?;
        content = after.get(this.len() % 2..).unwrap_or_default();
        Some((chunk.id, chunk.kind, if chunk.kind.is_some() { this.get(4..)? } else { this }))
    })
}

/// Base of the offsets and the rows in one part of the OpenDML index (`ix00`).
pub(super) fn standard_index(content: &[u8]) -> Option<(u64, &[u8])> {
    let mut bytes = Bytes(content);
    bytes.take(8)?;
    (bytes.u16_le()? == 2 && bytes.u16()? == 0x0001).then_some(())?;
    let count = usize::try_from(bytes.u32_le()?).ok()?;
    bytes.four()?;
    let base = bytes.u64_le()?;
    bytes.take(4)?;
    Some((base, bytes.take(count.checked_mul(8)?)?))
}

/// Finds the video stream in the content of `hdrl`. Prefers codings that browsers decode.
///
/// # Errors
///
/// [`FilmError::NoVideo`] without a video stream, [`FilmError::Damaged`] if no video stream can be read.
pub(super) fn stream(content: &[u8]) -> Result<Stream, FilmError> {
    let lists = chunks(content).filter(|(_, kind, _)| *kind == Some(*b"strl")).map(|(_, _, list)| list);
    let videos: Vec<_> = lists.enumerate().filter_map(|(number, list)| read_stream(number, list)).collect();
    let further = videos.len().saturating_sub(1);
    let failed = videos.iter().find_map(|video| video.as_ref().err().cloned());
    let (first, others): (Vec<Stream>, Vec<Stream>) =
        videos.into_iter().filter_map(Result::ok).partition(|stream| stream.codec.coding.is_in_browsers());
    let found = first.into_iter().chain(others).next();
    let stream = found.ok_or(failed.unwrap_or(FilmError::NoVideo))?;
    // `strh` may count only the frames of the first OpenDML part.
    let lists = chunks(content).filter(|(_, kind, _)| *kind == Some(*b"odml"));
    let all = lists.flat_map(|(_, _, list)| chunks(list)).find(|(id, _, _)| id == b"dmlh");
    let all = all.and_then(|(_, _, content)| Bytes(content).u32_le()).unwrap_or(0);
    let length = [stream.length, all].into_iter().filter(|&length| length as usize <= MOST_SAMPLES).max();
    Ok(Stream { further, length: length.unwrap_or(0), ..stream })
}

/// Reads `strl`; `None` if it is not a video stream.
fn read_stream(number: usize, list: &[u8]) -> Option<Result<Stream, FilmError>> {
    let part = |id: &[u8; 4]| chunks(list).find(|(other, _, _)| other == id).map(|(_, _, content)| content);
    let header = part(b"strh")?;
    header.starts_with(b"vids").then_some(())?;
    let read = || {
        let digit = |value: usize| u8::try_from(value).ok().filter(|value| *value < 10).map(|value| b'0' + value);
        let mut header = Bytes(header.get(20..)?);
        let (scale, rate) = (header.u32_le()?, header.u32_le()?);
        header.take(4)?;
        let length = header.u32_le()?;
        let mut format = Bytes(part(b"strf")?.get(4..)?);
        let size = [format.u32_le()?, format.u32_le()?.cast_signed().unsigned_abs()];
        format.take(4)?;
        let coding = format.four()?;
        let index = part(b"indx").and_then(super_index).unwrap_or_default();
        (scale > 0 && rate > 0).then_some(())?;
        let number = [digit(number / 10)?, digit(number % 10)?];
        Some(Stream { number, codec: Codec::of_four(coding), size, scale, rate, length, further: 0, index })
    };
    Some(read().ok_or(FilmError::Damaged { part: "strl" }))
}

/// Reads offset and size of each part of the OpenDML index from the content of `indx`.
fn super_index(content: &[u8]) -> Option<Vec<(u64, u32)>> {
    let mut bytes = Bytes(content);
    (bytes.u16_le()? == 4 && bytes.u16()? == 0).then_some(())?;
    let count = bytes.u32_le()?;
    bytes.take(16)?;
    let mut rows = bytes.take(usize::try_from(count).ok()?.checked_mul(16)?)?.chunks_exact(16);
    rows.try_fold(Vec::new(), |mut parts, row| {
        let mut row = Bytes(row);
        parts.push((row.u64_le()?, row.u32_le()?));
        Some(parts)
    })
}

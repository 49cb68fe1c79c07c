//! AVI with a JPEG picture for each frame (Microsoft, AVI RIFF File Reference; OpenDML AVI File Format Extensions 1.02).
//!
//! Frames are found by the index of OpenDML, else by `idx1`, else by walking the chunks. A frame has no time of its own: it is
//! its number times the interval that the header states. An empty chunk stands for a frame that was missed.

use super::FilmError;
use super::bytes::Bytes;
use super::codec::Codec;
use super::film::{Container, Film, Orientation, Sample, Samples};
use super::limits::{MOST_PARTS, MOST_SAMPLES, MOST_TABLE};
use super::notice::Notice;
use super::piece::{Piece, Reader, Stop};

/// What is read from the start of a chunk on.
const AHEAD: u64 = 4 << 10;

/// Reads the chunks of a file.
#[derive(Debug, Default)]
pub(super) struct Avi {
    at: u64,
    chunks: usize,
    stage: Stage,
    stream: Option<Stream>,
    /// Where the list of frames begins: at its type, `movi`.
    frames_at: Option<u64>,
    samples: Samples,
    /// The number of the next frame, missed ones counted.
    number: u32,
}

#[derive(Debug, Default)]
enum Stage {
    /// Headers, and `idx1` behind the frames.
    #[default]
    Headers,
    /// The parts of the index of OpenDML, of which so many are done.
    Index(usize),
    /// From chunk to chunk.
    Walk,
}

/// The stream of video, as its headers have it.
#[derive(Debug)]
struct Stream {
    /// The characters with which its chunks begin.
    number: [u8; 2],
    codec: Codec,
    size: [u32; 2],
    /// A frame lasts `scale / rate` seconds.
    scale: u32,
    rate: u32,
    length: u32,
    further: usize,
    /// The parts of its index: offset and size.
    index: Vec<(u64, u32)>,
}

/// The header of a chunk.
struct Chunk {
    id: [u8; 4],
    size: u64,
    /// The type of a list.
    kind: Option<[u8; 4]>,
}

impl Chunk {
    fn read(bytes: &[u8]) -> Option<Self> {
        let mut bytes = Bytes(bytes);
        let (id, size) = (bytes.four()?, bytes.u32_le()?.into());
        Some(Self { id, size, kind: if [*b"LIST", *b"RIFF"].contains(&id) { bytes.four() } else { None } })
    }

    /// Where the next one begins, if this one begins at `at`. Chunks begin at even offsets.
    fn next(&self, at: u64) -> u64 {
        at.saturating_add(8 + self.size + self.size % 2)
    }
}

impl Reader for Avi {
    fn advance(&mut self, piece: &Piece) -> Result<Film, Stop> {
        loop {
            self.chunks += 1;
            if self.chunks > MOST_PARTS {
                return Err(FilmError::TooLarge.into());
            }
            let done = match self.stage {
                Stage::Headers => self.headers(piece)?,
                Stage::Index(part) => self.index_part(part, piece)?,
                Stage::Walk => self.walk(piece)?,
            };
            if let Some(notice) = done {
                return self.finish(notice, piece);
            }
        }
    }
}

impl Avi {
    /// Passes one chunk before or behind the frames. `Some` at the end.
    fn headers(&mut self, piece: &Piece) -> Result<Option<Option<Notice>>, Stop> {
        let chunk = Chunk::read(piece.get(self.at, 12, AHEAD)?);
        let Some(chunk) = chunk else { return self.begin_walk(piece) };
        let content = |from: u64| {
            if chunk.size > MOST_TABLE { Err(FilmError::TooLarge.into()) } else { piece.get(from, chunk.size, 0) }
        };
        let mut next = chunk.next(self.at);
        match (&chunk.id, &chunk.kind) {
            (b"RIFF", _) => next = self.at.saturating_add(12),
            (b"LIST", Some(kind)) if kind == b"hdrl" && self.stream.is_none() => {
                self.stream = Some(stream(content(self.at + 8)?.get(4..).unwrap_or_default())?);
            }
            (b"LIST", Some(kind)) if kind == b"movi" && self.frames_at.is_none() => {
                self.frames_at = Some(self.at + 8);
                if self.stream.as_ref().is_some_and(|stream| !stream.index.is_empty()) {
                    self.stage = Stage::Index(0);
                }
            }
            (b"idx1", _)
                if next.saturating_sub(1) <= piece.size && self.old_index(content(self.at + 8)?, piece.size)? =>
            {
                return Ok(Some(None));
            }
            _ => {}
        }
        self.at = next;
        Ok(None)
    }

    fn begin_walk(&mut self, piece: &Piece) -> Result<Option<Option<Notice>>, Stop> {
        let Some(frames_at) = self.frames_at else { return Err(FilmError::Truncated { bytes: piece.size }.into()) };
        self.at = frames_at + 4;
        self.stage = Stage::Walk;
        (self.samples, self.number) = (Samples::default(), 0);
        Ok(None)
    }

    /// Takes the next frame, or passes over one that was missed.
    fn add(&mut self, offset: u64, size: u32, file: u64) -> Result<(), FilmError> {
        let scale = self.stream.as_ref().map_or(0, |stream| stream.scale);
        let ticks = i64::from(self.number) * i64::from(scale);
        self.number += 1;
        if self.number as usize > MOST_SAMPLES {
            return Err(FilmError::TooLarge);
        }
        self.samples.add(Sample { offset, size, ticks, key: true, shown: true }, file);
        Ok(())
    }

    fn is_frame(&self, id: [u8; 4]) -> bool {
        let [first, second, kind @ ..] = id;
        self.stream.as_ref().is_some_and(|stream| stream.number == [first, second]) && [*b"dc", *b"db"].contains(&kind)
    }

    /// Reads `idx1`; returns whether it lists frames that are there.
    fn old_index(&mut self, content: &[u8], file: u64) -> Result<bool, FilmError> {
        let Some(frames_at) = self.frames_at else { return Ok(false) };
        let mut base = None;
        for row in content.chunks_exact(16) {
            let mut row = Bytes(row);
            let fields = || Some((row.four()?, row.u32_le()?, row.u32_le()?, row.u32_le()?));
            let Some((id, _, offset, size)) = { fields }() else { break };
            // Offsets count from the list of frames, or with some writers from the start of the file.
            let base = *base.get_or_insert(if u64::from(offset) < frames_at { frames_at } else { 0 });
            if self.is_frame(id) {
                self.add(base + u64::from(offset) + 8, size, file)?;
            }
        }
        Ok(!self.samples.list.is_empty())
    }

    /// Reads a part of the index of OpenDML. If it is not what it should be, the chunks are walked.
    fn index_part(&mut self, part: usize, piece: &Piece) -> Result<Option<Option<Notice>>, Stop> {
        let Some(stream) = &self.stream else { return Err(FilmError::NoVideo.into()) };
        let Some(&(offset, size)) = stream.index.get(part) else {
            return if self.samples.list.is_empty() { self.begin_walk(piece) } else { Ok(Some(None)) };
        };
        if u64::from(size) > MOST_TABLE {
            return Err(FilmError::TooLarge.into());
        }
        let content = piece.get(offset, size.into(), 0)?;
        let Some((base, rows)) = standard_index(content) else { return self.begin_walk(piece) };
        for row in rows.chunks_exact(8) {
            let mut row = Bytes(row);
            let (offset, size) = (row.u32_le().unwrap_or(0), row.u32_le().unwrap_or(0));
            // The highest bit of the size marks a frame that is no key frame; each JPEG is one.
            self.add(base.saturating_add(offset.into()), size & 0x7fff_ffff, piece.size)?;
        }
        self.stage = Stage::Index(part + 1);
        Ok(None)
    }

    /// Passes one chunk among the frames. `Some` at the end.
    fn walk(&mut self, piece: &Piece) -> Result<Option<Option<Notice>>, Stop> {
        let start = piece.get(self.at, 12, AHEAD)?;
        let Some(chunk) = Chunk::read(start) else {
            let cut = Notice::Truncated { present: self.samples.list.len(), lost: 0, bytes: piece.size };
            return Ok(Some((!start.is_empty()).then_some(cut)));
        };
        if !chunk.id.iter().all(|byte| byte.is_ascii_graphic() || *byte == b' ') {
            return Ok(Some(Some(Notice::Broken { at: self.at })));
        }
        if chunk.kind.is_some() {
            self.at += 12;
            return Ok(None);
        }
        let next = chunk.next(self.at);
        if next.saturating_sub(1) > piece.size {
            return Ok(Some(Some(Notice::Truncated { present: self.samples.list.len(), lost: 0, bytes: piece.size })));
        }
        if self.is_frame(chunk.id) {
            self.add(self.at + 8, u32::try_from(chunk.size).unwrap_or(0), piece.size)?;
        }
        self.at = next;
        Ok(None)
    }

    fn finish(&mut self, notice: Option<Notice>, piece: &Piece) -> Result<Film, Stop> {
        let Some(stream) = self.stream.take() else { return Err(FilmError::NoVideo.into()) };
        let Samples { list: samples, lost } = std::mem::take(&mut self.samples);
        if samples.is_empty() {
            return Err(FilmError::NoFrames.into());
        }
        let mut notices = Vec::new();
        if stream.further > 0 {
            notices.push(Notice::FurtherVideos(stream.further));
        }
        let cut = Notice::Truncated { present: samples.len(), lost, bytes: piece.size };
        notices.extend(notice.or((lost > 0).then_some(cut)));
        let second = f64::from(stream.rate);
        Ok(Film {
            container: Container::Avi,
            codec: stream.codec,
            size: stream.size,
            pixel_aspect: [1, 1],
            orientation: Orientation::default(),
            timescale: stream.rate,
            samples,
            capture_rate: None,
            stated_rate: Some(second / f64::from(stream.scale)),
            duration: (stream.length > 0).then(|| f64::from(stream.length) * f64::from(stream.scale) / second),
            created: None,
            notices,
        })
    }
}

/// The chunks in a list.
fn chunks(mut content: &[u8]) -> impl Iterator<Item = ([u8; 4], Option<[u8; 4]>, &[u8])> {
    std::iter::from_fn(move || {
        let chunk = Chunk::read(content)?;
        let (_, rest) = content.split_at_checked(8)?;
        let (this, after) = rest.split_at_checked(usize::try_from(chunk.size).ok()?)?;
        content = after.get(this.len() % 2..).unwrap_or_default();
        Some((chunk.id, chunk.kind, if chunk.kind.is_some() { this.get(4..)? } else { this }))
    })
}

/// The base of the offsets in a part of the index, `ix00`, and its rows.
fn standard_index(content: &[u8]) -> Option<(u64, &[u8])> {
    let mut bytes = Bytes(content);
    bytes.take(8)?;
    (bytes.u16_le()? == 2 && bytes.u16()? == 0x0001).then_some(())?;
    let count = usize::try_from(bytes.u32_le()?).ok()?;
    bytes.four()?;
    let base = bytes.u64_le()?;
    bytes.take(4)?;
    Some((base, bytes.take(count.checked_mul(8)?)?))
}

/// The stream of video in the content of `hdrl`.
fn stream(content: &[u8]) -> Result<Stream, FilmError> {
    let lists = chunks(content).filter(|(_, kind, _)| *kind == Some(*b"strl")).map(|(_, _, list)| list);
    let videos: Vec<_> = lists.enumerate().filter_map(|(number, list)| read_stream(number, list)).collect();
    let further = videos.len().saturating_sub(1);
    let failed = videos.iter().find_map(|video| video.as_ref().err().cloned());
    let found = videos.into_iter().find_map(Result::ok);
    let stream = found.ok_or(failed.unwrap_or(FilmError::NoVideo))?;
    Ok(Stream { further, ..stream })
}

/// Reads `strl`; `None` if it is no video.
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
        Some((coding, Stream { number, codec: Codec::jpeg(), size, scale, rate, length, further: 0, index }))
    };
    let jpeg = |coding: [u8; 4]| [b"MJPG", b"JPEG", b"DMB1"].contains(&&coding.map(|byte| byte.to_ascii_uppercase()));
    Some(match read() {
        Some((coding, stream)) if jpeg(coding) => Ok(stream),
        Some((coding, _)) => Err(FilmError::unknown_codec(&coding)),
        None => Err(FilmError::Damaged { part: "strl" }),
    })
}

/// The parts of the index of OpenDML, in the content of `indx`.
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

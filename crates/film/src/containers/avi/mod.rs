//! AVI (Microsoft, AVI RIFF File Reference; OpenDML AVI File Format Extensions 1.02).
//!
//! Frames are found by the OpenDML index, else by `idx1`, else by walking the chunks. A frame has no time of its own:
//! its time is its number times the frame interval in the header. An empty chunk marks a missed frame.

mod headers;

use super::FilmError;
use super::bytes::Bytes;
use super::codec::Coding;
use super::film::{Container, Film, Orientation, Sample, Samples};
use super::limits::{MOST_PARTS, MOST_SAMPLES, MOST_TABLE};
use super::notice::Notice;
use super::piece::{Piece, Reader, Stop};
use headers::{Chunk, Stream, standard_index, stream};

/// Bytes requested from the start of a chunk.
const AHEAD: u64 = 4 << 10;
/// Flag of a key frame in `idx1`.
const KEY: u32 = 0x10;

/// Reader of AVI files.
#[derive(Debug, Default)]
pub(super) struct Avi {
    at: u64,
    chunks: usize,
    stage: Stage,
    stream: Option<Stream>,
    /// Offset of the type `movi` in the list of frames.
    frames_at: Option<u64>,
    /// Lower bound of the complete file size in bytes, by list sizes and index offsets.
    least_end: u64,
    samples: Samples,
    /// Number of the next frame; missed frames count.
    number: u32,
}

#[derive(Debug, Default)]
enum Stage {
    /// Reading headers, and `idx1` after the frames.
    #[default]
    Headers,
    /// Reading the part of the OpenDML index with this number.
    Index(usize),
    /// Walking the chunks.
    Walk,
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
    /// Reads one chunk before or after the frames. `Some` at the end of the film.
    fn headers(&mut self, piece: &Piece) -> Result<Option<Option<Notice>>, Stop> {
        let chunk = Chunk::read(piece.get(self.at, 12, AHEAD)?);
        let Some(chunk) = chunk else { return self.begin_walk(piece) };
        if chunk.kind.is_some() {
            self.least_end = self.least_end.max(chunk.least_end(self.at));
        }
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
                if self.at + 8 + chunk.size <= piece.size && self.old_index(content(self.at + 8)?, piece.size)? =>
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

    /// Adds the next frame. A frame of size 0 is counted but not listed. `file`: size of the file in bytes.
    ///
    /// # Errors
    ///
    /// [`FilmError::TooLarge`] after [`MOST_SAMPLES`] frames.
    fn add(&mut self, offset: u64, size: u32, key: bool, file: u64) -> Result<(), FilmError> {
        let (scale, coding) =
            self.stream.as_ref().map_or((0, Coding::Jpeg), |stream| (stream.scale, stream.codec.coding));
        let ticks = i64::from(self.number) * i64::from(scale);
        let key = key || coding == Coding::Jpeg;
        self.number += 1;
        if self.number as usize > MOST_SAMPLES {
            return Err(FilmError::TooLarge);
        }
        self.samples.add(Sample { offset, size, ticks, key, shown: true }, file);
        Ok(())
    }

    fn is_frame(&self, id: [u8; 4]) -> bool {
        let [first, second, kind @ ..] = id;
        self.stream.as_ref().is_some_and(|stream| stream.number == [first, second]) && [*b"dc", *b"db"].contains(&kind)
    }

    /// Reads `idx1`. Returns true if it lists frames inside the file, which has `file` bytes.
    fn old_index(&mut self, content: &[u8], file: u64) -> Result<bool, FilmError> {
        let Some(frames_at) = self.frames_at else { return Ok(false) };
        let mut base = None;
        for row in content.chunks_exact(16) {
            let mut row = Bytes(row);
            let fields = || Some((row.four()?, row.u32_le()?, row.u32_le()?, row.u32_le()?));
            let Some((id, flags, offset, size)) = { fields }() else { break };
            // Offsets count from the list of frames; some writers count from the start of the file.
            let base = *base.get_or_insert(if u64::from(offset) < frames_at { frames_at } else { 0 });
            if self.is_frame(id) {
                self.add(base + u64::from(offset) + 8, size, flags & KEY != 0, file)?;
            }
        }
        Ok(!self.samples.list.is_empty())
    }

    /// Reads one part of the OpenDML index. Falls back to walking the chunks if its header is invalid.
    fn index_part(&mut self, part: usize, piece: &Piece) -> Result<Option<Option<Notice>>, Stop> {
        let Some(stream) = &self.stream else { return Err(FilmError::NoVideo.into()) };
        let Some(&(offset, size)) = stream.index.get(part) else {
            return if self.samples.list.is_empty() { self.begin_walk(piece) } else { Ok(Some(None)) };
        };
        if u64::from(size) > MOST_TABLE {
            return Err(FilmError::TooLarge.into());
        }
        self.least_end = self.least_end.max(offset.saturating_add(size.into()));
        let content = piece.get(offset, size.into(), 0)?;
        let Some((base, rows)) = standard_index(content) else { return self.begin_walk(piece) };
        for row in rows.chunks_exact(8) {
            let mut row = Bytes(row);
            let (offset, size) = (row.u32_le().unwrap_or(0), row.u32_le().unwrap_or(0));
            // The highest bit of the size marks a frame that is not a key frame.
            self.add(base.saturating_add(offset.into()), size & 0x7fff_ffff, size >> 31 == 0, piece.size)?;
        }
        self.stage = Stage::Index(part + 1);
        Ok(None)
    }

    /// Reads the header of one chunk among the frames. `Some` at the end of the film.
    fn walk(&mut self, piece: &Piece) -> Result<Option<Option<Notice>>, Stop> {
        let start = piece.get(self.at, 12, AHEAD)?;
        let Some(chunk) = Chunk::read(start) else {
            let cut = !start.is_empty() || self.least_end > piece.size;
            return Ok(Some(if cut { self.truncated(piece) } else { None }));
        };
        if !chunk.id.iter().all(|byte| byte.is_ascii_graphic() || *byte == b' ') {
            return Ok(Some(Some(Notice::Broken { at: self.at })));
        }
        if chunk.kind.is_some() {
            self.least_end = self.least_end.max(chunk.least_end(self.at));
            self.at += 12;
            return Ok(None);
        }
        let next = chunk.next(self.at);
        if next.saturating_sub(chunk.size % 2) > piece.size {
            return Ok(Some(self.truncated(piece)));
        }
        if self.is_frame(chunk.id) {
            let key = self.samples.list.is_empty();
            self.add(self.at + 8, u32::try_from(chunk.size).unwrap_or(0), key, piece.size)?;
        }
        self.at = next;
        Ok(None)
    }

    /// Notice that the file is cut off, with the number of missing frames by the header. `None` if no frame is missing,
    /// only the index.
    fn truncated(&self, piece: &Piece) -> Option<Notice> {
        let stated = self.stream.as_ref().map_or(0, |stream| stream.length);
        let lost = stated.saturating_sub(self.number) as usize;
        let cut = Notice::Truncated { present: self.samples.list.len(), lost, bytes: piece.size };
        (self.number != stated).then_some(cut)
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

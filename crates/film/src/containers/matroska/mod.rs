//! WebM and Matroska (RFC 9559). The index of such a file lists only key frames. All block headers are read instead.

mod ebml;
mod track;

use super::FilmError;
use super::bytes::Bytes;
use super::film::{Container, Film, Sample, Samples};
use super::limits::{MOST_PARTS, MOST_SAMPLES, MOST_TABLE};
use super::notice::Notice;
use super::piece::{Piece, Reader, Stop};
use ebml::{Header, find, float, number, unsigned};
use track::{Track, tracks};
use units::order::sort_by_key;

/// Element identifiers.
const EBML: u32 = 0x1a45_dfa3;
const SEGMENT: u32 = 0x1853_8067;
const INFO: u32 = 0x1549_a966;
const TRACKS: u32 = 0x1654_ae6b;
const CLUSTER: u32 = 0x1f43_b675;
const TIMESTAMP: u32 = 0xe7;
const SIMPLE_BLOCK: u32 = 0xa3;
const BLOCK_GROUP: u32 = 0xa0;
const BLOCK: u32 = 0xa1;
const REFERENCE_BLOCK: u32 = 0xfb;

/// Bytes requested at once among small blocks, and after a large block, which is skipped.
const DENSE: u64 = 1 << 20;
const SPARSE: u64 = 4 << 10;
/// Blocks with more bytes are large.
const LARGE: u64 = 32 << 10;
/// Bytes read of a block: track number, time, flags and the start of its frame.
const BLOCK_START: u64 = 64;
/// Seconds from 1970-01-01 to 2001-01-01, the epoch of Matroska dates.
const TO_2001: i64 = 978_307_200;

/// Reader of the elements of a file. It enters segments, clusters and groups instead of skipping them. Their sizes,
/// unknown in live recordings, are not needed.
#[derive(Debug, Default)]
pub(super) struct Matroska {
    at: u64,
    ahead: u64,
    elements: usize,
    web: bool,
    info: Info,
    track: Option<Track>,
    further: usize,
    /// Offset of the end of the segment, if known.
    end: Option<u64>,
    /// Time of the cluster, in units of `info.scale` nanoseconds.
    cluster: u64,
    samples: Samples,
    /// True if the last block added a frame of the chosen track.
    ours: bool,
}

#[derive(Debug)]
struct Info {
    /// Nanoseconds per tick.
    scale: u64,
    duration: Option<f64>,
    created: Option<i64>,
}

impl Default for Info {
    fn default() -> Self {
        Self { scale: 1_000_000, duration: None, created: None }
    }
}

impl Reader for Matroska {
    fn advance(&mut self, piece: &Piece) -> Result<Film, Stop> {
        loop {
            let start = piece.get(self.at, Header::MOST, self.ahead)?;
            if start.is_empty() || self.end.is_some_and(|end| self.at >= end) {
                let cut = self.end.is_some_and(|end| end > piece.size);
                return self.finish(cut.then(|| self.truncated(piece)));
            }
            let Some(header) = Header::read(start) else {
                let notice = if start.len() < 12 { self.truncated(piece) } else { Notice::Broken { at: self.at } };
                return self.finish(Some(notice));
            };
            let content = self.at.saturating_add(header.length);
            if [SEGMENT, CLUSTER, BLOCK_GROUP].contains(&header.id) {
                if header.id == SEGMENT {
                    self.end = header.size.map(|size| content.saturating_add(size));
                }
                self.step(content)?;
                continue;
            }
            let Some(size) = header.size else { return self.finish(Some(Notice::Broken { at: self.at })) };
            let next = content.saturating_add(size);
            if next > piece.size {
                return self.finish(Some(self.truncated(piece)));
            }
            self.element(header.id, content, size, piece)?;
            self.ahead = if size > LARGE { SPARSE } else { DENSE };
            self.step(next)?;
        }
    }
}

impl Matroska {
    fn step(&mut self, to: u64) -> Result<(), FilmError> {
        self.at = to;
        self.elements += 1;
        if self.elements > MOST_PARTS { Err(FilmError::TooLarge) } else { Ok(()) }
    }

    /// Reads an element with `size` bytes of content from offset `at`.
    fn element(&mut self, id: u32, at: u64, size: u64, piece: &Piece) -> Result<(), Stop> {
        let content = || {
            if size > MOST_TABLE { Err(FilmError::TooLarge.into()) } else { piece.get(at, size, self.ahead) }
        };
        match id {
            EBML => self.web = find(content()?, 0x4282).is_some_and(|kind| kind.starts_with(b"webm")),
            INFO => self.info = Info::read(content()?),
            TRACKS if self.track.is_none() => {
                let tracks = tracks(content()?);
                self.further = tracks.len().saturating_sub(1);
                let failed = tracks.iter().find_map(|track| track.as_ref().err().cloned());
                let mut found: Vec<_> = tracks.into_iter().filter_map(Result::ok).collect();
                sort_by_key(&mut found, |track| !track.codec.coding.is_in_browsers());
                let found = found.into_iter().next();
                self.track = Some(found.ok_or(failed.unwrap_or(FilmError::NoVideo))?);
            }
            TIMESTAMP => self.cluster = unsigned(content()?).unwrap_or(0),
            SIMPLE_BLOCK | BLOCK => {
                let start = piece.get(at, BLOCK_START.min(size), self.ahead)?;
                self.block(start, at, size, id == SIMPLE_BLOCK, piece.size)?;
            }
            REFERENCE_BLOCK if self.ours => {
                if let Some(sample) = self.samples.list.last_mut() {
                    sample.key = false;
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// Reads the start of a block (RFC 9559, 10.1 and 10.2). `file`: size of the file in bytes.
    fn block(&mut self, start: &[u8], at: u64, size: u64, simple: bool, file: u64) -> Result<(), FilmError> {
        self.ours = false;
        let Some(track) = &mut self.track else { return Err(FilmError::NoVideo) };
        let mut bytes = Bytes(start);
        let fields = number(&mut bytes, false).zip(bytes.u16()).zip(bytes.u8());
        let Some((((number, _), time), flags)) = fields else { return Err(FilmError::Damaged { part: "Block" }) };
        if number != track.number {
            return Ok(());
        }
        if flags & 6 != 0 {
            return Err(FilmError::Packed);
        }
        if self.samples.list.len() >= MOST_SAMPLES {
            return Err(FilmError::TooLarge);
        }
        if !bytes.0.is_empty()
            && let Some(codec) = track.ask_frame.take()
        {
            track.codec = codec(bytes.0).ok_or(FilmError::Damaged { part: "CodecPrivate" })?;
        }
        let read = (start.len() - bytes.0.len()) as u64;
        let ticks = i64::try_from(self.cluster).unwrap_or(i64::MAX).saturating_add(time.cast_signed().into());
        let ticks = ticks.saturating_mul(i64::try_from(self.info.scale).unwrap_or(i64::MAX));
        let size = u32::try_from(size - read).map_err(|_| FilmError::Damaged { part: "Block" })?;
        let key = !simple || flags & 0x80 != 0;
        self.samples.add(Sample { offset: at + read, size, ticks, key, shown: true }, file);
        self.ours = size > 0;
        Ok(())
    }

    fn truncated(&self, piece: &Piece) -> Notice {
        Notice::Truncated { present: self.samples.list.len(), lost: 0, bytes: piece.size }
    }

    fn finish(&mut self, notice: Option<Notice>) -> Result<Film, Stop> {
        let Some(track) = self.track.take() else {
            return Err(match notice {
                Some(Notice::Truncated { bytes, .. }) => FilmError::Truncated { bytes },
                Some(_) => FilmError::Damaged { part: "Segment" },
                None => FilmError::NoVideo,
            }
            .into());
        };
        let samples = std::mem::take(&mut self.samples.list);
        if samples.is_empty() {
            return Err(FilmError::NoFrames.into());
        }
        let mut notices = Vec::new();
        if self.further > 0 {
            notices.push(Notice::FurtherVideos(self.further));
        }
        if track.orientation.is_none() {
            notices.push(Notice::Skewed);
        }
        notices.extend(notice);
        Ok(Film {
            container: if self.web { Container::WebM } else { Container::Matroska },
            codec: track.codec,
            size: track.size,
            pixel_aspect: track.pixel_aspect,
            orientation: track.orientation.unwrap_or_default(),
            timescale: 1_000_000_000,
            samples,
            capture_rate: None,
            stated_rate: track.stated_rate,
            duration: self.info.duration.map(|ticks| ticks * self.info.scale as f64 / 1e9),
            created: self.info.created,
            notices,
        })
    }
}

impl Info {
    fn read(content: &[u8]) -> Self {
        let scale = find(content, 0x002a_d7b1).and_then(unsigned).filter(|&scale| scale > 0);
        let date = find(content, 0x4461).filter(|date| date.len() == 8).and_then(unsigned);
        Self {
            scale: scale.unwrap_or(1_000_000),
            duration: find(content, 0x4489).and_then(float).filter(|ticks| ticks.is_finite() && *ticks > 0.0),
            created: date.map(|nanoseconds| nanoseconds.cast_signed().div_euclid(1_000_000_000) + TO_2001),
        }
    }
}

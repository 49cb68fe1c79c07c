//! MP4 and QuickTime (ISO/IEC 14496-12; Apple, QuickTime File Format): movies with complete tables, and fragmented
//! ones.

mod boxes;
mod edits;
mod entry;
mod fragments;
mod metadata;
mod table;
mod track;

use super::FilmError;
use super::film::{Container, Film, Samples};
use super::limits::{MOST_PARTS, MOST_TABLE};
use super::notice::Notice;
use super::piece::{Piece, Reader, Stop};
use boxes::{Boxes, Header, find};
use fragments::Fragments;
use track::{Track, times};

/// Bytes requested from the start of a box: enough for a fragment of a live recording.
const AHEAD: u64 = 4 << 10;
/// Seconds from 1904-01-01, the epoch of movie times, to 1970-01-01.
const FROM_1904: i64 = 2_082_844_800;

/// Reader of the boxes of a file.
#[derive(Debug, Default)]
pub(super) struct Mp4 {
    at: u64,
    boxes: usize,
    quick_time: bool,
    movie: Option<Movie>,
}

/// Movie whose fragments are being read.
#[derive(Debug)]
struct Movie {
    film: Film,
    samples: Samples,
    /// Edit list of the video track; durations in units of the movie time scale.
    edits: Vec<edits::Edit>,
    timescale: u32,
    fragments: Option<Fragments>,
}

impl Reader for Mp4 {
    fn advance(&mut self, piece: &Piece) -> Result<Film, Stop> {
        loop {
            let start = piece.get(self.at, Header::MOST, AHEAD)?;
            if start.len() < 8 {
                return self.finish(piece, None);
            }
            let Some(header) = Header::read(start) else {
                return self.finish(piece, Some(Notice::Broken { at: self.at }));
            };
            let size = header.size.unwrap_or(piece.size - self.at);
            let next = self.at.saturating_add(size);
            match &header.kind {
                b"ftyp" => self.quick_time = piece.get(self.at, 12, AHEAD)?.get(8..) == Some(b"qt  "),
                b"moov" if self.movie.is_none() => {
                    self.movie = Some(Movie::read(self.content(piece, header, size)?, piece.size, self.quick_time)?);
                }
                b"moof" if next <= piece.size => {
                    let content = self.content(piece, header, size)?;
                    let at = self.at;
                    if let Some(movie) = &mut self.movie
                        && let Some(fragments) = &mut movie.fragments
                    {
                        fragments.add(content, at, piece.size, &mut movie.samples)?;
                    }
                }
                _ => {}
            }
            if self.movie.as_ref().is_some_and(|movie| movie.fragments.is_none()) {
                return self.finish(piece, None);
            }
            if next > piece.size {
                return self.finish(piece, Some(self.truncated(piece)));
            }
            self.boxes += 1;
            if self.boxes > MOST_PARTS {
                return Err(FilmError::TooLarge.into());
            }
            self.at = next;
        }
    }
}

impl Mp4 {
    /// Content of the current box.
    fn content<'a>(&self, piece: &'a Piece, header: Header, size: u64) -> Result<&'a [u8], Stop> {
        if self.at.saturating_add(size) > piece.size {
            return Err(FilmError::Truncated { bytes: piece.size }.into());
        }
        if size > MOST_TABLE {
            return Err(FilmError::TooLarge.into());
        }
        let bytes = piece.get(self.at, size, 0)?;
        Ok(usize::try_from(header.length).ok().and_then(|length| bytes.get(length..)).unwrap_or_default())
    }

    fn truncated(&self, piece: &Piece) -> Notice {
        let (present, lost) =
            self.movie.as_ref().map_or((0, 0), |movie| (movie.samples.list.len(), movie.samples.lost));
        Notice::Truncated { present, lost, bytes: piece.size }
    }

    fn finish(&mut self, piece: &Piece, notice: Option<Notice>) -> Result<Film, Stop> {
        let Some(movie) = self.movie.take() else {
            return Err(match notice {
                Some(Notice::Broken { .. }) => FilmError::Damaged { part: "moov" },
                _ => FilmError::Truncated { bytes: piece.size },
            }
            .into());
        };
        let Movie { mut film, samples, edits, timescale, .. } = movie;
        film.samples = samples.list;
        if film.samples.is_empty() {
            let none = if samples.lost > 0 { FilmError::Truncated { bytes: piece.size } } else { FilmError::NoFrames };
            return Err(none.into());
        }
        if edits::apply(&edits, timescale, film.timescale, &mut film.samples) {
            film.notices.push(Notice::Speed);
        }
        if film.samples.iter().all(|sample| !sample.shown) {
            return Err(FilmError::NoFrames.into());
        }
        let cut = Notice::Truncated { present: film.samples.len(), lost: samples.lost, bytes: piece.size };
        film.notices.extend(notice.or((samples.lost > 0).then_some(cut)));
        Ok(film)
    }
}

impl Movie {
    /// Reads the content of `moov`. `file`: size of the file in bytes.
    fn read(content: &[u8], file: u64, quick_time: bool) -> Result<Self, FilmError> {
        if find(content, b"cmov").is_some() {
            return Err(FilmError::Packed);
        }
        let header = find(content, b"mvhd").and_then(times).ok_or(FilmError::Damaged { part: "mvhd" })?;
        let tracks = Boxes(content).filter(|(kind, _)| kind == b"trak").filter_map(|(_, content)| Track::read(content));
        let tracks: Vec<Track<'_>> = tracks.collect::<Result<_, _>>()?;
        let further = tracks.len().saturating_sub(1);
        // The longest readable track. Others are cover pictures or previews. The first of equally long ones.
        let ease = |track: &Track<'_>| track.entry.as_ref().ok().map(|entry| entry.codec.coding.is_in_browsers());
        let track = tracks.into_iter().rev().max_by_key(|track| (ease(track), track.count));
        let Some(track) = track else { return Err(FilmError::NoVideo) };
        let entry = track.entry?;
        let (samples, decoding) = table::samples(track.tables, file)?;
        let mut notices = Vec::new();
        if further > 0 {
            notices.push(Notice::FurtherVideos(further));
        }
        if track.orientation.is_none() {
            notices.push(Notice::Skewed);
        }
        let created =
            (header.created > 0).then(|| i64::try_from(header.created).ok()?.checked_sub(FROM_1904)).flatten();
        let film = Film {
            container: if quick_time { Container::QuickTime } else { Container::Mp4 },
            codec: entry.codec,
            size: entry.size,
            pixel_aspect: entry.pixel_aspect,
            orientation: track.orientation.unwrap_or_default(),
            timescale: track.timescale,
            samples: Vec::new(),
            capture_rate: metadata::capture_rate(content),
            stated_rate: None,
            duration: (header.duration > 0).then(|| header.duration as f64 / f64::from(header.timescale)),
            created,
            notices,
        };
        let fragments = find(content, b"mvex").map(|content| Fragments::new(content, track.id, track.count, decoding));
        Ok(Self { film, samples, edits: track.edits, timescale: header.timescale, fragments })
    }
}

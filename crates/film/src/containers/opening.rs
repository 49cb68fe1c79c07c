//! Step-by-step opening of a film: the caller supplies the requested byte ranges, from a file or from a browser's
//! `File.slice`.

use super::FilmError;
use super::avi::Avi;
use super::film::Film;
use super::matroska::Matroska;
use super::mp4::Mp4;
use super::piece::{Piece, Reader, Stop};
use super::signature::{Format, format};
use std::ops::Range;

/// Bytes that suffice to determine the format.
const SIGNATURE: u64 = 512;
/// Size of the first request in bytes. Small films are read completely by it.
const FIRST: u64 = 64 << 10;

/// State of opening a film: as long as it needs bytes, the caller supplies them and gets the next state.
#[derive(Debug)]
pub enum Opening {
    /// More bytes of the file are needed.
    Needs(Request),
    /// The film, or the reason why it cannot be opened.
    Done(Result<Box<Film>, FilmError>),
}

/// Request for a byte range of the file.
#[derive(Debug)]
pub struct Request {
    range: Range<u64>,
    size: u64,
    stage: Stage,
}

#[derive(Debug)]
enum Stage {
    Signature,
    Mp4(Box<Mp4>),
    Matroska(Box<Matroska>),
    Avi(Box<Avi>),
}

impl Opening {
    /// Starts with a file of `size` bytes.
    pub fn new(size: u64) -> Self {
        Request { range: 0..FIRST.min(size), size, stage: Stage::Signature }.or_empty()
    }
}

impl Request {
    fn or_empty(self) -> Opening {
        if self.size == 0 { Opening::Done(Err(FilmError::Empty)) } else { Opening::Needs(self) }
    }

    /// Requested bytes. The range is never empty and never extends beyond the end of the file.
    pub fn range(&self) -> Range<u64> {
        self.range.clone()
    }

    /// Continues with the bytes of the range. Fewer bytes mean that the file ends there: it may have been cut off since
    /// it was chosen.
    pub fn supply(self, bytes: Vec<u8>) -> Opening {
        let Self { range, mut size, mut stage } = self;
        if (bytes.len() as u64) < range.end - range.start {
            size = range.start + bytes.len() as u64;
        }
        let piece = Piece { start: range.start, bytes, size };
        match stage.advance(&piece) {
            Ok(film) => Opening::Done(Ok(Box::new(film))),
            Err(Stop::Failed(error)) => Opening::Done(Err(error)),
            Err(Stop::Need(range)) => Request { range, size, stage }.or_empty(),
        }
    }
}

impl Stage {
    fn advance(&mut self, piece: &Piece) -> Result<Film, Stop> {
        if let Self::Signature = self {
            *self = match format(piece.get(0, SIGNATURE, SIGNATURE)?)? {
                Format::Mp4 => Self::Mp4(Box::default()),
                Format::Matroska => Self::Matroska(Box::default()),
                Format::Avi => Self::Avi(Box::default()),
            };
        }
        match self {
            Self::Mp4(reader) => reader.advance(piece),
            Self::Matroska(reader) => reader.advance(piece),
            Self::Avi(reader) => reader.advance(piece),
            Self::Signature => Err(FilmError::NotAFilm.into()),
        }
    }
}

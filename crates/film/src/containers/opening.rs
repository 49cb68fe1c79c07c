//! Opening a film step by step: the caller reads what is asked for, from a file or from a browser's `File.slice`.

use super::FilmError;
use super::avi::Avi;
use super::film::Film;
use super::matroska::Matroska;
use super::mp4::Mp4;
use super::piece::{Piece, Reader, Stop};
use super::signature::{Format, format};
use std::ops::Range;

/// So many bytes tell the format.
const SIGNATURE: u64 = 512;
/// What is read at once at the start; small films are in it as a whole.
const FIRST: u64 = 64 << 10;

/// A film that is being opened.
///
/// ```
/// use film::containers::Opening;
/// let file = b"GIF89a and so on";
/// let mut opening = Opening::new(file.len() as u64);
/// let result = loop {
///     match opening {
///         Opening::Needs(request) => {
///             let range = request.range();
///             opening = request.supply(file[range.start as usize..range.end as usize].to_vec());
///         }
///         Opening::Done(result) => break result,
///     }
/// };
/// assert_eq!(result, Err(film::containers::FilmError::Gif));
/// ```
#[derive(Debug)]
pub enum Opening {
    /// Bytes of the file are needed.
    Needs(Request),
    /// The film, or why there is none.
    Done(Result<Box<Film>, FilmError>),
}

/// Asks for a range of the file.
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
    /// Begins with a file of `size` bytes.
    pub fn new(size: u64) -> Self {
        Request { range: 0..FIRST.min(size), size, stage: Stage::Signature }.or_empty()
    }
}

impl Request {
    fn or_empty(self) -> Opening {
        if self.size == 0 { Opening::Done(Err(FilmError::Empty)) } else { Opening::Needs(self) }
    }

    /// The bytes to read: never none, and never beyond the end of the file.
    pub fn range(&self) -> Range<u64> {
        self.range.clone()
    }

    /// Goes on with the bytes of the range. Fewer mean that the file ends there; it may have been cut since it was chosen.
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

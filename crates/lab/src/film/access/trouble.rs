//! Errors of showing films.

use film::containers::FilmError;
use units::{Words, words};

/// Reason why a film, or a picture of it, cannot be shown.
#[derive(Clone, Debug, PartialEq)]
pub enum Trouble {
    /// The file cannot be opened as a film.
    Film(FilmError),
    /// The browser offers no decoder to this page, which was loaded without encryption.
    Insecure,
    /// The browser cannot read the file any more.
    Unreadable,
    /// The decoder does not deliver this frame (number from 1).
    Frame(usize),
    /// The film was closed during the request.
    Closed,
}

impl From<FilmError> for Trouble {
    fn from(error: FilmError) -> Self {
        Self::Film(error)
    }
}

impl Trouble {
    /// Message: what is wrong, and what to do.
    pub fn words(&self) -> Words {
        match self {
            Self::Film(error) => error.words(),
            Self::Insecure => words(
                "browsers decode films only in pages from a file, from https or from this computer (localhost), and this page came over http: save the page and open the file, or serve it with https",
            ),
            Self::Unreadable => {
                words("the browser cannot read the file any more; it was moved or changed: open it again")
            }
            Self::Frame(frame) => words!(
                "the browser could not decode frame {frame}; the film may be damaged there: leave that part out, or convert the film to MP4 with H.264"
            ),
            Self::Closed => words("the film was closed"),
        }
    }
}

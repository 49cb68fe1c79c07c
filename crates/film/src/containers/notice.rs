//! What a reader should know of a film that opened.

use super::error::size;
use units::{Words, words};

/// Something about the file that does not prevent work with it.
#[derive(Clone, Debug, PartialEq)]
pub enum Notice {
    /// The file ends before the film does; what is there was read.
    Truncated {
        /// Frames that are there.
        present: usize,
        /// Frames that the file lists and does not hold; 0 if it has no list.
        lost: usize,
        /// The size of the file in bytes.
        bytes: u64,
    },
    /// The structure of the file is broken at this byte; what is before it was read.
    Broken {
        /// The offset from the start of the file.
        at: u64,
    },
    /// The file holds so many further videos, which are not read.
    FurtherVideos(usize),
    /// An edit list plays a part of the film at another rate. Times are those of the camera.
    Speed,
    /// The picture is to be turned by another angle than quarter turns, or skewed; it is left as it is.
    Skewed,
}

impl Notice {
    /// It in a sentence.
    pub fn words(&self) -> Words {
        match self {
            Self::Truncated { present, lost: 0, bytes } => words!(
                "the file ends in the middle of the film: {present} frames in {} were read; if it was being copied, copy it again",
                "el archivo termina en medio del vídeo: se leyeron {present} fotogramas en {}; si se copió a medias, cópialo de nuevo",
                size(*bytes)
            ),
            Self::Truncated { present, lost, bytes } => {
                let listed = present.saturating_add(*lost);
                words!(
                    "the file ends in the middle of the film: of {listed} frames, {present} are in its {} and were read; copy it again to get the others",
                    "el archivo termina en medio del vídeo: de {listed} fotogramas, {present} están en sus {} y se leyeron; cópialo de nuevo para tener los demás",
                    size(*bytes)
                )
            }
            Self::Broken { at } => words!(
                "the file is damaged at byte {at}; the frames before it were read",
                "el archivo está dañado en el byte {at}; se leyeron los fotogramas anteriores"
            ),
            Self::FurtherVideos(1) => words(
                "the file holds a second video, which is not read",
                "el archivo contiene otro vídeo, que no se lee",
            ),
            Self::FurtherVideos(count) => words!(
                "the file holds {count} further videos, which are not read",
                "el archivo contiene otros {count} vídeos, que no se leen"
            ),
            Self::Speed => words(
                "the film was edited so that a part plays faster or slower; the times are those of the recording",
                "el vídeo se editó para que una parte vaya más rápida o más lenta; los tiempos son los de la grabación",
            ),
            Self::Skewed => words(
                "the film asks for its picture to be turned by an odd angle; it is shown as it was recorded",
                "el vídeo pide girar la imagen un ángulo que no es recto; se muestra como se grabó",
            ),
        }
    }
}

//! Why a film cannot be shown, and what to do.

use film::containers::FilmError;
use units::{Words, words};

/// Why there is no film, or no picture of it.
#[derive(Clone, Debug, PartialEq)]
pub enum Trouble {
    /// The file is none that can be read.
    Film(FilmError),
    /// The browser offers no decoders to this page: it came over the network without encryption.
    Insecure,
    /// The browser does not give the file any more.
    Unreadable,
    /// The decoder does not give this frame (counted from 1).
    Frame(usize),
    /// The film stopped before the end of what was asked for.
    Closed,
}

impl From<FilmError> for Trouble {
    fn from(error: FilmError) -> Self {
        Self::Film(error)
    }
}

impl Trouble {
    /// What is wrong and what to do.
    pub fn words(&self) -> Words {
        match self {
            Self::Film(error) => error.words(),
            Self::Insecure => words(
                "browsers decode films only in pages from a file, from https or from this computer (localhost), and this page came over http: save the page and open the file, or serve it with https",
                "los navegadores solo decodifican vídeos en páginas de un archivo, de https o de este equipo (localhost), y esta página llegó por http: guarda la página y abre el archivo, o sírvela con https",
            ),
            Self::Unreadable => words(
                "the browser cannot read the file any more; it was moved or changed: open it again",
                "el navegador ya no puede leer el archivo; se movió o cambió: ábrelo de nuevo",
            ),
            Self::Frame(frame) => words!(
                "the browser could not decode frame {frame}; the film may be damaged there: leave that part out, or convert the film to MP4 with H.264",
                "el navegador no pudo decodificar el fotograma {frame}; el vídeo puede estar dañado ahí: excluye esa parte o convierte el vídeo a MP4 con H.264"
            ),
            Self::Closed => words("the film was closed", "se cerró el vídeo"),
        }
    }
}

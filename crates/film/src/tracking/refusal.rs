//! Why a film cannot be tracked.

use units::{Words, words};

/// Why a film, or one frame of it, cannot be tracked.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// A number of the settings is not finite, or a click lies outside the picture.
    Click {
        /// To the right, in pixels.
        x: f64,
        /// Downwards, in pixels.
        y: f64,
    },
    /// The two points of a tube are closer than this many pixels.
    Tube {
        /// Their distance.
        length: f64,
        /// The shortest that works.
        least: f64,
    },
    /// A frame does not have the size of the first one.
    Size {
        /// The frame.
        frame: usize,
    },
    /// The time of a frame is not finite or not later than that of the frame before.
    Order {
        /// The frame.
        frame: usize,
    },
    /// The film has more frames than fit into the memory that tracking may take.
    Long {
        /// How many fit.
        frames: usize,
    },
    /// There are fewer frames than tracking needs.
    Short {
        /// How many it needs.
        frames: usize,
    },
    /// The clicked place shows nothing that could be followed.
    Plain,
    /// The picture shows nothing that could be followed within the radius that was stated.
    PlainDisc {
        /// Pixels.
        radius: f64,
    },
    /// The clicked place does not stand out of the noise.
    Noise {
        /// The frame of the click.
        frame: usize,
    },
    /// The other frames show what does not resemble the clicked place.
    Left {
        /// The frame of the click.
        frame: usize,
    },
    /// A mark lies on a place that shows nothing that could be found again.
    PlainMark {
        /// Which one, from 1.
        number: usize,
    },
    /// A resting mark was lost.
    Mark {
        /// Which one, from 1.
        number: usize,
        /// In which frame.
        frame: usize,
    },
    /// The radius of a body is not finite, or none that can be followed.
    Radius {
        /// The smallest in pixels.
        least: f64,
        /// The greatest in pixels.
        greatest: f64,
    },
    /// More bodies or marks than can be followed.
    Many {
        /// How many can.
        greatest: usize,
    },
}

impl Refusal {
    /// The message for people: what happened, and what to do.
    pub fn words(&self) -> Words {
        match self {
            Self::Click { x, y } => words!(
                "The point ({x:.1}, {y:.1}) lies outside the picture. Click inside the picture.",
                "El punto ({x:.1}, {y:.1}) está fuera de la imagen. Pulsa dentro de la imagen."
            ),
            Self::Tube { length, least } => words!(
                "The two points of the tube are {length:.1} pixels apart. Choose points at least {least:.0} pixels apart.",
                "Los dos puntos del tubo distan {length:.1} píxeles. Elige puntos a {least:.0} píxeles como mínimo."
            ),
            Self::Size { frame } => words!(
                "Frame {frame} does not have the size of the first one. Cut the film there and track each part.",
                "El fotograma {frame} no tiene el tamaño del primero. Corta ahí el vídeo y sigue cada parte.",
                frame = counted(*frame)
            ),
            Self::Order { frame } => words!(
                "The time of frame {frame} does not follow that of the frame before it. Convert the film with ffmpeg.",
                "El tiempo del fotograma {frame} no sigue al del anterior. Convierte el vídeo con ffmpeg.",
                frame = counted(*frame)
            ),
            Self::Long { frames } => words!(
                "The film is too long to be tracked at once. Choose a part of at most {frames} frames.",
                "El vídeo es demasiado largo para seguirlo de una vez. Elige una parte de {frames} fotogramas como máximo."
            ),
            Self::Short { frames } => words!(
                "Tracking needs at least {frames} frames. Choose a longer part of the film.",
                "El seguimiento necesita al menos {frames} fotogramas. Elige una parte más larga del vídeo."
            ),
            Self::Plain => words(
                "The picture is uniform at the clicked place. Click an edge that moves.",
                "La imagen es uniforme en el punto elegido. Pulsa un borde que se mueva.",
            ),
            Self::PlainDisc { radius } => words!(
                "The picture is uniform around the clicked place, within the radius of {radius:.0} px. Enter a larger radius, or click an edge that moves.",
                "La imagen es uniforme alrededor del punto elegido, dentro del radio de {radius:.0} px. Escribe un radio mayor o pulsa un borde que se mueva."
            ),
            Self::Noise { frame } => words!(
                "The clicked place in frame {frame} does not stand out of the noise of the film. Click the edge of the surface.",
                "El punto elegido en el fotograma {frame} no sobresale del ruido del vídeo. Pulsa el borde de la superficie.",
                frame = counted(*frame)
            ),
            Self::Left { frame } => words!(
                "The other frames do not show what was clicked in frame {frame}. Click the edge of the surface where it is sharp.",
                "Los demás fotogramas no muestran lo elegido en el fotograma {frame}. Pulsa el borde de la superficie donde se vea nítido.",
                frame = counted(*frame)
            ),
            Self::PlainMark { number } => words!(
                "The picture is uniform at mark {number}. Choose marks with an edge on all sides, such as dots.",
                "La imagen es uniforme en la marca {number}. Elige marcas con borde por todos lados, como puntos."
            ),
            Self::Mark { number, frame } => words!(
                "Mark {number} cannot be found in frame {frame}. Choose marks that stay in the picture.",
                "La marca {number} no se encuentra en el fotograma {frame}. Elige marcas que no salgan de la imagen.",
                frame = counted(*frame)
            ),
            Self::Radius { least, greatest } => words!(
                "The radius of a body must be a number from {least:.0} to {greatest:.0} px in this picture. Correct it, or clear it to find it around the click.",
                "El radio de un cuerpo debe ser un número de {least:.0} a {greatest:.0} px en esta imagen. Corrígelo, o bórralo para hallarlo alrededor del clic."
            ),
            Self::Many { greatest } => words!(
                "There are more than {greatest} marks. Choose at most {greatest}.",
                "Hay más de {greatest} marcas. Elige {greatest} como máximo."
            ),
        }
    }
}

/// A frame as people count: from 1.
fn counted(frame: usize) -> Words {
    Words::same((frame + 1).to_string())
}

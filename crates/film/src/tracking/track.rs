//! What tracking finds.

use units::number::fixed;
use units::{Words, words};

/// Where something is in one frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The frame, counted as the caller counts.
    pub frame: usize,
    /// When the row in which it is seen was exposed, in seconds: the frame's own time without a rolling shutter.
    pub time: f64,
    /// `x` to the right and `y` downwards, in pixels; with resting marks, in the picture of the first frame.
    pub position: [f64; 2],
    /// The standard errors of both coordinates in pixels. A column is measured along its tube: its errors are those of that
    /// direction.
    pub sigma: [f64; 2],
    /// The correlation of the pixels with what was sought, at most 1.
    pub score: f64,
    /// Whether a person should look at this frame.
    pub doubtful: bool,
}

/// A position in each frame, in the order of time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Track {
    /// The positions.
    pub points: Vec<Point>,
    /// How long each frame was exposed.
    pub exposure: Option<Exposure>,
    /// How long the camera takes to read a frame.
    pub readout: Option<Readout>,
    /// The direction, of length 1, in which a column is measured; none for a body.
    pub direction: Option<[f64; 2]>,
    /// The first frame in which a body was lost; tracking ends before it.
    pub lost: Option<usize>,
    /// The outline of a body, by its last key frame; none for a column.
    pub outline: Option<Outline>,
    /// The motion of the camera, where the picture beside a tube shows one and no marks were given.
    pub shift: Option<CameraShift>,
}

/// The circle by which a body is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outline {
    /// Pixels to the right and downwards from the position of the body, which is that of its click, to the centre.
    pub offset: [f64; 2],
    /// Pixels.
    pub radius: f64,
}

impl Track {
    /// What a person should know of the camera, as far as the track shows it.
    pub fn camera(&self) -> Vec<Words> {
        let exposure = self.exposure.map(|exposure| match exposure {
            Exposure::Seconds(seconds) => {
                words!("exposure: {ms} ms", "exposición: {ms} ms", ms = milliseconds(seconds))
            }
            Exposure::Under(seconds) => words!(
                "exposure: under {ms} ms, too short to smear the picture",
                "exposición: menos de {ms} ms, demasiado corta para emborronar la imagen",
                ms = milliseconds(seconds)
            ),
        });
        // One that was stated has no error, and whoever has stated it knows it.
        let readout = self.readout.filter(|readout| readout.sigma > 0.0).map(|readout| {
            words!(
                "rolling shutter: {ms} ± {sigma} ms from the first row to the last; times are corrected for it",
                "obturador rodante: {ms} ± {sigma} ms de la primera fila a la última; los tiempos están corregidos",
                ms = milliseconds(readout.seconds),
                sigma = milliseconds(readout.sigma)
            )
        });
        let shift = self.shift.map(CameraShift::words);
        exposure.into_iter().chain(readout).chain(shift).collect()
    }
}

fn milliseconds(seconds: f64) -> Words {
    Words::each(|language| fixed(1e3 * seconds, 1, language.style()))
}

/// The motion of the camera by what stands still in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraShift {
    /// The greatest shift since the first frame by which positions are corrected, in pixels.
    pub pixels: f64,
}

impl CameraShift {
    fn words(self) -> Words {
        words!(
            "the picture moved by up to {px} px: the camera was not still; positions are corrected by the background. A plain background, or one with regular lines, can mislead: marks on things at rest make it certain",
            "la imagen se movió hasta {px} px: la cámara no estaba quieta; las posiciones están corregidas según el fondo. Un fondo liso, o con líneas regulares, puede engañar: unas marcas en cosas inmóviles dan seguridad",
            px = Words::each(|language| fixed(self.pixels, 1, language.style()))
        )
    }
}

/// The exposure time that was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Exposure {
    /// Seconds.
    Seconds(f64),
    /// The film shows no smear: less than so many seconds.
    Under(f64),
}

/// How long a rolling shutter takes from the first row to the last.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Readout {
    /// Seconds; negative where the camera was held upside down.
    pub seconds: f64,
    /// Its standard error in seconds.
    pub sigma: f64,
}

/// A quantity of the camera that may be known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Known {
    /// It is estimated from the film.
    #[default]
    Estimated,
    /// It is known, in seconds.
    Seconds(f64),
}

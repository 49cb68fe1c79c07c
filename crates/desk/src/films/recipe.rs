//! How a simulation is filmed: a virtual camera films a run of the open document, so that a film with known truth is there without a
//! laboratory.

use crate::films::identity::FilmIdentity;
use film::containers::{Codec, Coding, Container, Film, Orientation, Sample};
use units::{Language, Words, words};

/// Width and height of the picture in pixels.
pub const FILMED_SIZE: [usize; 2] = [640, 360];
/// A film has no more frames: each takes a quarter of a megabyte of memory.
const MOST_FRAMES: f64 = 900.0;
/// The fewest frames with which an oscillation can be told from a line.
const LEAST_FRAMES: f64 = 10.0;
/// Frames a second, at most and at least.
const RATES: [f64; 2] = [0.01, 10_000.0];
/// The largest standard deviation of the noise, in grey values of 255.
const LOUDEST: f64 = 30.0;
/// Times of frames are whole microseconds.
const TIMESCALE: u32 = 1_000_000;

/// What the virtual camera is set to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraSettings {
    /// How long it films, in seconds.
    pub seconds: f64,
    /// Frames a second.
    pub rate: f64,
    /// How long the shutter is open for each frame, in seconds.
    pub exposure: f64,
    /// The standard deviation of the noise at a grey of 128, in grey values of 255.
    pub noise: f64,
    /// Films of equal seed have the same noise.
    pub seed: u32,
}

impl CameraSettings {
    /// Ten seconds at 30 frames a second, for a run that is watched at this many of its seconds in a second. A run that lasts
    /// `end` seconds is not filmed for longer.
    pub fn usual(pace: f64, end: f64) -> Self {
        let pace = if pace.is_finite() && pace > 0.0 { pace } else { 1.0 };
        let rate = (30.0 / pace).clamp(RATES[0], RATES[1]);
        Self { seconds: (10.0 * pace).min(end), rate, exposure: 0.12 / rate, noise: 2.0, seed: 1 }
    }

    /// How many frames are taken.
    pub fn frames(&self) -> usize {
        (self.seconds * self.rate).clamp(0.0, MOST_FRAMES) as usize
    }

    /// The middle of the exposure of a frame, in microseconds of the run. The first exposure begins with the run.
    fn ticks(&self, frame: usize) -> i64 {
        (f64::from(TIMESCALE) * (self.exposure / 2.0 + frame as f64 / self.rate)).ceil() as i64
    }

    /// The same in seconds.
    pub fn time(&self, frame: usize) -> f64 {
        self.ticks(frame) as f64 / f64::from(TIMESCALE)
    }

    /// Refuses what no camera can do, or what there is no room for.
    ///
    /// # Errors
    /// Which number is not possible, and which ones are.
    pub fn check(&self) -> Result<(), Words> {
        let [least, most] = RATES;
        if !(least..=most).contains(&self.rate) {
            return Err(words!(
                "The camera takes from {least} to {most} frames a second.",
                "La cámara toma de {least} a {most} fotogramas por segundo."
            ));
        }
        if !(LEAST_FRAMES..=MOST_FRAMES).contains(&(self.seconds * self.rate)) {
            return Err(words!(
                "Seconds times frames a second must be between {LEAST_FRAMES} and {MOST_FRAMES} frames.",
                "Los segundos por los fotogramas por segundo deben dar entre {LEAST_FRAMES} y {MOST_FRAMES} fotogramas."
            ));
        }
        if !(0.0..=1.0).contains(&(self.exposure * self.rate)) {
            return Err(words(
                "The exposure cannot be longer than the time from one frame to the next.",
                "La exposición no puede ser más larga que el tiempo de un fotograma al siguiente.",
            ));
        }
        if !(0.0..=LOUDEST).contains(&self.noise) {
            return Err(words!(
                "The noise is between 0 and {LOUDEST} of 255 grey values.",
                "El ruido está entre 0 y {LOUDEST} de 255 valores de gris."
            ));
        }
        Ok(())
    }
}

/// All that decides the pictures of a filmed simulation.
#[derive(Clone, Debug, PartialEq)]
pub struct FilmRecipe {
    /// The title of the document.
    pub document: String,
    /// The hash of its text.
    pub source: String,
    /// Its state at the start of the run, as [`play::Play::share`] writes it.
    pub state: String,
    /// The language of the words in the scene.
    pub language: String,
    /// What the camera is set to.
    pub settings: CameraSettings,
}

impl FilmRecipe {
    /// What the film is known by: a hash of all that decides it.
    pub fn identity(&self) -> FilmIdentity {
        let CameraSettings { seconds, rate, exposure, noise, seed } = self.settings;
        let numbers = [seconds, rate, exposure, noise].map(|number| number.to_bits().to_string()).join(" ");
        let text =
            [&self.source, &self.state, &self.language, &numbers, &seed.to_string()].map(String::as_str).join("\n");
        let name = format!("{}: {}", filmed().text(Language::of(&self.language)), self.document);
        FilmIdentity::new(&name, text.len() as u64, text.as_bytes())
    }

    /// The film with so many frames, which are in no file.
    pub(crate) fn film(&self, frames: usize) -> Film {
        let sample =
            |frame: usize| Sample { offset: 0, size: 1, ticks: self.settings.ticks(frame), key: true, shown: true };
        Film {
            container: Container::Drawn,
            codec: Codec { coding: Coding::Raw, name: String::new(), description: Vec::new() },
            size: FILMED_SIZE.map(|side| side as u32),
            pixel_aspect: [1, 1],
            orientation: Orientation::default(),
            timescale: TIMESCALE,
            samples: (0..frames.min(MOST_FRAMES as usize)).map(sample).collect(),
            capture_rate: None,
            stated_rate: None,
            duration: None,
            created: None,
            notices: Vec::new(),
        }
    }
}

fn filmed() -> Words {
    words("Filmed simulation", "Simulación filmada")
}

/// The hash by which a text is known again.
pub(crate) fn hash(text: &str) -> String {
    FilmIdentity::new("", 0, text.as_bytes()).hash
}

//! Recipe of a film of a simulation: a virtual camera films a run of the open document. The film has a known truth and
//! needs no laboratory.

use crate::films::identity::FilmIdentity;
use film::containers::{Codec, Coding, Container, Film, Orientation, Sample};
use units::{Language, Words, words};

/// Width and height of the picture, px.
pub const FILMED_SIZE: [usize; 2] = [640, 360];
/// Maximum number of frames; each needs 0.25 MB.
const MOST_FRAMES: f64 = 900.0;
/// Minimum number of frames, for an oscillation.
const LEAST_FRAMES: f64 = 10.0;
/// Minimum and maximum frame rate, frames per second.
const RATES: [f64; 2] = [0.01, 10_000.0];
/// Maximum standard deviation of the noise, grey values of 255.
const LOUDEST: f64 = 30.0;
/// Ticks per second of the frame times.
const TIMESCALE: u32 = 1_000_000;

/// Settings of the virtual camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraSettings {
    /// Duration of the film, s.
    pub seconds: f64,
    /// Frames per second.
    pub rate: f64,
    /// Exposure time of a frame, s.
    pub exposure: f64,
    /// Standard deviation of the noise at a grey value of 128, in grey values of 255.
    pub noise: f64,
    /// Seed of the noise.
    pub seed: u32,
}

impl CameraSettings {
    /// Default settings: 10 s of playback at 30 frames per second. `pace`: model seconds per second of playback; `end`:
    /// duration of the run, s, the maximum duration of the film.
    pub fn usual(pace: f64, end: f64) -> Self {
        let pace = if pace.is_finite() && pace > 0.0 { pace } else { 1.0 };
        let rate = (30.0 / pace).clamp(RATES[0], RATES[1]);
        Self { seconds: (10.0 * pace).min(end), rate, exposure: 0.12 / rate, noise: 2.0, seed: 1 }
    }

    /// Number of frames.
    pub fn frames(&self) -> usize {
        (self.seconds * self.rate).clamp(0.0, MOST_FRAMES) as usize
    }

    /// Middle of the exposure of a frame, in microseconds of the run. The first exposure begins with the run.
    fn ticks(&self, frame: usize) -> i64 {
        (f64::from(TIMESCALE) * (self.exposure / 2.0 + frame as f64 / self.rate)).ceil() as i64
    }

    /// Middle of the exposure of a frame, in s of the run.
    pub fn time(&self, frame: usize) -> f64 {
        self.ticks(frame) as f64 / f64::from(TIMESCALE)
    }

    /// Checks the settings.
    ///
    /// # Errors
    ///
    /// A message with the invalid number and its bounds.
    pub fn check(&self) -> Result<(), Words> {
        let [least, most] = RATES;
        if !(least..=most).contains(&self.rate) {
            return Err(words!("The camera takes from {least} to {most} frames a second."));
        }
        if !(LEAST_FRAMES..=MOST_FRAMES).contains(&(self.seconds * self.rate)) {
            return Err(words!(
                "Seconds times frames a second must be between {LEAST_FRAMES} and {MOST_FRAMES} frames."
            ));
        }
        if !(0.0..=1.0).contains(&(self.exposure * self.rate)) {
            return Err(words("The exposure cannot be longer than the time from one frame to the next."));
        }
        if !(0.0..=LOUDEST).contains(&self.noise) {
            return Err(words!("The noise is between 0 and {LOUDEST} of 255 grey values."));
        }
        Ok(())
    }
}

/// All that determines the pictures of a filmed simulation.
#[derive(Clone, Debug, PartialEq)]
pub struct FilmRecipe {
    /// Title of the document.
    pub document: String,
    /// Hash of the source text of the document.
    pub source: String,
    /// State at the start of the run, as written by [`play::Play::share`].
    pub state: String,
    /// Language of the scene.
    pub language: String,
    /// Settings of the camera.
    pub settings: CameraSettings,
}

impl FilmRecipe {
    /// Identity of the film: a hash of all fields.
    pub fn identity(&self) -> FilmIdentity {
        let CameraSettings { seconds, rate, exposure, noise, seed } = self.settings;
        let numbers = [seconds, rate, exposure, noise].map(|number| number.to_bits().to_string()).join(" ");
        let text =
            [&self.source, &self.state, &self.language, &numbers, &seed.to_string()].map(String::as_str).join("\n");
        let name = format!("{}: {}", filmed().text(Language::of(&self.language)), self.document);
        FilmIdentity::new(&name, text.len() as u64, text.as_bytes())
    }

    /// Description of the film with this number of frames. It has no file.
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
    words("Filmed simulation")
}

/// Hash of a text.
pub(crate) fn hash(text: &str) -> String {
    FilmIdentity::new("", 0, text.as_bytes()).hash
}

//! Sample records: virtual measurements of liquid columns with known parameters and fixed seeds.

use crate::records::Records;
use crate::records::measurement::{measured_text, truth_of};
use crate::{Changes, OpenDocument, Refusal};
use analysis::virtual_record::Camera;
use document::Document;
use play::Play;
use units::{Language, Words, words};

/// A sample record.
#[derive(Clone, Debug)]
pub struct Sample {
    /// File of the theory that generates it.
    pub file: &'static str,
    /// Name in English and in Spanish.
    name: Words,
    /// Values of parameters, SI, by name.
    settings: &'static [(&'static str, f64)],
    camera: Camera,
}

/// A good camera on a tripod: 0.33 mm per pixel, 30 frames per second. Lengths in m, times in s.
const CAMERA: Camera =
    Camera { rate: 30.0, duration: 8.0, pixel: 3.3e-4, noise: 2e-4, jitter: 0.0, scale: 0.0, seed: 0 };

/// The sample records: three column lengths with linear friction, and one with contact-line friction.
pub static SAMPLES: [Sample; 4] = [
    Sample {
        file: "theories/linear.md",
        name: words("Column of 18 cm"),
        settings: &[("L", 0.18), ("gamma", 0.42), ("y_0", 0.045), ("c", 0.002)],
        camera: Camera { seed: 18, ..CAMERA },
    },
    Sample {
        file: "theories/linear.md",
        name: words("Column of 24 cm"),
        settings: &[("L", 0.24), ("gamma", 0.42), ("y_0", 0.045), ("c", -0.001)],
        camera: Camera { seed: 24, ..CAMERA },
    },
    Sample {
        file: "theories/linear.md",
        name: words("Column of 32 cm"),
        settings: &[("L", 0.32), ("gamma", 0.42), ("y_0", 0.045), ("c", 0.0005)],
        camera: Camera { seed: 32, ..CAMERA },
    },
    Sample {
        file: "theories/linear-contact-line.md",
        name: words("Column with a contact line"),
        settings: &[("L", 0.21), ("gamma", 0.25), ("mu", 0.12), ("s", 0.002), ("y_0", 0.05), ("c", 0.001)],
        camera: Camera { seed: 21, noise: 3e-4, jitter: 5e-4, ..CAMERA },
    },
];

impl Sample {
    /// Name in a language.
    pub fn name(&self, language: Language) -> String {
        self.name.text(language).into_owned()
    }
}

impl Records {
    /// Makes a sample record with the theory that it follows, and adds it. Returns its id.
    ///
    /// # Errors
    /// As [`crate::Desk::add_record`]; also if the theory lacks a parameter of the sample.
    pub fn add_sample(
        &mut self,
        open: OpenDocument<'_>,
        sample: usize,
        theory: Document,
    ) -> Result<(u32, Changes), Refusal> {
        let unknown = || Refusal::unknown(sample);
        let Sample { name, settings, camera, .. } = SAMPLES.get(sample).ok_or_else(unknown)?;
        let name = name.text(open.language());
        let mut play = Play::open(theory.program);
        for (parameter, value) in *settings {
            let index = play.model().parameters.iter().position(|one| one.name == *parameter).ok_or_else(unknown)?;
            play.change_settings(|settings| settings.set_parameter(index, *value))?;
        }
        let text = measured_text(&play, "y", camera)?;
        self.insert(open, &name, text.as_bytes(), Some(truth_of(&play)))
    }
}

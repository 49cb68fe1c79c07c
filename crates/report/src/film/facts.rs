//! Properties of a film file.

use units::Language;
use units::number::plain;

/// Properties of a film file and its calibration.
#[derive(Clone, Debug, Default)]
pub struct FilmFile {
    /// Width and height of the upright picture in pixels; `None` if the file was not read.
    pub size: Option<[f64; 2]>,
    /// Times of the frames in seconds; empty if the file was not read.
    pub times: Vec<f64>,
    /// Frames per second.
    pub rate: Option<f64>,
    /// Size of the file in bytes.
    pub bytes: u64,
    /// Length that calibrates it, as typed.
    pub calibrated_by: Option<String>,
}

impl FilmFile {
    /// Picture size, frames, file size and calibration as pairs of term and value.
    pub fn facts(&self, language: Language) -> Vec<(String, String)> {
        let plain = |value: f64, digits: usize| plain(value, digits, language.style());
        let mut facts = Vec::new();
        if let Some([width, height]) = self.size {
            facts.push((language.say("Picture"), format!("{width} × {height} px")));
        }
        if let (Some(first), Some(last), Some(rate)) = (self.times.first(), self.times.last(), self.rate) {
            let text = format!("{}, {} /s, {} s", self.times.len(), plain(rate, 5), plain(last - first, 4));
            facts.push((language.say("Frames"), text));
        }
        facts.push((language.say("File"), format!("{} MB", plain(self.bytes as f64 / 1e6, 3))));
        let length = self.calibrated_by.clone();
        facts.extend(length.map(|length| (language.say("Calibrated by"), length)));
        facts.into_iter().map(|(term, value)| (term.to_owned(), value)).collect()
    }
}

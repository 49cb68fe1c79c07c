//! What a film file is like.

use units::Language;
use units::number::plain;

/// A film file, and by what its lengths are known.
#[derive(Clone, Debug, Default)]
pub struct FilmFile {
    /// Width and height of the upright picture, if the file was read.
    pub size: Option<[f64; 2]>,
    /// When the frames are shown, in seconds; empty if the file was not read.
    pub times: Vec<f64>,
    /// Frames a second.
    pub rate: Option<f64>,
    /// How large the file is, in bytes.
    pub bytes: u64,
    /// The length that calibrates it, as it was typed.
    pub calibrated_by: Option<String>,
}

impl FilmFile {
    /// Size, length, frames, each with its name.
    pub fn facts(&self, language: Language) -> Vec<(String, String)> {
        let plain = |value: f64, digits: usize| plain(value, digits, language.style());
        let mut facts = Vec::new();
        if let Some([width, height]) = self.size {
            facts.push((language.pick("Picture", "Imagen"), format!("{width} × {height} px")));
        }
        if let (Some(first), Some(last), Some(rate)) = (self.times.first(), self.times.last(), self.rate) {
            let text = format!("{}, {} /s, {} s", self.times.len(), plain(rate, 5), plain(last - first, 4));
            facts.push((language.pick("Frames", "Fotogramas"), text));
        }
        facts.push((language.pick("File", "Archivo"), format!("{} MB", plain(self.bytes as f64 / 1e6, 3))));
        let length = self.calibrated_by.clone();
        facts.extend(length.map(|length| (language.pick("Calibrated by", "Calibrado con"), length)));
        facts.into_iter().map(|(term, value)| (term.to_owned(), value)).collect()
    }
}

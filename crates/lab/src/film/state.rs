//! The open film, as the desk has it.

use super::aim::Pixel;
use desk::{BodyOutline, CalibrationForm, Desk, DoubtfulFrame, MOST_BODIES, OpenFilm, Subject};
use film::calibration::{Calibration, Lengths};
use film::tracking::Track;
use units::number::{Style, plain};

/// The open film.
#[derive(Clone, Debug, PartialEq)]
pub struct Now {
    /// The name of its file.
    pub name: String,
    /// Frames, seconds and pixels.
    pub extent: (usize, f64, [f64; 2]),
    /// The times of its first and last frame, in seconds of the file.
    pub whole: [f64; 2],
    /// How many times slower it plays than things happened, as typed.
    pub factor: Option<f64>,
    /// The part that is used, in seconds of the file.
    pub part: [Option<f64>; 2],
    /// Its first and last frame.
    pub ends: [usize; 2],
    /// What is followed.
    pub subject: Subject,
    /// The outline of each body, once it was found or its radius was set.
    pub outlines: Vec<Option<BodyOutline>>,
    /// Marks that rest.
    pub marks: Vec<Pixel>,
    /// What has been said of lengths.
    pub form: CalibrationForm,
    /// The map that follows from it.
    pub calibration: Calibration,
    /// What has been found.
    pub tracks: Vec<Track>,
    /// The frames in doubt.
    pub doubts: Vec<DoubtfulFrame>,
    /// True if something was lost, or many frames are in doubt.
    pub plainly_in_doubt: bool,
    /// The record, if it is there.
    pub record: Option<u32>,
    /// Whether it is a filmed simulation.
    pub filmed: bool,
    /// The length of the ruler in the picture of a filmed simulation.
    pub ruler: Option<String>,
    /// What a person should know.
    pub notes: Vec<String>,
}

impl Now {
    /// What the desk says now.
    pub fn of(desk: &Desk) -> Option<Self> {
        let film: OpenFilm = desk.film()?;
        let times = film.clip().times();
        let whole = times.first().zip(times.last()).map_or([0.0; 2], |(first, last)| [*first, *last]);
        let seconds = whole[1] - whole[0];
        Some(Self {
            name: film.identity().name.clone(),
            extent: (times.len(), seconds, film.clip().size()),
            whole,
            factor: film.typed_factor(),
            part: film.part(),
            ends: film.ends(),
            subject: film.subject().clone(),
            outlines: (0..MOST_BODIES).map(|body| film.body_outline(body)).collect(),
            marks: film.resting_marks().to_vec(),
            form: film.calibration_form().clone(),
            calibration: *film.calibration(),
            tracks: film.tracks(),
            doubts: film.doubtful(),
            plainly_in_doubt: film.is_plainly_in_doubt(),
            record: film.record().filter(|id| desk.records().iter().any(|record| record.id == *id)),
            filmed: film.truth().is_some(),
            ruler: film.truth().and_then(|truth| truth.ruler.clone()),
            notes: desk.film_notes(),
        })
    }

    /// The size of a pixel with its error; nothing without one.
    pub fn scale(&self, style: Style) -> String {
        let percent = |sigma: f64| plain(100.0 * sigma, 2, style);
        match &self.calibration.lengths {
            Lengths::Pixels => String::new(),
            Lengths::Scale(scale) => {
                format!("1 px = {} mm ± {} %", plain(1e3 * scale.pixel, 4, style), percent(scale.relative_sigma))
            }
            Lengths::Rectangle(rectangle) => format!("± {} %", percent(rectangle.relative_sigma)),
        }
    }
}

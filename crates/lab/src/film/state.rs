//! State of the open film on the desk.

use super::aim::Pixel;
use desk::{BodyOutline, CalibrationForm, Desk, MOST_BODIES, OpenFilm, Subject};
use film::calibration::{Calibration, Lengths};
use film::tracking::{DoubtfulFrame, Track};
use units::number::{Style, plain};

/// State of the open film.
#[derive(Clone, Debug, PartialEq)]
pub struct Now {
    /// Name of the file.
    pub name: String,
    /// Number of frames, duration (s), and width and height of the picture (px).
    pub extent: (usize, f64, [f64; 2]),
    /// Times of the first and last frame, s of playback.
    pub whole: [f64; 2],
    /// Factor of slow motion set by the user.
    pub factor: Option<f64>,
    /// Used part in s of playback; `None` for an end of the film.
    pub part: [Option<f64>; 2],
    /// First and last frame of the part.
    pub ends: [usize; 2],
    /// Subject of tracking.
    pub subject: Subject,
    /// Outline of each body, once it was found or its radius was set.
    pub outlines: Vec<Option<BodyOutline>>,
    /// Fixed marks, px.
    pub marks: Vec<Pixel>,
    /// Calibration form of the user.
    pub form: CalibrationForm,
    /// Map that follows from the form.
    pub calibration: Calibration,
    /// Tracks in px of the upright picture.
    pub tracks: Vec<Track>,
    /// Doubtful frames.
    pub doubts: Vec<DoubtfulFrame>,
    /// True if a track was lost or has many doubtful frames.
    pub plainly_in_doubt: bool,
    /// Number of the record, if it exists.
    pub record: Option<u32>,
    /// True for a filmed simulation.
    pub filmed: bool,
    /// Length of the ruler in the picture of a filmed simulation, with unit.
    pub ruler: Option<String>,
    /// Notes for the user.
    pub notes: Vec<String>,
}

impl Now {
    /// Present state of the desk; `None` without an open film.
    pub fn of(desk: &Desk) -> Option<Self> {
        let film: OpenFilm = desk.films().current()?;
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
            marks: film.fixed_marks().to_vec(),
            form: film.calibration_form().clone(),
            calibration: *film.calibration(),
            tracks: film.tracks(),
            doubts: film.doubtful(),
            plainly_in_doubt: film.is_plainly_in_doubt(),
            record: film.record().filter(|id| desk.records().list().iter().any(|record| record.id == *id)),
            filmed: film.truth().is_some(),
            ruler: film.truth().and_then(|truth| truth.ruler.clone()),
            notes: desk.films().notes(),
        })
    }

    /// Size of a pixel with its relative error as text; empty without a scale.
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

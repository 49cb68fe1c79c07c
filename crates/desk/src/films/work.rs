//! Stored work on a film: user input and results.

use crate::films::identity::FilmIdentity;
use crate::films::lengths::CalibrationForm;
use crate::films::recipe::FilmRecipe;
use crate::films::subject::Subject;
use film::calibration::Calibration;
use film::tracking::{Point, Track};

/// Work on a film, restored when the same film is opened again.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Work {
    pub identity: FilmIdentity,
    /// Factor of slow motion set by the user.
    pub factor: Option<f64>,
    /// Factor of slow motion by the file; 1 if it states none.
    pub stated_factor: f64,
    /// Used part, s of playback.
    pub part: [Option<f64>; 2],
    /// First and last frame of the part.
    pub ends: [usize; 2],
    pub subject: Subject,
    /// Fixed marks in the first frame of the part, px.
    pub marks: Vec<[f64; 2]>,
    /// Calibration form of the user.
    pub form: CalibrationForm,
    /// Map that follows from the form, from px of the upright picture.
    pub calibration: Calibration,
    pub found: Option<Found>,
    /// Recipe of the film, if it is that of a simulation.
    pub recipe: Option<FilmRecipe>,
    /// Number of the record of the film. The record may have been removed.
    pub record: Option<u32>,
}

/// Result of tracking a film.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Found {
    /// Tracks in px of the upright picture, in the order of the subject.
    pub tracks: Vec<Track>,
    /// Tracked frames with their recording times, s.
    pub frames: Vec<(usize, f64)>,
    /// Factor of slow motion at that time.
    pub factor: f64,
    /// Frames that repeat the picture before and were left out.
    pub repeated: Vec<usize>,
}

impl Work {
    pub fn factor(&self) -> f64 {
        self.factor.unwrap_or(self.stated_factor)
    }

    /// Tracks in the used part of the film, with times by the present factor.
    pub fn tracks(&self) -> Vec<Track> {
        let Some(found) = &self.found else { return Vec::new() };
        let [first, last] = self.ends;
        let stretch = found.factor / self.factor();
        // A factor of 1 changes no bit.
        let point = |point: &Point| Point { time: point.time * stretch, ..*point };
        let track = |track: &Track| Track {
            points: track.points.iter().filter(|one| (first..=last).contains(&one.frame)).map(point).collect(),
            exposure: track.exposure.map(|exposure| match exposure {
                film::tracking::Exposure::Seconds(seconds) => film::tracking::Exposure::Seconds(seconds * stretch),
                film::tracking::Exposure::Under(seconds) => film::tracking::Exposure::Under(seconds * stretch),
            }),
            readout: track.readout.map(|readout| film::tracking::Readout {
                seconds: readout.seconds * stretch,
                sigma: readout.sigma * stretch,
            }),
            direction: track.direction,
            lost: track.lost,
            outline: track.outline,
            shift: track.shift,
        };
        found.tracks.iter().map(track).collect()
    }

    /// Recording time of a tracked frame, s.
    pub fn taken(&self, frame: usize) -> Option<f64> {
        let found = self.found.as_ref()?;
        let at = found.frames.binary_search_by_key(&frame, |frame| frame.0).ok()?;
        found.frames.get(at).map(|frame| frame.1 * (found.factor / self.factor()))
    }
}

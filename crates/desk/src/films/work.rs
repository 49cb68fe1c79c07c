//! What a person has said of a film, and what has been found in it.

use crate::films::identity::FilmIdentity;
use crate::films::lengths::CalibrationForm;
use crate::films::recipe::FilmRecipe;
use crate::films::subject::Subject;
use film::calibration::Calibration;
use film::tracking::{Point, Track};

/// The work on a film: all that is there again when the same film is opened.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Work {
    pub identity: FilmIdentity,
    /// How many times slower the film plays than things happened, where a person has said so.
    pub factor: Option<f64>,
    /// The same by what the file says; 1 where it says nothing.
    pub stated_factor: f64,
    /// The part that is used, in seconds of the file.
    pub part: [Option<f64>; 2],
    /// The first and the last frame of the part.
    pub ends: [usize; 2],
    pub subject: Subject,
    /// Marks that rest, clicked in the first frame of the part.
    pub marks: Vec<[f64; 2]>,
    /// What a person has said of lengths.
    pub form: CalibrationForm,
    /// The map that follows from it, from pixels of the upright picture.
    pub calibration: Calibration,
    pub found: Option<Found>,
    /// How the film was taken, if it is that of a simulation.
    pub recipe: Option<FilmRecipe>,
    /// The record that the film has become; there may be none of this id any more.
    pub record: Option<u32>,
}

/// What has been found in a film.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Found {
    /// In pixels of the upright picture, in the order of what is followed.
    pub tracks: Vec<Track>,
    /// The frames in which something was sought, with the times at which they were taken, in seconds.
    pub frames: Vec<(usize, f64)>,
    /// The factor with which times were computed then.
    pub factor: f64,
    /// Frames that repeat the picture before and were left out.
    pub repeated: Vec<usize>,
}

impl Work {
    pub fn factor(&self) -> f64 {
        self.factor.unwrap_or(self.stated_factor)
    }

    /// What has been found in the part of the film that is used, with the times of the present factor.
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

    /// When a frame was taken, in seconds, if something was sought in it.
    pub fn taken(&self, frame: usize) -> Option<f64> {
        let found = self.found.as_ref()?;
        let at = found.frames.binary_search_by_key(&frame, |frame| frame.0).ok()?;
        found.frames.get(at).map(|frame| frame.1 * (found.factor / self.factor()))
    }
}

//! Result of tracking.

use units::number::fixed;
use units::{Words, words};

/// Position in one frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Frame number of the caller.
    pub frame: usize,
    /// Time in s at which the row of the position was read. Equals the time of the frame without a rolling shutter.
    pub time: f64,
    /// Position in px, `x` to the right and `y` downwards; with camera motion, in the picture of the first frame.
    pub position: [f64; 2],
    /// Standard errors of both coordinates, px. For a surface, the components of its error along the tube.
    pub sigma: [f64; 2],
    /// Correlation of the pixels with the model, at most 1.
    pub score: f64,
    /// True if the user should check this frame.
    pub doubtful: bool,
}

/// Positions in the order of time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Track {
    /// The positions.
    pub points: Vec<Point>,
    /// Exposure time of the frames.
    pub exposure: Option<Exposure>,
    /// Readout time of a frame.
    pub readout: Option<Readout>,
    /// Unit vector along the tube of a surface; `None` for a body.
    pub direction: Option<[f64; 2]>,
    /// First frame in which a body was lost. Tracking resumes at the next key frame, if any.
    pub lost: Option<usize>,
    /// Outline of a body, by its last key frame; `None` for a surface.
    pub outline: Option<Outline>,
    /// Motion of the camera seen beside a tube, if no marks are given.
    pub shift: Option<CameraShift>,
}

/// Words on the track of a number, from 1, which name it if there are several.
pub fn of_several(number: usize, count: usize, what: Words) -> Words {
    match count {
        0 | 1 => what,
        _ => words!("track {number}: {what}", number = Words::same(number.to_string()), what = what),
    }
}

/// Outline of a tracked body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outline {
    /// Vector from the position of the body, which is that of its click, to the centre of the circle, px.
    pub offset: [f64; 2],
    /// Radius, px.
    pub radius: f64,
}

impl Track {
    /// Notes on the camera for the user: exposure time, readout time and motion.
    pub fn camera(&self) -> Vec<Words> {
        let exposure = self.exposure.map(|exposure| match exposure {
            Exposure::Seconds(seconds) => {
                words!("exposure: {ms} ms", ms = milliseconds(seconds))
            }
            Exposure::Under(seconds) => {
                words!("exposure: under {ms} ms, too short to smear the picture", ms = milliseconds(seconds))
            }
        });
        // A given readout time has no error and needs no note.
        let readout = self.readout.filter(|readout| readout.sigma > 0.0).map(|readout| {
            words!(
                "rolling shutter: {ms} ± {sigma} ms from the first row to the last; times are corrected for it",
                ms = milliseconds(readout.seconds),
                sigma = milliseconds(readout.sigma)
            )
        });
        let shift = self.shift.map(CameraShift::words);
        exposure.into_iter().chain(readout).chain(shift).collect()
    }
}

fn milliseconds(seconds: f64) -> Words {
    Words::each(move |language| fixed(1e3 * seconds, 1, language.style()))
}

/// Motion of the camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraShift {
    /// Largest shift since the first frame by which positions are corrected, px.
    pub pixels: f64,
}

impl CameraShift {
    fn words(self) -> Words {
        words!(
            "the picture moved by up to {px} px: the camera was not still; positions are corrected by the background. A plain background, or one with regular lines, can mislead: marks on things at rest make it certain",
            px = Words::each(move |language| fixed(self.pixels, 1, language.style()))
        )
    }
}

/// Estimated exposure time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Exposure {
    /// Exposure time, s.
    Seconds(f64),
    /// Upper bound in s: the film shows no smear.
    Under(f64),
}

/// Readout time of a rolling shutter, from the first row to the last.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Readout {
    /// Readout time, s; negative if the camera was held upside down.
    pub seconds: f64,
    /// Standard error, s.
    pub sigma: f64,
}

/// Quantity of the camera that may be known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Known {
    /// Estimated from the film.
    #[default]
    Estimated,
    /// Known value, s.
    Seconds(f64),
}

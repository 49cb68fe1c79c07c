//! What tracking finds.

/// Where something is in one frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The frame, counted as the caller counts.
    pub frame: usize,
    /// When the row in which it is seen was exposed, in seconds: the frame's own time without a rolling shutter.
    pub time: f64,
    /// `x` to the right and `y` downwards, in pixels; with resting marks, in the picture of the first frame.
    pub position: [f64; 2],
    /// The standard errors of both coordinates in pixels. A column is measured along its tube: its errors are those of that
    /// direction.
    pub sigma: [f64; 2],
    /// The correlation of the pixels with what was sought, at most 1.
    pub score: f64,
    /// Whether a person should look at this frame.
    pub doubtful: bool,
}

/// A position in each frame, in the order of time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Track {
    /// The positions.
    pub points: Vec<Point>,
    /// How long each frame was exposed.
    pub exposure: Option<Exposure>,
    /// How long the camera takes to read a frame.
    pub readout: Option<Readout>,
    /// The direction, of length 1, in which a column is measured; none for a body.
    pub direction: Option<[f64; 2]>,
    /// The first frame in which a body was lost; tracking ends before it.
    pub lost: Option<usize>,
}

/// The exposure time that was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Exposure {
    /// Seconds.
    Seconds(f64),
    /// The film shows no smear: less than so many seconds.
    Under(f64),
}

/// How long a rolling shutter takes from the first row to the last.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Readout {
    /// Seconds; negative where the camera was held upside down.
    pub seconds: f64,
    /// Its standard error in seconds.
    pub sigma: f64,
}

/// A quantity of the camera that may be known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Known {
    /// It is estimated from the film.
    #[default]
    Estimated,
    /// It is known, in seconds.
    Seconds(f64),
}

//! The film from which a record comes: what it is like, and pictures of it with what was tracked and fitted.

mod facts;
mod page;
mod picture;
mod section;

pub use facts::FilmFile;
pub use page::{TrackReport, film_html};
pub use picture::Frame;
pub(crate) use section::films;

/// A film from which a record comes.
#[derive(Clone, Debug, Default)]
pub struct Film {
    /// The name of its file.
    pub name: String,
    /// What is known of it, each with its name: size, length, rate.
    pub facts: Vec<(String, String)>,
    /// What a person should know of its times, its camera and its scale, in sentences.
    pub notes: Vec<String>,
    /// Pictures of it; a part of them may be missing.
    pub pictures: Vec<FilmPicture>,
}

/// What a picture of a film shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FilmView {
    /// A frame, by its number from 0.
    Frame(usize),
    /// The strip along a tube from every frame, side by side.
    SpaceTime,
}

/// A grey picture with lines over it. Lines are in units of a drawing of some size, which the picture fills.
#[derive(Clone, Debug)]
pub struct FilmPicture {
    /// What it shows.
    pub view: FilmView,
    /// Pixels in a row, and rows.
    pub pixels: [usize; 2],
    /// Their values, row by row from the top.
    pub grey: Vec<u8>,
    /// Width and height of the drawing.
    pub size: [f64; 2],
    /// What was tracked.
    pub tracked: Vec<Vec<[f64; 2]>>,
    /// The fitted curve.
    pub fitted: Vec<Vec<[f64; 2]>>,
    /// The marks of the calibration: a line between two, or a single point.
    pub marks: Vec<Vec<[f64; 2]>>,
}

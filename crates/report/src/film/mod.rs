//! The film from which a record was made: its properties, and pictures of it with the tracked and the fitted curve.

mod facts;
mod page;
mod picture;
mod section;

pub use facts::FilmFile;
pub use page::{TrackReport, film_html};
pub use picture::Frame;
pub(crate) use section::films;

/// The film from which a record was made.
#[derive(Clone, Debug, Default)]
pub struct Film {
    /// File name.
    pub name: String,
    /// Properties as pairs of term and value.
    pub facts: Vec<(String, String)>,
    /// Remarks about its times, its camera and its scale, in sentences.
    pub notes: Vec<String>,
    /// Pictures of it; may be empty.
    pub pictures: Vec<FilmPicture>,
}

/// Content of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FilmView {
    /// A frame, by its index from 0.
    Frame(usize),
    /// Space-time picture: the strip along a tube from every frame, side by side.
    SpaceTime,
}

/// A grey picture with lines over it. The lines are in units of a drawing of `size`, which the picture fills.
#[derive(Clone, Debug)]
pub struct FilmPicture {
    /// Content of the picture.
    pub view: FilmView,
    /// Number of columns and rows.
    pub pixels: [usize; 2],
    /// Grey values, row by row from the top.
    pub grey: Vec<u8>,
    /// Width and height of the drawing.
    pub size: [f64; 2],
    /// Tracked curves.
    pub tracked: Vec<Vec<[f64; 2]>>,
    /// Fitted curves.
    pub fitted: Vec<Vec<[f64; 2]>>,
    /// Marks of the calibration: a line between two points, or a single point.
    pub marks: Vec<Vec<[f64; 2]>>,
}

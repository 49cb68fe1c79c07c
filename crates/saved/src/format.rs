//! The storage format for records, fits, answers and films. A field can be added at any time: readers ignore unknown
//! fields and use defaults for missing ones. A change that earlier readers would misinterpret needs a new version
//! ([`Item::write`](crate::Item::write)).
//!
//! Numbers are SI, columns count from 0.

use handed::Number;
use serde::{Deserialize, Serialize};

pub use handed::answer::{Answer, Attempt};

/// Content of an item.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Content {
    /// A record.
    Record(Record),
    /// A fit.
    Fit(Fit),
    /// An answer to a question.
    Answer(Answer),
    /// The work on a film.
    Film(Box<Film>),
}

/// A record: its text and the user's settings.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Record {
    /// Name of the file.
    pub name: String,
    /// Text of the file.
    pub text: String,
    /// True if the record is not drawn.
    #[serde(skip_serializing_if = "is_false")]
    pub hidden: bool,
    /// True values of parameters by name, if the data are simulated.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub truth: Option<Vec<(String, Number)>>,
    /// Rows that are left out of fits, from 0.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub excluded: Vec<usize>,
    /// Values of parameters in this record, by name.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub known: Vec<(String, Number)>,
    /// Columns that the user has chosen as independent variables.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub against: Vec<usize>,
    /// Uses of columns chosen by the user.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub columns: Vec<Column>,
    /// Columns that were differentiated.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub derivatives: Vec<Derivative>,
    /// Results of a fit for this record.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub found: Option<FoundOfRecord>,
}

/// Use of a column.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Column {
    /// Index of the column.
    pub column: usize,
    /// Name of the quantity in the document; empty if the column is not used.
    pub quantity: String,
    /// Unit of the column, as text.
    pub unit: String,
    /// True if the user has stated the unit.
    pub stated: bool,
    /// True if fits use the column.
    pub fitted: bool,
}

/// A column whose velocity and acceleration were computed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Derivative {
    /// Index of the column.
    pub column: usize,
    /// Method of differentiation, `Differentiation::code`.
    pub method: String,
}

/// Results of a fit for a record. Valid only with the document of this hash.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct FoundOfRecord {
    /// Hash of the document's text.
    pub document: String,
    /// Clock reading at which the model begins.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub origin: Option<Number>,
    /// True if a fit has found the origin, false if it is the beginning of the fitted part.
    #[serde(skip_serializing_if = "is_false")]
    pub origin_fitted: bool,
    /// Zeros of the scales by column.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub offsets: Vec<(usize, Number)>,
}

/// A fit: its theory, its task, and the values from which it is reconstructed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Fit {
    /// Text of the theory and of its translations.
    pub documents: Vec<String>,
    /// Task as requested: records, time window, varied numbers and loss.
    pub task: Task,
    /// The values found.
    pub found: Found,
}

/// Task of a fit.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Task {
    /// File name of the theory.
    pub file: String,
    /// Start and end of the fitted time window on the record clocks.
    pub window: [Option<Number>; 2],
    /// Values of all parameters. Varied ones start there.
    pub parameters: Vec<Number>,
    /// The varied numbers.
    pub varied: Vec<Varied>,
    /// `Loss::code`; `None` for least squares.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub loss: Option<String>,
    /// The records that take part.
    pub records: Vec<Part>,
}

/// A varied number.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Varied {
    /// The varied number.
    pub target: Target,
    /// True if all records share one value.
    #[serde(default, skip_serializing_if = "is_false")]
    pub shared: bool,
    /// Lower and upper bound, SI, if they are not those of the parameter.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bounds: Option<[Number; 2]>,
}

/// Kind and index of a varied number.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Target {
    /// Parameter of the theory, by index.
    Parameter(usize),
    /// Clock reading at which the model begins.
    Origin,
    /// Zero of the scale of an observation, by index.
    Offset(usize),
}

/// Participation of a record in a fit.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Part {
    /// Name of the record in the storage.
    pub record: String,
    /// Name of the record.
    pub name: String,
    /// Clock reading at which the model begins.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub origin: Option<Number>,
    /// Parameters with a fixed value of their own in this record: index and value.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub fixed: Vec<(usize, Number)>,
    /// Uses of the columns.
    pub columns: Vec<Column>,
    /// Stated standard errors of columns.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub errors: Vec<StatedError>,
    /// Rows that were left out, from 0.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub excluded: Vec<usize>,
}

/// Standard errors stated for the values of a column, by one of both fields.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct StatedError {
    /// Index of the column.
    pub column: usize,
    /// One standard error for all values, SI.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub value: Option<Number>,
    /// Index of the column with the standard errors.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub beside: Option<usize>,
}

/// Result of a fit.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Found {
    /// Fitted values in the order of the search; empty if the full search has to be repeated.
    pub values: Vec<Number>,
    /// Number of starts of the search.
    pub starts: usize,
    /// Another minimum found by the search.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rival: Option<Rival>,
}

/// Another minimum of the search.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rival {
    /// Excess of its sum of squares, in variances of a residual.
    pub growth: Number,
    /// Varied numbers at this minimum, in the order of the search.
    pub values: Vec<Number>,
}

/// Point in pixels of the upright picture: x, y.
pub type Place = [Number; 2];

/// The user's settings for a film and its tracks. The film itself is not stored.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Film {
    /// Name of the file.
    pub name: String,
    /// Size of the file in bytes. `hash` is the hash of its beginning.
    pub size: u64,
    /// Hash of the beginning of the file.
    pub hash: String,
    /// Slow-motion factor set by the user: playing time divided by real time.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub factor: Option<Number>,
    /// Start and end of the used part, in seconds of the file; `None` is open.
    pub part: [Option<Number>; 2],
    /// Kind of the tracked objects: `surfaces`, `bodies` or `points`; empty if there are none.
    pub kind: String,
    /// The tracked objects.
    pub followed: Vec<Followed>,
    /// Stationary marks, from which the motion of the camera is determined.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub marks: Vec<Place>,
    /// Marks of the ruler or corners of the rectangle.
    pub points: Vec<Place>,
    /// Length between the marks or sides of the rectangle, as typed.
    pub lengths: Vec<String>,
    /// Number of intervals between the marks of the ruler.
    pub intervals: u32,
    /// Size of a pixel in metres, and its relative standard error.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scale: Option<[Number; 2]>,
    /// Origin of the coordinates.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub origin: Option<Place>,
    /// A point on the axis.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axis: Option<Place>,
    /// Distance of the ruler behind the motion and distance of the camera from the motion, as typed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub parallax: Option<[String; 2]>,
    /// Width and height of the rectangle in metres.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sides: Option<Place>,
    /// The map from pixels to lengths: zero point, angle of the axes, and `behind` and `distance` of the parallax in
    /// metres.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub zero: Option<Place>,
    /// Angle of the axes, in radians.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub angle: Option<Number>,
    /// Distance of the ruler behind the motion and of the camera from the motion, in metres.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ruler: Option<Place>,
    /// Slow-motion factor stated by the file. `ends`: first and last frame of the used part.
    pub stated_factor: Option<Number>,
    /// First and last frame of the used part.
    pub ends: [usize; 2],
    /// Result of the tracking.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub found: Option<FoundInFilm>,
    /// Name in the storage of the record made from the film.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub record: Option<String>,
    /// Camera settings, if it is a film of a simulation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub recipe: Option<Recipe>,
}

/// Source and camera settings of a filmed simulation.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Recipe {
    /// Title of the document. `source` is the hash of its text, `state` the initial state as in a link.
    pub document: String,
    /// Hash of the text of the document.
    pub source: String,
    /// Initial state, as in a link.
    pub state: String,
    /// Language tag.
    pub language: String,
    /// Duration in seconds, frames per second, exposure in seconds, noise in grey values of 255.
    pub camera: Option<[Number; 4]>,
    /// Seed of the noise.
    pub seed: u32,
}

/// Result of tracking a film, in seconds and pixels of the upright picture.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct FoundInFilm {
    /// Slow-motion factor with which the times were computed.
    pub factor: Option<Number>,
    /// Processed frames and their times.
    pub frames: Vec<(usize, Number)>,
    /// Frames that repeat the one before.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub repeated: Vec<usize>,
    /// The tracks, in the order of the tracked objects.
    pub tracks: Vec<TrackInFilm>,
}

/// Track of one object.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct TrackInFilm {
    /// Unit vector along the tube; `None` for a body.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub direction: Option<Place>,
    /// Exposure in seconds; true if that is only an upper bound.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub exposure: Option<(Number, bool)>,
    /// Readout time of the rolling shutter and its standard error, in seconds.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub readout: Option<Place>,
    /// Frame at which the object was lost.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lost: Option<usize>,
    /// Outline of a body: offset of its centre from the position, and radius, in pixels.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outline: Option<[Number; 3]>,
    /// Greatest shift of the picture by which positions are corrected, in pixels.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shift: Option<Number>,
    /// Per point: frame; time, position, errors of both coordinates, score; true if it is doubtful.
    pub points: Vec<(usize, [Number; 6], bool)>,
}

/// A tracked object.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Followed {
    /// Frames and positions: click of a surface, key frames of a body, or points set by hand.
    pub clicks: Vec<(usize, Place)>,
    /// Ends of the tube.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tube: Option<[Place; 2]>,
    /// Frames and positions set by hand.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub anchors: Vec<(usize, Place)>,
    /// Radius of a body, in pixels.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radius: Option<Number>,
    /// Standard error of points set by hand, in pixels.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sigma: Option<Number>,
}

fn is_false(value: &bool) -> bool {
    !value
}

//! The saved-state format: what of records, fits and answers is kept, apart from what the desk makes of them. A field can be
//! added at any time: who does not know it ignores it, and where it is missing its default holds. What earlier readers would
//! misunderstand needs another version ([`Item::write`](super::Item::write)).
//!
//! Numbers are SI, columns count from 0.

use super::number::Number;
use serde::{Deserialize, Serialize};

/// An item of any kind.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Content {
    Record(Record),
    Fit(Fit),
    Answer(Answer),
    Film(Box<Film>),
}

/// A record: its text, and what a person has said about it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct Record {
    pub name: String,
    /// The text it was read from.
    pub text: String,
    /// Whether it is not drawn.
    #[serde(skip_serializing_if = "is_false")]
    pub hidden: bool,
    /// The true values of parameters by name, if the data are simulated.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub truth: Option<Vec<(String, Number)>>,
    /// Values that parameters have in this record, by name.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub known: Vec<(String, Number)>,
    /// The columns that a person has made independent variables.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub against: Vec<usize>,
    /// What a person has said of columns.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub columns: Vec<Column>,
    /// Columns that were differentiated.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub derivatives: Vec<Derivative>,
    /// What a fit has found of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub found: Option<FoundOfRecord>,
}

/// What a column is taken for.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct Column {
    pub column: usize,
    /// The name of the quantity in the document; empty where the column is not used.
    pub quantity: String,
    pub unit: String,
    /// Whether a person has stated the unit.
    pub stated: bool,
    /// Whether a fit is to follow it.
    pub fitted: bool,
}

/// Velocity and acceleration made of a column.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct Derivative {
    pub column: usize,
    /// `Differentiation::code`
    pub method: String,
}

/// What a fit has found of a record. It holds beside the document of this name alone.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct FoundOfRecord {
    /// The hash of the document's text.
    pub document: String,
    /// The reading of the record's clock at which the model begins.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub origin: Option<Number>,
    /// Whether a fit has found the origin. Otherwise it is where the fitted part began.
    #[serde(skip_serializing_if = "is_false")]
    pub origin_fitted: bool,
    /// The zeros of the scales of columns.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub offsets: Vec<(usize, Number)>,
}

/// A fit: its theory, what was asked for, and the numbers from which it is made again.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct Fit {
    /// The text of the theory, and those of its translations.
    pub documents: Vec<String>,
    pub task: Task,
    pub found: Found,
}

/// What was asked for.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct Task {
    /// The file of the theory.
    pub file: String,
    /// What part of the records is fitted: readings of their clocks.
    pub window: [Option<Number>; 2],
    /// All parameters where they are not varied.
    pub parameters: Vec<Number>,
    pub varied: Vec<Varied>,
    /// `Loss::code`; least squares where there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub loss: Option<String>,
    pub records: Vec<Part>,
}

/// A number that is varied.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Varied {
    pub target: Target,
    /// Whether it is one for all records.
    #[serde(default, skip_serializing_if = "is_false")]
    pub shared: bool,
}

/// Which number is varied.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Target {
    /// A parameter of the theory.
    Parameter(usize),
    /// The reading of the clock at which the model begins.
    Origin,
    /// The zero of the scale of what is followed.
    Offset(usize),
}

/// What a fit follows of a record.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct Part {
    /// The record by the name under which it is stored; by its place where an earlier version has saved the fit.
    pub record: String,
    pub name: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub origin: Option<Number>,
    /// Parameters that have a value of their own in it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub fixed: Vec<(usize, Number)>,
    pub columns: Vec<Column>,
}

/// What a fit has found.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct Found {
    /// The numbers, in the order of the search; none where it has to be searched from the beginning.
    pub values: Vec<Number>,
    /// From how many starts was searched.
    pub starts: usize,
    /// Another minimum that a search has met.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rival: Option<Rival>,
}

/// Another minimum.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Rival {
    /// By how much its sum of squares is larger, in variances of a residual.
    pub growth: Number,
    pub values: Vec<Number>,
}

/// What was answered to a question.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct Answer {
    pub typed: String,
    /// `Grade::code`; none where it has not been checked.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub grade: Option<String>,
    #[serde(skip_serializing_if = "is_false")]
    pub revealed: bool,
}

/// A point in pixels of the upright picture.
pub(crate) type Place = [Number; 2];

/// What a person has said of a film. The film itself is not stored.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct Film {
    pub name: String,
    /// The size of the file in bytes, and the hash of its beginning.
    pub size: u64,
    pub hash: String,
    /// How many times slower it plays than things happened, where a person has said so.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub factor: Option<Number>,
    /// The part that is used, in seconds of the file.
    pub part: [Option<Number>; 2],
    /// `surfaces`, `bodies` or `points`.
    pub kind: String,
    pub followed: Vec<Followed>,
    /// Marks that rest.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub marks: Vec<Place>,
    /// The marks of the ruler, or the corners of the rectangle.
    pub points: Vec<Place>,
    /// The length between the marks, or the sides of the rectangle, as typed.
    pub lengths: Vec<String>,
    pub intervals: u32,
    /// Metres in a pixel and their relative standard error.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scale: Option<[Number; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub origin: Option<Place>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axis: Option<Place>,
    /// By how much the ruler is behind what moves, and how far the camera is, as typed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub parallax: Option<[String; 2]>,
    /// Width and height of the rectangle in metres.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sides: Option<Place>,
    /// The map to lengths: the point that is zero, the angle of the axes, and behind and distance of the ruler in metres.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub zero: Option<Place>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub angle: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ruler: Option<Place>,
    /// The factor of the file itself, and the first and the last frame of the part.
    pub stated_factor: Option<Number>,
    pub ends: [usize; 2],
    /// What was found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub found: Option<FoundInFilm>,
    /// The record by the name under which it is stored.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub record: Option<String>,
    /// How it was taken, if it is that of a simulation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub recipe: Option<Recipe>,
}

/// How a simulation was filmed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct Recipe {
    /// The title of the document, the hash of its text, and the state of its start as in a link.
    pub document: String,
    pub source: String,
    pub state: String,
    pub language: String,
    /// Seconds, frames a second, exposure in seconds, noise in grey values.
    pub camera: Option<[Number; 4]>,
    pub seed: u32,
}

/// What was found in a film, in seconds and pixels of the upright picture.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct FoundInFilm {
    /// The factor with which times were computed.
    pub factor: Option<Number>,
    /// The frames in which something was sought, with their times.
    pub frames: Vec<(usize, Number)>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub repeated: Vec<usize>,
    pub tracks: Vec<TrackInFilm>,
}

/// A track.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct TrackInFilm {
    /// The direction of a tube.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub direction: Option<Place>,
    /// The exposure in seconds, and whether it is shorter than that.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub exposure: Option<(Number, bool)>,
    /// The readout time and its error.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub readout: Option<Place>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lost: Option<usize>,
    /// Frame; time, position, errors of both coordinates, score; whether it is in doubt.
    pub points: Vec<(usize, [Number; 6], bool)>,
}

/// Something that is followed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct Followed {
    /// Frames and places: the click of a surface, the key frames of a body, points by hand.
    pub clicks: Vec<(usize, Place)>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tube: Option<[Place; 2]>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub anchors: Vec<(usize, Place)>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radius: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sigma: Option<Number>,
}

fn is_false(value: &bool) -> bool {
    !value
}

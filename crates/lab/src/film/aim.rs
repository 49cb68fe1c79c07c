//! What a click on the film means.

use desk::Subject;

/// A point of the upright picture, in pixels.
pub type Pixel = [f64; 2];

/// What is followed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kind {
    /// The surface of a liquid in a tube.
    #[default]
    Surface,
    /// Those in both arms of a tube.
    Arms,
    /// Bodies.
    Body,
    /// A point that is clicked in each frame.
    Hand,
}

impl Kind {
    /// That of what is followed already.
    pub fn of(subject: &Subject) -> Option<Self> {
        match subject {
            Subject::Nothing => None,
            Subject::Surfaces(surfaces) if surfaces.len() > 1 => Some(Self::Arms),
            Subject::Surfaces(_) => Some(Self::Surface),
            Subject::Bodies(_) => Some(Self::Body),
            Subject::Points { .. } => Some(Self::Hand),
        }
    }
}

/// What the next click sets.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tool {
    /// Nothing.
    #[default]
    Rest,
    /// What is followed.
    Subject,
    /// Two points of the tube's axis.
    Tube,
    /// Marks that rest, against shake.
    Still,
    /// Two marks of the ruler.
    Ruler,
    /// The point that becomes zero.
    Origin,
    /// A point on the x axis.
    Axis,
    /// The corners of a rectangle.
    Corners,
}

/// A point that can be moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Handle {
    /// Where a surface was clicked.
    Surface(usize),
    /// An end of a tube's axis.
    Tube(usize, usize),
    /// A key frame of a body.
    Body(usize, usize),
    /// A point by hand.
    Hand(usize),
    /// A resting mark.
    Still(usize),
    /// A mark of the ruler.
    Ruler(usize),
    /// The origin.
    Origin,
    /// The point on the x axis.
    Axis,
    /// A corner of the rectangle.
    Corner(usize),
}

/// A point that is being placed or moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aim {
    /// What is moved; a new point without it.
    pub handle: Option<Handle>,
    /// Where it is.
    pub at: Pixel,
    /// Whether it is moved by keys.
    pub by_keys: bool,
}

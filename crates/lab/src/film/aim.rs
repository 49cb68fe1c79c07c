//! Effects of clicks on the film.

use desk::Subject;

/// Point of the upright picture, px.
pub type Pixel = [f64; 2];

/// Kind of subject.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kind {
    /// Surface of a liquid in a tube.
    #[default]
    Surface,
    /// Surfaces in both arms of a tube.
    Arms,
    /// Bodies.
    Body,
    /// Point clicked by hand in each frame.
    Hand,
}

impl Kind {
    /// Kind of an existing subject.
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

/// Effect of the next click.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tool {
    /// None.
    #[default]
    Rest,
    /// Clicks the subject.
    Subject,
    /// Sets two points of the tube axis.
    Tube,
    /// Adds fixed marks against camera shake.
    Still,
    /// Sets two marks of the ruler.
    Ruler,
    /// Sets the origin.
    Origin,
    /// Sets a point on the x axis.
    Axis,
    /// Sets the corners of a rectangle.
    Corners,
}

/// Movable point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Handle {
    /// Click on the surface with this index.
    Surface(usize),
    /// End of a tube axis: index of the surface and of the end.
    Tube(usize, usize),
    /// Key frame of a body: index of the body and of the key frame.
    Body(usize, usize),
    /// Point clicked by hand.
    Hand(usize),
    /// Fixed mark.
    Still(usize),
    /// Mark of the ruler.
    Ruler(usize),
    /// The origin.
    Origin,
    /// The point on the x axis.
    Axis,
    /// Corner of the rectangle.
    Corner(usize),
}

/// Point being placed or moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aim {
    /// Moved point; `None` for a new one.
    pub handle: Option<Handle>,
    /// Present position, px.
    pub at: Pixel,
    /// True if it is moved by keys.
    pub by_keys: bool,
}

//! What is followed in a film.

use crate::films::clip::Clip;
use film::tracking::column::Click;
use film::tracking::{Refusal, body};

/// How many surfaces are followed at once.
pub const MOST_SURFACES: usize = 2;
/// How many bodies are.
pub const MOST_BODIES: usize = 4;
/// How many clicks a film may have by hand, as key frames or as anchors of a surface.
const MOST_CLICKS: usize = 10_000;
/// The standard error of each coordinate of a point that is clicked by hand, in pixels, unless a person states another one.
pub const POINT_SIGMA: f64 = 1.0;

/// What is followed.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Subject {
    /// Nothing yet.
    #[default]
    Nothing,
    /// Surfaces in tubes: one, or those of both arms.
    Surfaces(Vec<FilmedSurface>),
    /// Bodies.
    Bodies(Vec<FilmedBody>),
    /// A point that a person clicks in each frame.
    Points {
        /// At most one in a frame.
        clicks: Vec<Click>,
        /// The standard error of each coordinate in pixels: [`POINT_SIGMA`], unless it is stated.
        sigma: f64,
    },
}

/// The surface of a liquid in a tube.
#[derive(Clone, Debug, PartialEq)]
pub struct FilmedSurface {
    /// Where it was clicked.
    pub click: Click,
    /// Two points of the tube's axis; an upright tube through the click without them.
    pub tube: Option<[[f64; 2]; 2]>,
    /// Where a person has corrected the path.
    pub anchors: Vec<Click>,
}

impl FilmedSurface {
    /// In an upright tube.
    pub fn new(click: Click) -> Self {
        Self { click, tube: None, anchors: Vec::new() }
    }
}

/// A body.
#[derive(Clone, Debug, PartialEq)]
pub struct FilmedBody {
    /// Where it was clicked: the frame from which on it is followed, and further key frames.
    pub keys: Vec<Click>,
    /// Its radius in pixels; found around the click without it.
    pub radius: Option<f64>,
}

impl FilmedBody {
    /// With a radius that is found.
    pub fn new(click: Click) -> Self {
        Self { keys: vec![click], radius: None }
    }
}

impl Subject {
    /// Whether nothing has been clicked.
    pub fn is_nothing(&self) -> bool {
        match self {
            Self::Nothing => true,
            Self::Surfaces(surfaces) => surfaces.is_empty(),
            Self::Bodies(bodies) => bodies.is_empty(),
            Self::Points { clicks, .. } => clicks.is_empty(),
        }
    }

    /// Whether frames have to be searched.
    pub fn needs_tracking(&self) -> bool {
        matches!(self, Self::Surfaces(_) | Self::Bodies(_)) && !self.is_nothing()
    }

    /// Refuses clicks that this film does not have, radii that cannot be followed in it, and too many of either.
    pub(crate) fn check(&self, clip: &Clip) -> Result<(), Refusal> {
        let (size, frames) = (clip.size(), clip.times().len());
        let [least, greatest] = body::radii(clip.plane_size()[1] as f64);
        let most = |count: usize, greatest: usize| match count <= greatest {
            true => Ok(()),
            false => Err(Refusal::Many { greatest }),
        };
        let inside = |click: &Click| match click.frame < frames {
            true => inside(click.position, size),
            false => Err(Refusal::Short { frames: click.frame.saturating_add(1) }),
        };
        match self {
            Self::Nothing => Ok(()),
            Self::Surfaces(surfaces) => {
                most(surfaces.len(), MOST_SURFACES)?;
                for surface in surfaces {
                    most(surface.anchors.len(), MOST_CLICKS)?;
                    surface.tube.iter().flatten().try_for_each(|point| self::inside(*point, size))?;
                    std::iter::once(&surface.click).chain(&surface.anchors).try_for_each(inside)?;
                }
                Ok(())
            }
            Self::Bodies(bodies) => {
                most(bodies.len(), MOST_BODIES)?;
                for body in bodies {
                    most(body.keys.len(), MOST_CLICKS)?;
                    body.keys.iter().try_for_each(inside)?;
                    if body.radius.is_some_and(|radius| !(least..=greatest).contains(&radius)) {
                        return Err(Refusal::Radius { least, greatest: greatest.floor() });
                    }
                }
                Ok(())
            }
            Self::Points { clicks, .. } => {
                most(clicks.len(), MOST_CLICKS)?;
                clicks.iter().try_for_each(inside)
            }
        }
    }

    /// Without what has no meaning: keys and points in order and one in a frame, bodies without any, errors that are not positive.
    pub(crate) fn settled(mut self) -> Self {
        match &mut self {
            Self::Nothing | Self::Surfaces(_) => {}
            Self::Bodies(bodies) => {
                bodies.iter_mut().for_each(|body| one_in_a_frame(&mut body.keys));
                bodies.retain(|body| !body.keys.is_empty());
            }
            Self::Points { clicks, sigma } => {
                one_in_a_frame(clicks);
                if !(*sigma > 0.0 && sigma.is_finite()) {
                    *sigma = POINT_SIGMA;
                }
            }
        }
        if self.is_nothing() { Self::Nothing } else { self }
    }
}

/// The last click of each frame, in order.
fn one_in_a_frame(clicks: &mut Vec<Click>) {
    clicks.reverse();
    clicks.sort_by_key(|click| click.frame);
    clicks.dedup_by_key(|click| click.frame);
}

/// Refuses a point outside the picture.
pub(crate) fn inside([x, y]: [f64; 2], [width, height]: [f64; 2]) -> Result<(), Refusal> {
    let inside = (0.0..=width).contains(&x) && (0.0..=height).contains(&y);
    if inside { Ok(()) } else { Err(Refusal::Click { x, y }) }
}

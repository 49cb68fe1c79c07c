//! Subjects of tracking.

use crate::films::clip::Clip;
use film::tracking::column::Click;
use film::tracking::{Refusal, body};
use units::order::sort_by_key;

/// Maximum number of surfaces.
pub const MOST_SURFACES: usize = 2;
/// Maximum number of bodies.
pub const MOST_BODIES: usize = 4;
/// Maximum number of clicks by hand per film, and of key frames or anchors per object.
const MOST_CLICKS: usize = 10_000;
/// Default standard error of each coordinate of a point clicked by hand, px.
pub const POINT_SIGMA: f64 = 1.0;

/// Subject of tracking.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Subject {
    /// Nothing yet.
    #[default]
    Nothing,
    /// Surfaces in tubes: one, or those of both arms.
    Surfaces(Vec<FilmedSurface>),
    /// Bodies.
    Bodies(Vec<FilmedBody>),
    /// Point clicked by hand in each frame.
    Points {
        /// Clicks, at most one per frame.
        clicks: Vec<Click>,
        /// Standard error of each coordinate, px; default [`POINT_SIGMA`].
        sigma: f64,
    },
}

/// Surface of a liquid in a tube.
#[derive(Clone, Debug, PartialEq)]
pub struct FilmedSurface {
    /// Click on the surface.
    pub click: Click,
    /// Two points of the tube axis, px. Default: an upright tube through the click.
    pub tube: Option<[[f64; 2]; 2]>,
    /// Corrections of the path.
    pub anchors: Vec<Click>,
}

impl FilmedSurface {
    /// Surface in an upright tube.
    pub fn new(click: Click) -> Self {
        Self { click, tube: None, anchors: Vec::new() }
    }
}

/// Body with its key frames.
#[derive(Clone, Debug, PartialEq)]
pub struct FilmedBody {
    /// Clicks in the first frame and in further key frames.
    pub keys: Vec<Click>,
    /// Radius, px. Default: found around the click.
    pub radius: Option<f64>,
}

impl FilmedBody {
    /// Body without a given radius.
    pub fn new(click: Click) -> Self {
        Self { keys: vec![click], radius: None }
    }
}

impl Subject {
    /// True if nothing has been clicked.
    pub fn is_nothing(&self) -> bool {
        match self {
            Self::Nothing => true,
            Self::Surfaces(surfaces) => surfaces.is_empty(),
            Self::Bodies(bodies) => bodies.is_empty(),
            Self::Points { clicks, .. } => clicks.is_empty(),
        }
    }

    /// True if frames have to be read for tracking.
    pub fn needs_tracking(&self) -> bool {
        matches!(self, Self::Surfaces(_) | Self::Bodies(_)) && !self.is_nothing()
    }

    /// Checks clicks, radii and numbers of objects for this film.
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

    /// Removes meaningless content: keeps one click per frame in order, drops bodies without clicks, and replaces an
    /// invalid standard error.
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

/// Keeps the last click of each frame, in order.
fn one_in_a_frame(clicks: &mut Vec<Click>) {
    clicks.reverse();
    sort_by_key(clicks, |click| click.frame);
    clicks.dedup_by_key(|click| click.frame);
}

/// Checks that a point lies inside the picture, px.
pub(crate) fn inside([x, y]: [f64; 2], [width, height]: [f64; 2]) -> Result<(), Refusal> {
    let inside = (0.0..=width).contains(&x) && (0.0..=height).contains(&y);
    if inside { Ok(()) } else { Err(Refusal::Click { x, y }) }
}

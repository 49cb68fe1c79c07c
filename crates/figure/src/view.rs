//! Zooming and panning: the next view after a gesture in pixels. The default view, fully automatic, resets it.

use crate::figure::Figure;
use crate::items::{Point, Scale};
use crate::limits::sane;
use crate::plot::{Interval, View};

/// Maximum length of an axis relative to its automatic limits.
const WIDEST: f64 = 100.0;

/// Minimum length of an axis relative to the magnitude of its values: labels would not fit below.
const CLOSEST: f64 = 1e-9;

/// Minimum width and height of a zoom rectangle, pixels; a narrower one zooms only in the other direction.
const LEAST_RECTANGLE: f32 = 6.0;

/// Axes along which a view changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// The horizontal axis.
    Horizontal,
    /// The vertical axes.
    Vertical,
    /// All axes.
    Both,
}

impl Figure {
    /// Zooms by `factor` (2 shows half as much) about a pixel, whose values stay in place.
    pub fn zoom(&self, at: Point, factor: f64, direction: Direction) -> View {
        if !factor.is_finite() || factor <= 0.0 {
            return self.view.clone();
        }
        self.change(direction, |scale, horizontal| {
            let fixed = scale.value(f64::from(if horizontal { at.x } else { at.y }));
            let Interval { low, high } = scale.values;
            Interval { low: fixed - (fixed - low) / factor, high: fixed + (high - fixed) / factor }
        })
    }

    /// Zooms by `factor` about the centre of the panel.
    pub fn zoom_centre(&self, factor: f64, direction: Direction) -> View {
        let panel = self.panel;
        let at = Point { x: panel.x + panel.width / 2.0, y: panel.y + panel.height / 2.0 };
        self.zoom(at, factor, direction)
    }

    /// Zooms to the rectangle between two pixels. A flat or narrow one zooms in one direction only; one that is both flat
    /// and narrow changes nothing.
    pub fn zoom_to(&self, one: Point, other: Point) -> View {
        let direction = match ((one.x - other.x).abs() >= LEAST_RECTANGLE, (one.y - other.y).abs() >= LEAST_RECTANGLE) {
            (true, true) => Direction::Both,
            (true, false) => Direction::Horizontal,
            (false, true) => Direction::Vertical,
            (false, false) => return self.view.clone(),
        };
        self.change(direction, |scale, horizontal| {
            let ends = if horizontal { (one.x, other.x) } else { (one.y, other.y) };
            let (least, most) = (scale.low.min(scale.high), scale.low.max(scale.high));
            let value = |pixel: f32| scale.value(f64::from(pixel).clamp(least, most));
            Interval::new(value(ends.0), value(ends.1))
        })
    }

    /// Moves the content by so many pixels to the right and down.
    pub fn pan(&self, right: f64, down: f64) -> View {
        let direction = match (right == 0.0, down == 0.0) {
            (true, true) => return self.view.clone(),
            (false, true) => Direction::Horizontal,
            (true, false) => Direction::Vertical,
            (false, false) => Direction::Both,
        };
        self.change(direction, |scale, horizontal| {
            let pixels = if horizontal { right } else { down };
            Interval { low: scale.value(scale.low - pixels), high: scale.value(scale.high - pixels) }
        })
    }

    /// The view with some limits changed by `limits`, within reason; its second argument is true for the horizontal axis.
    fn change(&self, direction: Direction, limits: impl Fn(&Scale, bool) -> Interval) -> View {
        let mut view = self.view.clone();
        if direction != Direction::Vertical
            && let (Some(scale), Some(home)) = (&self.x, self.home_x)
        {
            view.x = Some(reasonable(limits(scale, true), scale.values, home));
        }
        if direction != Direction::Horizontal {
            view.y = (self.y.iter().zip(&self.home_y))
                .map(|(scale, home)| reasonable(limits(scale, false), scale.values, *home))
                .collect();
        }
        view
    }
}

/// The wanted limits, moved so that part of the automatic limits stays visible. The present ones if the wanted limits are
/// too long, too short or not finite.
fn reasonable(wanted: Interval, present: Interval, home: Interval) -> Interval {
    let length = wanted.high - wanted.low;
    let magnitude = wanted.low.abs().max(wanted.high.abs());
    let possible = length.is_finite() && magnitude.is_finite();
    let shorter = length < present.length();
    if !possible
        || (shorter && length < CLOSEST * magnitude.max(home.length() * 1e-3))
        || (!shorter && length > WIDEST * home.length().max(present.length() / WIDEST))
    {
        return present;
    }
    // At least a tenth of the visible length stays within the automatic limits.
    let overlap = 0.1 * length.min(home.length());
    let right = (home.low + overlap - wanted.high).max(0.0);
    let left = (wanted.low - (home.high - overlap)).max(0.0);
    sane(Interval { low: wanted.low + right - left, high: wanted.high + right - left })
}

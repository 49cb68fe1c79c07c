//! Zooming and panning: from a gesture in pixels to the next view. The default view, all automatic, is the way back.

use crate::figure::Figure;
use crate::items::{Point, Scale};
use crate::limits::sane;
use crate::plot::{Interval, View};

/// How many times longer than what the automatic limits show an axis may get.
const WIDEST: f64 = 100.0;

/// How many times shorter than its values an axis may get: finer, the labels would not fit.
const CLOSEST: f64 = 1e-9;

/// A rectangle narrower than this, in pixels, is meant along the other direction only.
const LEAST_RECTANGLE: f32 = 6.0;

/// Along which axes a view changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Along the horizontal axis.
    Horizontal,
    /// Along the vertical axes.
    Vertical,
    /// Along both.
    Both,
}

impl Figure {
    /// Zooms by a factor (2 shows half as much) about a pixel, which keeps its values.
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

    /// Zooms by a factor about the centre of the panel.
    pub fn zoom_centre(&self, factor: f64, direction: Direction) -> View {
        let panel = self.panel;
        let at = Point { x: panel.x + panel.width / 2.0, y: panel.y + panel.height / 2.0 };
        self.zoom(at, factor, direction)
    }

    /// Zooms to the rectangle between two pixels. A flat or narrow one zooms along one direction only, and one that is
    /// both changes nothing.
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

    /// Moves what is shown by so many pixels, right and down, as if the paper were dragged.
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

    /// The view with the limits of some axes changed, kept within reason.
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

/// Limits as they are wanted, unless they are too long, too short or not finite; and moved so far that something of what
/// the automatic limits show stays in sight.
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
    // At least a tenth of what is shown stays within the automatic limits.
    let overlap = 0.1 * length.min(home.length());
    let right = (home.low + overlap - wanted.high).max(0.0);
    let left = (wanted.low - (home.high - overlap)).max(0.0);
    sane(Interval { low: wanted.low + right - left, high: wanted.high + right - left })
}

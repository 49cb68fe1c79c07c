//! What a figure consists of: places, strokes and items in pixels, and the scales that lead from values to them.

use std::ops::Range;

use crate::plot::Interval;

/// The radius of the dots of measured data.
pub(crate) const DATA_RADIUS: f32 = 2.5;
/// So many computed points have dots as large as those of measured data.
const FULL_SIZE: f32 = 300.0;
/// The radius of the smallest dots.
const LEAST_RADIUS: f32 = 0.7;

/// The radius of each of so many computed points. Beyond [`FULL_SIZE`] together they cover the same area, until they would be
/// too small to be seen: the structure of a section or a bifurcation diagram is lost where dots overlap.
pub(crate) fn radius_of(count: usize) -> f32 {
    (DATA_RADIUS * libm::sqrtf(FULL_SIZE / (count as f32).max(FULL_SIZE))).max(LEAST_RADIUS)
}

/// A place in the figure, in CSS pixels from its upper left corner.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// To the right.
    pub x: f32,
    /// Downwards.
    pub y: f32,
}

/// An upright rectangle in CSS pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rect {
    /// The left edge.
    pub x: f32,
    /// The upper edge.
    pub y: f32,
    /// The width.
    pub width: f32,
    /// The height.
    pub height: f32,
}

impl Rect {
    /// Whether the point lies in it, edges included.
    pub fn contains(self, point: Point) -> bool {
        (self.x..=self.x + self.width).contains(&point.x) && (self.y..=self.y + self.height).contains(&point.y)
    }
}

/// What a line or text is, from which the palette knows its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ink {
    /// What lies behind the whole figure.
    Ground,
    /// Titles, tick labels, names.
    Text,
    /// The lines of the grid.
    Grid,
    /// The line of the value zero.
    Zero,
    /// The axes and their ticks.
    Axis,
    /// The line of the present.
    Marker,
    /// A series in its colour.
    Series(u8),
    /// A run that was kept, in the colour of its own.
    Run(u8),
    /// A series as an earlier run left it: its colour, faint.
    Ghost(u8),
    /// What a series may be wrong by: its colour, fainter still.
    Band(u8),
}

/// The dashes of a line, so that lines can be distinguished without colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dash {
    /// No gaps.
    #[default]
    Solid,
    /// One of the patterns, counted modulo their number.
    Pattern(u8),
}

impl Dash {
    /// Lengths of dash and gap in turn, in CSS pixels; empty for a solid line.
    pub fn lengths(self) -> &'static [f32] {
        const PATTERNS: [&[f32]; 5] =
            [&[7.0, 4.0], &[2.0, 3.0], &[10.0, 3.0, 2.0, 3.0], &[14.0, 5.0], &[6.0, 3.0, 2.0, 3.0, 2.0, 3.0]];
        match self {
            Dash::Solid => &[],
            Dash::Pattern(number) => PATTERNS[usize::from(number) % PATTERNS.len()],
        }
    }
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Its colour.
    pub ink: Ink,
    /// Its width in CSS pixels.
    pub width: f32,
    /// Its dashes.
    pub dash: Dash,
}

/// Which part of a text stands at its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// The text begins there.
    Start,
    /// The text is centred there.
    Middle,
    /// The text ends there.
    End,
}

/// One thing to paint, in the order of the list.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Item<'a> {
    /// A filled rectangle.
    Fill(Rect, Ink),
    /// A straight, upright or level line.
    Line(Point, Point, Stroke),
    /// A line through the points, x and y in turn; at least two points, all of them inside the panel or on its edge.
    Polyline(&'a [f32], Stroke),
    /// The filled area that a line through the points, x and y in turn, encloses; at least three points.
    Area(&'a [f32], Ink),
    /// Filled circles about the points, x and y in turn.
    Dots {
        /// The centres.
        centres: &'a [f32],
        /// The radius of each.
        radius: f32,
        /// The colour.
        ink: Ink,
        /// Whether a ring in the colour of the ground sets the circles off from what lies beneath.
        ringed: bool,
    },
    /// Upright bars with round ends: dots so close that they overlap. Abscissa, upper and lower end of each in turn; the
    /// ends are centres of dots, and may be one.
    Bars {
        /// The bars.
        bars: &'a [f32],
        /// The radius of the dots: half the width of a bar.
        radius: f32,
        /// The colour.
        ink: Ink,
    },
    /// A line of text.
    Text {
        /// The characters.
        text: &'a str,
        /// Where its baseline is anchored.
        at: Point,
        /// Which part of it is there.
        anchor: Anchor,
        /// The size of the font in CSS pixels.
        size: f32,
        /// Whether it is set in semibold.
        strong: bool,
        /// The colour.
        ink: Ink,
    },
}

/// An item as it is stored: with ranges into the figure's buffers in place of slices.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Entry {
    Fill(Rect, Ink),
    Line(Point, Point, Stroke),
    Polyline(Range<usize>, Stroke),
    Area(Range<usize>, Ink),
    Dots { centres: Range<usize>, radius: f32, ink: Ink, ringed: bool },
    Bars { bars: Range<usize>, radius: f32, ink: Ink },
    Text { text: Range<usize>, at: Point, anchor: Anchor, size: f32, strong: bool, ink: Ink },
}

/// The linear map between the values of an axis and pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// The values at the two ends.
    pub values: Interval,
    /// The pixel of the lower value.
    pub low: f64,
    /// The pixel of the upper value.
    pub high: f64,
}

impl Scale {
    /// The pixel of a value.
    pub fn pixel(&self, value: f64) -> f64 {
        self.low + (value - self.values.low) * self.factor()
    }

    /// The value at a pixel.
    pub fn value(&self, pixel: f64) -> f64 {
        let fraction = (pixel - self.low) / (self.high - self.low);
        self.values.low * (1.0 - fraction) + self.values.high * fraction
    }

    /// Pixels per unit of value, negative when the pixels run the other way.
    pub(crate) fn factor(&self) -> f64 {
        (self.high - self.low) / self.values.length()
    }

    /// A tenth of what one pixel is worth: finer than that nothing is written.
    pub(crate) fn resolution(&self) -> f64 {
        (0.1 / self.factor()).abs()
    }
}

/// The middle of the pixel, where a line one pixel wide is sharp.
pub(crate) fn crisp(pixel: f64) -> f32 {
    (libm::floor(pixel) + 0.5) as f32
}

//! Elements of a figure: points, strokes and items in pixels, and the scales from values to pixels.

use std::ops::Range;

use crate::plot::Interval;

/// Radius of the dots of measured data, pixels.
pub(crate) const DATA_RADIUS: f32 = 2.5;
/// Maximum number of computed points whose dots are as large as those of measured data.
const FULL_SIZE: f32 = 300.0;
/// Minimum radius of a dot, pixels.
const LEAST_RADIUS: f32 = 0.7;

/// Radius of the dots of `count` computed points, pixels. Above [`FULL_SIZE`] points the total area of the dots is
/// constant, down to the minimum radius: overlapping dots would hide the structure of a Poincaré section or a bifurcation
/// diagram.
pub(crate) fn radius_of(count: usize) -> f32 {
    (DATA_RADIUS * libm::sqrtf(FULL_SIZE / (count as f32).max(FULL_SIZE))).max(LEAST_RADIUS)
}

/// A point of the figure, in CSS pixels from its upper left corner.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// Distance to the right.
    pub x: f32,
    /// Distance downwards.
    pub y: f32,
}

/// A rectangle with horizontal and vertical edges, in CSS pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rect {
    /// Left edge.
    pub x: f32,
    /// Upper edge.
    pub y: f32,
    /// Width.
    pub width: f32,
    /// Height.
    pub height: f32,
}

impl Rect {
    /// True if the rectangle contains the point; edges are included.
    pub fn contains(self, point: Point) -> bool {
        (self.x..=self.x + self.width).contains(&point.x) && (self.y..=self.y + self.height).contains(&point.y)
    }
}

/// Role of a line, text or area, which determines its colour in a palette.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ink {
    /// Background of the figure.
    Ground,
    /// Titles, labels of ticks, names.
    Text,
    /// Grid lines.
    Grid,
    /// Line at the value zero.
    Zero,
    /// Axes and their ticks.
    Axis,
    /// Line at the present moment.
    Marker,
    /// A series in its own colour, given by index.
    Series(u8),
    /// A kept run in its own colour, given by index.
    Run(u8),
    /// Kept runs, by the index of their series: its hue, paler.
    Faded(u8),
    /// A series of an earlier run: the colour of the series, faint.
    Ghost(u8),
    /// Uncertainty of a series: the colour of the series, very faint.
    Band(u8),
}

/// Dash pattern of a line; distinguishes lines without colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dash {
    /// No gaps.
    #[default]
    Solid,
    /// One of the patterns, by index modulo their number.
    Pattern(u8),
}

impl Dash {
    /// Lengths of dash and gap in turn, CSS pixels; empty for a solid line.
    pub fn lengths(self) -> &'static [f32] {
        const PATTERNS: [&[f32]; 5] =
            [&[7.0, 4.0], &[2.0, 3.0], &[10.0, 3.0, 2.0, 3.0], &[14.0, 5.0], &[6.0, 3.0, 2.0, 3.0, 2.0, 3.0]];
        match self {
            Dash::Solid => &[],
            Dash::Pattern(number) => PATTERNS[usize::from(number) % PATTERNS.len()],
        }
    }
}

/// Style of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Colour.
    pub ink: Ink,
    /// Width, CSS pixels.
    pub width: f32,
    /// Dash pattern.
    pub dash: Dash,
}

/// Part of a text that is placed at its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// Start of the text.
    Start,
    /// Centre of the text.
    Middle,
    /// End of the text.
    End,
}

/// An item to paint; items are painted in the order of the list.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Item<'a> {
    /// A filled rectangle.
    Fill(Rect, Ink),
    /// A straight horizontal or vertical line.
    Line(Point, Point, Stroke),
    /// A polyline through points (x and y alternating): at least two, all inside the panel or on its edge.
    Polyline(&'a [f32], Stroke),
    /// A filled polygon with these corners (x and y alternating), at least three.
    Area(&'a [f32], Ink),
    /// Filled circles with these centres (x and y alternating).
    Dots {
        /// Centres, x and y alternating, CSS pixels.
        centres: &'a [f32],
        /// Radius of the circles, CSS pixels.
        radius: f32,
        /// Colour.
        ink: Ink,
        /// True if a ring in the background colour separates the circles from what is below.
        ringed: bool,
    },
    /// Vertical bars with round ends, which stand for overlapping dots. Three numbers each: x, upper end, lower end. The
    /// ends are centres of dots and may coincide.
    Bars {
        /// The bars: x, upper end and lower end in turn, CSS pixels.
        bars: &'a [f32],
        /// Radius of the dots, half the width of a bar; CSS pixels.
        radius: f32,
        /// Colour.
        ink: Ink,
    },
    /// A line of text.
    Text {
        /// The characters.
        text: &'a str,
        /// Anchor point on the baseline.
        at: Point,
        /// Part of the text at the anchor point.
        anchor: Anchor,
        /// Font size, CSS pixels.
        size: f32,
        /// True for semibold type.
        strong: bool,
        /// Colour.
        ink: Ink,
    },
}

/// Stored form of an [`Item`], with ranges in the buffers of the figure instead of slices.
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

/// Linear map between values of an axis and pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// Values at both ends.
    pub values: Interval,
    /// Pixel of the lower value.
    pub low: f64,
    /// Pixel of the upper value.
    pub high: f64,
}

impl Scale {
    /// Pixel of a value.
    pub fn pixel(&self, value: f64) -> f64 {
        self.low + (value - self.values.low) * self.factor()
    }

    /// Value at a pixel.
    pub fn value(&self, pixel: f64) -> f64 {
        let fraction = (pixel - self.low) / (self.high - self.low);
        self.values.low * (1.0 - fraction) + self.values.high * fraction
    }

    /// True if a value is between both ends, or beyond one of them by less than half a pixel: a value at an end may be rounded.
    pub(crate) fn shows(&self, value: f64) -> bool {
        let pixel = self.pixel(value);
        pixel >= self.low.min(self.high) - 0.5 && pixel <= self.low.max(self.high) + 0.5
    }

    /// Pixels per unit of value; negative if pixels decrease with the value.
    pub(crate) fn factor(&self) -> f64 {
        (self.high - self.low) / self.values.length()
    }

    /// Resolution of displayed numbers: a tenth of the value of one pixel.
    pub(crate) fn resolution(&self) -> f64 {
        (0.1 / self.factor()).abs()
    }
}

/// Centre of the pixel, where a line of one pixel width is sharp.
pub(crate) fn crisp(pixel: f64) -> f32 {
    (libm::floor(pixel) + 0.5) as f32
}

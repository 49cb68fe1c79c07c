//! Input of a figure: a plot with its axes and series, borrowed from the owner of the data.

/// A plot. Columns and texts are borrowed; axes and series are listed again for each layout.
#[derive(Clone, Debug, Default)]
pub struct Plot<'a> {
    /// Title above the plot; none if empty.
    pub title: &'a str,
    /// Description in one sentence for readers who cannot see the figure; the `desc` of the SVG.
    pub description: &'a str,
    /// The horizontal axis.
    pub x: Axis<'a>,
    /// The vertical axes, one per dimension: the first at the left, the others at the right.
    pub y: Vec<Axis<'a>>,
    /// The series in drawing order, the last one on top.
    pub series: Vec<Series<'a>>,
    /// True if the horizontal values of every series ascend, such as time. The horizontal axis then grows in steps, and the
    /// read-out finds samples by their horizontal value. False for curves that may turn back, such as a phase portrait.
    pub ordered: bool,
    /// True if the limits of the horizontal axis are chosen as those of the vertical axes although the values ascend,
    /// because they do not grow during the run.
    pub steady: bool,
    /// Present moment: a vertical line at this horizontal value.
    pub marker: Option<f64>,
    /// Visible part of the plane.
    pub view: View,
    /// True if both axes have the same scale, so that a path keeps its shape. Ignored with several vertical axes.
    pub equal: bool,
}

/// An axis: quantity and unit.
#[derive(Clone, Copy, Debug, Default)]
pub struct Axis<'a> {
    /// Name of the quantity, `y` or `E, T, V`.
    pub label: &'a str,
    /// Words that stand before the label in the title of the axis, such as `Displacement`, if there is room; empty for none.
    pub name: &'a str,
    /// Unit as text, empty for a pure number.
    pub unit: &'a str,
    /// Range that automatic limits must contain as well, in the unit of the axis; keeps an axis from starting empty.
    pub include: Option<Interval>,
    /// Range of the automatic limits instead of that of the series, in the unit of the axis.
    pub only: Option<Interval>,
}

/// A series of points.
#[derive(Clone, Copy, Debug, Default)]
pub struct Series<'a> {
    /// Name in the legend; a series without name is not listed.
    pub label: &'a str,
    /// Name at its last visible point; empty for none.
    pub end: &'a str,
    /// Name of the horizontal quantity in read-outs; empty if it is the label of the horizontal axis.
    pub across: &'a str,
    /// Index of its vertical axis.
    pub axis: usize,
    /// Index of its colour in the palette, modulo the number of series colours.
    pub colour: u8,
    /// Style of drawing.
    pub style: Style,
    /// Horizontal values, in the unit of the horizontal axis.
    pub x: &'a [f64],
    /// Vertical values, in the unit of the vertical axis. If the columns differ in length, the shorter one counts.
    pub y: &'a [f64],
    /// Width of each of [`Style::Bars`], in the unit of the horizontal axis.
    pub width: f64,
    /// Uncertainty of each vertical value, in its unit, or empty: error bars of points, or a band around a line.
    pub spread: &'a [f64],
    /// Rows before which the line is interrupted (the first row after each jump), ascending.
    pub breaks: &'a [usize],
    /// Identifies the columns of a series with very many points between layouts, to avoid a new pass over them: as long as
    /// it is the same, rows are only added. 0: all rows are examined in each layout.
    pub version: u64,
    /// Values at the present moment, marked by a dot.
    pub present: Option<(f64, f64)>,
}

/// Style in which a series is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Style {
    /// A solid line.
    #[default]
    Line,
    /// A thin, faint line: a curve of an earlier run.
    Ghost,
    /// A line with a dash pattern, by index modulo their number.
    Kept(u8),
    /// A kept run: paler than the series of its colour, with a dash pattern, by index modulo their number. Curves after the first
    /// are thinner.
    Faded(u8),
    /// One of several runs, with its own colour and dash pattern, by index modulo their numbers. Curves after the first are thinner.
    Run(u8),
    /// Separate points: measured data.
    Points,
    /// Separate faint points: measured data that are left out of fits.
    Unused,
    /// Separate computed points, such as those of a Poincaré section: the more points, the smaller.
    Dots,
    /// Vertical bars from zero, centred on the horizontal values: a histogram.
    Bars,
}

impl Style {
    /// True if it consists of separate points.
    pub fn is_of_points(self) -> bool {
        matches!(self, Style::Points | Style::Unused | Style::Dots)
    }
}

/// A closed interval of values, with `low` not above `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The lower end.
    pub low: f64,
    /// The upper end.
    pub high: f64,
}

impl Interval {
    /// Interval between two values, in any order.
    pub fn new(one: f64, other: f64) -> Interval {
        if other < one { Interval { low: other, high: one } } else { Interval { low: one, high: other } }
    }

    /// Interval around the finite ones of these values; `None` if there are none.
    pub fn around(values: impl IntoIterator<Item = f64>) -> Option<Interval> {
        values.into_iter().filter(|value| value.is_finite()).fold(None, |around: Option<Interval>, value| {
            let Interval { low, high } = around.unwrap_or(Interval { low: value, high: value });
            Some(Interval { low: low.min(value), high: high.max(value) })
        })
    }

    /// Smallest interval that contains both.
    pub fn joined(self, other: Interval) -> Interval {
        Interval { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Length of the interval.
    pub fn length(self) -> f64 {
        self.high - self.low
    }

    /// True if the interval contains the value; ends are included.
    pub fn contains(self, value: f64) -> bool {
        self.low <= value && value <= self.high
    }
}

/// Visible part of the plane; by default automatic, which shows all data and grows with them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct View {
    /// Limits of the horizontal axis, `None` for automatic.
    pub x: Option<Interval>,
    /// Limits of each vertical axis, empty for automatic.
    pub y: Vec<Interval>,
}

impl View {
    /// True if all limits are automatic.
    pub fn is_automatic(&self) -> bool {
        self.x.is_none() && self.y.is_empty()
    }
}

/// Vertical scale of a drawing beside the figure, for the same quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level {
    /// Height of the value 0, in CSS pixels from the top of the figure.
    pub zero: f64,
    /// CSS pixels upwards per unit of the axis.
    pub unit: f64,
}

impl Level {
    /// Values at both ends of a panel between two heights; `None` for a scale that does not grow upwards.
    pub(crate) fn limits(self, top: f64, bottom: f64) -> Option<Interval> {
        let value = |pixel: f64| (self.zero - pixel) / self.unit;
        let limits = Interval { low: value(bottom), high: value(top) };
        (limits.low < limits.high && limits.low.is_finite() && limits.high.is_finite()).then_some(limits)
    }
}

/// Size of the figure and style of its texts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Width of the figure, CSS pixels.
    pub width: f64,
    /// Height of the figure, CSS pixels.
    pub height: f64,
    /// Font size, CSS pixels.
    pub font_size: f64,
    /// True for numbers with a decimal comma.
    pub decimal_comma: bool,
    /// Scale of a drawing beside the figure. An only vertical axis has it unless it is zoomed or does not contain its automatic range.
    pub level: Option<Level>,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings { width: 640.0, height: 360.0, font_size: 13.0, decimal_comma: false, level: None }
    }
}

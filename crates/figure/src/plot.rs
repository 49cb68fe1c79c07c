//! What is to be drawn: a plot with its axes and series, borrowed from whoever has the data.

/// A plot. Columns and texts are borrowed; the few axes and series are listed again for each layout.
#[derive(Clone, Debug, Default)]
pub struct Plot<'a> {
    /// The title above the plot; nothing is drawn when it is empty.
    pub title: &'a str,
    /// One sentence for those who do not see the figure; becomes the `desc` of the SVG.
    pub description: &'a str,
    /// The horizontal axis.
    pub x: Axis<'a>,
    /// The vertical axes, one for each dimension: the first at the left, the others at the right.
    pub y: Vec<Axis<'a>>,
    /// The series in the order in which they are drawn, the last on top.
    pub series: Vec<Series<'a>>,
    /// Whether the abscissas of every series ascend, as time does. The horizontal axis then grows in steps from where the
    /// data begin, and the read-out finds values by abscissa; else the curve may turn back, as a phase portrait does.
    pub ordered: bool,
    /// Whether the horizontal axis is limited as the vertical ones are, although the abscissas ascend: they do not go forward
    /// with the run.
    pub steady: bool,
    /// The present: a vertical line at this abscissa.
    pub marker: Option<f64>,
    /// What part of the plane is shown.
    pub view: View,
    /// Whether a unit is as long on the vertical axis as on the horizontal one, so that a path keeps its shape. Plots with
    /// several vertical axes take no notice.
    pub equal: bool,
}

/// One axis: the quantity drawn along it and the unit of its numbers.
#[derive(Clone, Copy, Debug, Default)]
pub struct Axis<'a> {
    /// The quantity, `y` or `E, T, V`.
    pub label: &'a str,
    /// The unit as text, empty for a pure number.
    pub unit: &'a str,
    /// Automatic limits contain these values too, so that an axis does not begin with nothing.
    pub include: Option<Interval>,
}

/// One series of points.
#[derive(Clone, Copy, Debug, Default)]
pub struct Series<'a> {
    /// The name in the legend; a series without a name is not listed there.
    pub label: &'a str,
    /// What its abscissas are in a read-out, where it is not the label of the horizontal axis; else empty.
    pub across: &'a str,
    /// Which of the plot's vertical axes it belongs to.
    pub axis: usize,
    /// Which of the palette's series colours it is drawn in (counted modulo their number).
    pub colour: u8,
    /// How it is drawn.
    pub style: Style,
    /// The abscissas, in the unit of the horizontal axis.
    pub x: &'a [f64],
    /// The ordinates, in the unit of the vertical axis. The shorter of the two columns counts.
    pub y: &'a [f64],
    /// How wide each of [`Style::Bars`] is, in the unit of the horizontal axis.
    pub width: f64,
    /// The uncertainty of each ordinate, if there is one: an error bar on a point, a band about a line.
    pub spread: &'a [f64],
    /// Rows before which the line is interrupted (the first row after a jump), ascending.
    pub breaks: &'a [usize],
    /// Names the columns of a series with very many points from layout to layout, so that they are not gone through again
    /// each time: while it is the same, rows are only added. 0 for columns that are looked at each time.
    pub version: u64,
    /// Where the series is at the present: a dot there.
    pub present: Option<(f64, f64)>,
}

/// How a series is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Style {
    /// A solid line.
    #[default]
    Line,
    /// A thin, faint line: what an earlier run left behind.
    Ghost,
    /// A line in a dash pattern of its own (counted modulo their number).
    Kept(u8),
    /// A run that was kept, in a colour and a dash pattern of its own (both counted modulo their number). The curves after
    /// the first are thinner.
    Run(u8),
    /// Separate points: measured data.
    Points,
    /// Separate points that are computed, such as those of a section: the more there are, the smaller they are.
    Dots,
    /// Upright bars from zero, about their abscissas: how often values occur.
    Bars,
}

impl Style {
    /// Whether it consists of separate points.
    pub fn is_of_points(self) -> bool {
        matches!(self, Style::Points | Style::Dots)
    }
}

/// A closed interval of values, `low` below `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The lower end.
    pub low: f64,
    /// The upper end.
    pub high: f64,
}

impl Interval {
    /// The interval between two values, in whichever order they come.
    pub fn new(one: f64, other: f64) -> Interval {
        if other < one { Interval { low: other, high: one } } else { Interval { low: one, high: other } }
    }

    /// The distance between the ends.
    pub fn length(self) -> f64 {
        self.high - self.low
    }

    /// Whether the value lies in it, ends included.
    pub fn contains(self, value: f64) -> bool {
        self.low <= value && value <= self.high
    }
}

/// What part of the plane is shown; the default is all of it, and growing with the data.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct View {
    /// The limits of the horizontal axis, automatic when absent.
    pub x: Option<Interval>,
    /// The limits of each vertical axis, automatic when empty.
    pub y: Vec<Interval>,
}

impl View {
    /// Whether all limits are automatic.
    pub fn is_automatic(&self) -> bool {
        self.x.is_none() && self.y.is_empty()
    }
}

/// The size of the figure and how its texts are written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Width of the whole figure in CSS pixels.
    pub width: f64,
    /// Height of the whole figure in CSS pixels.
    pub height: f64,
    /// Size of the text in CSS pixels.
    pub font_size: f64,
    /// Whether numbers have a decimal comma.
    pub decimal_comma: bool,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings { width: 640.0, height: 360.0, font_size: 13.0, decimal_comma: false }
    }
}

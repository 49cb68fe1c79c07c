//! Plots: curves, axes and kinds of figures.

use crate::{Compiled, NodeId};
use serde::{Deserialize, Serialize};

/// A figure: `"Phase portrait": y' against y`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plot {
    /// Title, to be translated with [`crate::Program::text`].
    pub title: String,
    /// Quantity on the horizontal axis.
    pub x: Curve,
    /// Curves; those of equal dimension share a vertical axis.
    pub curves: Vec<Curve>,
    /// Curves with their own horizontal quantity, of the same dimension as `x`: index of the curve and that quantity.
    pub others: Vec<(usize, Curve)>,
    /// True if the document asks for equal scales on both axes.
    pub equal: bool,
    /// Kind of figure.
    pub drawing: Drawing,
}

/// Kind of figure.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub enum Drawing {
    /// Lines along the run.
    #[default]
    Run,
    /// A point of the run at each multiple of a period (stroboscopic section).
    Every(Every),
    /// Lines or points over the values of a parameter.
    Sweep(Sweep),
    /// A point of the run before each firing of an event; the node counts the firings.
    At(NodeId),
    /// Lines or points over the members of families at the moment shown.
    Profile(Profile),
    /// Histogram of the values of these members of a family at the moment shown; if there are none, of the curve over the
    /// run so far.
    Histogram(Vec<NodeId>),
}

/// Curves over the members of families.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Profile {
    /// Members of each curve, in the order of the curves.
    pub members: Vec<Members>,
    /// True if the members are single points, not joined by a line.
    pub points: bool,
}

/// Members of one curve, in the order in which a line joins them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Members {
    /// Horizontal values, one per member.
    pub x: Vec<NodeId>,
    /// Vertical values, one per member.
    pub y: Vec<NodeId>,
}

impl Members {
    /// Maximum number of members of a curve or a histogram.
    pub const MOST: usize = 2_000;
}

impl Drawing {
    /// True if it shows a single moment of the run, not its past.
    pub fn is_of_a_moment(&self) -> bool {
        match self {
            Self::Profile(_) => true,
            Self::Histogram(members) => !members.is_empty(),
            _ => false,
        }
    }
}

/// Moments of a stroboscopic section.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Every {
    /// Period in the independent variable, SI units; depends on parameters only.
    pub period: NodeId,
    /// First moment, SI units; `None`: one period after the start.
    pub from: Option<f64>,
}

/// Values of a parameter over which curves are drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sweep {
    /// Index in [`crate::Model::parameters`].
    pub parameter: usize,
    /// Minimum value, SI units.
    pub low: f64,
    /// Maximum value, SI units.
    pub high: f64,
    /// Distance of the values, SI units.
    pub step: f64,
    /// Drawn value of each curve, in the order of the curves.
    pub taken: Vec<Taken>,
    /// Aggregates that [`Taken::Run`] reads: each is the value of a further parameter after those of the model.
    pub aggregates: Vec<Aggregate>,
    /// End of the runs, SI units; 0 if no runs are needed.
    pub until: f64,
    /// Node that counts the firings of the event at which [`Taken::Points`] are taken; `None`: at every row.
    pub at: Option<NodeId>,
}

/// Drawn value for each value of the parameter. Times are in SI units.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Taken {
    /// The value of the curve itself, which depends on parameters only.
    Value,
    /// This expression of [`Sweep::aggregates`], parameters, initial values, and of states and the independent variable at
    /// the end of the run. The value of the curve itself is not defined.
    Run(NodeId),
    /// Points of a run from this time on. Either all curves of a plot have points, or none.
    Points(f64),
}

/// A number computed from a whole run: `maximum(x) from 60 [s]`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Aggregate {
    /// Kind of number.
    pub kind: AggregateKind,
    /// Quantity along the run.
    pub of: NodeId,
    /// Start of the evaluation, SI units.
    pub from: f64,
}

/// Numbers that are taken of each of many runs.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outcomes {
    /// Name, label and unit of each number.
    pub curves: Vec<Curve>,
    /// Expression of each number, in the order of the curves. It reads aggregates, parameters, initial values, and states and the
    /// independent variable at the end of the run.
    pub nodes: Vec<NodeId>,
    /// Aggregates that the expressions read: each is the value of a further parameter after those of the model.
    pub aggregates: Vec<Aggregate>,
}

/// Kind of number computed from a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum AggregateKind {
    /// Maximum, over rows and events.
    Maximum,
    /// Minimum, over rows and events.
    Minimum,
    /// Mean over the independent variable.
    Mean,
    /// Integral over the independent variable.
    Integral,
}

impl AggregateKind {
    /// The kind computed by the function of this name.
    pub fn named(name: &str) -> Option<Self> {
        match name {
            "maximum" => Some(Self::Maximum),
            "minimum" => Some(Self::Minimum),
            "mean" => Some(Self::Mean),
            "integral" => Some(Self::Integral),
            _ => None,
        }
    }
}

impl Aggregate {
    /// Maximum number of aggregates of a plot.
    pub const MOST: usize = 1_000;
}

impl Sweep {
    /// Maximum number of values of a curve.
    pub const MOST: usize = 2_000;

    /// Maximum number of points of a plot; each run has an equal share.
    pub const MOST_POINTS: usize = 100_000;

    /// True if points are drawn instead of lines.
    pub fn is_of_points(&self) -> bool {
        self.taken.iter().any(|taken| matches!(taken, Taken::Points(_)))
    }

    /// True if a run can be evaluated from this time on (SI units).
    pub fn counts_from(&self, from: f64) -> bool {
        (0.0..self.until).contains(&from)
    }

    /// Number of values, at most one more than [`Self::MOST`].
    pub fn count(&self) -> usize {
        // The maximum value is included in spite of rounding.
        let steps = ((self.high - self.low) / self.step + 1e-9).floor();
        if steps >= 0.0 { (steps.min(Self::MOST as f64) as usize) + 1 } else { 0 }
    }

    /// The values in ascending order, SI units.
    pub fn values(&self) -> impl Iterator<Item = f64> + use<> {
        let (low, step) = (self.low, self.step);
        (0..self.count()).map(move |number| low + number as f64 * step)
    }
}

impl Plot {
    /// Horizontal quantity of a curve.
    pub fn x_of(&self, curve: usize) -> &Curve {
        self.others.iter().find(|(place, _)| *place == curve).map_or(&self.x, |(_, x)| x)
    }

    /// All horizontal quantities.
    pub fn abscissas(&self) -> impl Iterator<Item = &Curve> {
        std::iter::once(&self.x).chain(self.others.iter().map(|(_, x)| x))
    }

    /// All expressions to be evaluated.
    pub fn expressions(&self) -> impl Iterator<Item = &Curve> {
        self.curves.iter().chain(self.abscissas())
    }
}

/// An expression of a plot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Curve {
    /// Source text, such as `y'`.
    pub expression: String,
    /// Label given by the plot; otherwise, if the expression is a name, the label of that name.
    pub label: Option<String>,
    /// True if the plot gives the label, which is then shown in the legend.
    pub named: bool,
    /// The compiled value, always a number.
    pub value: Compiled,
}

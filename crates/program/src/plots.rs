//! Plots: what is drawn against what.

use crate::{Compiled, NodeId};
use serde::{Deserialize, Serialize};

/// A figure: `"Phase portrait": y' against y`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plot {
    /// The title, to be passed through [`crate::Program::text`].
    pub title: String,
    /// What is drawn along the horizontal axis.
    pub x: Curve,
    /// What is drawn; those of equal dimension share an axis.
    pub curves: Vec<Curve>,
    /// The curves that are drawn against something else than `x`, of the same dimension: their places and that.
    pub others: Vec<(usize, Curve)>,
    /// Whether the document asks for a unit of the same length on both axes.
    pub equal: bool,
    /// How it comes about.
    pub drawing: Drawing,
}

/// How a plot comes about.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub enum Drawing {
    /// Lines along the run.
    #[default]
    Run,
    /// A point of the run at each multiple of a period.
    Every(Every),
    /// Lines or points over the values of a parameter.
    Sweep(Sweep),
    /// A point of the run, as it was before, at each firing of the event that this counts.
    At(NodeId),
    /// Lines or points over the members of families at the moment shown.
    Profile(Profile),
    /// How many values lie where, of the members of a family at the moment shown; where there are none, of the curve over
    /// the run so far.
    Histogram(Vec<NodeId>),
}

/// What is drawn over the members of families.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Profile {
    /// For each curve, in their order.
    pub members: Vec<Members>,
    /// Whether the members are single points, not joined by a line.
    pub points: bool,
}

/// The members of one curve, in the order in which a line joins them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Members {
    /// What each is drawn against.
    pub x: Vec<NodeId>,
    /// What is drawn of each.
    pub y: Vec<NodeId>,
}

impl Members {
    /// No curve has more members, and no histogram.
    pub const MOST: usize = 2_000;
}

impl Drawing {
    /// Whether it shows one moment of a run and not what led to it.
    pub fn is_of_a_moment(&self) -> bool {
        match self {
            Self::Profile(_) => true,
            Self::Histogram(members) => !members.is_empty(),
            _ => false,
        }
    }
}

/// The moments of a section.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Every {
    /// The period, of the independent variable (SI); depends on parameters only.
    pub period: NodeId,
    /// The first moment (SI); one period after the start where the document does not say.
    pub from: Option<f64>,
}

/// The values of a parameter over which curves are drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sweep {
    /// By its place in [`crate::Model::parameters`].
    pub parameter: usize,
    /// The least value, SI.
    pub low: f64,
    /// The greatest value, SI.
    pub high: f64,
    /// The distance of the values, SI.
    pub step: f64,
    /// What is drawn of each curve, in their order.
    pub taken: Vec<Taken>,
    /// What [`Taken::Run`] reads: the value of each is a parameter behind those of the model.
    pub aggregates: Vec<Aggregate>,
    /// Where the runs end, SI; 0 where none are needed.
    pub until: f64,
    /// What counts the event at whose firings [`Taken::Points`] are taken; each row of a run has them where there is none.
    pub at: Option<NodeId>,
}

/// What is drawn for a value of the parameter. Times are SI.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Taken {
    /// The curve's own value, which parameters alone decide.
    Value,
    /// This expression of [`Sweep::aggregates`], parameters and initial values, and of states and the independent variable
    /// at the end of the run. The curve's own value is never a number.
    Run(NodeId),
    /// Points of a run from this time on. All curves of a plot are such, or none.
    Points(f64),
}

/// A number that is taken of a whole run: `maximum(x) from 60 [s]`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Aggregate {
    /// Which number.
    pub kind: AggregateKind,
    /// What it is taken of, along the run.
    pub of: NodeId,
    /// From when on a run counts (SI).
    pub from: f64,
}

/// Which number is taken of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum AggregateKind {
    /// The greatest value, at rows and events.
    Maximum,
    /// The least value likewise.
    Minimum,
    /// The mean over the independent variable.
    Mean,
    /// The integral over the independent variable.
    Integral,
}

impl AggregateKind {
    /// The kind that a function of this name takes.
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
    /// No plot takes more of a run.
    pub const MOST: usize = 1_000;
}

impl Sweep {
    /// No curve has more values.
    pub const MOST: usize = 2_000;

    /// No plot has more points, and each run the same part of them.
    pub const MOST_POINTS: usize = 100_000;

    /// Whether points are drawn, and no lines.
    pub fn is_of_points(&self) -> bool {
        self.taken.iter().any(|taken| matches!(taken, Taken::Points(_)))
    }

    /// Whether a run can count from a time on (SI).
    pub fn counts_from(&self, from: f64) -> bool {
        (0.0..self.until).contains(&from)
    }

    /// How many values there are; at most one more than [`Self::MOST`].
    pub fn count(&self) -> usize {
        // The greatest value is one of them although quotients are rounded.
        let steps = ((self.high - self.low) / self.step + 1e-9).floor();
        if steps >= 0.0 { (steps.min(Self::MOST as f64) as usize) + 1 } else { 0 }
    }

    /// The values, ascending, SI.
    pub fn values(&self) -> impl Iterator<Item = f64> + use<> {
        let (low, step) = (self.low, self.step);
        (0..self.count()).map(move |number| low + number as f64 * step)
    }
}

impl Plot {
    /// What a curve is drawn against.
    pub fn x_of(&self, curve: usize) -> &Curve {
        self.others.iter().find(|(place, _)| *place == curve).map_or(&self.x, |(_, x)| x)
    }

    /// All that is drawn along the horizontal axis.
    pub fn abscissas(&self) -> impl Iterator<Item = &Curve> {
        std::iter::once(&self.x).chain(self.others.iter().map(|(_, x)| x))
    }

    /// Everything that is evaluated.
    pub fn expressions(&self) -> impl Iterator<Item = &Curve> {
        self.curves.iter().chain(self.abscissas())
    }
}

/// One expression of a plot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Curve {
    /// As written: `y'`.
    pub expression: String,
    /// The label that the plot gives it; without one the author's label of the name, where the expression is one.
    pub label: Option<String>,
    /// Whether the plot gives the label: then it stands in the legend.
    pub named: bool,
    /// Its value; always a number.
    pub value: Compiled,
}

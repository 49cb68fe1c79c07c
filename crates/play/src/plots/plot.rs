//! A plot: its identifier, its settings, and the data kept from frame to frame.

use super::added::{AddedPlot, Points};
use super::histogram::Histogram;
use super::labels::Labels;
use super::members::Snapshot;
use super::section::{Moments, Section};
use super::sweep::Swept;
use super::traces::Columns;
use figure::{Figure, Style, View};
use program::{Drawing, Plot, Program};
use std::fmt;

/// Identifies a plot while the document is open. The document's plots come first, in the order of the text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PlotId(pub(crate) usize);

impl PlotId {
    /// Identifier of the plot at a position in the list.
    pub fn at(place: usize) -> Self {
        Self(place)
    }

    /// Position in the list.
    pub fn place(self) -> usize {
        self.0
    }
}

/// Writes the position, for ids of HTML elements.
impl fmt::Display for PlotId {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(formatter)
    }
}

/// A plot, for the list of plots.
#[derive(Clone, Debug, PartialEq)]
pub struct PlotView {
    /// Identifier.
    pub id: PlotId,
    /// Title in the chosen language.
    pub title: String,
    /// True if the user has not hidden it.
    pub shown: bool,
    /// True if it is not zoomed: all data are visible.
    pub automatic: bool,
    /// True if it has anything to show; residuals, for instance, only if there are measurements.
    pub offered: bool,
    /// True if it stands apart from the other plots.
    pub apart: bool,
    /// True if both axes have the same scale, so that its height limits its width.
    pub equal: bool,
}

/// Settings of a plot, and the data kept from frame to frame.
#[derive(Debug)]
pub struct PlotState {
    pub shown: bool,
    pub view: View,
    pub figure: Figure,
    /// Row at which the keyboard cursor reads.
    pub cursor: Option<usize>,
    pub labels: Labels,
    /// Measured points over the curves.
    pub points: Vec<Points>,
    /// Content of a plot that does not come from the document.
    pub added: Option<AddedPlot>,
    /// Computed content.
    pub content: Content,
}

/// Computed content of a plot of the document.
#[derive(Debug, Default)]
pub enum Content {
    /// Lines along the run: only the columns shared by all plots.
    #[default]
    Run,
    /// Isolated points of the run.
    Section(Section),
    /// Lines over the values of a parameter.
    Swept(Box<Swept>),
    /// Lines or points over family members at the moment shown.
    Profile(Snapshot, Style),
    /// Bars.
    Histogram(Histogram),
}

impl Default for PlotState {
    fn default() -> Self {
        Self {
            shown: true,
            view: View::default(),
            figure: Figure::default(),
            cursor: None,
            labels: Labels::default(),
            points: Vec::new(),
            added: None,
            content: Content::Run,
        }
    }
}

impl PlotState {
    /// Number of document plots shown initially. More would be too small to read.
    pub const AT_FIRST: usize = 3;

    /// States of the document's plots.
    pub fn of(program: &Program, columns: &Columns) -> Vec<Self> {
        let state = |(index, plot): (usize, &Plot)| {
            let model = &program.model;
            let content = columns.plot(index).map(|columns| match &plot.drawing {
                Drawing::Run => Content::Run,
                Drawing::Every(every) => {
                    Content::Section(Section::new(model, plot, Moments::Every(every.clone()), columns))
                }
                Drawing::At(count) => Content::Section(Section::new(model, plot, Moments::Firings(*count), columns)),
                Drawing::Sweep(sweep) => Content::Swept(Box::new(Swept::new(model, plot, sweep, columns.units()))),
                Drawing::Profile(profile) => {
                    let style = if profile.points { Style::Dots } else { Style::Line };
                    Content::Profile(Snapshot::of_curves(model, plot, &profile.members, columns), style)
                }
                Drawing::Histogram(members) => Content::Histogram(Histogram::new(model, plot, members)),
            });
            Self { content: content.unwrap_or_default(), shown: index < Self::AT_FIRST, ..Self::default() }
        };
        program.plots.iter().enumerate().map(state).collect()
    }

    /// Discards the rows processed, because another run replaces the present one.
    pub fn forget_rows(&mut self) {
        match &mut self.content {
            Content::Section(section) => section.truncate(0),
            Content::Profile(profile, _) => profile.forget(),
            Content::Histogram(histogram) => histogram.forget(),
            Content::Run | Content::Swept(_) => {}
        }
    }

    /// Curves over a parameter, if the plot has them.
    pub fn swept(&self) -> Option<&Swept> {
        match &self.content {
            Content::Swept(swept) => Some(swept),
            _ => None,
        }
    }

    /// Mutable access to the curves over a parameter, if the plot has them.
    pub fn swept_mut(&mut self) -> Option<&mut Swept> {
        match &mut self.content {
            Content::Swept(swept) => Some(swept),
            _ => None,
        }
    }

    /// An empty plot that does not come from the document.
    pub fn added() -> Self {
        Self { added: Some(AddedPlot::default()), ..Self::default() }
    }
}

//! A plot: its name, what is chosen for it, and what is kept of it from frame to frame.

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

/// Names a plot as long as the document is open. The document's plots come first, in the order of the text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PlotId(pub(crate) usize);

impl PlotId {
    /// The plot of this place in the list.
    pub fn at(place: usize) -> Self {
        Self(place)
    }

    /// Its place in the list.
    pub fn place(self) -> usize {
        self.0
    }
}

/// Its place, for names of elements.
impl fmt::Display for PlotId {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(formatter)
    }
}

/// A plot in the list.
#[derive(Clone, Debug, PartialEq)]
pub struct PlotView {
    /// Names it.
    pub id: PlotId,
    /// The title in the chosen language.
    pub title: String,
    /// Whether it is to be shown.
    pub shown: bool,
    /// Whether it shows all of the data.
    pub automatic: bool,
    /// Whether there is anything for it to show: residuals only where something is measured.
    pub offered: bool,
    /// Whether it stands apart from the other plots.
    pub apart: bool,
    /// Whether a unit has the same length on both axes, so that its height limits its width.
    pub equal: bool,
}

/// What is chosen for a plot, and what is kept of it from frame to frame.
#[derive(Debug)]
pub struct PlotState {
    pub shown: bool,
    pub view: View,
    pub figure: Figure,
    /// The row at which the keyboard reads.
    pub cursor: Option<usize>,
    pub labels: Labels,
    /// Points over the curves.
    pub points: Vec<Points>,
    /// What is drawn, where it is not a plot of the document.
    pub added: Option<AddedPlot>,
    /// What is computed for it.
    pub content: Content,
}

/// What is computed for a plot of the document.
#[derive(Debug, Default)]
pub enum Content {
    /// Lines along the run: nothing beyond the columns of all plots.
    #[default]
    Run,
    /// Single points of the run.
    Section(Section),
    /// Lines over the values of a parameter.
    Swept(Box<Swept>),
    /// Lines, or points, over members at the moment shown.
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
    /// So many plots of a document are shown at first, since each of more would be too small to be read.
    pub const AT_FIRST: usize = 3;

    /// Those of the document.
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

    /// Another run takes the place of the one that was followed.
    pub fn forget_rows(&mut self) {
        match &mut self.content {
            Content::Section(section) => section.truncate(0),
            Content::Profile(profile, _) => profile.forget(),
            Content::Histogram(histogram) => histogram.forget(),
            Content::Run | Content::Swept(_) => {}
        }
    }

    /// Its curves over a parameter.
    pub fn swept(&self) -> Option<&Swept> {
        match &self.content {
            Content::Swept(swept) => Some(swept),
            _ => None,
        }
    }

    /// The same to be changed.
    pub fn swept_mut(&mut self) -> Option<&mut Swept> {
        match &mut self.content {
            Content::Swept(swept) => Some(swept),
            _ => None,
        }
    }

    /// An empty plot that is not the document's.
    pub fn added() -> Self {
        Self { added: Some(AddedPlot::default()), ..Self::default() }
    }
}

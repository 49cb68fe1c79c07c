//! A plot: its name, what is chosen for it, and what is kept of it from frame to frame.

use super::added::{AddedPlot, Points};
use super::labels::Labels;
use super::section::Section;
use super::sweep::Swept;
use super::traces::Columns;
use figure::{Figure, View};
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
    /// What is drawn, where it is not a line along the run.
    pub section: Option<Section>,
    pub swept: Option<Swept>,
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
            section: None,
            swept: None,
        }
    }
}

impl PlotState {
    /// Those of the document.
    pub fn of(program: &Program, columns: &Columns) -> Vec<Self> {
        let state = |(index, plot): (usize, &Plot)| {
            let (mut state, model) = (Self::default(), &program.model);
            match (&plot.drawing, columns.plot(index)) {
                (Drawing::Every(every), Some(columns)) => {
                    state.section = Some(Section::new(model, plot, every, columns));
                }
                (Drawing::Sweep(sweep), Some(columns)) => {
                    state.swept = Some(Swept::new(model, plot, sweep, columns.units()));
                }
                _ => {}
            }
            state
        };
        program.plots.iter().enumerate().map(state).collect()
    }

    /// An empty plot that is not the document's.
    pub fn added() -> Self {
        Self { added: Some(AddedPlot::default()), ..Self::default() }
    }
}

//! What others add to the figures: points over the curves of a plot, and plots of their own.

use super::labels::Labels;
use super::plot::{PlotId, PlotState};
use crate::Play;
use figure::{Axis, Interval, Plot, Series, Style, View};

/// The colour of the points over the first curve: not that of a line, or the line could not be seen on its points.
pub const POINTS: u8 = 3;

/// Points over one curve of a plot of the document, in the units of its axes.
#[derive(Clone, Debug, Default)]
pub struct Points {
    /// Which curve.
    pub curve: usize,
    /// The entry in the legend.
    pub label: String,
    /// Where they come from; a reading begins with it.
    pub source: String,
    /// Along the horizontal axis.
    pub x: Vec<f64>,
    /// Along the vertical axis.
    pub y: Vec<f64>,
    /// See [`figure::Series::version`].
    pub version: u64,
}

/// A plot that is not the document's, such as residuals.
#[derive(Debug, Default)]
pub struct AddedPlot {
    /// Its texts.
    pub labels: Labels,
    /// What is drawn.
    pub series: Vec<AddedSeries>,
    /// What the horizontal axis shows at least.
    pub x_includes: Option<Interval>,
    /// What the vertical axes show at least.
    pub y_includes: Option<Interval>,
    /// What the vertical axis shows unless it is zoomed.
    pub y_limits: Option<Interval>,
    /// Whether the time shown is marked on the horizontal axis.
    pub marks_time: bool,
    /// Whether the abscissas ascend.
    pub ordered: bool,
    /// Whether there is anything to show.
    pub offered: bool,
    /// Whether it stands apart from the other plots, where its owner puts it.
    pub apart: bool,
    /// The series along which the keyboard's cursor goes.
    pub cursor: usize,
}

/// A series of an [`AddedPlot`], in the units of its axes.
#[derive(Debug, Default)]
pub struct AddedSeries {
    /// Which axis.
    pub axis: usize,
    /// Which colour of the palette.
    pub colour: u8,
    /// How it is drawn.
    pub style: Style,
    /// Whether it stands in the legend, with its name among [`Labels::curves`].
    pub in_legend: bool,
    /// Along the horizontal axis.
    pub x: Vec<f64>,
    /// Along the vertical axis.
    pub y: Vec<f64>,
    /// Standard errors; empty where there are none.
    pub errors: Vec<f64>,
    /// See [`figure::Series::version`].
    pub version: u64,
}

impl Play {
    /// Adds an empty plot after the others.
    pub fn add_plot(&mut self) -> PlotId {
        self.plots.push(PlotState::added());
        self.revision.plots += 1;
        PlotId(self.plots.len() - 1)
    }

    /// A plot that was added, to be read or changed; call [`Play::added_plot_changed`] afterwards.
    pub fn added_plot(&mut self, id: PlotId) -> Option<&mut AddedPlot> {
        self.plots.get_mut(id.0)?.added.as_mut()
    }

    /// The plots are to be drawn again. With another title, what a person has zoomed was something else: all is shown.
    pub fn added_plot_changed(&mut self, id: PlotId) {
        if let Some(state) = self.plots.get_mut(id.0)
            && let Some(added) = &state.added
            && added.labels.title != state.labels.title
        {
            state.view = View::default();
            state.labels.title.clone_from(&added.labels.title);
        }
        self.revision.plots += 1;
    }

    /// Puts points over the curves of a plot of the document, in the place of those that were there.
    pub fn set_points(&mut self, plot: usize, points: Vec<Points>) {
        if let Some(state) = self.plots.get_mut(plot) {
            state.points = points;
            self.revision.plots += 1;
        }
    }

    /// What is drawn in a plot that was added.
    pub(super) fn added_figure<'a>(&'a self, added: &'a AddedPlot, view: &View) -> Plot<'a> {
        let labels = &added.labels;
        let unit = &self.model().independent.unit;
        let series = added.series.iter().enumerate().map(|(number, series)| Series {
            label: labels.curves.get(number).filter(|_| series.in_legend).map_or("", String::as_str),
            axis: series.axis,
            colour: series.colour,
            style: series.style,
            x: &series.x,
            y: &series.y,
            spread: &series.errors,
            version: series.version,
            ..Series::default()
        });
        let limits = added.y_limits.filter(|_| view.y.is_empty());
        let axis = |(label, unit): &'a (String, String)| Axis { label, unit, include: added.y_includes };
        Plot {
            title: &labels.title,
            description: &labels.description,
            x: Axis { label: &labels.x.0, unit: &labels.x.1, include: added.x_includes },
            y: labels.axes.iter().map(axis).collect(),
            series: series.collect(),
            marker: added.marks_time.then(|| unit.from_si(self.course.time())),
            view: View { x: view.x, y: limits.map_or_else(|| view.y.clone(), |limits| vec![limits]) },
            ordered: added.ordered,
            equal: false,
        }
    }
}

//! Operations on plots: zoom, pan, and read-out by pointer or keyboard.

use super::added::{AddedPlot, Points};
use super::plot::{Content, PlotId, PlotState, PlotView};
use super::sweep::Swept;
use crate::values::symbol::symbol;
use crate::{Changes, Play, WORK_PER_TICK, words};
use figure::{Direction, Figure, Palette, Plot, Point, Readout, Settings, Style, View};

impl Play {
    /// All plots: those of the document in the order of the text, then added ones.
    pub fn plots(&self) -> Vec<PlotView> {
        let view = |(index, plot): (usize, &PlotState)| PlotView {
            id: PlotId(index),
            title: plot.labels.title.clone(),
            shown: plot.shown,
            automatic: plot.view.is_automatic(),
            offered: plot.added.as_ref().is_none_or(|added| added.offered),
            apart: plot.added.as_ref().is_some_and(|added| added.apart),
            equal: self.has_equal_axes(index),
        };
        self.plots.iter().enumerate().map(view).collect()
    }

    /// Continues the runs of sweep plots that are shown, limited to [`WORK_PER_TICK`] per call. Returns true if work
    /// remains.
    pub fn work_on_plots(&mut self) -> bool {
        let mut left = WORK_PER_TICK;
        let mut worked = false;
        for plot in self.plots.iter_mut().filter(|plot| plot.shown) {
            let Some(swept) = plot.swept_mut() else { continue };
            swept.follow(self.line.course());
            let before = swept.progress();
            swept.proceed(self.basis.model(), &mut left);
            worked |= swept.progress() != before;
        }
        if worked {
            self.note(Changes::FRAME);
        }
        self.plots.iter().any(|plot| plot.shown && plot.swept().is_some_and(Swept::is_unfinished))
    }

    /// Number of complete runs of a sweep plot and total number; `None` if it needs no runs or all are complete.
    pub fn plot_progress(&self, PlotId(index): PlotId) -> Option<(usize, usize)> {
        self.plots.get(index)?.swept()?.progress().filter(|(done, all)| done < all)
    }

    /// Shows or hides a plot.
    pub fn show_plot(&mut self, PlotId(index): PlotId, shown: bool) {
        if let Some(plot) = self.plots.get_mut(index) {
            plot.shown = shown;
            self.note(Changes::PLOTS);
        }
    }

    /// Adds an empty plot after the others.
    pub fn add_plot(&mut self) -> PlotId {
        self.plots.push(PlotState::added());
        self.note(Changes::PLOTS);
        PlotId(self.plots.len() - 1)
    }

    /// Access to an added plot. Call [`Play::added_plot_changed`] after changing it; `None` if the plot is not an added
    /// one.
    pub fn added_plot(&mut self, id: PlotId) -> Option<&mut AddedPlot> {
        self.plots.get_mut(id.0)?.added.as_mut()
    }

    /// Redraws an added plot after a change. If its title has changed, the zoom is reset because it referred to other
    /// content.
    pub fn added_plot_changed(&mut self, id: PlotId) {
        if let Some(state) = self.plots.get_mut(id.0)
            && let Some(added) = &state.added
            && added.labels.title != state.labels.title
        {
            state.view = View::default();
            state.labels.title.clone_from(&added.labels.title);
        }
        self.note(Changes::PLOTS);
    }

    /// Replaces the points over the curves of a plot of the document.
    pub fn set_points(&mut self, plot: usize, points: Vec<Points>) {
        if let Some(state) = self.plots.get_mut(plot) {
            state.points = points;
            self.note(Changes::PLOTS);
        }
    }

    /// Lays out a plot for the time shown, reusing the buffers of its figure. `None` if there is no such plot.
    pub fn layout_plot(&mut self, PlotId(index): PlotId, settings: &Settings) -> Option<&Figure> {
        self.follow();
        let mut figure = std::mem::take(&mut self.plots.get_mut(index)?.figure);
        if let Some(mut plot) = self.figure_of(index) {
            // The page shows title and legend above the figure.
            plot.title = "";
            plot.series.iter_mut().for_each(|series| series.label = "");
            figure::layout_into(&mut figure, &plot, settings);
        }
        let state = self.plots.get_mut(index)?;
        state.figure = figure;
        Some(&state.figure)
    }

    /// Figure of the last [`Play::layout_plot`].
    pub fn plot_figure(&self, PlotId(index): PlotId) -> Option<&Figure> {
        self.plots.get(index).map(|plot| &plot.figure)
    }

    /// The plot as a standalone figure with title and legend, for export.
    pub fn titled_figure(&mut self, PlotId(index): PlotId, settings: &Settings) -> Option<Figure> {
        self.follow();
        let names = self.series_names(index);
        let titled = self.moment_of(index).map(|moment| format!("{} ({moment})", self.title_of(index)));
        let mut plot = self.figure_of(index)?;
        if let Some(title) = &titled {
            plot.title = title;
        }
        // One legend entry stands for all curves of a kept run.
        for (series, name) in plot.series.iter_mut().zip(&names) {
            if let (Style::Run(_), 0, Some(run)) = (series.style, series.colour, &name.run) {
                series.label = run;
            } else {
                series.label = self.legend_name(index, series);
            }
        }
        Some(figure::layout(&plot, settings))
    }

    /// The plot as a standalone SVG file; empty if there is no such plot.
    pub fn plot_svg(&mut self, PlotId(index): PlotId, settings: &Settings, palette: &Palette) -> String {
        self.titled_figure(PlotId(index), settings).map_or_else(String::new, |figure| figure.svg(palette))
    }

    /// Read-out at a pixel of the last layout: values of the present and kept runs and the nearest measured points.
    /// Moves the keyboard cursor there.
    pub fn hover_plot(&mut self, PlotId(index): PlotId, at: Point) -> Option<Readout> {
        let readout = self.plot_figure(PlotId(index))?.hover(&self.readable_plot(index)?, at);
        let first = self.series_behind(index);
        let sample = readout.iter().flat_map(|readout| &readout.samples).find(|sample| sample.series >= first);
        let row = sample.map(|sample| sample.row);
        if let (Some(row), Some(state)) = (row, self.plots.get_mut(index)) {
            state.cursor = Some(row);
        }
        let readout = readout.map(|readout| self.named(index, readout));
        self.with_points(index, at, readout)
    }

    /// Moves the keyboard cursor by `rows` rows along the run, initially from the present row, and returns the read-out
    /// there.
    pub fn move_cursor(&mut self, PlotId(index): PlotId, rows: isize) -> Option<Readout> {
        let present = match &self.plots.get(index)?.content {
            Content::Swept(swept) => swept.present_row(self.course()),
            Content::Profile(..) | Content::Histogram(_) => 0,
            Content::Run | Content::Section(_) => self.course().rows_until_shown().saturating_sub(1),
        };
        let row = self.plots.get(index)?.cursor.unwrap_or(present);
        let (mut series, mut plot) = (self.series_behind(index), self.readable_plot(index)?);
        if let Some(added) = self.added(index) {
            series = added.cursor;
        } else if self.course().rows() < 2 && self.points_behind(index) > 0 {
            // Without a run, the cursor moves along the measured points.
            (series, plot) = (0, self.figure_of(index)?);
        }
        let figure = self.plot_figure(PlotId(index))?;
        let row = figure.step(&plot, series, row, rows)?;
        let readout = figure.readout(&plot, series, row)?;
        if let Some(state) = self.plots.get_mut(index) {
            state.cursor = Some(row);
        }
        let at = readout.samples.iter().find(|sample| sample.series == series).map(|sample| sample.at);
        let readout = self.named(index, readout);
        match at {
            Some(at) => self.with_points(index, at, Some(readout)),
            None => Some(readout),
        }
    }

    /// Zooms by `factor` (2 shows half as much) about a pixel, or about the centre if `at` is `None`.
    pub fn zoom_plot(&mut self, PlotId(index): PlotId, at: Option<Point>, factor: f64, direction: Direction) {
        if !(factor.is_finite() && factor > 0.0) {
            return;
        }
        self.set_view(index, |figure| match at {
            Some(at) => figure.zoom(at, factor, direction),
            None => figure.zoom_centre(factor, direction),
        });
    }

    /// Zooms to the rectangle between two pixels.
    pub fn zoom_plot_to(&mut self, PlotId(index): PlotId, one: Point, other: Point) {
        self.set_view(index, |figure| figure.zoom_to(one, other));
    }

    /// Pans by a number of pixels.
    pub fn pan_plot(&mut self, PlotId(index): PlotId, right: f64, down: f64) {
        self.set_view(index, |figure| figure.pan(right, down));
    }

    /// Resets the zoom: shows all data.
    pub fn reset_plot(&mut self, PlotId(index): PlotId) {
        self.set_view(index, |_| View::default());
    }

    fn set_view(&mut self, index: usize, change: impl FnOnce(&Figure) -> View) {
        if let Some(plot) = self.plots.get_mut(index) {
            plot.view = change(&plot.figure);
            self.note(Changes::PLOTS);
        }
    }

    /// The plot with only the series that can be read out, without ghost and points.
    fn readable_plot(&self, index: usize) -> Option<Plot<'_>> {
        let mut plot = self.figure_of(index)?;
        if self.added(index).is_some() {
            return Some(plot);
        }
        for series in &mut plot.series {
            if matches!(series.style, Style::Ghost | Style::Points) {
                (series.x, series.y) = (&[], &[]);
            }
        }
        Some(plot)
    }

    /// Completes the texts of a read-out: errors in added plots, counts in histograms, run names for kept runs.
    fn named(&self, index: usize, mut readout: Readout) -> Readout {
        if let Some(added) = self.added(index) {
            return self.with_errors(added, readout);
        }
        if self.plots.get(index).is_some_and(|plot| matches!(plot.content, Content::Histogram(_))) {
            for sample in &mut readout.samples {
                sample.text = format!("{} = {}", words::count(self.basis.language()), sample.y);
            }
            return readout;
        }
        let (points, first) = (self.points_behind(index), self.series_behind(index));
        let curves = self.plots.get(index).map_or(&[][..], |plot| &plot.labels.curves);
        let ghosts = if self.line.has_ghost() { curves.len() } else { 0 };
        let kept: Vec<String> =
            self.line.kept(&self.basis).into_iter().filter(|kept| kept.shown).map(|kept| kept.name).collect();
        for sample in readout.samples.iter_mut().filter(|sample| sample.series < first) {
            let Some(place) = sample.series.checked_sub(points + ghosts) else {
                continue;
            };
            let (Some(run), Some(curve)) = (kept.get(place / curves.len()), curves.get(place % curves.len())) else {
                continue;
            };
            let value = sample.text.rsplit(" = ").next().unwrap_or_default();
            sample.text = format!("{curve} ({run}) = {value}");
        }
        readout
    }

    fn title_of(&self, index: usize) -> &str {
        self.plots.get(index).map_or("", |plot| &plot.labels.title)
    }

    /// Text of the moment shown, `t = 1.25 s`, for a plot that shows a single moment; `None` for other plots.
    pub(super) fn moment_of(&self, index: usize) -> Option<String> {
        let of_a_moment = self.basis.program().plots.get(index).is_some_and(|plot| plot.drawing.is_of_a_moment());
        of_a_moment
            .then(|| format!("{} = {}", symbol(&self.model().independent.name), self.basis.time_text(self.course())))
    }

    fn added(&self, index: usize) -> Option<&AddedPlot> {
        self.plots.get(index)?.added.as_ref()
    }
}

//! Lists of the plots, figures for export, and read-outs by pointer or keyboard.

use super::added::AddedPlot;
use super::plot::{PlotId, PlotView};
use super::{Content, Figures, PlotState};
use crate::values::symbol::symbol;
use crate::words;
use figure::{Figure, Palette, Plot, Point, Readout, Settings, Style};
use units::Unit;

impl<'a> Figures<'a> {
    /// All plots: those of the document in the order of the text, then added ones.
    pub fn list(&self) -> Vec<PlotView> {
        let view = |(index, plot): (usize, &PlotState)| PlotView {
            id: PlotId(index),
            title: plot.labels.title.clone(),
            shown: plot.shown,
            automatic: plot.view.is_automatic(),
            offered: plot.added.as_ref().is_none_or(|added| added.offered),
            apart: plot.added.as_ref().is_some_and(|added| added.apart),
            follows_run: self.is_against_independent(index),
            quantity: self.quantity_of(index),
            symbols: self.symbols_of(index),
            equal: self.has_equal_axes(index),
        };
        self.plots.states.iter().enumerate().map(view).collect()
    }

    /// Expression of the only curve of a plot of the document against the independent variable; empty for other plots.
    fn quantity_of(&self, index: usize) -> String {
        let plot = self.basis.program().plots.get(index).filter(|_| self.is_against_independent(index));
        match plot.map(|plot| &plot.curves[..]) {
            Some([curve]) => curve.expression.clone(),
            _ => String::new(),
        }
    }

    /// Symbols of the curves of a plot of the document, with that of another abscissa than the independent variable.
    fn symbols_of(&self, index: usize) -> String {
        let Some(state) = self.plots.states.get(index).filter(|state| state.added.is_none()) else {
            return String::new();
        };
        let (curves, across) = (state.labels.curves.join(", "), &state.labels.x.0);
        if self.is_against_independent(index) || across.is_empty() { curves } else { format!("{curves}({across})") }
    }

    /// Number of complete runs of a sweep plot and total number; `None` if it needs no runs or all are complete.
    pub fn progress(&self, PlotId(index): PlotId) -> Option<(usize, usize)> {
        self.plots.states.get(index)?.swept()?.progress().filter(|(done, all)| done < all)
    }

    /// Figure of the last [`crate::Play::layout_plot`].
    pub fn figure(&self, PlotId(index): PlotId) -> Option<&'a Figure> {
        self.plots.states.get(index).map(|plot| &plot.figure)
    }

    /// The plot as a standalone figure with title and legend, for export.
    pub fn titled(&self, PlotId(index): PlotId, settings: &Settings) -> Option<Figure> {
        let names = self.series_names(index);
        let titled = self.moment_of(index).map(|moment| format!("{} ({moment})", self.title_of(index)));
        let mut plot = self.figure_of(index)?;
        if let Some(title) = &titled {
            plot.title = title;
        }
        // One legend entry stands for all curves of a kept run.
        for (series, name) in plot.series.iter_mut().zip(&names) {
            if let (Style::Faded(_), 0, Some(run)) = (series.style, series.colour, &name.run) {
                series.label = run;
            } else {
                series.label = self.legend_name(index, series);
            }
        }
        Some(figure::layout(&plot, settings))
    }

    /// The plot as a standalone SVG file; empty if there is no such plot.
    pub fn svg(&self, PlotId(index): PlotId, settings: &Settings, palette: &Palette) -> String {
        self.titled(PlotId(index), settings).map_or_else(String::new, |figure| figure.svg(palette))
    }

    /// The plot with only the series that can be read out, without ghost and points.
    fn readable_plot(&self, index: usize) -> Option<Plot<'_>> {
        let mut plot = self.figure_of(index)?;
        if self.added(index).is_some() {
            return Some(plot);
        }
        for series in &mut plot.series {
            if matches!(series.style, Style::Ghost | Style::Points | Style::Unused) {
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
        if self.plots.states.get(index).is_some_and(|plot| matches!(plot.content, Content::Histogram(_))) {
            for sample in &mut readout.samples {
                sample.text = format!("{} = {}", words::count(self.basis.language()), sample.y);
            }
            return readout;
        }
        let (points, first) = (self.points_behind(index), self.series_behind(index));
        let curves = self.plots.states.get(index).map_or(&[][..], |plot| &plot.labels.curves);
        let ghosts = if self.line.has_ghost() { curves.len() } else { 0 };
        let kept: Vec<String> =
            self.line.kept(self.basis).into_iter().filter(|kept| kept.shown).map(|kept| kept.name).collect();
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
        self.plots.states.get(index).map_or("", |plot| &plot.labels.title)
    }

    /// Text of the moment shown, `t = 1.25 s`, for a plot that shows a single moment; `None` for other plots.
    pub(super) fn moment_of(&self, index: usize) -> Option<String> {
        let of_a_moment = self.basis.program().plots.get(index).is_some_and(|plot| plot.drawing.is_of_a_moment());
        of_a_moment.then(|| {
            format!("{} = {}", symbol(&self.basis.model().independent.name), self.basis.time_text(self.line.course()))
        })
    }

    fn added(&self, index: usize) -> Option<&AddedPlot> {
        self.plots.states.get(index)?.added.as_ref()
    }

    /// Read-out at a pixel, and the row of the run to which it belongs.
    pub(super) fn hover(&self, id: PlotId, at: Point) -> Option<(Option<usize>, Option<Readout>)> {
        let PlotId(index) = id;
        let readout = self.figure(id)?.hover(&self.readable_plot(index)?, at);
        let first = self.series_behind(index);
        let sample = readout.iter().flat_map(|readout| &readout.samples).find(|sample| sample.series >= first);
        let row = sample.map(|sample| sample.row);
        let readout = readout.map(|readout| self.named(index, readout));
        Some((row, self.with_points(index, at, readout)))
    }

    /// Row at `rows` rows from the keyboard cursor, and the read-out there.
    pub(super) fn beside_cursor(&self, id: PlotId, rows: isize) -> Option<(usize, Option<Readout>)> {
        let PlotId(index) = id;
        let state = self.plots.states.get(index)?;
        let present = match &state.content {
            Content::Swept(swept) => swept.present_row(self.line.course()),
            Content::Profile(..) | Content::Histogram(_) => 0,
            Content::Run | Content::Section(_) => self.line.course().rows_until_shown().saturating_sub(1),
        };
        let row = state.cursor.unwrap_or(present);
        let (mut series, mut plot) = (self.series_behind(index), self.readable_plot(index)?);
        if let Some(added) = self.added(index) {
            series = added.cursor;
        } else if self.line.course().rows() < 2 && self.points_behind(index) > 0 {
            // Without a run, the cursor moves along the measured points.
            (series, plot) = (0, self.figure_of(index)?);
        }
        let row = state.figure.step(&plot, series, row, rows)?;
        let readout = state.figure.readout(&plot, series, row)?;
        let at = readout.samples.iter().find(|sample| sample.series == series).map(|sample| sample.at);
        let readout = self.named(index, readout);
        Some((
            row,
            match at {
                Some(at) => self.with_points(index, at, Some(readout)),
                None => Some(readout),
            },
        ))
    }

    /// Unit of the horizontal axis of a plot that shows points against the independent variable; `None` for other
    /// plots.
    pub fn unit_of_time_axis(&self, PlotId(index): PlotId) -> Option<&'a Unit> {
        let has_points = self.plots.states.get(index).is_some_and(|plot| !plot.points.is_empty());
        let plot = self.basis.program().plots.get(index).filter(|_| has_points && self.is_against_independent(index));
        plot.map(|plot| &plot.x.value.unit)
    }
}

//! Assembles the figure of a plot: series in drawing order, with their axes.

use super::added::AddedPlot;
use super::histogram::Histogram;
use super::members::Snapshot;
use super::section::Section;
use super::sweep::Swept;
use super::traces::CurveColumns;
use super::{Content, Figures};
use crate::words;
use figure::{Axis, Interval, Plot, Series, Style, View};
use program::{Curve, Drawing};

impl Figures<'_> {
    /// Figure of a plot; `None` for an unknown index.
    pub(crate) fn figure_of(&self, index: usize) -> Option<Plot<'_>> {
        let state = self.plots.states.get(index)?;
        if let Some(added) = &state.added {
            return Some(self.added_figure(added, &state.view));
        }
        match &state.content {
            Content::Run => self.figure_plot(index),
            Content::Section(section) => self.section_figure(index, section),
            Content::Swept(swept) => self.swept_figure(index, swept),
            Content::Profile(profile, style) => self.profile_figure(index, profile, *style),
            Content::Histogram(histogram) => self.histogram_figure(index, histogram),
        }
    }

    /// Series from back to front: points, the ghost, the kept runs, the present run; curves keep their colours in all
    /// runs.
    fn figure_plot(&self, index: usize) -> Option<Plot<'_>> {
        let state = self.plots.states.get(index)?;
        let columns = self.line.columns().plot(index)?;
        let labels = &state.labels;
        let ghosts = self.line.ghost_traces().map(|traces| (traces, Style::Ghost, "")).into_iter();
        let shown = || self.line.kept(self.basis).into_iter().filter(|kept| kept.shown);
        let names = self.runs.get_or_init(|| shown().map(|kept| kept.name).collect());
        let kept = self.line.kept_traces().zip(names);
        let kept = kept.map(|((traces, pattern), name)| (traces, Style::Faded(pattern), name.as_str()));
        let independent = self.is_against_independent(index);
        let unit = &self.basis.model().independent.unit;
        let until = self.plots.records_until.map(|time| unit.from_si(time));
        let points = state.points.iter().filter_map(|points| {
            let axis = columns.curves.get(points.curve)?.axis;
            let style = if points.unused { Style::Unused } else { Style::Points };
            let colour = points.colour;
            let (x, y, version) = (&points.x[..], &points.y[..], points.version);
            let (label, spread) = (points.label.as_str(), &points.errors[..]);
            let whole = Series { label, axis, colour, style, x, y, spread, version, ..Series::default() };
            Some(until.filter(|_| independent).map_or(whole, |until| begun(whole, until)))
        });
        let mut series: Vec<Series<'_>> = points.collect();
        let runs = ghosts.chain(kept).chain([(self.line.traces(), Style::Line, "")]);
        for (traces, style, run) in runs.filter(|_| until.is_none()) {
            let present_run = style == Style::Line;
            for (number, &CurveColumns { x, y, axis }) in columns.curves.iter().enumerate() {
                let present = self.line.present().get(x).copied().zip(self.line.present().get(y).copied());
                let label = match style {
                    Style::Line => labels.curves.get(number).map_or("", String::as_str),
                    // One legend entry stands for all curves of a kept run.
                    Style::Ghost if number == 0 => words::previous_run(self.basis.language()),
                    _ => "",
                };
                let (x, y) = (traces.column(x), traces.column(y));
                let across = labels.across.get(number).map_or("", String::as_str);
                let mut curve = Series { label, across, axis, colour: number as u8, style, x, y, ..Series::default() };
                // The first curve of a kept run names it.
                curve.end = if number == 0 { run } else { "" };
                curve.breaks = traces.breaks(columns.first + number);
                curve.present = present.filter(|_| present_run);
                series.push(curve);
            }
        }
        let first = Interval::new(0.0, unit.from_si(self.basis.first_part(self.line.course())));
        // Beside a record, a run is compared with it: the axes are those of the record.
        let along = |axis: usize| {
            let on_axis = state
                .points
                .iter()
                .zip(&state.measured)
                .filter(|(points, _)| columns.curves.get(points.curve).is_some_and(|curve| curve.axis == axis));
            on_axis.filter_map(|(_, measured)| measured[1]).reduce(Interval::joined)
        };
        let only = state.measured.iter().filter_map(|measured| measured[0]).reduce(Interval::joined);
        let only = only.filter(|_| independent);
        let ahead = |axis: usize| {
            let on_axis = columns.curves.iter().filter(|curve| curve.axis == axis);
            on_axis.filter_map(|curve| self.line.range_ahead(curve.y)).reduce(Interval::joined)
        };
        let across =
            || columns.curves.iter().filter_map(|curve| self.line.range_ahead(curve.x)).reduce(Interval::joined);
        let include = if independent { Some(first) } else { across() };
        let y = labels.axes.iter().enumerate();
        let y = y.map(|(axis, (label, unit))| {
            let name = labels.names.1.get(axis).map_or("", String::as_str);
            Axis { label, name, unit, include: ahead(axis), only: along(axis) }
        });
        let y = y.collect();
        Some(Plot {
            title: &labels.title,
            description: &labels.description,
            x: Axis { label: &labels.x.0, name: &labels.names.0, unit: &labels.x.1, include, only },
            y,
            series,
            marker: if independent { until.or_else(|| self.line.present().get(columns.x).copied()) } else { None },
            view: state.view.clone(),
            ordered: independent,
            steady: false,
            equal: self.has_equal_axes(index),
        })
    }

    /// A plot of the document without series.
    fn empty_figure(&self, index: usize) -> Option<Plot<'_>> {
        let state = self.plots.states.get(index)?;
        let labels = &state.labels;
        let names = labels.names.1.iter().map(String::as_str).chain(std::iter::repeat(""));
        let y = labels.axes.iter().zip(names);
        let y = y.map(|((label, unit), name)| Axis { label, name, unit, ..Axis::default() });
        Some(Plot {
            title: &labels.title,
            description: &labels.description,
            x: Axis { label: &labels.x.0, name: &labels.names.0, unit: &labels.x.1, ..Axis::default() },
            y: y.collect(),
            view: state.view.clone(),
            equal: self.has_equal_axes(index),
            ..Plot::default()
        })
    }

    /// Series of one curve of a plot that is not drawn along the run.
    fn curve_alone<'a>(&'a self, index: usize, number: usize, x: &'a [f64], y: &'a [f64]) -> Option<Series<'a>> {
        let labels = &self.plots.states.get(index)?.labels;
        let text = |list: &'a [String]| list.get(number).map_or("", String::as_str);
        let axis = self.line.columns().plot(index)?.curves.get(number)?.axis;
        let (label, across, colour) = (text(&labels.curves), text(&labels.across), number as u8);
        Some(Series { label, across, axis, colour, x, y, ..Series::default() })
    }

    /// Points of the run at multiples of a period, or at the firings of an event.
    fn section_figure<'a>(&'a self, index: usize, section: &'a Section) -> Option<Plot<'a>> {
        let curves = self.line.columns().plot(index)?.curves.len();
        let series = (0..curves).filter_map(|number| {
            let (x, y) = section.curve(number);
            Some(Series { style: Style::Dots, ..self.curve_alone(index, number, x, y)? })
        });
        Some(Plot {
            series: series.collect(),
            ordered: self.is_against_independent(index),
            ..self.empty_figure(index)?
        })
    }

    /// Curves over the values of a parameter, with the present value marked.
    fn swept_figure<'a>(&'a self, index: usize, swept: &'a Swept) -> Option<Plot<'a>> {
        let mut plot = self.empty_figure(index)?;
        let style = if swept.is_of_points() { Style::Dots } else { Style::Line };
        let curves = swept.y.iter().enumerate();
        let series =
            curves.filter_map(|(number, y)| Some(Series { style, ..self.curve_alone(index, number, &swept.x, y)? }));
        plot.series = series.collect();
        // The axis ends with the sweep: no values are computed beyond it.
        plot.view.x.get_or_insert(swept.range());
        plot.marker = swept.present(self.line.course());
        plot.ordered = style == Style::Line;
        Some(plot)
    }

    /// Members of families at the moment shown.
    fn profile_figure<'a>(&'a self, index: usize, profile: &'a Snapshot, style: Style) -> Option<Plot<'a>> {
        let mut plot = self.empty_figure(index)?;
        let curves = self.line.columns().plot(index)?.curves.len();
        let series = (0..curves).filter_map(|number| {
            let (x, y) = (profile.column(2 * number), profile.column(2 * number + 1));
            Some(Series { style, ..self.curve_alone(index, number, x, y)? })
        });
        plot.series = series.collect();
        plot.x.include = profile.reached(0);
        for (number, axis) in plot.y.iter_mut().enumerate() {
            axis.include = profile.reached(1 + number);
        }
        plot.ordered = style == Style::Line && plot.series.iter().all(|series| series.x.is_sorted());
        plot.steady = true;
        Some(plot)
    }

    /// Bars of a histogram.
    fn histogram_figure<'a>(&'a self, index: usize, histogram: &'a Histogram) -> Option<Plot<'a>> {
        let mut plot = self.empty_figure(index)?;
        let bins = histogram.bins();
        let series = self.curve_alone(index, 0, &bins.middles, &bins.counts)?;
        plot.series = vec![Series { style: Style::Bars, width: bins.width, ..series }];
        plot.x.include = Some(histogram.across());
        plot.y.iter_mut().for_each(|axis| axis.include = Some(histogram.along()));
        (plot.ordered, plot.steady) = (true, true);
        Some(plot)
    }

    /// True if both axes have the same scale: if lengths are plotted against a length, or the document requests it. Not
    /// for profiles by default: displacements of members against their places would be flattened.
    pub(super) fn has_equal_axes(&self, index: usize) -> bool {
        let is_length = |curve: &Curve| curve.value.unit.dimension == units::Dimension::LENGTH;
        self.basis.program().plots.get(index).is_some_and(|plot| match plot.drawing {
            Drawing::Histogram(_) => false,
            Drawing::Profile(_) => plot.equal,
            _ => plot.equal || plot.expressions().all(is_length),
        })
    }

    /// Horizontal interval of the first zoomed plot of the document against the independent variable; `None` if none is
    /// zoomed.
    pub fn zoomed_part(&self) -> Option<Interval> {
        let against = (0..self.basis.program().plots.len()).filter(|index| self.is_against_independent(*index));
        against.filter_map(|index| self.plots.states.get(index)?.view.x).next()
    }

    pub(super) fn is_against_independent(&self, index: usize) -> bool {
        let independent = |x: &Curve| self.basis.model().is_independent(x.value.node);
        self.basis.program().plots.get(index).is_some_and(|plot| plot.abscissas().all(independent))
    }

    /// Figure of an added plot.
    fn added_figure<'a>(&'a self, added: &'a AddedPlot, view: &View) -> Plot<'a> {
        let labels = &added.labels;
        let unit = &self.basis.model().independent.unit;
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
        let axis =
            |(label, unit): &'a (String, String)| Axis { label, unit, include: added.y_includes, ..Axis::default() };
        Plot {
            title: &labels.title,
            description: &labels.description,
            x: Axis { label: &labels.x.0, unit: &labels.x.1, include: added.x_includes, ..Axis::default() },
            y: labels.axes.iter().map(axis).collect(),
            series: series.collect(),
            marker: added.marks_time.then(|| unit.from_si(self.line.course().time())),
            view: View { x: view.x, y: limits.map_or_else(|| view.y.clone(), |limits| vec![limits]) },
            ordered: added.ordered,
            steady: false,
            equal: false,
        }
    }

    /// Number of series drawn behind those of the present run.
    pub(super) fn series_behind(&self, index: usize) -> usize {
        self.points_behind(index) + self.runs_behind(index)
    }

    /// Number of series of points, which are drawn behind all lines.
    pub(super) fn points_behind(&self, index: usize) -> usize {
        let along = self.plots.states.get(index).filter(|plot| matches!(plot.content, Content::Run));
        along.map_or(0, |plot| plot.points.len())
    }

    fn runs_behind(&self, index: usize) -> usize {
        let state = self.plots.states.get(index);
        if state.is_none_or(|state| !matches!(state.content, Content::Run)) {
            return 0;
        }
        let curves = self.line.columns().plot(index).map_or(0, |plot| plot.curves.len());
        let behind = usize::from(self.line.has_ghost()) + self.line.kept_traces().count();
        curves * behind
    }
}

/// Points of a series up to an abscissa, the last of which is the present moment.
fn begun(whole: Series<'_>, until: f64) -> Series<'_> {
    let count = whole.x.partition_point(|x| *x <= until);
    let [x, y] = [whole.x, whole.y].map(|values| values.get(..count).unwrap_or(values));
    let present = x.last().copied().zip(y.last().copied());
    // The version stands for the whole series.
    Series { x, y, present, version: 0, ..whole }
}

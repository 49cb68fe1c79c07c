//! Series of a plot by name: legend, export as CSV, differences between read-outs.

use super::Figures;
use super::plot::PlotId;
use crate::words;
use engine::csv::Dialect;
use figure::{Plot, Readout, Series, Style};

/// An entry of a legend.
#[derive(Clone, Debug, PartialEq)]
pub struct LegendEntry {
    /// Text of the entry.
    pub label: String,
    /// Palette index of the series.
    pub colour: u8,
    /// Drawing style.
    pub style: Style,
}

/// Description of a series.
#[derive(Clone, Debug, Default)]
pub(crate) struct SeriesName {
    /// Curve, such as `y`, or name of a measurement.
    pub curve: String,
    /// Name of the run, or the moment shown; `None` for the present run.
    pub run: Option<String>,
}

impl Figures<'_> {
    /// Legend of a plot; empty if it has fewer than two entries.
    pub fn legend(&self, PlotId(index): PlotId) -> Vec<LegendEntry> {
        let names = self.series_names(index);
        let Some(plot) = self.figure_of(index) else { return Vec::new() };
        let entry = |(series, name): (&Series<'_>, SeriesName)| {
            // One entry stands for all curves of a kept run.
            let (label, colour) = match series.style {
                Style::Faded(_) if series.colour == 0 => (name.run.unwrap_or_default(), series.colour),
                _ => (self.legend_name(index, series).to_owned(), series.colour),
            };
            (!label.is_empty()).then_some(LegendEntry { label, colour, style: series.style })
        };
        let entries: Vec<LegendEntry> = plot.series.iter().zip(names).filter_map(entry).collect();
        if entries.len() < 2 { Vec::new() } else { entries }
    }

    /// Legend label of a series: the label that the plot gives its curve, otherwise its name.
    pub(super) fn legend_name<'a>(&'a self, index: usize, series: &Series<'a>) -> &'a str {
        let labels = self.plots.states.get(index).map(|plot| &plot.labels);
        let number = usize::from(series.colour);
        let own = labels.filter(|labels| labels.curves.get(number).is_some_and(|name| name == series.label));
        own.and_then(|labels| labels.legend.get(number)).map_or(series.label, String::as_str)
    }

    /// All series of a plot as CSV. Each series has its own columns of abscissas and ordinates, because row counts
    /// differ.
    pub fn csv(&self, PlotId(index): PlotId) -> String {
        let names = self.series_names(index);
        let Some(plot) = self.figure_of(index) else { return String::new() };
        let dialect = if self.basis.style().decimal_comma { Dialect::Semicolons } else { Dialect::Commas };
        let mut out = dialect.start().to_owned();
        let head = |label: &str, unit: &str| {
            if unit.is_empty() { label.to_owned() } else { format!("{label} [{unit}]") }
        };
        let heads = plot.series.iter().zip(&names).flat_map(|(series, name)| {
            let unit = plot.y.get(series.axis).map_or("", |axis| axis.unit);
            let run = name.run.as_ref().map(|run| format!(" ({run})")).unwrap_or_default();
            let across = if series.across.is_empty() { plot.x.label } else { series.across };
            [head(&format!("{across}{run}"), plot.x.unit), head(&format!("{}{run}", name.curve), unit)]
        });
        // Writing to a string cannot fail.
        for (place, head) in heads.enumerate() {
            if place > 0 {
                out.push(dialect.separator());
            }
            let _ = dialect.text(&mut out, &head);
        }
        out.push_str(dialect.line_end());
        // If a run ends on a grid row, its last row occurs twice.
        let length = |series: &Series<'_>| match series.x.len().min(series.y.len()) {
            rows @ 2.. if series.x[rows - 1] == series.x[rows - 2] && series.y[rows - 1] == series.y[rows - 2] => {
                rows - 1
            }
            rows => rows,
        };
        for row in 0..plot.series.iter().map(length).max().unwrap_or(0) {
            for (place, series) in plot.series.iter().enumerate() {
                if place > 0 {
                    out.push(dialect.separator());
                }
                let cell = |column: &[f64]| column.get(row).copied().filter(|_| row < length(series));
                if let Some(x) = cell(series.x) {
                    let _ = dialect.number(&mut out, x);
                }
                out.push(dialect.separator());
                if let Some(y) = cell(series.y) {
                    let _ = dialect.number(&mut out, y);
                }
            }
            out.push_str(dialect.line_end());
        }
        out
    }

    /// Removes the samples of kept runs from a read-out, unless it contains nothing else.
    pub fn own_samples(&self, PlotId(index): PlotId, mut readout: Readout) -> Readout {
        let Some(plot) = self.figure_of(index) else { return readout };
        let own = |style: Style| !matches!(style, Style::Faded(_) | Style::Ghost);
        let is_own = |number: usize| plot.series.get(number).is_some_and(|series| own(series.style));
        if readout.samples.iter().any(|sample| is_own(sample.series)) {
            readout.samples.retain(|sample| is_own(sample.series));
        }
        readout
    }

    /// Difference between two read-outs of a plot: `Δt = 0.5 s`, `Δy = 0.1 m`.
    pub fn difference(&self, PlotId(index): PlotId, from: &Readout, to: &Readout) -> Vec<String> {
        let difference = |figure: &figure::Figure, plot: Plot<'_>| figure.difference(&plot, from, to);
        self.figure(PlotId(index))
            .zip(self.figure_of(index))
            .map(|(figure, plot)| difference(figure, plot))
            .unwrap_or_default()
    }

    /// Descriptions of the series of a plot, in their order.
    pub(crate) fn series_names(&self, index: usize) -> Vec<SeriesName> {
        let Some(plot) = self.figure_of(index) else { return Vec::new() };
        let kept = self.line.kept(self.basis);
        let curves = self.plots.states.get(index).map_or(&[][..], |plot| &plot.labels.curves);
        let moment = self.moment_of(index);
        let name = |series: &Series<'_>| {
            let run = match series.style {
                Style::Faded(pattern) => kept.iter().find(|kept| kept.pattern == pattern).map(|kept| kept.name.clone()),
                Style::Ghost => Some(words::previous_run(self.basis.language()).to_owned()),
                _ => moment.clone(),
            };
            let curve = match run {
                Some(_) => curves.get(usize::from(series.colour)).map_or("", String::as_str),
                None => series.label,
            };
            SeriesName { curve: curve.to_owned(), run }
        };
        plot.series.iter().map(name).collect()
    }
}

//! The plot of the residuals: measured minus computed values.

use super::data::{Measured, Residuals};
use super::points::shortened;
use crate::measured::MeasuredData;
use crate::{number, words};
use figure::{Interval, Style};
use play::{AddedPlot, AddedSeries, Labels, Play, points_colour, symbol};
use units::{Dimension, Unit};

/// Number of residuals of a column that are computed per call, a fraction of a frame's time.
const SLICE: usize = 4000;

impl MeasuredData {
    /// Resets the plot of the residuals. Needed when the measured columns or their meanings change.
    pub(crate) fn begin_residuals(&mut self, play: &mut Play) {
        let unit = &play.model().independent.unit;
        let ends = self.columns.iter().filter_map(|measured| measured.times.last());
        let whole = Interval::new(0.0, unit.from_si(ends.fold(0.0, |end, time| time.max(end))));
        let mut axes: Vec<Dimension> = Vec::new();
        let mut series = Vec::new();
        for (number, measured) in self.columns.iter().enumerate() {
            let dimension = measured.observed.dimension();
            let axis = axes.iter().position(|axis| *axis == dimension).unwrap_or_else(|| {
                axes.push(dimension);
                axes.len() - 1
            });
            series.push(AddedSeries {
                axis,
                colour: points_colour(number),
                style: Style::Points,
                in_legend: true,
                version: self.version_of(number),
                ..AddedSeries::default()
            });
        }
        let offered = self.has_points();
        let change = |plot: &mut AddedPlot| {
            let labels = std::mem::take(&mut plot.labels);
            let x_includes = Some(whole);
            *plot = AddedPlot {
                labels,
                series,
                x_includes,
                marks_time: true,
                ordered: true,
                offered,
                ..AddedPlot::default()
            };
        };
        play.change_plots(|plots, _| plots.change_added(self.plot, change));
        self.label_residuals(play);
    }

    /// True if residuals up to the front of the run are not yet computed.
    pub fn lags(&self, play: &Play) -> bool {
        let front = play.course().front();
        let is_behind = |(residuals, measured): (&Residuals, &Measured)| {
            measured.times.get(residuals.passed).is_some_and(|time| *time <= front)
        };
        self.residuals.iter().zip(&self.columns).any(is_behind)
    }

    /// Computes residuals up to the front of the run, at most [`SLICE`] values per column and call.
    pub(crate) fn follow_residuals(&mut self, play: &mut Play) {
        if !self.lags(play) {
            return;
        }
        let front = play.course().front();
        let unit = play.model().independent.unit.clone();
        let mut state = vec![0.0; play.model().states.len()];
        for (number, (residuals, measured)) in self.residuals.iter_mut().zip(&self.columns).enumerate() {
            // Columns of the same dimension share an axis and the unit of the first of them.
            let own = &measured.observed.unit;
            let shares = |other: &&Measured| other.observed.unit.dimension == own.dimension;
            let axis = self.columns.iter().find(shares).map_or(own, |first| &first.observed.unit);
            let turning = own.turning(axis);
            let rest = measured.times.iter().zip(&measured.values).enumerate().skip(residuals.passed);
            let (mut x, mut y, mut errors) = (Vec::new(), Vec::new(), Vec::new());
            for (row, (&time, &value)) in rest.take(SLICE).take_while(|(_, (time, _))| **time <= front) {
                residuals.passed += 1;
                let Some(parameters) = play
                    .change_run(|line, _| line.state_at(time, &mut state))
                    .filter(|_| time >= 0.0 && !measured.excludes(row))
                else {
                    continue;
                };
                let computed = residuals.readings.at(&parameters, play.course().initial(), time, &state);
                let left = value - computed.first().copied().unwrap_or(f64::NAN);
                x.push(unit.from_si(time));
                y.push(axis.from_si(left * turning));
                errors.extend(measured.errors.get(row).map(|error| axis.from_si(error * turning)));
            }
            let append = |plot: &mut AddedPlot| {
                if let Some(series) = plot.series.get_mut(number) {
                    series.x.append(&mut x);
                    series.y.append(&mut y);
                    series.errors.append(&mut errors);
                }
            };
            play.change_plots(|plots, _| plots.change_added(self.plot, append));
        }
    }

    /// Drops the residuals after `time` (SI), where the run was discarded.
    pub(crate) fn truncate_residuals(&mut self, play: &mut Play, time: f64) {
        self.version += 1;
        let last = play.model().independent.unit.from_si(time);
        for (residuals, measured) in self.residuals.iter_mut().zip(&self.columns) {
            residuals.passed = residuals.passed.min(measured.times.partition_point(|&at| at <= time));
        }
        if self.columns.is_empty() {
            return;
        }
        let truncate = |plot: &mut AddedPlot| {
            for (number, series) in plot.series.iter_mut().enumerate() {
                let kept = series.x.partition_point(|&at| at <= last);
                series.x.truncate(kept);
                series.y.truncate(kept);
                series.errors.truncate(kept);
                series.version = self.version_of(number);
            }
        };
        play.change_plots(|plots, _| plots.change_added(self.plot, truncate));
    }

    /// Sets the texts of the plot of the residuals.
    pub(crate) fn label_residuals(&self, play: &mut Play) {
        let [title, left_over] = words::residuals(play.basis().language());
        let independent = &play.model().independent;
        let names: Vec<String> = self.columns.iter().map(|measured| format!("Δ{}", symbol(&measured.name))).collect();
        let mut axes: Vec<(String, &Unit)> = Vec::new();
        for (measured, name) in self.columns.iter().zip(&names) {
            let unit = &measured.observed.unit;
            match axes.iter_mut().find(|(_, axis)| axis.dimension == unit.dimension) {
                Some((label, _)) if label.split(", ").any(|one| one == name) => {}
                Some((label, _)) => label.extend([", ", name]),
                None => axes.push((name.clone(), unit)),
            }
        }
        let first = self.columns.first().map(|measured| measured.record);
        let several = self.columns.iter().any(|measured| Some(measured.record) != first);
        let curves = self.columns.iter().zip(names).map(|(measured, name)| {
            if several { format!("{name} ({})", shortened(&measured.record_name)) } else { name }
        });
        let curves = curves.collect();
        let labels = Labels {
            title: title.to_owned(),
            description: format!("{title}: {left_over}"),
            x: (symbol(&independent.name), number::unit_text(&independent.unit.text)),
            axes: axes.into_iter().map(|(label, unit)| (label, number::unit_text(&unit.text))).collect(),
            curves,
            ..Labels::default()
        };
        play.change_plots(|plots, _| plots.change_added(self.plot, |plot| plot.labels = labels));
    }
}

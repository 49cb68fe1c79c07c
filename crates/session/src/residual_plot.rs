//! The plot of the residuals: what measurements leave over beside the run.

use crate::observed::shortened;
use crate::plot::{Labels, MEASURED};
use crate::symbol::symbol;
use crate::{Session, number, words};
use figure::{Axis, Interval, Plot, Series, Style};

impl Session {
    /// What measurements leave over beside the present run.
    pub(crate) fn residual_plot(&self) -> Option<Plot<'_>> {
        let state = self.plots.get(self.document.program.plots.len())?;
        let labels = &state.labels;
        let unit = &self.model().independent.unit;
        let mut axes: Vec<units::Dimension> = Vec::new();
        let mut series = Vec::new();
        let columns = self.data.measured.iter().zip(&self.data.residuals).zip(&labels.curves);
        for (number, ((measured, residuals), label)) in columns.enumerate() {
            let dimension = measured.observed.dimension();
            let axis = axes.iter().position(|axis| *axis == dimension).unwrap_or_else(|| {
                axes.push(dimension);
                axes.len() - 1
            });
            let (colour, style) = (MEASURED + number as u8, Style::Points);
            let (x, y) = (&residuals.x[..], &residuals.y[..]);
            let version = self.data.version_of(number);
            series.push(Series { label, axis, colour, style, x, y, version, ..Series::default() });
        }
        let ends = self.data.measured.iter().filter_map(|measured| measured.times.last());
        let whole = Interval::new(0.0, unit.from_si(ends.fold(0.0, |end, time| time.max(end))));
        Some(Plot {
            title: &labels.title,
            description: &labels.description,
            x: Axis { label: &labels.x.0, unit: &labels.x.1, include: Some(whole) },
            y: labels.axes.iter().map(|(label, unit)| Axis { label, unit, include: None }).collect(),
            series,
            marker: Some(unit.from_si(self.course.time())),
            view: state.view.clone(),
            ordered: true,
            equal: false,
        })
    }

    /// Writes the texts of the plot of the residuals.
    pub(crate) fn label_residuals(&mut self) {
        let (title, left_over) = words::residuals(self.language);
        let independent = &self.model().independent;
        let names: Vec<String> =
            self.data.measured.iter().map(|measured| format!("Δ{}", symbol(&measured.name))).collect();
        let mut axes: Vec<(String, &units::Unit)> = Vec::new();
        for (measured, name) in self.data.measured.iter().zip(&names) {
            let unit = &measured.observed.unit;
            match axes.iter_mut().find(|(_, axis)| axis.dimension == unit.dimension) {
                Some((label, _)) if label.split(", ").any(|one| one == name) => {}
                Some((label, _)) => label.extend([", ", name]),
                None => axes.push((name.clone(), unit)),
            }
        }
        let first = self.data.measured.first().map(|measured| measured.record);
        let several = self.data.measured.iter().any(|measured| Some(measured.record) != first);
        let curves = self.data.measured.iter().zip(names).map(|(measured, name)| {
            let record = self.record(measured.record).filter(|_| several);
            record.map_or(name.clone(), |record| format!("{name} ({})", shortened(&record.name)))
        });
        let curves = curves.collect();
        let labels = Labels {
            title: title.to_owned(),
            description: format!("{title}: {left_over}"),
            x: (symbol(&independent.name), number::unit_text(&independent.unit.text)),
            axes: axes.into_iter().map(|(label, unit)| (label, number::unit_text(&unit.text))).collect(),
            curves,
        };
        let index = self.document.program.plots.len();
        if let Some(state) = self.plots.get_mut(index) {
            state.labels = labels;
        }
    }
}

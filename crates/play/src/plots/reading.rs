//! Adds measured points to the read-outs of a plot by pointer or keyboard.

use super::Figures;
use super::added::AddedPlot;
use super::plot::PlotId;
use crate::number;
use figure::{Plot, Point, Readout, Sample, Series, Style};

/// Maximum distance of a point from the cursor, in pixels.
const REACH: f32 = 24.0;

impl Figures<'_> {
    /// Adds the measured points nearest to a pixel to a read-out: one per column if the abscissa is the independent
    /// variable, otherwise only the nearest point of all.
    pub(crate) fn with_points(&self, index: usize, at: Point, readout: Option<Readout>) -> Option<Readout> {
        let mut near = self.points_near(index, at);
        let Some(mut readout) = readout else {
            return (!near.is_empty()).then(|| Readout { heading: String::new(), samples: near });
        };
        readout.samples.append(&mut near);
        Some(readout)
    }

    /// Measured point nearest to a pixel: number of its column among all that are drawn, and index among the values of the
    /// column. `None` if no point is near.
    pub(super) fn measured_point(&self, PlotId(index): PlotId, at: Point) -> Option<(usize, usize)> {
        let near = |sample: &Sample| distance(sample, at) <= REACH * REACH;
        let nearest = self.points_near(index, at).into_iter().filter(near);
        let nearest = nearest.min_by(|one, other| distance(one, at).total_cmp(&distance(other, at)))?;
        let points = self.plots.states.get(index)?.points.get(nearest.series)?;
        Some((points.column, *points.places.get(nearest.row)?))
    }

    /// Read-out of an added plot, with the errors of values that have them.
    pub(super) fn with_errors(&self, added: &AddedPlot, mut readout: Readout) -> Readout {
        for sample in &mut readout.samples {
            let Some(series) = added.series.get(sample.series) else { continue };
            let Some(error) = series.errors.get(sample.row).copied() else { continue };
            let Some((name, unit)) = added.labels.axes.get(series.axis) else { continue };
            let value = number::with_error(sample.y, Some(error), self.basis.style());
            sample.text = format!("{name} = {}", number::error_with_unit(&value, unit));
        }
        readout
    }

    fn points_near(&self, index: usize, at: Point) -> Vec<Sample> {
        let (Some(figure), Some(plot)) = (self.figure(PlotId(index)), self.figure_of(index)) else {
            return Vec::new();
        };
        let Some(state) = self.plots.states.get(index) else { return Vec::new() };
        let curves = &state.labels.curves;
        let mut found: Vec<Sample> = Vec::new();
        for (number, points) in state.points.iter().enumerate() {
            // On its own, so that the heading is that of the point.
            let Some(own) = plot.series.get(number) else { continue };
            let label = curves.get(points.curve).map_or("", String::as_str);
            let series = Series {
                label,
                axis: own.axis,
                colour: points.colour,
                style: Style::Points,
                x: own.x,
                y: own.y,
                ..*own
            };
            let alone = Plot { series: vec![series], ..plot.clone() };
            let Some(mut readout) = figure.hover(&alone, at) else { continue };
            let Some(mut sample) = readout.samples.pop().filter(|sample| (sample.at.x - at.x).abs() <= REACH) else {
                continue;
            };
            sample.text = format!("{}: {}, {}", points.source, readout.heading, sample.text);
            sample.series = number;
            // A computed column may hold the same values as its source.
            if !found.iter().any(|other| other.text == sample.text) {
                found.push(sample);
            }
        }
        if plot.ordered {
            return found;
        }
        found.into_iter().min_by(|one, other| distance(one, at).total_cmp(&distance(other, at))).into_iter().collect()
    }
}

/// Square of the distance of a sample from a pixel.
fn distance(sample: &Sample, at: Point) -> f32 {
    let (across, down) = (sample.at.x - at.x, sample.at.y - at.y);
    across * across + down * down
}

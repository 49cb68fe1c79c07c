//! Read-out of values at the pointer or the keyboard cursor.

use crate::figure::Figure;
use crate::items::Point;
use crate::limits::drawable;
use crate::plot::{Axis, Plot, Series};
use units::number::{DASH, axis_unit, resolved, write_power};

/// Maximum distance of a sample from the pointer, in pixels.
const REACH: f64 = 24.0;

/// Values of a figure at one place.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Readout {
    /// Horizontal value with its unit, `t = 1.25 s`; common to all samples of a time plot.
    pub heading: String,
    /// Samples at that place: in a time plot one per series, otherwise only the nearest one.
    pub samples: Vec<Sample>,
}

/// A sample of a series.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// Index of the series in the plot.
    pub series: usize,
    /// Index of the row in the series.
    pub row: usize,
    /// Index of the vertical axis of that series.
    pub axis: usize,
    /// Horizontal value, in the unit of the axis.
    pub x: f64,
    /// Vertical value, in the unit of the axis.
    pub y: f64,
    /// Position in the figure, clamped to the panel.
    pub at: Point,
    /// Vertical value with name and unit, `y = 0.412 m`.
    pub text: String,
}

impl Figure {
    /// Read-out at a pixel of the panel. If horizontal values ascend: the horizontally nearest sample of each series.
    /// Otherwise: the single nearest sample. `None` if no sample is near.
    pub fn hover(&self, plot: &Plot<'_>, at: Point) -> Option<Readout> {
        if !self.panel.contains(at) {
            return None;
        }
        if plot.ordered {
            return self.at_abscissa(plot, f64::from(at.x), None);
        }
        let nearest = (plot.series.iter().enumerate())
            .flat_map(|(index, series)| (0..series.x.len().min(series.y.len())).map(move |row| (index, row)))
            .filter_map(|(index, row)| {
                let (x, y) = self.pixel(plot, index, row)?;
                let (right, down) = (x - f64::from(at.x), y - f64::from(at.y));
                Some((right * right + down * down, index, row))
            })
            .min_by(|one, other| one.0.total_cmp(&other.0))?;
        let (distance, index, row) = nearest;
        if distance <= REACH * REACH { self.single(plot, index, row) } else { None }
    }

    /// Read-out at a row of a series, for the keyboard cursor. If horizontal values ascend, it includes the other series at
    /// the same horizontal value.
    pub fn readout(&self, plot: &Plot<'_>, series: usize, row: usize) -> Option<Readout> {
        let (x, _) = self.pixel(plot, series, row)?;
        if plot.ordered { self.at_abscissa(plot, x, Some((series, row))) } else { self.single(plot, series, row) }
    }

    /// Row reached from `row` by moving `rows` visible rows forward or back. Rows that cannot be drawn or are outside the
    /// panel are skipped; at the end of the series it is the last visible row. `None` if no row is visible.
    pub fn step(&self, plot: &Plot<'_>, series: usize, row: usize, rows: isize) -> Option<usize> {
        let column = plot.series.get(series)?;
        let count = column.x.len().min(column.y.len());
        let shown = |row: &usize| {
            self.pixel(plot, series, *row).is_some_and(|(x, y)| self.panel.contains(Point { x: x as f32, y: y as f32 }))
        };
        let row = row.min(count.checked_sub(1)?);
        let distance = rows.unsigned_abs();
        let reached = if rows >= 0 {
            (row + 1..count).filter(shown).take(distance).last()
        } else {
            (0..row).rev().filter(shown).take(distance).last()
        };
        reached
            .or_else(|| Some(row).filter(shown))
            .or_else(|| (row..count).find(shown))
            .or_else(|| (0..row).rev().find(shown))
    }

    /// Position of the values (`x`, `y`) in the figure; `None` if it is outside the panel.
    pub fn place(&self, axis: usize, x: f64, y: f64) -> Option<Point> {
        let at = Point { x: self.x?.pixel(x) as f32, y: self.y.get(axis)?.pixel(y) as f32 };
        self.panel.contains(at).then_some(at)
    }

    /// Differences between two read-outs: `Δt = 0.5 s`, and `Δy = 0.1 m` for each curve that is in both. If they have no
    /// common curve, their first samples are compared, provided these have the same axis.
    pub fn difference(&self, plot: &Plot<'_>, from: &Readout, to: &Readout) -> Vec<String> {
        let (Some(first), Some(other)) = (from.samples.first(), to.samples.first()) else { return Vec::new() };
        let resolution = self.x.map_or(0.0, |scale| scale.resolution());
        let name = format!("Δ{}", plot.x.label);
        let mut lines = vec![self.quantity(&name, &plot.x, other.x - first.x, resolution, self.x_power)];
        let mut pairs: Vec<(&Sample, &Sample)> = Vec::new();
        for one in &from.samples {
            pairs.extend(to.samples.iter().find(|other| name_of(other) == name_of(one)).map(|other| (one, other)));
        }
        if pairs.is_empty() {
            pairs.push((first, other));
        }
        for (one, other) in pairs {
            let (Some(series), Some(second)) = (plot.series.get(one.series), plot.series.get(other.series)) else {
                continue;
            };
            let axis = series.axis;
            let (Some(scale), Some(ticks)) = (self.y.get(axis), self.y_ticks.get(axis)) else { continue };
            if let Some(drawn) = plot.y.get(axis).filter(|_| second.axis == axis) {
                let label = if series.label.is_empty() { drawn.label } else { series.label };
                let name = format!("Δ{label}");
                lines.push(self.quantity(&name, drawn, other.y - one.y, scale.resolution(), ticks.power));
            }
        }
        lines
    }

    /// Samples of all series horizontally nearest to a pixel. `given` fixes the row of one series, which distinguishes the
    /// two rows at a jump.
    fn at_abscissa(&self, plot: &Plot<'_>, pixel: f64, given: Option<(usize, usize)>) -> Option<Readout> {
        let scale = self.x?;
        let wanted = scale.value(pixel);
        let mut samples = Vec::new();
        let mut nearest: Option<(f64, f64)> = None;
        for (index, series) in plot.series.iter().enumerate() {
            let given = given.filter(|given| given.0 == index).map(|given| given.1);
            let Some(row) = given.or_else(|| nearest_row(series, wanted)) else {
                continue;
            };
            let Some((across, _)) = self.pixel(plot, index, row) else {
                continue;
            };
            let distance = (across - pixel).abs();
            // A series that ends before the pointer or begins after it has no value here.
            let rows = series.x.len().min(series.y.len());
            let covers = series.x[0] <= wanted && wanted <= series.x[rows - 1];
            if !scale.values.contains(series.x[row]) || (!covers && distance > REACH) {
                continue;
            }
            if nearest.is_none_or(|(best, _)| distance < best) {
                nearest = Some((distance, series.x[row]));
            }
            samples.extend(self.sample(plot, index, row));
        }
        let (_, x) = nearest?;
        Some(Readout { heading: self.heading_at(plot, plot.x.label, x), samples })
    }

    fn single(&self, plot: &Plot<'_>, series: usize, row: usize) -> Option<Readout> {
        let sample = self.sample(plot, series, row)?;
        let own = plot.series.get(series).map(|series| series.across).filter(|across| !across.is_empty());
        let heading = self.heading_at(plot, own.unwrap_or(plot.x.label), sample.x);
        Some(Readout { heading, samples: vec![sample] })
    }

    fn heading_at(&self, plot: &Plot<'_>, label: &str, x: f64) -> String {
        let resolution = self.x.map_or(0.0, |scale| scale.resolution());
        self.quantity(label, &plot.x, x, resolution, self.x_power)
    }

    fn sample(&self, plot: &Plot<'_>, index: usize, row: usize) -> Option<Sample> {
        let series = plot.series.get(index)?;
        let (across, down) = self.pixel(plot, index, row)?;
        let (axis, scale) = (plot.y.get(series.axis)?, self.y.get(series.axis)?);
        let ticks = self.y_ticks.get(series.axis)?;
        let panel = self.panel;
        let (x, y) = (series.x[row], series.y[row]);
        let label = if series.label.is_empty() { axis.label } else { series.label };
        Some(Sample {
            series: index,
            row,
            axis: series.axis,
            x,
            y,
            at: Point {
                x: (across as f32).clamp(panel.x, panel.x + panel.width),
                y: (down as f32).clamp(panel.y, panel.y + panel.height),
            },
            text: self.quantity(label, axis, y, scale.resolution(), ticks.power),
        })
    }

    /// A value with name and unit; power of ten and prefix are those of the axis.
    fn quantity(&self, label: &str, axis: &Axis<'_>, value: f64, resolution: f64, power: i32) -> String {
        let mut text = String::new();
        if !label.is_empty() {
            text.push_str(label);
            text.push_str(" = ");
        }
        if !value.is_finite() {
            text.push_str(DASH);
            return text;
        }
        text.push_str(&resolved(value, resolution, power, self.style));
        let (unit, power) = axis_unit(axis.unit, power);
        if power != 0 {
            text.push('×');
            write_power(&mut text, power);
        }
        if !unit.is_empty() {
            text.push('\u{a0}');
            text.push_str(&unit);
        }
        text
    }

    /// Position of a row of a series in pixels; `None` if it cannot be drawn.
    fn pixel(&self, plot: &Plot<'_>, series: usize, row: usize) -> Option<(f64, f64)> {
        let series = plot.series.get(series)?;
        let (x, y) = (*series.x.get(row)?, *series.y.get(row)?);
        let scale = self.y.get(series.axis)?;
        (drawable(x) && drawable(y)).then_some((self.x?.pixel(x), scale.pixel(y)))
    }
}

/// Name of the quantity of a sample. Unlike the index of the series, it is stable between read-outs.
fn name_of(sample: &Sample) -> &str {
    sample.text.rsplit_once(" = ").map_or("", |(name, _)| name)
}

/// Drawable row of a series with ascending horizontal values that is nearest to `wanted`.
fn nearest_row(series: &Series<'_>, wanted: f64) -> Option<usize> {
    let rows = series.x.len().min(series.y.len());
    let after = series.x[..rows].partition_point(|value| *value < wanted);
    let shown = |row: &usize| drawable(series.x[*row]) && drawable(series.y[*row]);
    let before = (0..after).rev().find(shown);
    match (before, (after..rows).find(shown)) {
        (Some(before), Some(after)) => {
            let nearer = wanted - series.x[before] < series.x[after] - wanted;
            Some(if nearer { before } else { after })
        }
        (before, after) => before.or(after),
    }
}

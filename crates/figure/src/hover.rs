//! Reading values off a figure: what lies under the pointer or the keyboard's cursor.

use crate::figure::Figure;
use crate::items::Point;
use crate::limits::drawable;
use crate::plot::{Axis, Plot, Series};
use units::number::{DASH, axis_unit, resolved, write_power};

/// How near to the pointer, in pixels, a sample must be that is not within reach by its abscissa.
const REACH: f64 = 24.0;

/// What a figure says about a place.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Readout {
    /// The abscissa with its unit, `t = 1.25 s`; the same for all samples of a time plot.
    pub heading: String,
    /// The samples there: in a time plot one of each series, else the nearest one alone.
    pub samples: Vec<Sample>,
}

/// One sample of a series.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// Which of the plot's series.
    pub series: usize,
    /// Which row of it.
    pub row: usize,
    /// The vertical axis of that series.
    pub axis: usize,
    /// Its abscissa in the unit of the axis.
    pub x: f64,
    /// Its ordinate in the unit of the axis.
    pub y: f64,
    /// Where it is in the figure, moved to the edge of the panel if it is above or below it.
    pub at: Point,
    /// The ordinate with name and unit, `y = 0.412 m`.
    pub text: String,
}

impl Figure {
    /// The samples nearest to a pixel of the panel: of each series the one nearest along the horizontal axis if the
    /// abscissas are ordered, else the single nearest sample of all. None when there is none near.
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

    /// The read-out at a row of a series, for a cursor moved by keyboard: with the other series at that abscissa if the
    /// abscissas are ordered.
    pub fn readout(&self, plot: &Plot<'_>, series: usize, row: usize) -> Option<Readout> {
        let (x, _) = self.pixel(plot, series, row)?;
        if plot.ordered { self.at_abscissa(plot, x, Some((series, row))) } else { self.single(plot, series, row) }
    }

    /// The row that a cursor reaches by moving `rows` on from `row` in a series, over rows that cannot be drawn or are
    /// outside the panel; the last such row if there are not so many. None if there is none at all.
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

    /// Where a place of the plane is in the figure; none if it is outside the panel.
    pub fn place(&self, axis: usize, x: f64, y: f64) -> Option<Point> {
        let at = Point { x: self.x?.pixel(x) as f32, y: self.y.get(axis)?.pixel(y) as f32 };
        self.panel.contains(at).then_some(at)
    }

    /// How far a read-out is from another one: `Δt = 0.5 s`, and of each curve that is in both `Δy = 0.1 m`. Where they have no
    /// curve in common, their first samples are compared if they have an axis in common.
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

    /// The samples of all series nearest to a pixel along the horizontal axis; of one series the row may be given, which
    /// tells apart the two at a jump.
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
            // A series that ends before the pointer, or has not begun there, says nothing about this place.
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

    /// A value with its name and unit, in which the axis has it too.
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

    /// Where a row of a series is, if it can be drawn.
    fn pixel(&self, plot: &Plot<'_>, series: usize, row: usize) -> Option<(f64, f64)> {
        let series = plot.series.get(series)?;
        let (x, y) = (*series.x.get(row)?, *series.y.get(row)?);
        let scale = self.y.get(series.axis)?;
        (drawable(x) && drawable(y)).then_some((self.x?.pixel(x), scale.pixel(y)))
    }
}

/// What a sample is a value of: its series may have another number in a later read-out.
fn name_of(sample: &Sample) -> &str {
    sample.text.rsplit_once(" = ").map_or("", |(name, _)| name)
}

/// The drawable row of an ordered series that is nearest to an abscissa.
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

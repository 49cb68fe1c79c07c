//! Uncertainty of a series: error bars of points, or a band around a line.

use std::ops::Range;

use crate::figure::Figure;
use crate::items::{DATA_RADIUS, Dash, Entry, Ink, Point, Scale, Stroke};
use crate::limits::{Extent, drawable};
use crate::plot::{Plot, Series};
use crate::series::visible_rows;

/// Half the length of the caps of an error bar, pixels.
const CAP: f32 = 2.0;
/// Minimum distance of error bars, pixels: if points are denser, only some have error bars.
const SPACE: f32 = 8.0;

/// Extent of the vertical values with their uncertainties.
pub(crate) fn extent(series: &Series<'_>) -> Extent {
    let ends = series.y.iter().zip(series.spread).flat_map(|(y, spread)| [y - spread, y + spread]);
    ends.filter(|end| drawable(*end))
        .fold(Extent::EMPTY, |extent, end| extent.union(Extent { low: end, high: end, turned: false }))
}

impl Figure {
    /// Draws the band around a line, interrupted where the line is.
    pub(crate) fn band(&mut self, plot: &Plot<'_>, series: &Series<'_>) {
        let (Some(x), Some(y)) = (self.x, self.y.get(series.axis).copied()) else {
            return;
        };
        if series.spread.is_empty() || series.style.is_of_points() {
            return;
        }
        let rows = visible_rows(plot, series, &x);
        let rows = rows.start..rows.end.min(series.spread.len()).max(rows.start);
        let mut start = rows.start;
        for row in rows.clone() {
            let whole = [series.x[row], series.y[row], series.spread[row]].into_iter().all(drawable);
            if !whole {
                self.piece(series, start..row, &x, &y);
                start = row + 1;
            } else if series.breaks.binary_search(&row).is_ok() {
                self.piece(series, start..row, &x, &y);
                start = row;
            }
        }
        self.piece(series, start..rows.end, &x, &y);
    }

    /// Draws a part of the band without gaps: forward along its upper edge, back along the lower one.
    fn piece(&mut self, series: &Series<'_>, rows: Range<usize>, x: &Scale, y: &Scale) {
        if rows.len() < 2 {
            return;
        }
        let start = self.points.len();
        let corner = |row: usize, sign: f64| {
            [within(x, series.x[row]), within(y, series.y[row] + sign * series.spread[row].abs())]
        };
        self.points.extend(rows.clone().flat_map(|row| corner(row, 1.0)));
        self.points.extend(rows.rev().flat_map(|row| corner(row, -1.0)));
        self.entries.push(Entry::Area(start..self.points.len(), Ink::Band(series.colour)));
    }

    /// Draws the error bars that are longer than the dots; evenly thinned if they are dense.
    pub(crate) fn bars(&mut self, series: &Series<'_>, rows: Range<usize>, x: &Scale, y: &Scale) {
        let stroke = Stroke { ink: Ink::Ghost(series.colour), width: 1.0, dash: Dash::Solid };
        let inside = |row: &usize| {
            let whole = [series.x[*row], series.y[*row], series.spread[*row]].into_iter().all(drawable);
            whole && x.values.contains(series.x[*row])
        };
        let hidden = f64::from(DATA_RADIUS) / y.factor().abs();
        let seen = |row: &usize| inside(row) && series.spread[*row].abs() > hidden;
        let rows = rows.start..rows.end.min(series.spread.len()).max(rows.start);
        let most = ((self.panel.width / SPACE) as usize).max(1);
        let every = rows.clone().filter(seen).count().div_ceil(most).max(1);
        for row in rows.filter(seen).step_by(every) {
            let across = within(x, series.x[row]);
            let ends = [1.0, -1.0].map(|sign| series.y[row] + sign * series.spread[row].abs());
            let [top, bottom] = ends.map(|end| within(y, end));
            if top == bottom {
                continue;
            }
            let point = |x: f32, y: f32| Point { x, y };
            self.entries.push(Entry::Line(point(across, top), point(across, bottom), stroke));
            for (end, down) in ends.into_iter().zip([top, bottom]) {
                if y.values.contains(end) {
                    let (from, to) = (point(across - CAP, down), point(across + CAP, down));
                    self.entries.push(Entry::Line(from, to, stroke));
                }
            }
        }
    }
}

/// Pixel of a value, or of the nearest end of the axis.
fn within(scale: &Scale, value: f64) -> f32 {
    scale.pixel(value.clamp(scale.values.low, scale.values.high)) as f32
}

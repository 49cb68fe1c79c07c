//! Drawing of series: lines, points, and the dots at the present moment.

use std::ops::Range;

use crate::figure::Figure;
use crate::items::{DATA_RADIUS, Dash, Entry, Ink, Point, Rect, Scale, Stroke, crisp, radius_of};
use crate::limits::drawable;
use crate::plot::{Plot, Series, Style};
use crate::trace::{Tracer, scatter};

/// Distance by which lines may cross the edge of the panel, in pixels, so that a line along the edge is not cut in half.
const BLEED: f32 = 1.5;

impl Figure {
    /// Draws the line or the points of a series.
    pub(crate) fn trace(&mut self, plot: &Plot<'_>, series: &Series<'_>) {
        let (Some(x), Some(y)) = (self.x, self.y.get(series.axis).copied()) else {
            return;
        };
        let rows = visible_rows(plot, series, &x);
        let first = rows.start;
        let count = rows.len();
        let panel = self.panel;
        let (x_factor, y_factor) = (x.factor(), y.factor());
        let (x_low, y_low) = (x.values.low, y.values.low);
        // Limit of pixel coordinates: values far outside the panel would overflow `f32`.
        let limit = 1e9;
        let pixel = |row: usize| {
            let (value_x, value_y) = (series.x[row], series.y[row]);
            (drawable(value_x) && drawable(value_y)).then(|| {
                let across = (x.low + (value_x - x_low) * x_factor).clamp(-limit, limit);
                let down = (y.low + (value_y - y_low) * y_factor).clamp(-limit, limit);
                (across as f32, down as f32)
            })
        };
        if series.style == Style::Bars {
            self.columns(series, rows, &x, &y);
            return;
        }
        if series.style.is_of_points() {
            let ink = Ink::Series(series.colour);
            let area = grown(panel, 0.5);
            self.bars(series, rows.clone(), &x, &y);
            if self.cloud(plot, series, &x, &y) {
                return;
            }
            scatter(&mut self.points, &mut self.entries, area, ink, radius(series, count), rows.filter_map(pixel));
            return;
        }
        let dense = plot.ordered && count as f32 > 2.0 * panel.width;
        let mut breaks = series.breaks.iter().copied().skip_while(|row| *row <= first).peekable();
        let mut tracer = Tracer::new(&mut self.points, &mut self.entries, grown(panel, BLEED), stroke(series));
        for row in rows {
            while breaks.next_if(|next| *next <= row).is_some() {
                tracer.interrupt();
            }
            match pixel(row) {
                Some((across, down)) if dense => tracer.dense(across, down),
                Some((across, down)) => tracer.line_to(across, down),
                None => tracer.interrupt(),
            }
        }
        tracer.interrupt();
    }

    /// Draws the visible parts of bars from zero, with a gap of one pixel between them.
    fn columns(&mut self, series: &Series<'_>, rows: Range<usize>, x: &Scale, y: &Scale) {
        let panel = self.panel;
        let (right, bottom) = (f64::from(panel.x + panel.width), f64::from(panel.y + panel.height));
        let across = |value: f64| x.pixel(value).clamp(f64::from(panel.x), right);
        let down = |value: f64| y.pixel(value).clamp(f64::from(panel.y), bottom);
        for row in rows {
            let (middle, height) = (series.x[row], series.y[row]);
            if !(drawable(middle) && drawable(height) && drawable(series.width)) || height == 0.0 {
                continue;
            }
            let (from, to) = (across(middle - series.width / 2.0), across(middle + series.width / 2.0));
            let (zero, end) = (down(0.0), down(height));
            let gap = if to - from > 3.0 { 1.0 } else { 0.0 };
            let (wide, high) = ((to - from - gap) as f32, (zero - end).abs() as f32);
            if wide > 0.0 && high > 0.0 {
                let bar = Rect { x: from as f32, y: zero.min(end) as f32, width: wide, height: high };
                self.entries.push(Entry::Fill(bar, Ink::Series(series.colour)));
            }
        }
    }

    /// Draws the line at the present moment and the dots on the series.
    pub(crate) fn present(&mut self, plot: &Plot<'_>) {
        let Some(x) = self.x else { return };
        let panel = self.panel;
        if let Some(marker) = plot.marker.filter(|marker| x.shows(*marker)) {
            let pixel = crisp(x.pixel(marker));
            let stroke = Stroke { ink: Ink::Marker, width: 1.0, dash: Dash::Solid };
            let (from, to) = (Point { x: pixel, y: panel.y }, Point { x: pixel, y: panel.y + panel.height });
            self.entries.push(Entry::Line(from, to, stroke));
        }
        for series in &plot.series {
            let (Some((at_x, at_y)), Some(y)) = (series.present, self.y.get(series.axis)) else {
                continue;
            };
            if x.shows(at_x) && y.shows(at_y) {
                let start = self.points.len();
                let dot = Point { x: x.pixel(at_x) as f32, y: y.pixel(at_y) as f32 };
                self.present.get_or_insert(dot);
                self.points.extend([dot.x, dot.y]);
                let centres = start..self.points.len();
                self.entries.push(Entry::Dots { centres, radius: 4.0, ink: Ink::Series(series.colour), ringed: true });
            }
        }
    }
}

/// Radius of the dots of a series with `count` points, pixels.
pub(crate) fn radius(series: &Series<'_>, count: usize) -> f32 {
    if series.style == Style::Dots { radius_of(count) } else { DATA_RADIUS }
}

/// Style of the line of a series.
pub(crate) fn stroke(series: &Series<'_>) -> Stroke {
    match series.style {
        Style::Line | Style::Points | Style::Dots | Style::Bars => {
            Stroke { ink: Ink::Series(series.colour), width: 2.0, dash: Dash::Solid }
        }
        Style::Ghost | Style::Unused => Stroke { ink: Ink::Ghost(series.colour), width: 1.25, dash: Dash::Solid },
        Style::Faded(number) => {
            let width = if series.colour == 0 { 1.75 } else { 1.25 };
            Stroke { ink: Ink::Faded(series.colour), width, dash: Dash::Pattern(number) }
        }
        Style::Run(number) => {
            let width = if series.colour == 0 { 1.75 } else { 1.25 };
            Stroke { ink: Ink::Run(number), width, dash: Dash::Pattern(number) }
        }
        Style::Kept(number) => Stroke { ink: Ink::Series(series.colour), width: 1.5, dash: Dash::Pattern(number) },
    }
}

/// Rectangle with its edges moved outwards by `by`.
fn grown(area: Rect, by: f32) -> Rect {
    Rect { x: area.x - by, y: area.y - by, width: area.width + 2.0 * by, height: area.height + 2.0 * by }
}

/// Visible rows: all of them, or if horizontal values ascend in a zoomed view, those in the panel and one more on either
/// side.
pub(crate) fn visible_rows(plot: &Plot<'_>, series: &Series<'_>, x: &Scale) -> Range<usize> {
    let rows = series.x.len().min(series.y.len());
    if !plot.ordered || plot.view.x.is_none() {
        return 0..rows;
    }
    let column = &series.x[..rows];
    let start = column.partition_point(|value| *value < x.values.low).saturating_sub(1);
    let end = (column.partition_point(|value| *value <= x.values.high) + 1).min(rows);
    start..end.max(start)
}

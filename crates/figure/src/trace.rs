//! Conversion of rows of values to polylines in pixels: interrupted at jumps, clipped to the panel, without invisible
//! points.
//!
//! Points are left out in two ways. If many points of ascending data share a column of pixels, only the first, the lowest,
//! the highest and the last are kept (M4 aggregation of Jugel and others, 2014). Of points along a nearly straight line
//! only the ends are kept (sleeve algorithm of Zhao and Saalfeld, 1997): no point left out is farther than `TOLERANCE` from
//! the line drawn.

use std::ops::Range;

use crate::items::{Entry, Ink, Rect, Stroke};

/// Maximum distance of a line from a point left out, pixels.
const TOLERANCE: f32 = 0.2;

/// Draws lines into the buffers of a figure, one after the other.
pub(crate) struct Tracer<'a> {
    points: &'a mut Vec<f32>,
    entries: &'a mut Vec<Entry>,
    area: Rect,
    stroke: Stroke,
    /// Index in `points` where the current polyline begins.
    start: usize,
    /// Previous point, inside the area or not.
    previous: Option<(f32, f32)>,
    /// Latest point of the polyline, not drawn yet.
    held: Option<(f32, f32)>,
    /// Range of directions from the last point drawn in which the line can continue straight: right and left end.
    sleeve: Option<((f32, f32), (f32, f32))>,
    /// Greatest distance of the line from the last point drawn, pixels.
    reach: f32,
    column: Option<PixelColumn>,
}

/// Points kept of one column of pixels.
struct PixelColumn {
    number: i32,
    /// Number of points after the first.
    count: u32,
    /// Index in the column, x and y of the point with the least y; `highest` and `last` likewise.
    lowest: (u32, f32, f32),
    highest: (u32, f32, f32),
    last: (u32, f32, f32),
}

impl<'a> Tracer<'a> {
    pub(crate) fn new(points: &'a mut Vec<f32>, entries: &'a mut Vec<Entry>, area: Rect, stroke: Stroke) -> Tracer<'a> {
        let start = points.len();
        Tracer {
            points,
            entries,
            area,
            stroke,
            start,
            previous: None,
            held: None,
            sleeve: None,
            reach: 0.0,
            column: None,
        }
    }

    /// Takes the next point of a line with many points per column of pixels.
    pub(crate) fn dense(&mut self, x: f32, y: f32) {
        // Rounds towards zero: two columns left of the figure, where nothing is drawn, count as one.
        let number = x as i32;
        match &mut self.column {
            Some(column) if column.number == number => {
                column.count += 1;
                let point = (column.count, x, y);
                if y < column.lowest.2 {
                    column.lowest = point;
                }
                if y > column.highest.2 {
                    column.highest = point;
                }
                column.last = point;
            }
            _ => {
                self.flush_column();
                let point = (0, x, y);
                self.column = Some(PixelColumn { number, count: 0, lowest: point, highest: point, last: point });
                self.line_to(x, y);
            }
        }
    }

    /// Draws the points kept of a column, in their original order.
    fn flush_column(&mut self) {
        let Some(PixelColumn { lowest, highest, last, .. }) = self.column.take() else {
            return;
        };
        let (one, two) = if lowest.0 < highest.0 { (lowest, highest) } else { (highest, lowest) };
        let mut drawn = 0;
        for (place, x, y) in [one, two, last] {
            if place > drawn {
                self.line_to(x, y);
                drawn = place;
            }
        }
    }

    /// Takes the next point of a line.
    pub(crate) fn line_to(&mut self, x: f32, y: f32) {
        let from = self.previous.replace((x, y));
        let inside = self.contains(x, y);
        match from {
            None if inside => self.continue_to((x, y)),
            None => {}
            Some(from) if inside && self.contains(from.0, from.1) => self.continue_to((x, y)),
            Some(from) => self.cross(from, (x, y), inside),
        }
    }

    /// Ends the line; the next point begins a new one.
    pub(crate) fn interrupt(&mut self) {
        self.flush_column();
        self.previous = None;
        self.finish_polyline();
    }

    fn contains(&self, x: f32, y: f32) -> bool {
        let area = self.area;
        x >= area.x && x <= area.x + area.width && y >= area.y && y <= area.y + area.height
    }

    /// Draws the part of a segment inside the area (Liang-Barsky clipping).
    fn cross(&mut self, from: (f32, f32), to: (f32, f32), ends_inside: bool) {
        let area = self.area;
        let (x, y) = (f64::from(from.0), f64::from(from.1));
        let (dx, dy) = (f64::from(to.0) - x, f64::from(to.1) - y);
        let (left, top) = (f64::from(area.x), f64::from(area.y));
        let (right, bottom) = (left + f64::from(area.width), top + f64::from(area.height));
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for (direction, distance) in [(-dx, x - left), (dx, right - x), (-dy, y - top), (dy, bottom - y)] {
            if direction == 0.0 {
                if distance < 0.0 {
                    enter = 2.0;
                }
            } else if direction < 0.0 {
                enter = enter.max(distance / direction);
            } else {
                leave = leave.min(distance / direction);
            }
        }
        if enter <= leave {
            let at = |part: f64| ((x + part * dx).clamp(left, right) as f32, (y + part * dy).clamp(top, bottom) as f32);
            if enter > 0.0 {
                self.finish_polyline();
                self.continue_to(at(enter));
            }
            self.continue_to(if ends_inside { to } else { at(leave) });
        }
        if !ends_inside {
            self.finish_polyline();
        }
    }

    /// Continues the polyline to a point inside the area. The held point is left out if the line passes close to it.
    fn continue_to(&mut self, point: (f32, f32)) {
        if self.points.len() == self.start {
            self.points.extend([point.0, point.1]);
            return;
        }
        let drawn = self.points.len();
        let anchor = (self.points[drawn - 2], self.points[drawn - 1]);
        let (dx, dy) = (point.0 - anchor.0, point.1 - anchor.1);
        let distance = (dx * dx + dy * dy).sqrt();
        if let (Some(held), Some((right, left))) = (self.held, self.sleeve)
            && (cross(right, (dx, dy)) < 0.0 || cross(left, (dx, dy)) > 0.0 || distance < self.reach - TOLERANCE)
        {
            self.points.extend([held.0, held.1]);
            self.held = None;
            self.sleeve = None;
            self.reach = 0.0;
            self.continue_to(point);
            return;
        }
        self.held = Some(point);
        self.reach = self.reach.max(distance);
        // A point within the tolerance restricts no direction.
        if distance > TOLERANCE {
            let ratio = TOLERANCE / distance;
            let (across_x, across_y) = (-dy * ratio, dx * ratio);
            let own = ((dx - across_x, dy - across_y), (dx + across_x, dy + across_y));
            self.sleeve = Some(match self.sleeve {
                None => own,
                Some((right, left)) => (
                    if cross(right, own.0) > 0.0 { own.0 } else { right },
                    if cross(left, own.1) < 0.0 { own.1 } else { left },
                ),
            });
        }
    }

    fn finish_polyline(&mut self) {
        if let Some(held) = self.held.take() {
            self.points.extend([held.0, held.1]);
        }
        self.sleeve = None;
        self.reach = 0.0;
        let range = self.start..self.points.len();
        self.start = self.points.len();
        match range.len() {
            0 => {}
            // A single row between two that cannot be drawn becomes a dot.
            2 => {
                let (radius, ink) = (self.stroke.width * 0.75, self.stroke.ink);
                self.entries.push(Entry::Dots { centres: range, radius, ink, ringed: false });
            }
            _ => self.entries.push(Entry::Polyline(range, self.stroke)),
        }
    }
}

/// Cross product: positive if the second direction is counter-clockwise of the first, in the sense from x to y.
fn cross(one: (f32, f32), two: (f32, f32)) -> f32 {
    one.0 * two.1 - one.1 * two.0
}

/// Adds the centres of separate points inside the area. Points that nearly coincide with the previous one are left out.
pub(crate) fn scatter(
    points: &mut Vec<f32>,
    entries: &mut Vec<Entry>,
    area: Rect,
    ink: Ink,
    radius: f32,
    pixels: impl Iterator<Item = (f32, f32)>,
) {
    let start = points.len();
    let mut last = (f32::NEG_INFINITY, f32::NEG_INFINITY);
    for (x, y) in pixels {
        let inside = area.contains(crate::items::Point { x, y });
        let coincides = (x - last.0).abs() < TOLERANCE && (y - last.1).abs() < TOLERANCE;
        if inside && !coincides {
            points.extend([x, y]);
            last = (x, y);
        }
    }
    let centres: Range<usize> = start..points.len();
    if !centres.is_empty() {
        entries.push(Entry::Dots { centres, radius, ink, ringed: false });
    }
}

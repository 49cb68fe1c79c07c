//! Raster of a panel: the pixels that contain a point of a long series, kept from frame to frame.

use crate::items::{Rect, Scale};
use crate::limits::{Progressive, drawable};
use crate::plot::Series;

/// Data kept of a series with a version.
#[derive(Clone, Debug, Default)]
pub(crate) struct Cloud {
    pub version: u64,
    pub x: Progressive,
    pub y: Progressive,
    pub raster: Option<Raster>,
}

/// The pixels of a panel that contain a point.
#[derive(Clone, Debug)]
pub(crate) struct Raster {
    pub x: Scale,
    pub y: Scale,
    pub panel: Rect,
    /// First row examined, and next row to examine.
    pub first: usize,
    pub next: usize,
    rows: usize,
    /// True if the series has not been drawn completely before.
    pub is_new: bool,
    /// One bit per pixel, column by column; each column begins with a new word.
    cells: Vec<u64>,
    /// Upper and lower end of the points in each column, in pixels below the upper edge of the panel.
    ends: Vec<(f32, f32)>,
}

impl Cloud {
    /// The kept data of the series of this version, created if missing.
    pub fn of(clouds: &mut Vec<Self>, version: u64) -> &mut Self {
        let place = clouds.iter().position(|cloud| cloud.version == version).unwrap_or_else(|| {
            clouds.push(Self { version, ..Self::default() });
            clouds.len() - 1
        });
        &mut clouds[place]
    }
}

impl Raster {
    /// An empty raster for the rows from `first` on.
    pub fn new(x: Scale, y: Scale, panel: Rect, first: usize) -> Self {
        let pixels = |length: f32| libm::ceilf(length.clamp(1.0, 1e5)) as usize;
        let (columns, rows) = (pixels(panel.width), pixels(panel.height));
        let words = rows.div_ceil(64);
        Self {
            x,
            y,
            panel,
            first,
            next: first,
            rows,
            is_new: false,
            cells: vec![0; columns * words],
            ends: vec![(f32::INFINITY, f32::NEG_INFINITY); columns],
        }
    }

    /// Marks the pixels of the points up to row `end`, exclusive.
    pub fn take(&mut self, series: &Series<'_>, end: usize) {
        let panel = self.panel;
        let words = self.rows.div_ceil(64);
        let (x_factor, y_factor) = (self.x.factor(), self.y.factor());
        let (x_start, y_start) = (self.x.low - f64::from(panel.x), self.y.low - f64::from(panel.y));
        let (width, height) = (f64::from(panel.width), f64::from(panel.height));
        let points = series.x.iter().zip(series.y).take(end).skip(self.next);
        for (&value_x, &value_y) in points {
            let across = x_start + (value_x - self.x.values.low) * x_factor;
            let down = y_start + (value_y - self.y.values.low) * y_factor;
            // Also false for NaN.
            let inside = across >= -0.5 && across <= width + 0.5 && down >= -0.5 && down <= height + 0.5;
            if !inside || !drawable(value_x) || !drawable(value_y) {
                continue;
            }
            // A point up to half a pixel outside becomes 0.
            let column = (across as usize).min(self.ends.len() - 1);
            let row = (down as usize).min(self.rows - 1);
            self.cells[column * words + row / 64] |= 1 << (row % 64);
            let ends = &mut self.ends[column];
            // In WebAssembly, `min` and `max` of floats are function calls, too slow for a million points.
            let down = down as f32;
            if down < ends.0 {
                ends.0 = down;
            }
            if down > ends.1 {
                ends.1 = down;
            }
        }
        self.next = self.next.max(end);
    }

    /// Appends the bars, three numbers each: x, upper end, lower end. The dots have this radius in pixels.
    pub fn bars(&self, radius: f32, out: &mut Vec<f32>) {
        let words = self.rows.div_ceil(64);
        // Distance below which dots overlap.
        let apart = libm::ceilf(2.0 * radius) as usize;
        for (number, (column, ends)) in self.cells.chunks_exact(words).zip(&self.ends).enumerate() {
            let across = self.panel.x + number as f32 + 0.5;
            let first = out.len();
            let mut last: Option<usize> = None;
            for (place, mut word) in column.iter().copied().enumerate() {
                while word != 0 {
                    let row = 64 * place + word.trailing_zeros() as usize;
                    word &= word - 1;
                    let down = self.panel.y + row as f32 + 0.5;
                    match out.last_mut() {
                        Some(lower) if last.is_some_and(|last| row - last <= apart) => *lower = down,
                        _ => out.extend([across, down, down]),
                    }
                    last = Some(row);
                }
            }
            if last.is_some() {
                // A bar of one pixel keeps its ends in order.
                let (upper, lower) = (self.panel.y + ends.0, self.panel.y + ends.1);
                let end = out.len() - 1;
                (out[first + 1], out[first + 2]) = (upper, out[first + 2].max(upper));
                (out[end - 1], out[end]) = (out[end - 1].min(lower), lower);
            }
        }
    }
}

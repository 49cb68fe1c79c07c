//! Many separate points as the few marks that pixels can show, and what of that can be kept from frame to frame.
//!
//! The panel is divided into cells of one pixel. Points that share a cell are one mark, marks in a column of pixels whose
//! dots overlap are one upright bar. The first and the last bar of a column end exactly at its lowest and highest point, so
//! that no extreme is lost. A frame costs as much as the panel has pixels, however many points there are; points that are
//! added cost as much as they are.

use crate::figure::{Entry, Figure, Ink, Rect, Scale};
use crate::limits::{Extent, Progressive, drawable};
use crate::plot::{Plot, Series};
use crate::series::{DATA_RADIUS, visible_rows};

/// So many points for each column of pixels are drawn one by one; more are drawn as bars.
const FEW_PER_COLUMN: f32 = 4.0;

/// So many points are marked in one layout when a series is new, a part of a frame; the next layout goes on. When its scales
/// change later, under somebody's finger, all are marked at once: better late than in part.
const SLICE: usize = 250_000;

/// No screen has more pixels; a figure may be asked for that has.
const MOST_PIXELS: f32 = 4e7;

/// What is kept of a series that is known by its version.
#[derive(Clone, Debug, Default)]
pub(crate) struct Cloud {
    version: u64,
    x: Progressive,
    y: Progressive,
    raster: Option<Raster>,
}

/// Which pixels of a panel hold a point.
#[derive(Clone, Debug)]
struct Raster {
    x: Scale,
    y: Scale,
    panel: Rect,
    /// The first row that was looked at, and the next one to be.
    first: usize,
    next: usize,
    rows: usize,
    /// Whether the series has not been drawn before.
    is_new: bool,
    /// A bit for each pixel, column by column; each column begins with a word of its own.
    cells: Vec<u64>,
    /// The highest and the lowest point of each column, in pixels from above.
    ends: Vec<(f32, f32)>,
}

impl Cloud {
    /// What is known of a series, and keeps what it learns.
    fn of(clouds: &mut Vec<Self>, version: u64) -> &mut Self {
        let place = clouds.iter().position(|cloud| cloud.version == version).unwrap_or_else(|| {
            clouds.push(Self { version, ..Self::default() });
            clouds.len() - 1
        });
        &mut clouds[place]
    }
}

impl Figure {
    /// Forgets series that the plot does not have any more.
    pub(crate) fn forget_clouds(&mut self, plot: &Plot<'_>) {
        self.clouds.retain(|cloud| plot.series.iter().any(|series| series.version == cloud.version));
    }

    /// The extent of the abscissas of a series.
    pub(crate) fn extent_across(&mut self, series: &Series<'_>) -> Extent {
        match series.version {
            0 => Extent::of(series.x),
            version => Cloud::of(&mut self.clouds, version).x.of(series.x),
        }
    }

    /// The extent of its ordinates.
    pub(crate) fn extent_up(&mut self, series: &Series<'_>) -> Extent {
        match series.version {
            0 => Extent::of(series.y),
            version => Cloud::of(&mut self.clouds, version).y.of(series.y),
        }
    }

    /// Draws a series of points as bars if it has too many to be drawn one by one. Whether it was drawn.
    pub(crate) fn cloud(&mut self, plot: &Plot<'_>, series: &Series<'_>, x: &Scale, y: &Scale) -> bool {
        let rows = visible_rows(plot, series, x);
        let panel = self.panel;
        if (rows.len() as f32) < FEW_PER_COLUMN * panel.width || panel.width * panel.height > MOST_PIXELS {
            return false;
        }
        let mut other = None;
        let kept = match series.version {
            0 => &mut other,
            version => &mut Cloud::of(&mut self.clouds, version).raster,
        };
        let same = kept.as_ref().is_some_and(|raster| {
            (raster.x, raster.y, raster.panel, raster.first) == (*x, *y, panel, rows.start) && raster.next <= rows.end
        });
        if !same {
            let is_new = kept.as_ref().is_none_or(|raster| raster.is_new && raster.next < rows.end);
            *kept = Some(Raster { is_new, ..Raster::new(*x, *y, panel, rows.start) });
        }
        if let Some(raster) = kept {
            let in_slices = series.version != 0 && raster.is_new;
            let end = if in_slices { rows.end.min(raster.next + SLICE) } else { rows.end };
            self.unfinished |= end < rows.end;
            raster.take(series, end);
            let start = self.points.len();
            raster.bars(&mut self.points);
            let (bars, ink) = (start..self.points.len(), Ink::Series(series.colour));
            self.entries.push(Entry::Bars { bars, radius: DATA_RADIUS, ink });
        }
        true
    }
}

impl Raster {
    fn new(x: Scale, y: Scale, panel: Rect, first: usize) -> Self {
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

    /// Marks the pixels of the points up to a row.
    fn take(&mut self, series: &Series<'_>, end: usize) {
        let panel = self.panel;
        let words = self.rows.div_ceil(64);
        let (x_factor, y_factor) = (self.x.factor(), self.y.factor());
        let (x_start, y_start) = (self.x.low - f64::from(panel.x), self.y.low - f64::from(panel.y));
        let (width, height) = (f64::from(panel.width), f64::from(panel.height));
        let points = series.x.iter().zip(series.y).take(end).skip(self.next);
        for (&value_x, &value_y) in points {
            let across = x_start + (value_x - self.x.values.low) * x_factor;
            let down = y_start + (value_y - self.y.values.low) * y_factor;
            // False for what is not a number, too.
            let inside = across >= -0.5 && across <= width + 0.5 && down >= -0.5 && down <= height + 0.5;
            if !inside || !drawable(value_x) || !drawable(value_y) {
                continue;
            }
            // What lies half a pixel outside becomes 0.
            let column = (across as usize).min(self.ends.len() - 1);
            let row = (down as usize).min(self.rows - 1);
            self.cells[column * words + row / 64] |= 1 << (row % 64);
            let ends = &mut self.ends[column];
            // In WebAssembly `min` and `max` of floats are calls, too dear for a million points.
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

    /// Appends the bars: abscissa, upper and lower end of each.
    fn bars(&self, out: &mut Vec<f32>) {
        let words = self.rows.div_ceil(64);
        // Dots nearer than this overlap.
        let apart = libm::ceilf(2.0 * DATA_RADIUS) as usize;
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

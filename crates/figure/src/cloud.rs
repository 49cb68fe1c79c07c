//! Clouds: many separate points reduced to the marks that pixels can show, partly kept from frame to frame.
//!
//! The panel is divided into cells of one pixel. Points in the same cell are one mark; marks in a column of pixels whose
//! dots overlap are one vertical bar. The first and the last bar of a column end exactly at its highest and lowest point,
//! so that no extreme is lost. The work per frame is proportional to the number of pixels of the panel, plus the number of
//! new points.

use crate::figure::Figure;
use crate::items::{Entry, Ink, Scale};
use crate::limits::Extent;
use crate::plot::{Plot, Series};
use crate::raster::{Cloud, Raster};
use crate::series::{radius, visible_rows};

/// Maximum number of points per column of pixels drawn one by one; more are drawn as bars.
const FEW_PER_COLUMN: f32 = 4.0;

/// Maximum number of points of a new series marked per layout; the next layout continues. When scales change later, during
/// a gesture, all points are marked at once: a delay is better than an incomplete picture.
const SLICE: usize = 250_000;

/// Maximum area of the panel, in pixels, for bars. No screen is larger, but a larger figure can be requested.
const MOST_PIXELS: f32 = 4e7;

impl Figure {
    /// Drops the data of series that the plot no longer has.
    pub(crate) fn forget_clouds(&mut self, plot: &Plot<'_>) {
        self.clouds.retain(|cloud| plot.series.iter().any(|series| series.version == cloud.version));
    }

    /// Extent of the horizontal values of a series.
    pub(crate) fn extent_across(&mut self, series: &Series<'_>) -> Extent {
        match series.version {
            0 => Extent::of(series.x),
            version => Cloud::of(&mut self.clouds, version).x.of(series.x),
        }
    }

    /// Extent of the vertical values of a series.
    pub(crate) fn extent_up(&mut self, series: &Series<'_>) -> Extent {
        match series.version {
            0 => Extent::of(series.y),
            version => Cloud::of(&mut self.clouds, version).y.of(series.y),
        }
    }

    /// Draws a series of points as bars if it has too many to be drawn one by one. True if it was drawn.
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
            let mut raster = Raster::new(*x, *y, panel, rows.start);
            raster.is_new = is_new;
            *kept = Some(raster);
        }
        if let Some(raster) = kept {
            let in_slices = series.version != 0 && raster.is_new;
            let end = if in_slices { rows.end.min(raster.next + SLICE) } else { rows.end };
            self.unfinished |= end < rows.end;
            raster.take(series, end);
            let start = self.points.len();
            let radius = radius(series, rows.len());
            raster.bars(radius, &mut self.points);
            let (bars, ink) = (start..self.points.len(), Ink::Series(series.colour));
            self.entries.push(Entry::Bars { bars, radius, ink });
        }
        true
    }
}

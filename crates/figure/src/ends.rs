//! Names at the ends of curves.

use crate::figure::Figure;
use crate::items::{Anchor, Ink, Scale, Stroke};
use crate::layout::{LABEL, point};
use crate::plot::{Plot, Series};
use crate::series::{stroke, visible_rows};
use crate::text::fitted;

/// Greatest part of the width of the panel that a name takes.
const WIDEST: f64 = 0.4;
/// Distance of baselines, and height of a name above its curve, in font sizes.
const LINE: f64 = 1.15;
const ABOVE: f64 = 0.35;

impl Figure {
    /// Writes the names of series ([`Series::end`]) above their last visible points, one below the other where they would
    /// overlap.
    pub(crate) fn ends(&mut self, plot: &Plot<'_>) {
        let Some(x) = self.x else { return };
        let size = LABEL * self.font_size;
        let last = |series: &&Series<'_>| -> Option<[f64; 2]> {
            let y = self.y.get(series.axis)?;
            let is_visible = |row: &usize| x.shows(series.x[*row]) && y.shows(series.y[*row]);
            let row = visible_rows(plot, series, &x).rev().find(is_visible)?;
            Some([x.pixel(series.x[row]), y.pixel(series.y[row]) - ABOVE * size])
        };
        let named = plot.series.iter().filter(|series| !series.end.is_empty());
        let mut names: Vec<([f64; 2], &Series<'_>)> = named.filter_map(|one| Some((last(&one)?, one))).collect();
        names.sort_by(|([_, one], _), ([_, other], _)| one.total_cmp(other));
        let (top, bottom) = (f64::from(self.panel.y), f64::from(self.panel.y + self.panel.height));
        let mut lowest = top;
        for ([_, baseline], _) in &mut names {
            *baseline = baseline.max(lowest + LINE * size);
            lowest = *baseline;
        }
        let mut highest = bottom + (LINE - ABOVE) * size;
        for ([_, baseline], _) in names.iter_mut().rev() {
            *baseline = baseline.min(highest - LINE * size);
            highest = *baseline;
        }
        let room = WIDEST * f64::from(self.panel.width);
        for ([across, baseline], series) in names {
            let Stroke { ink, .. } = stroke(series);
            self.end(&fitted(series.end, size, room), [across, baseline], size, ink, x);
        }
    }

    /// Writes a name that ends at a point; begins there if it would leave the panel.
    fn end(&mut self, name: &str, [across, baseline]: [f64; 2], size: f64, ink: Ink, x: Scale) {
        let anchor = if across - crate::text::width(name, size) < x.low { Anchor::Start } else { Anchor::End };
        let start = self.text.len();
        self.text.push_str(name);
        self.push_written(start, point(across, baseline), anchor, size, false, ink);
    }
}

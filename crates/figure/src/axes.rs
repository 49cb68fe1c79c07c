//! Axes of a figure: grid, lines, ticks, labels and titles.

use crate::figure::Figure;
use crate::items::{Anchor, Dash, Entry, Ink, Point, Stroke, crisp};
use crate::layout::{GAP, LABEL, ROW, TICK, point};
use crate::plot::{Axis, Plot};
use crate::text::width;
use crate::ticks::Ticks;

impl Figure {
    /// Draws the grid; the left vertical axis determines its horizontal lines.
    pub(crate) fn grid(&mut self, x_ticks: &Ticks) {
        let panel = self.panel;
        let rule = |ink| Stroke { ink, width: 1.0, dash: Dash::Solid };
        let (right, bottom) = (panel.x + panel.width, panel.y + panel.height);
        let mut zeros: Vec<(Point, Point)> = Vec::new();
        if let Some(x) = self.x {
            for (number, value) in x_ticks.iter() {
                let pixel = crisp(x.pixel(value));
                let ends = (Point { x: pixel, y: panel.y }, Point { x: pixel, y: bottom });
                if number == 0 && value != x.values.low {
                    zeros.push(ends);
                } else {
                    self.entries.push(Entry::Line(ends.0, ends.1, rule(Ink::Grid)));
                }
            }
        }
        if let (Some(y), Some(ticks)) = (self.y.first(), self.y_ticks.first()) {
            for (number, value) in ticks.iter() {
                let pixel = crisp(y.pixel(value));
                let ends = (Point { x: panel.x, y: pixel }, Point { x: right, y: pixel });
                if number == 0 && value != y.values.low {
                    zeros.push(ends);
                } else {
                    self.entries.push(Entry::Line(ends.0, ends.1, rule(Ink::Grid)));
                }
            }
        }
        for (from, to) in zeros {
            self.entries.push(Entry::Line(from, to, rule(Ink::Zero)));
        }
    }

    /// Draws the titles of all axes, before the labels of the ticks, so that a painter changes its font only once.
    pub(crate) fn axis_titles(&mut self, plot: &Plot<'_>, x_ticks: &Ticks, gutters: &[f64], rows: f64) {
        let font = self.font_size;
        let panel = self.panel;
        let start = self.text.len();
        self.write_name(&plot.x, f64::from(panel.width));
        x_ticks.write_title(&mut self.text, plot.x.label, plot.x.unit);
        let at = point(
            f64::from(panel.x + panel.width / 2.0),
            f64::from(panel.y + panel.height) + TICK + (1.15 * LABEL + 1.25) * font,
        );
        self.push_written(start, at, Anchor::Middle, font, false, Ink::Text);

        let baseline = f64::from(panel.y) - 0.7 * font;
        let mut right = f64::from(panel.x + panel.width);
        for (index, axis) in plot.y.iter().enumerate().take(self.y.len()) {
            let start = self.text.len();
            let several = self.y.len() > 1;
            if !several {
                self.write_name(axis, self.width - 2.0 * GAP * font);
            }
            self.y_ticks[index].write_title(&mut self.text, axis.label, axis.unit);
            let ink = if several { axis_ink(plot, index) } else { Ink::Text };
            let (at, anchor) = if index == 0 {
                let raised = if rows > 1.0 { ROW * font } else { 0.0 };
                (point(GAP * font, baseline - raised), Anchor::Start)
            } else {
                right += gutters[index];
                (point(right, baseline), Anchor::End)
            };
            self.push_written(start, at, anchor, font, false, ink);
        }
    }

    /// Writes the name of an axis before its label, if the title is not longer than this, in pixels.
    fn write_name(&mut self, axis: &Axis<'_>, most: f64) {
        let room = most - self.axis_title_width(axis);
        if !axis.name.is_empty() && width(axis.name, self.font_size) <= room {
            self.text.push_str(axis.name);
            self.text.push(' ');
        }
    }

    /// Draws the horizontal axis: line, ticks, labels.
    pub(crate) fn horizontal_axis(&mut self, ticks: &Ticks) {
        let Some(scale) = self.x else { return };
        let (font, style) = (self.font_size, self.style);
        let small = LABEL * font;
        let axis = Stroke { ink: Ink::Axis, width: 1.0, dash: Dash::Solid };
        let panel = self.panel;
        let base = crisp(f64::from(panel.y + panel.height));
        let ends = (Point { x: panel.x, y: base }, Point { x: panel.x + panel.width, y: base });
        self.entries.push(Entry::Line(ends.0, ends.1, axis));
        let baseline = f64::from(base) + TICK + 1.15 * small;
        let mut free_from = f64::NEG_INFINITY;
        for (number, value) in ticks.iter() {
            let pixel = scale.pixel(value);
            let (from, to) = (
                point(f64::from(crisp(pixel)), f64::from(base)),
                point(f64::from(crisp(pixel)), f64::from(base) + TICK),
            );
            self.entries.push(Entry::Line(from, to, axis));
            let start = self.text.len();
            ticks.write_label(&mut self.text, number, style);
            let half = width(&self.text[start..], small) / 2.0;
            // The outermost labels are kept inside the figure. A label that would touch its neighbour is left out.
            let centre = pixel.clamp(half.min(self.width / 2.0), (self.width - half).max(self.width / 2.0));
            if centre - half >= free_from {
                free_from = centre + half + 0.3 * font;
                self.push_written(start, point(centre, baseline), Anchor::Middle, small, false, Ink::Text);
            } else {
                self.text.truncate(start);
            }
        }
    }

    /// Draws the vertical axes: lines, ticks, labels.
    pub(crate) fn vertical_axes(&mut self, gutters: &[f64]) {
        let (font, style) = (self.font_size, self.style);
        let small = LABEL * font;
        let rule = Stroke { ink: Ink::Axis, width: 1.0, dash: Dash::Solid };
        let panel = self.panel;
        let mut place = f64::from(panel.x);
        for index in 0..self.y.len() {
            let (scale, ticks) = (self.y[index], self.y_ticks[index]);
            let outward = if index == 0 { -1.0 } else { 1.0 };
            if index == 1 {
                place = f64::from(panel.x + panel.width);
            } else if index > 1 {
                place += gutters[index - 1];
            }
            let line = f64::from(crisp(place));
            self.entries.push(Entry::Line(point(line, scale.high), point(line, scale.low), rule));
            let anchor = if index == 0 { Anchor::End } else { Anchor::Start };
            for (number, value) in ticks.iter() {
                let pixel = scale.pixel(value);
                let level = f64::from(crisp(pixel));
                self.entries.push(Entry::Line(point(line, level), point(line + outward * TICK, level), rule));
                let start = self.text.len();
                ticks.write_label(&mut self.text, number, style);
                let at = point(line + outward * (TICK + 0.3 * font), pixel + 0.35 * small);
                self.push_written(start, at, anchor, small, false, Ink::Text);
            }
        }
    }
}

/// Colour of the title of an axis: that of its series if they have the same one.
fn axis_ink(plot: &Plot<'_>, axis: usize) -> Ink {
    let mut colours = plot.series.iter().filter(|series| series.axis == axis).map(|series| series.colour);
    match colours.next() {
        Some(first) if colours.all(|colour| colour == first) => Ink::Series(first),
        _ => Ink::Text,
    }
}

//! Layout of a plot as a figure: space for texts, limits, ticks and series.

use crate::figure::Figure;
use crate::items::{Anchor, DATA_RADIUS, Entry, Ink, Point, Rect, Scale};
use crate::limits::{Extent, growing, sane, shared_limits};
use crate::plot::{Axis, Interval, Plot, Series, Settings};
use crate::series::stroke;
use crate::spread;
use crate::text::{fitted, width};
use crate::ticks::Ticks;

/// Space at the edges and between texts, as a multiple of the font size.
pub(crate) const GAP: f64 = 0.5;
/// Height of a row of text, as a multiple of the font size.
pub(crate) const ROW: f64 = 1.45;
/// Size of the labels of ticks, as a multiple of the font size.
pub(crate) const LABEL: f64 = 0.92;
/// Length of a tick, pixels.
pub(crate) const TICK: f64 = 4.0;
/// Length of a line sample in the legend, as a multiple of the font size.
const SAMPLE: f64 = 2.2;
/// Space between line sample and name, and after the name, as multiples of the font size.
const BEFORE: f64 = 0.5;
const AFTER: f64 = 0.9;
/// Minimum size of a panel, pixels; smaller ones are not drawn.
const LEAST_PANEL: f64 = 16.0;

/// Lays out a plot as a new figure.
pub fn layout(plot: &Plot<'_>, settings: &Settings) -> Figure {
    let mut figure = Figure::default();
    layout_into(&mut figure, plot, settings);
    while figure.is_unfinished() {
        layout_into(&mut figure, plot, settings);
    }
    figure
}

/// Lays out a plot in the buffers of an earlier figure. Series with very many points need several layouts, so that none
/// takes long ([`Figure::is_unfinished`]).
pub fn layout_into(figure: &mut Figure, plot: &Plot<'_>, settings: &Settings) {
    let size = |pixels: f64| {
        if pixels.is_finite() { pixels.clamp(0.0, 1e5) } else { 0.0 }
    };
    figure.width = size(settings.width);
    figure.height = size(settings.height);
    figure.font_size = if settings.font_size.is_finite() { settings.font_size.clamp(1.0, 1e3) } else { 13.0 };
    figure.style = units::number::Style::comma(settings.decimal_comma);
    figure.view.clone_from(&plot.view);
    figure.title.clear();
    figure.title.push_str(plot.title);
    figure.description.clear();
    figure.description.push_str(plot.description);
    figure.entries.clear();
    figure.points.clear();
    figure.text.clear();
    figure.x = None;
    figure.y.clear();
    figure.y_ticks.clear();
    figure.x_power = 0;
    figure.home_x = None;
    figure.home_y.clear();
    figure.panel = Rect::default();
    figure.unfinished = false;
    figure.level = settings.level;
    figure.is_level = false;
    figure.present = None;
    figure.forget_clouds(plot);
    let whole = Rect { x: 0.0, y: 0.0, width: figure.width as f32, height: figure.height as f32 };
    figure.entries.push(Entry::Fill(whole, Ink::Ground));
    if let Some(top) = figure.heading(plot) {
        figure.body(plot, top);
    }
}

impl Figure {
    /// Draws title and legend. Returns the height used; `None` if the figure is too small for a panel.
    fn heading(&mut self, plot: &Plot<'_>) -> Option<f64> {
        let font = self.font_size;
        let edge = GAP * font;
        if self.width < LEAST_PANEL + 4.0 * font || self.height < LEAST_PANEL + 4.0 * font {
            return None;
        }
        let title_size = 1.08 * font;
        let mut top = edge;
        let mut title_width = 0.0;
        if !plot.title.is_empty() {
            title_width = 1.1 * width(plot.title, title_size) + 2.0 * font;
            let at = point(edge, top + 1.05 * font);
            let title = fitted(plot.title, title_size * 1.1, self.width - 2.0 * edge);
            self.push_text(&title, at, Anchor::Start, title_size, true, Ink::Text);
            top += 1.15 * ROW * font;
        }
        let listed = || plot.series.iter().filter(|series| !series.label.is_empty());
        if listed().count() < 2 {
            return Some(top);
        }
        let entry_width = |series: &Series<'_>| (SAMPLE + BEFORE + AFTER) * font + width(series.label, font);
        let total: f64 = listed().map(entry_width).sum();
        let room = self.width - 2.0 * edge;
        // The legend is beside the title if there is room, in a figure without title between the titles of the axes,
        // otherwise in rows below.
        let free = self.between_axis_titles(plot).filter(|(from, to)| plot.title.is_empty() && total <= to - from);
        let (mut x, mut y) = if title_width > 0.0 && title_width + total <= room {
            (self.width - edge - total + AFTER * font, top - 1.15 * ROW * font)
        } else if let Some((from, to)) = free {
            ((from + to - total + AFTER * font) / 2.0, top + 0.05 * font)
        } else {
            (edge, top)
        };
        let beside = y < top || free.is_some();
        for series in listed() {
            let wide = entry_width(series);
            if !beside && x > edge && x + wide - AFTER * font > self.width - edge {
                (x, y) = (edge, y + ROW * font);
            }
            self.legend_entry(series, x, y + 1.05 * font);
            x += wide;
        }
        Some(if beside { top } else { y + ROW * font })
    }

    fn legend_entry(&mut self, series: &Series<'_>, x: f64, baseline: f64) {
        let font = self.font_size;
        let (from, to) = (point(x, baseline - 0.34 * font), point(x + SAMPLE * font, baseline - 0.34 * font));
        if series.style.is_of_points() {
            let start = self.points.len();
            self.points.extend([(from.x + to.x) / 2.0, from.y]);
            let centres = start..self.points.len();
            self.entries.push(Entry::Dots {
                centres,
                radius: DATA_RADIUS,
                ink: Ink::Series(series.colour),
                ringed: false,
            });
        } else {
            self.entries.push(Entry::Line(from, to, stroke(series)));
        }
        let from = x + (SAMPLE + BEFORE) * font;
        // One pixel of extra room, so that rounding does not cut a text that was found to fit.
        let label = fitted(series.label, font, self.width - GAP * font - from + 1.0);
        let at = point(from, baseline);
        self.push_text(&label, at, Anchor::Start, font, false, Ink::Text);
    }

    /// Draws the axes and the panel.
    fn body(&mut self, plot: &Plot<'_>, top: f64) {
        let font = self.font_size;
        let small = LABEL * font;
        let edge = GAP * font;
        let bottom = self.height - 2.0 * ROW * font - TICK;
        let title_rows = self.axis_title_rows(plot);
        let panel_top = top + title_rows * ROW * font + 0.35 * font;
        if bottom - panel_top < LEAST_PANEL {
            return;
        }
        self.vertical_scales(plot, panel_top, bottom);

        // The labels of the vertical axes determine the width of the panel.
        let mut gutters = Vec::with_capacity(self.y.len());
        for (index, ticks) in self.y_ticks.iter().enumerate() {
            let labels = ticks.widest_label(small, self.style);
            let mut gutter = labels + TICK + 0.4 * font;
            if index > 0 && index + 1 < plot.y.len() {
                gutter += font;
            }
            if index >= 2 {
                let mut title = String::new();
                let axis = &plot.y[index];
                ticks.write_title(&mut title, axis.label, axis.unit);
                gutter = gutter.max(width(&title, font) + font);
            }
            gutters.push(gutter);
        }
        let mut left = edge + gutters.first().copied().unwrap_or(0.0);
        let right = self.width - if gutters.len() > 1 { edge + gutters[1..].iter().sum::<f64>() } else { 1.3 * font };
        if right - left < LEAST_PANEL {
            self.y.clear();
            self.y_ticks.clear();
            return;
        }
        let mut x_ticks = self.horizontal_scale(plot, left, right);
        if plot.equal && self.y.len() == 1 {
            // Longer axes may need wider labels, which leave less space.
            let before = gutters[0];
            gutters[0] = self.even_out(left, right).widest_label(small, self.style) + TICK + 0.4 * font;
            left += gutters[0] - before;
            x_ticks = self.horizontal_scale(plot, left, right);
            self.even_out(left, right);
            x_ticks = self.ticks_across(right - left).unwrap_or(x_ticks);
        }
        self.panel = Rect {
            x: left as f32,
            y: panel_top as f32,
            width: (right - left) as f32,
            height: (bottom - panel_top) as f32,
        };
        self.x_power = x_ticks.power;
        // Bands are below the grid, which they would hide.
        for series in &plot.series {
            self.band(plot, series);
        }
        self.grid(&x_ticks);
        for series in &plot.series {
            self.trace(plot, series);
        }
        self.ends(plot);
        self.present(plot);
        self.axis_titles(plot, &x_ticks, &gutters, title_rows);
        self.horizontal_axis(&x_ticks);
        self.vertical_axes(&gutters);
    }

    /// Number of rows of axis titles above the panel: 1, or 2 if the left and right titles would meet.
    fn axis_title_rows(&self, plot: &Plot<'_>) -> f64 {
        let total: f64 = plot.y.iter().map(|axis| self.axis_title_width(axis)).sum();
        if plot.y.len() > 1 && total > self.width { 2.0 } else { 1.0 }
    }

    /// Free part of the row of axis titles, from left to right in pixels; `None` if it is full.
    fn between_axis_titles(&self, plot: &Plot<'_>) -> Option<(f64, f64)> {
        let edge = GAP * self.font_size;
        let (left, right) = plot.y.split_first()?;
        let right: f64 = right.iter().map(|axis| self.axis_title_width(axis)).sum();
        let (from, to) = (edge + self.axis_title_width(left), self.width - edge - right);
        (from < to).then_some((from, to))
    }

    /// Upper bound of the width of the title of a vertical axis, pixels. Includes space for a power of ten, which is not
    /// known yet.
    pub(crate) fn axis_title_width(&self, axis: &Axis<'_>) -> f64 {
        width(axis.label, self.font_size) + width(axis.unit, self.font_size) + 4.5 * self.font_size
    }

    /// Determines limits, scales and ticks of the vertical axes.
    fn vertical_scales(&mut self, plot: &Plot<'_>, top: f64, bottom: f64) {
        let least = 2.1 * self.font_size;
        let height = bottom - top;
        let intervals = libm::floor(height / least).clamp(2.0, 8.0) as usize;
        let extents: Vec<Extent> = (plot.y.iter().enumerate())
            .map(|(index, axis)| {
                if axis.only.is_some() {
                    return Extent::EMPTY.with(axis.only);
                }
                (plot.series.iter().filter(|series| series.axis == index))
                    .map(|series| self.extent_up(series).union(spread::extent(series)))
                    .fold(Extent::EMPTY, Extent::union)
                    .with(axis.include)
            })
            .collect();
        let of_drawing = self.level.filter(|_| !plot.equal && plot.view.is_automatic());
        let of_drawing = of_drawing.and_then(|level| level.limits(top, bottom)).filter(|limits| match extents[..] {
            [extent] => extent.is_within(*limits),
            _ => false,
        });
        self.is_level = of_drawing.is_some();
        for (index, limits) in shared_limits(&extents, intervals).into_iter().enumerate() {
            let home = of_drawing.unwrap_or(limits.values);
            let zoomed = plot.view.y.get(index);
            let values = zoomed.map_or(home, |limits| sane(*limits));
            // Several automatic axes keep the steps chosen so that one grid fits all.
            let ticks = if extents.len() > 1 && zoomed.is_none() {
                Ticks::within(values, limits.step)
            } else {
                Ticks::spaced(values, height, least, |_, spacing| spacing >= least * 0.75)
            };
            self.home_y.push(home);
            self.y.push(Scale { values, low: bottom, high: top });
            self.y_ticks.push(ticks);
        }
    }

    /// Determines limits, scale and ticks of the horizontal axis.
    fn horizontal_scale(&mut self, plot: &Plot<'_>, left: f64, right: f64) -> Ticks {
        let font = self.font_size;
        let mut extent = Extent::EMPTY.with(plot.x.include);
        if plot.x.only.is_some() {
            extent = Extent::EMPTY.with(plot.x.only);
        }
        for series in plot.series.iter().filter(|_| plot.x.only.is_none()) {
            extent = extent.union(if plot.ordered { Extent::of_ordered(series.x) } else { self.extent_across(series) });
        }
        let wide = right - left;
        let home = if plot.ordered && !plot.steady {
            growing(extent)
        } else {
            let intervals = libm::floor(wide / (4.0 * font)).clamp(2.0, 8.0) as usize;
            shared_limits(&[extent], intervals).first().map_or(Interval::new(-1.0, 1.0), |limits| limits.values)
        };
        self.home_x = Some(home);
        let values = plot.view.x.map_or(home, sane);
        self.x = Some(Scale { values, low: left, high: right });
        self.ticks_over(values, wide)
    }

    fn ticks_over(&self, values: Interval, wide: f64) -> Ticks {
        let (font, style) = (self.font_size, self.style);
        Ticks::spaced(values, wide, 4.0 * font, |ticks, spacing| {
            spacing >= 3.2 * font && spacing >= ticks.widest_label(LABEL * font, style) + font
        })
    }

    /// Ticks for the current horizontal scale.
    fn ticks_across(&self, wide: f64) -> Option<Ticks> {
        self.x.map(|scale| self.ticks_over(scale.values, wide))
    }

    /// Makes both scales equal, in pixels per unit, by extending the limits of one axis. Returns the ticks of the vertical
    /// axis.
    fn even_out(&mut self, left: f64, right: f64) -> Ticks {
        let least = 2.1 * self.font_size;
        if let (Some(x), Some(y)) = (&mut self.x, self.y.first_mut()) {
            let (wide, high) = (right - left, y.low - y.high);
            let factor = (wide / x.values.length()).min(high / y.values.length());
            x.values = about_the_middle(x.values, wide / factor);
            y.values = about_the_middle(y.values, high / factor);
            let ticks = Ticks::spaced(y.values, high, least, |_, spacing| spacing >= least * 0.75);
            if let Some(place) = self.y_ticks.first_mut() {
                *place = ticks;
            }
            return ticks;
        }
        self.y_ticks.first().copied().unwrap_or_else(|| Ticks::spaced(Interval::new(0.0, 1.0), 1.0, least, |_, _| true))
    }

    fn push_text(&mut self, text: &str, at: Point, anchor: Anchor, size: f64, strong: bool, ink: Ink) {
        let start = self.text.len();
        self.text.push_str(text);
        self.push_written(start, at, anchor, size, strong, ink);
    }

    /// Adds an item for the text written to the buffer from `start` on.
    pub(crate) fn push_written(&mut self, start: usize, at: Point, anchor: Anchor, size: f64, strong: bool, ink: Ink) {
        let text = start..self.text.len();
        if !text.is_empty() {
            self.entries.push(Entry::Text { text, at, anchor, size: size as f32, strong, ink });
        }
    }
}

/// Interval of this length with the same centre.
fn about_the_middle(values: Interval, length: f64) -> Interval {
    let middle = values.low + values.length() / 2.0;
    Interval { low: middle - length / 2.0, high: middle + length / 2.0 }
}

pub(crate) fn point(x: f64, y: f64) -> Point {
    Point { x: x as f32, y: y as f32 }
}

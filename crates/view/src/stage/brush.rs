//! The brush: a selected part of the time axis, such as the part of a record to be fitted. In plots against time it
//! lies between two draggable lines; the rest is faint.

use crate::pieces::colours::Colours;
use figure::{Figure, Ink};
use js_sys::Array;
use units::Unit;
use web_sys::CanvasRenderingContext2d;

/// Begin and end of a selected part, SI; `None` for an open end.
pub type Part = [Option<f64>; 2];

/// Half of the length of a grip, in CSS pixels.
const GRIP: f64 = 14.0;

/// A selected part in a figure against time.
pub struct Brush<'a> {
    /// The selected part.
    pub part: Part,
    /// The figure.
    pub figure: &'a Figure,
    /// Unit of its horizontal axis.
    pub unit: &'a Unit,
}

impl Brush<'_> {
    /// Pixels of the two ends. An open end, or one outside the panel, lies at the edge of the panel.
    fn ends(&self) -> [f64; 2] {
        let edges = self.edges();
        let place = |end: usize| {
            let value = self.part[end].map(|value| self.unit.from_si(value));
            let pixel = value.and_then(|value| Some(self.figure.x_scale()?.pixel(value)));
            pixel.map_or(edges[end], |pixel| pixel.clamp(edges[0], edges[1]))
        };
        [place(0), place(1)]
    }

    fn edges(&self) -> [f64; 2] {
        let panel = self.figure.panel;
        [f64::from(panel.x), f64::from(panel.x + panel.width)]
    }

    /// Index of the end grabbed at pixel `x`, within `reach` pixels; `None` if neither is.
    pub fn grabbed(&self, x: f64, reach: f64) -> Option<usize> {
        let [begin, end] = self.ends().map(|pixel| (pixel - x).abs());
        // If both ends coincide, the one that has room to move.
        let nearer = usize::from(end < begin || (end == begin && x > self.ends()[1]));
        (begin.min(end) <= reach).then_some(nearer)
    }

    /// The part with one end moved to pixel `x`, rounded to the resolution of a pixel. At the edge of the panel the end
    /// is open; the ends cannot pass each other.
    pub fn with_end(&self, end: usize, x: f64) -> Part {
        let ([left, right], ends) = (self.edges(), self.ends());
        let at_edge = if end == 0 { x <= left } else { x >= right };
        let x = if end == 0 { x.clamp(left, ends[1]) } else { x.clamp(ends[0], right) };
        let mut part = self.part;
        part[end] = match self.figure.x_scale() {
            Some(scale) if !at_edge => {
                let pixel = (scale.value(x + 1.0) - scale.value(x)).abs();
                // An integer divided by a power of ten is the double nearest to a short decimal.
                let fineness = libm::pow(10.0, -libm::floor(libm::log10(pixel)));
                Some(self.unit.to_si((scale.value(x) * fineness).round() / fineness)).filter(|value| value.is_finite())
            }
            _ => None,
        };
        part
    }

    /// Draws the brush over the figure.
    pub fn paint(&self, context: &CanvasRenderingContext2d, colours: &Colours) {
        let (panel, [begin, end], [left, right]) = (self.figure.panel, self.ends(), self.edges());
        let (top, height) = (f64::from(panel.y), f64::from(panel.height));
        context.set_fill_style_str(colours.of(Ink::Ground));
        context.set_global_alpha(0.7);
        context.fill_rect(left, top, begin - left, height);
        context.fill_rect(end, top, right - end, height);
        context.set_global_alpha(1.0);
        let _ = context.set_line_dash(&Array::new());
        context.set_line_cap("round");
        context.set_stroke_style_str(colours.of(Ink::Text));
        for x in [begin, end] {
            let middle = top + height / 2.0;
            for (width, from, to) in [(1.0, top, top + height), (5.0, middle - GRIP, middle + GRIP)] {
                context.set_line_width(width);
                context.begin_path();
                context.move_to(x, from);
                context.line_to(x, to);
                context.stroke();
            }
        }
        context.set_line_cap("butt");
    }
}

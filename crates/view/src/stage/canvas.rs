//! Paints the display list of a figure on a canvas.

use crate::pieces::colours::Colours;
use figure::{Anchor, Dash, Figure, Ink, Item, Point, Readout, Stroke};
use js_sys::Array;
use units::alphabet::with_indices;
use web_sys::CanvasRenderingContext2d;

/// Font family of the figures.
const FACE: &str = "system-ui, -apple-system, 'Segoe UI', Roboto, 'Noto Sans', sans-serif";

/// Paints the whole figure; `scale` is the number of canvas pixels per figure pixel.
pub fn paint(context: &CanvasRenderingContext2d, figure: &Figure, colours: &Colours, scale: f64) {
    let _ = context.set_transform(scale, 0.0, 0.0, scale, 0.0, 0.0);
    context.set_line_join("round");
    context.set_line_cap("butt");
    let mut brush = Brush { context, colours, stroke: None, fill: None, font: None, anchor: None };
    for item in figure.items() {
        brush.paint(item);
    }
}

/// Paints rings around the samples of a read-out.
pub fn paint_readout(context: &CanvasRenderingContext2d, readout: &Readout, figure: &Figure, colours: &Colours) {
    context.set_line_width(2.0);
    let _ = context.set_line_dash(&Array::new());
    let panel = figure.panel;
    if let [_, _, ..] = readout.samples.as_slice()
        && let Some(sample) = readout.samples.first()
    {
        context.set_stroke_style_str(colours.of(Ink::Marker));
        context.set_line_width(1.0);
        let x = f64::from(sample.at.x).round() + 0.5;
        context.begin_path();
        context.move_to(x, f64::from(panel.y));
        context.line_to(x, f64::from(panel.y + panel.height));
        context.stroke();
        context.set_line_width(2.0);
    }
    for sample in &readout.samples {
        context.begin_path();
        let _ = context.arc(f64::from(sample.at.x), f64::from(sample.at.y), 5.0, 0.0, std::f64::consts::TAU);
        context.set_fill_style_str(colours.of(Ink::Ground));
        context.fill();
        context.set_stroke_style_str(colours.of(Ink::Text));
        context.stroke();
    }
}

/// Paints a pinned read-out: rings around its samples, and a line with its letter.
pub fn paint_pin(context: &CanvasRenderingContext2d, pin: &Readout, letter: &str, figure: &Figure, colours: &Colours) {
    let places = pin.samples.iter().filter_map(|sample| figure.place(sample.axis, sample.x, sample.y));
    let places: Vec<figure::Point> = places.collect();
    let Some(first) = places.first() else { return };
    let (x, panel) = (f64::from(first.x).round() + 0.5, figure.panel);
    context.set_stroke_style_str(colours.of(Ink::Text));
    context.set_line_width(1.0);
    let _ = context.set_line_dash(&Array::of2(&3.into(), &3.into()));
    context.begin_path();
    context.move_to(x, f64::from(panel.y));
    context.line_to(x, f64::from(panel.y + panel.height));
    context.stroke();
    let _ = context.set_line_dash(&Array::new());
    context.set_line_width(2.0);
    for place in &places {
        context.begin_path();
        let _ = context.arc(place.x.into(), place.y.into(), 4.0, 0.0, std::f64::consts::TAU);
        context.set_fill_style_str(colours.of(Ink::Ground));
        context.fill();
        context.stroke();
    }
    context.set_fill_style_str(colours.of(Ink::Text));
    context.set_font(&format!("600 12px {FACE}"));
    context.set_text_align("left");
    let _ = context.fill_text(letter, x + 4.0, f64::from(panel.y) + 12.0);
}

/// Paints the zoom rectangle.
pub fn paint_box(context: &CanvasRenderingContext2d, from: (f64, f64), to: (f64, f64), colours: &Colours) {
    let (x, y) = (from.0.min(to.0), from.1.min(to.1));
    let (width, height) = ((from.0 - to.0).abs(), (from.1 - to.1).abs());
    context.set_stroke_style_str(colours.of(Ink::Text));
    context.set_line_width(1.0);
    let _ = context.set_line_dash(&Array::of2(&4.into(), &3.into()));
    context.stroke_rect(x, y, width, height);
    context.set_fill_style_str(colours.of(Ink::Marker));
    context.set_global_alpha(0.12);
    context.fill_rect(x, y, width, height);
    context.set_global_alpha(1.0);
}

/// A canvas context with its last settings: setting a font or colour costs more than drawing a line.
struct Brush<'a> {
    context: &'a CanvasRenderingContext2d,
    colours: &'a Colours,
    stroke: Option<Stroke>,
    fill: Option<Ink>,
    font: Option<(f32, bool)>,
    anchor: Option<Anchor>,
}

impl Brush<'_> {
    fn paint(&mut self, item: Item<'_>) {
        let context = self.context;
        match item {
            Item::Fill(area, ink) => {
                self.fill(ink);
                context.fill_rect(area.x.into(), area.y.into(), area.width.into(), area.height.into());
            }
            Item::Line(from, to, stroke) => {
                self.stroke(stroke);
                context.begin_path();
                context.move_to(from.x.into(), from.y.into());
                context.line_to(to.x.into(), to.y.into());
                context.stroke();
            }
            Item::Polyline(points, stroke) => {
                self.stroke(stroke);
                context.begin_path();
                for point in points.chunks_exact(2) {
                    context.line_to(point[0].into(), point[1].into());
                }
                context.stroke();
            }
            Item::Area(points, ink) => {
                self.fill(ink);
                context.begin_path();
                for point in points.chunks_exact(2) {
                    context.line_to(point[0].into(), point[1].into());
                }
                context.fill();
            }
            Item::Dots { centres, radius, ink, ringed } => {
                for centre in centres.chunks_exact(2) {
                    if ringed {
                        self.disc(centre, radius + 2.0, Ink::Ground);
                    }
                    self.disc(centre, radius, ink);
                }
            }
            Item::Bars { bars, radius, ink } => {
                self.stroke(Stroke { ink, width: 2.0 * radius, dash: Dash::Solid });
                context.set_line_cap("round");
                context.begin_path();
                for bar in bars.chunks_exact(3) {
                    context.move_to(bar[0].into(), bar[1].into());
                    // A line of length zero would not be drawn.
                    context.line_to(bar[0].into(), bar[2].max(bar[1] + 0.01).into());
                }
                context.stroke();
                context.set_line_cap("butt");
            }
            Item::Text { text, at, anchor, size, strong, ink } => {
                self.fill(ink);
                if text.contains('_') {
                    self.text_with_indices(text, at, anchor, (size, strong));
                } else {
                    self.font(size, strong);
                    self.anchor(anchor);
                    let _ = context.fill_text(text, at.x.into(), at.y.into());
                }
            }
        }
    }

    /// Draws a text piece by piece, with smaller, lowered indices.
    fn text_with_indices(&mut self, text: &str, at: Point, anchor: Anchor, (size, strong): (f32, bool)) {
        let context = self.context;
        let mut pieces = Vec::new();
        let mut total = 0.0;
        for (piece, is_index) in with_indices(text) {
            self.font(if is_index { 0.75 * size } else { size }, strong);
            let width = context.measure_text(piece).map_or(0.0, |measure| measure.width());
            pieces.push((piece, is_index, total));
            total += width;
        }
        let begin = f64::from(at.x)
            - match anchor {
                Anchor::Start => 0.0,
                Anchor::Middle => total / 2.0,
                Anchor::End => total,
            };
        self.anchor(Anchor::Start);
        for (piece, is_index, offset) in pieces {
            self.font(if is_index { 0.75 * size } else { size }, strong);
            let below = if is_index { 0.225 * f64::from(size) } else { 0.0 };
            let _ = context.fill_text(piece, begin + offset, f64::from(at.y) + below);
        }
    }

    fn font(&mut self, size: f32, strong: bool) {
        if self.font != Some((size, strong)) {
            let weight = if strong { 600 } else { 400 };
            self.context.set_font(&format!("{weight} {size}px {FACE}"));
            self.font = Some((size, strong));
        }
    }

    fn anchor(&mut self, anchor: Anchor) {
        if self.anchor != Some(anchor) {
            self.context.set_text_align(match anchor {
                Anchor::Start => "left",
                Anchor::Middle => "center",
                Anchor::End => "right",
            });
            self.anchor = Some(anchor);
        }
    }

    fn disc(&mut self, centre: &[f32], radius: f32, ink: Ink) {
        self.fill(ink);
        self.context.begin_path();
        let _ = self.context.arc(centre[0].into(), centre[1].into(), radius.into(), 0.0, std::f64::consts::TAU);
        self.context.fill();
    }

    fn fill(&mut self, ink: Ink) {
        if self.fill != Some(ink) {
            self.context.set_fill_style_str(self.colours.of(ink));
            self.fill = Some(ink);
        }
    }

    fn stroke(&mut self, stroke: Stroke) {
        let before = self.stroke.replace(stroke);
        if before.is_none_or(|before| before.ink != stroke.ink) {
            self.context.set_stroke_style_str(self.colours.of(stroke.ink));
        }
        if before.is_none_or(|before| before.width != stroke.width) {
            self.context.set_line_width(stroke.width.into());
        }
        if before.is_none_or(|before| before.dash != stroke.dash) {
            let lengths: Array = match stroke.dash {
                Dash::Solid => Array::new(),
                dash => dash.lengths().iter().map(|&length| wasm_bindgen::JsValue::from(length)).collect(),
            };
            let _ = self.context.set_line_dash(&lengths);
        }
    }
}

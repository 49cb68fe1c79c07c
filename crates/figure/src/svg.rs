//! The figure as a standalone SVG file.

use std::fmt::Write;

use crate::figure::Figure;
use crate::items::{Anchor, Item, Stroke};
use crate::palette::Palette;
use units::alphabet::with_indices;
use units::markup::Escaped;

/// Font family of all texts: the font of the system.
pub const FONT_FAMILY: &str = "system-ui, -apple-system, 'Segoe UI', Roboto, 'DejaVu Sans', sans-serif";

impl Figure {
    /// The figure as a standalone, accessible SVG document with title and description.
    pub fn svg(&self, palette: &Palette) -> String {
        let mut out = String::with_capacity(4096 + self.points.len() * 6);
        // Writing to a string cannot fail.
        let _ = self.write_svg(&mut out, palette);
        out
    }

    fn write_svg(&self, out: &mut String, palette: &Palette) -> std::fmt::Result {
        // An image needs a name: if the surrounding page shows the title, the description takes its place.
        let name = if self.title.is_empty() { &self.description } else { &self.title };
        write_head(out, (self.width as f32, self.height as f32), name, &self.description)?;
        for item in self.items() {
            write_item(out, item, palette)?;
            out.push('\n');
        }
        out.push_str("</svg>\n");
        Ok(())
    }
}

/// Begins a drawing of this size, in pixels, with its name and a description.
pub(crate) fn write_head(
    out: &mut String,
    (width, height): (f32, f32),
    name: &str,
    description: &str,
) -> std::fmt::Result {
    let (width, height) = (Short(width), Short(height));
    write!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" role=\"img\" font-family=\"{FONT_FAMILY}\">"
    )?;
    write!(out, "<title>{}</title><desc>{}</desc>", Escaped(name), Escaped(description))
}

fn write_item(out: &mut String, item: Item<'_>, palette: &Palette) -> std::fmt::Result {
    match item {
        Item::Fill(area, ink) => write!(
            out,
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>",
            Short(area.x),
            Short(area.y),
            Short(area.width),
            Short(area.height),
            palette.colour(ink)
        ),
        Item::Line(from, to, stroke) => {
            let ends = [from.x, from.y, to.x, to.y].map(Short);
            write!(out, "<path d=\"M{} {}L{} {}\"", ends[0], ends[1], ends[2], ends[3])?;
            write_stroke(out, stroke, palette)
        }
        Item::Polyline(points, stroke) => {
            write_points(out, points)?;
            write_stroke(out, stroke, palette)
        }
        Item::Area(points, ink) => {
            write_points(out, points)?;
            write!(out, " fill=\"{}\"/>", palette.colour(ink))
        }
        Item::Dots { centres, radius, ink, ringed } => {
            write!(out, "<g fill=\"{}\"", palette.colour(ink))?;
            if ringed {
                write!(out, " stroke=\"{}\" stroke-width=\"1.5\"", palette.ground)?;
            }
            out.push('>');
            for centre in centres.chunks_exact(2) {
                let (x, y) = (Short(centre[0]), Short(centre[1]));
                write!(out, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{}\"/>", Short(radius))?;
            }
            out.push_str("</g>");
            Ok(())
        }
        Item::Bars { bars, radius, ink } => {
            out.push_str("<path d=\"");
            for bar in bars.chunks_exact(3) {
                write!(out, "M{} {}V{}", Short(bar[0]), Short(bar[1]), Short(bar[2]))?;
            }
            let (colour, width) = (palette.colour(ink), Short(2.0 * radius));
            write!(out, "\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\" stroke-linecap=\"round\"/>")
        }
        Item::Text { text, at, anchor, size, strong, ink } => {
            let anchor = match anchor {
                Anchor::Start => "start",
                Anchor::Middle => "middle",
                Anchor::End => "end",
            };
            let weight = if strong { " font-weight=\"600\"" } else { "" };
            write!(
                out,
                "<text x=\"{}\" y=\"{}\" text-anchor=\"{anchor}\" font-size=\"{}\"{weight} fill=\"{}\">",
                Short(at.x),
                Short(at.y),
                Short(size),
                palette.colour(ink),
            )?;
            write_with_indices(out, text)?;
            out.push_str("</text>");
            Ok(())
        }
    }
}

/// Writes a text with its indices smaller and below the baseline.
fn write_with_indices(out: &mut String, text: &str) -> std::fmt::Result {
    let mut lowered = false;
    for (piece, is_index) in with_indices(text) {
        let piece = Escaped(piece);
        match (is_index, lowered) {
            (true, _) => write!(out, "<tspan dy=\"0.3em\" font-size=\"75%\">{piece}</tspan>")?,
            // Back to the baseline: 0.3 em of 75 %.
            (false, true) => write!(out, "<tspan dy=\"-0.225em\">{piece}</tspan>")?,
            (false, false) => write!(out, "{piece}")?,
        }
        lowered = is_index;
    }
    Ok(())
}

/// Begins a path through points.
fn write_points(out: &mut String, points: &[f32]) -> std::fmt::Result {
    out.push_str("<path d=\"");
    for (index, point) in points.chunks_exact(2).enumerate() {
        let command = if index == 0 { 'M' } else { 'L' };
        write!(out, "{command}{} {}", Short(point[0]), Short(point[1]))?;
    }
    out.push('"');
    Ok(())
}

fn write_stroke(out: &mut String, stroke: Stroke, palette: &Palette) -> std::fmt::Result {
    write!(out, " fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"", palette.colour(stroke.ink), Short(stroke.width))?;
    let lengths = stroke.dash.lengths();
    if !lengths.is_empty() {
        out.push_str(" stroke-dasharray=\"");
        for (index, length) in lengths.iter().enumerate() {
            write!(out, "{}{}", if index == 0 { "" } else { " " }, Short(*length))?;
        }
        out.push('"');
    }
    out.push_str(" stroke-linejoin=\"round\"/>");
    Ok(())
}

/// A length rounded to a hundredth of a pixel, without trailing zeros.
pub(crate) struct Short(pub f32);

impl std::fmt::Display for Short {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let hundredths = libm::roundf(self.0 * 100.0) as i64;
        let (sign, hundredths) = (if hundredths < 0 { "-" } else { "" }, hundredths.unsigned_abs());
        write!(formatter, "{sign}{}", hundredths / 100)?;
        match hundredths % 100 {
            0 => Ok(()),
            rest if rest % 10 == 0 => write!(formatter, ".{}", rest / 10),
            rest => write!(formatter, ".{rest:02}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::write_with_indices;

    #[test]
    fn indices_stand_below_the_line_and_what_follows_on_it() {
        for (text, expected) in [
            ("y [cm]", "y [cm]"),
            ("h_l", "h<tspan dy=\"0.3em\" font-size=\"75%\">l</tspan>"),
            ("h_r < 2", "h<tspan dy=\"0.3em\" font-size=\"75%\">r</tspan><tspan dy=\"-0.225em\"> &lt; 2</tspan>"),
        ] {
            let mut written = String::new();
            write_with_indices(&mut written, text).unwrap();
            assert_eq!(written, expected);
        }
    }
}

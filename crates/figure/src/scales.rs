//! Diverging bars of answers on scales: one bar for each statement, its middle on a common line.

use crate::palette::{Colour, Palette};
use crate::svg::{Short, write_head};
use crate::text::{fitted, width};
use std::fmt::Write;
use units::markup::Escaped;

/// Height of a statement with its bar and the words at its ends, pixels.
const ROW: f64 = 84.0;
/// Top and height of the bar in its row, pixels.
const BAR: (f64, f64) = (26.0, 24.0);
/// Font sizes of statements and of other texts, pixels.
const LARGE: f64 = 15.0;
const SMALL: f64 = 12.5;

/// Answers to one statement.
#[derive(Clone, Copy, Debug)]
pub struct ScaleRow<'a> {
    /// The statement.
    pub asked: &'a str,
    /// Words at the lower end.
    pub low: &'a str,
    /// Words at the upper end.
    pub high: &'a str,
    /// Number of answers for each step, the lowest first.
    pub counts: &'a [usize],
}

impl ScaleRow<'_> {
    fn total(&self) -> usize {
        self.counts.iter().sum()
    }

    /// Share of the answers on the lower side; half of the middle step counts.
    fn below(&self) -> f64 {
        let half = self.counts.len() / 2;
        let middle = if self.counts.len().is_multiple_of(2) { 0 } else { self.counts.get(half).copied().unwrap_or(0) };
        let below: usize = self.counts.iter().take(half).sum();
        (below as f64 + middle as f64 / 2.0) / self.total().max(1) as f64
    }
}

/// Diverging bars as a standalone SVG document of this width in pixels, with name and description. All bars have the same
/// scale; each step shows its number, and each statement the number of all answers.
pub fn scale_bars(rows: &[ScaleRow<'_>], across: f64, name: &str, description: &str, palette: &Palette) -> String {
    let mut out = String::new();
    let height = ROW * rows.len() as f64;
    // Writing to a string cannot fail.
    let _ = write_head(&mut out, (across as f32, height as f32), name, description);
    let reach = rows.iter().map(|row| row.below().max(1.0 - row.below())).fold(0.5, f64::max);
    let unit = across / 2.0 / reach;
    for (index, row) in rows.iter().enumerate() {
        let _ = write_row(&mut out, row, ROW * index as f64, (across, unit), palette);
    }
    let middle = Short((across / 2.0) as f32);
    let _ = write!(out, "<path d=\"M{middle} 0V{}\" stroke=\"{}\"/>", Short(height as f32), palette.axis);
    out.push_str("</svg>\n");
    out
}

fn write_row(
    out: &mut String,
    row: &ScaleRow<'_>,
    top: f64,
    (across, unit): (f64, f64),
    palette: &Palette,
) -> std::fmt::Result {
    let total = format!("n = {}", row.total());
    let room = across - width(&total, LARGE) - 16.0;
    let line = top + LARGE + 3.0;
    write_text(out, &fitted(row.asked, LARGE, room), (0.0, line), ("start", LARGE), palette.text)?;
    write_text(out, &total, (across, line), ("end", LARGE), palette.text)?;
    let mut left = across / 2.0 - row.below() * unit;
    for (step, &count) in row.counts.iter().enumerate() {
        let long = count as f64 / row.total().max(1) as f64 * unit;
        let colour = colour(step, row.counts.len(), palette);
        let [x, y, w, h] = [left, top + BAR.0, long, BAR.1].map(|number| Short(number as f32));
        if count > 0 {
            write!(
                out,
                "<rect x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" fill=\"{colour}\" stroke=\"{}\"/>",
                palette.ground
            )?;
        }
        let written = count.to_string();
        if count > 0 && long >= width(&written, SMALL) + 2.0 {
            let ink = if colour.contrast(palette.text) >= colour.contrast(palette.ground) {
                palette.text
            } else {
                palette.ground
            };
            write_text(out, &written, (left + long / 2.0, top + BAR.0 + BAR.1 / 2.0 + 4.5), ("middle", SMALL), ink)?;
        }
        left += long;
    }
    let line = top + BAR.0 + BAR.1 + SMALL + 3.0;
    let room = across / 2.0 - 12.0;
    write_text(out, &fitted(row.low, SMALL, room), (0.0, line), ("start", SMALL), palette.text)?;
    write_text(out, &fitted(row.high, SMALL, room), (across, line), ("end", SMALL), palette.text)
}

/// Colour of a step: one hue for each side, stronger towards its end, and grey in the middle.
fn colour(step: usize, steps: usize, palette: &Palette) -> Colour {
    // Distance to the middle in half steps, of at most `steps - 1`.
    let offset = 2 * step as i64 + 1 - steps as i64;
    let hue = match offset {
        0 => return palette.zero,
        below if below < 0 => palette.series[1],
        _ => palette.series[0],
    };
    let strength = 70 + 150 * offset.unsigned_abs() / (steps as u64).max(2);
    hue.mixed(palette.ground, strength.min(255) as u8)
}

fn write_text(
    out: &mut String,
    text: &str,
    (x, y): (f64, f64),
    (anchor, size): (&str, f64),
    ink: Colour,
) -> std::fmt::Result {
    let [x, y, size] = [x, y, size].map(|number| Short(number as f32));
    let text = Escaped(text);
    write!(out, "<text x=\"{x}\" y=\"{y}\" text-anchor=\"{anchor}\" font-size=\"{size}\" fill=\"{ink}\">{text}</text>")
}

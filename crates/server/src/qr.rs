//! QR codes of the join address: for the terminal and for the projector.

use qrcodegen::{QrCode, QrCodeEcc};
use std::fmt::Write as _;

/// Width of the quiet zone in modules (ISO 18004).
const MARGIN: i32 = 4;

fn code(text: &str) -> Option<QrCode> {
    QrCode::encode_text(text, QrCodeEcc::Low).ok()
}

/// QR code as an SVG; empty if the text is too long.
pub fn svg(text: &str) -> String {
    let Some(code) = code(text) else { return String::new() };
    let mut path = String::new();
    for row in 0..code.size() {
        for column in (0..code.size()).filter(|column| code.get_module(*column, row)) {
            // Writing to a string cannot fail.
            let _ = write!(path, "M{column} {row}h1v1h-1z");
        }
    }
    let whole = code.size() + 2 * MARGIN;
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"QR\" viewBox=\"-{MARGIN} -{MARGIN} {whole} {whole}\" \
         width=\"{0}\" height=\"{0}\" shape-rendering=\"crispEdges\"><path fill=\"#fff\" d=\"M-{MARGIN} -{MARGIN}h{whole}v{whole}h-{whole}z\"/>\
         <path d=\"{path}\"/></svg>",
        8 * whole
    )
}

/// QR code for a terminal, two rows of modules in a line, light on dark or dark on light alike; empty if the text is too long.
pub fn terminal(text: &str) -> String {
    let Some(code) = code(text) else { return String::new() };
    let is_dark = |column, row| code.get_module(column, row);
    let mut lines = String::new();
    // A narrow quiet zone, drawn light as the code's own light modules.
    for row in (-2..code.size() + 2).step_by(2) {
        for column in -2..code.size() + 2 {
            lines.push(match (is_dark(column, row), is_dark(column, row + 1)) {
                (true, true) => ' ',
                (true, false) => '▄',
                (false, true) => '▀',
                (false, false) => '█',
            });
        }
        lines.push('\n');
    }
    lines
}

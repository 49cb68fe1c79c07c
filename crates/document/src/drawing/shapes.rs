//! Elements available for drawing: parts, and SVG elements as written in a frame.

use crate::scene::{PARTS, Part, part};
use units::words;

/// Shapes of SVG.
static SHAPES: [Part; 8] = [
    part("line", words("Line"), 2, &["from", "to"]),
    part("rect", words("Rectangle"), 2, &["at", "size"]),
    part("circle", words("Circle"), 2, &["at", "r"]),
    part("ellipse", words("Ellipse"), 3, &["at", "rx", "ry"]),
    part("polyline", words("Open polygon"), 1, &["points"]),
    part("polygon", words("Polygon"), 1, &["points"]),
    part("path", words("Path"), 1, &["d"]),
    part("text", words("Text"), 1, &["at"]),
];

/// Elements that contain other elements.
static CONTAINERS: [Part; 2] =
    [part("frame", words("Frame"), 2, &["x", "y", "box"]), part("g", words("Group"), 0, &["at", "turn"])];

/// Elements that can be inserted: parts, then shapes. Images are left out, since their picture must come from a file.
pub fn drawable() -> impl Iterator<Item = &'static Part> {
    PARTS.iter().chain(&SHAPES).filter(|kind| kind.name != "image")
}

/// Kind of an element; `None` for definitions, titles and text spans.
pub(super) fn kind_of(name: &str) -> Option<&'static Part> {
    PARTS.iter().chain(&SHAPES).chain(&CONTAINERS).find(|kind| kind.name == name)
}

/// True if the element can contain other elements of the drawing.
pub(super) fn holds_others(kind: &Part) -> bool {
    CONTAINERS.iter().any(|container| container.name == kind.name)
}

/// True if the element shows its text content.
pub fn shows_text(kind: &Part) -> bool {
    matches!(kind.name, "text" | "label")
}

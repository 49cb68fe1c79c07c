//! Elements available for drawing: parts, and SVG elements as written in a frame.

use crate::scene::{PARTS, Part, part};

/// Shapes of SVG.
const SHAPES: [Part; 8] = [
    part("line", ("Line", "Línea"), 2, &["from", "to"]),
    part("rect", ("Rectangle", "Rectángulo"), 2, &["at", "size"]),
    part("circle", ("Circle", "Círculo"), 2, &["at", "r"]),
    part("ellipse", ("Ellipse", "Elipse"), 3, &["at", "rx", "ry"]),
    part("polyline", ("Open polygon", "Línea quebrada"), 1, &["points"]),
    part("polygon", ("Polygon", "Polígono"), 1, &["points"]),
    part("path", ("Path", "Trazo"), 1, &["d"]),
    part("text", ("Text", "Texto"), 1, &["at"]),
];

/// Elements that contain other elements.
const CONTAINERS: [Part; 2] =
    [part("frame", ("Frame", "Marco"), 2, &["x", "y", "box"]), part("g", ("Group", "Grupo"), 0, &["at", "turn"])];

/// Elements that can be inserted: parts, then shapes. Images are left out, since their picture must come from a file.
pub fn drawable() -> impl Iterator<Item = Part> {
    PARTS.into_iter().chain(SHAPES).filter(|kind| kind.name != "image")
}

/// Kind of an element; `None` for definitions, titles and text spans.
pub(super) fn kind_of(name: &str) -> Option<Part> {
    PARTS.into_iter().chain(SHAPES).chain(CONTAINERS).find(|kind| kind.name == name)
}

/// True if the element can contain other elements of the drawing.
pub(super) fn holds_others(kind: Part) -> bool {
    CONTAINERS.iter().any(|container| container.name == kind.name)
}

/// True if the element shows its text content.
pub fn shows_text(kind: Part) -> bool {
    matches!(kind.name, "text" | "label")
}

//! What there is to draw with: parts, and the elements of SVG as they are written in a frame.

use crate::scene::{PARTS, Part, part};

/// The shapes of SVG.
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

/// What other elements stand in.
const CONTAINERS: [Part; 2] =
    [part("frame", ("Frame", "Marco"), 2, &["x", "y", "box"]), part("g", ("Group", "Grupo"), 0, &["at", "turn"])];

/// All that can be drawn: parts, then shapes. An image is not among them, since its picture must come from somewhere.
pub fn drawable() -> impl Iterator<Item = Part> {
    PARTS.into_iter().chain(SHAPES).filter(|kind| kind.name != "image")
}

/// What an element is; `None` of definitions, titles and pieces of texts.
pub(super) fn kind_of(name: &str) -> Option<Part> {
    PARTS.into_iter().chain(SHAPES).chain(CONTAINERS).find(|kind| kind.name == name)
}

/// Whether further elements of the drawing stand in it.
pub(super) fn holds_others(kind: Part) -> bool {
    CONTAINERS.iter().any(|container| container.name == kind.name)
}

/// Whether it shows the text that stands in it.
pub fn shows_text(kind: Part) -> bool {
    matches!(kind.name, "text" | "label")
}

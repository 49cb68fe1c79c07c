//! Allowlists of scenes. Only listed items reach the page; everything else is left out and reported.

/// Elements: shapes, text, groups, and the paints and clips that they refer to. Excluded is everything that executes,
/// loads, animates itself or contains HTML (`script`, `image`, `use`, `a`, `animate`, `foreignObject` ...).
pub const ELEMENTS: [&str; 20] = [
    "svg",
    "g",
    "path",
    "rect",
    "circle",
    "ellipse",
    "line",
    "polyline",
    "polygon",
    "text",
    "tspan",
    "title",
    "desc",
    "defs",
    "linearGradient",
    "radialGradient",
    "stop",
    "clipPath",
    "marker",
    "style",
];

/// Attributes of any element.
pub const ATTRIBUTES: [&str; 80] = [
    // Names.
    "id",
    "class",
    // Geometry.
    "viewBox",
    "preserveAspectRatio",
    "width",
    "height",
    "x",
    "y",
    "x1",
    "y1",
    "x2",
    "y2",
    "cx",
    "cy",
    "r",
    "rx",
    "ry",
    "d",
    "points",
    "dx",
    "dy",
    "rotate",
    "pathLength",
    "textLength",
    "lengthAdjust",
    "transform",
    // Paints, clips and markers.
    "offset",
    "fx",
    "fy",
    "fr",
    "gradientTransform",
    "gradientUnits",
    "spreadMethod",
    "clipPathUnits",
    "markerWidth",
    "markerHeight",
    "markerUnits",
    "refX",
    "refY",
    "orient",
    // Appearance.
    "fill",
    "fill-opacity",
    "fill-rule",
    "stroke",
    "stroke-width",
    "stroke-opacity",
    "stroke-linecap",
    "stroke-linejoin",
    "stroke-dasharray",
    "stroke-dashoffset",
    "stroke-miterlimit",
    "opacity",
    "color",
    "stop-color",
    "stop-opacity",
    "clip-path",
    "clip-rule",
    "marker-start",
    "marker-mid",
    "marker-end",
    "font-size",
    "font-family",
    "font-weight",
    "font-style",
    "text-anchor",
    "dominant-baseline",
    "letter-spacing",
    "visibility",
    "display",
    "paint-order",
    "vector-effect",
    "pointer-events",
    "shape-rendering",
    "cursor",
    "baseline-shift",
    "word-spacing",
    // Dragging, an extension of the laboratory.
    "drag",
    "drag-up",
    "drag-right",
    "drag-zero",
];

/// Attributes that may refer to an element of the same scene, `url(#glass)`.
pub const REFERRING: [&str; 6] = ["fill", "stroke", "clip-path", "marker-start", "marker-mid", "marker-end"];

/// True for attributes written by drawing programs that have no effect here; they are left out without a message.
pub fn is_idle(attribute: &str) -> bool {
    matches!(attribute, "xmlns" | "version" | "xml:space" | "baseProfile") || attribute.starts_with("xmlns:")
}

/// Properties that a `<style>` may set.
pub fn is_property(name: &str) -> bool {
    const OTHERS: [&str; 2] = ["rx", "ry"];
    // Attributes that are also properties: from `fill` on, without references and dragging.
    let start = ATTRIBUTES.iter().position(|attribute| *attribute == "fill").unwrap_or(ATTRIBUTES.len());
    let plain = ATTRIBUTES[start..].contains(&name);
    (plain && !name.starts_with("drag") && !name.starts_with("marker") && name != "clip-path") || OTHERS.contains(&name)
}

/// First part of a value that could make a browser load or execute something, or that could hide this; `None` for a safe
/// value.
pub fn danger(value: &str) -> Option<&'static str> {
    // Browsers ignore blanks and control characters inside such words.
    let value: String =
        value.chars().filter(|c| !c.is_whitespace() && !c.is_control()).flat_map(char::to_lowercase).collect();
    let words = ["javascript:", "vbscript:", "data:", "url(", "expression(", "@import", "image(", "image-set(", "\\"];
    words.into_iter().find(|word| value.contains(word))
}

/// The id in a value that is exactly `url(#id)`.
pub fn reference(value: &str) -> Option<&str> {
    let id = value.trim().strip_prefix("url(#")?.strip_suffix(')')?;
    is_id(id).then_some(id)
}

/// True if a text can be an id.
pub fn is_id(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_alphabetic())
        && text.len() <= 60
        && text.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '-' | '_'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dangerous_values_are_seen_through_disguises() {
        for value in [
            "url(https://x)",
            "URL(x)",
            "u\trl(x)",
            "javascript:alert(1)",
            "java\nscript:x",
            " JavaScript :x",
            "\\75rl(x)",
            "data:image/svg+xml,x",
            "image-set('x' 1x)",
            "@im\u{0}port",
        ] {
            assert!(danger(value).is_some(), "{value}");
        }
        for value in ["M0 0L1 1z", "rotate(30)", "var(--liquid)", "#ff0000", "rgb(1 2 3 / 50%)"] {
            assert_eq!(danger(value), None, "{value}");
        }
    }

    #[test]
    fn only_local_references_are_references() {
        assert_eq!(reference("url(#glass)"), Some("glass"));
        for value in
            ["url(#)", "url( #a)", "url(\"#a\")", "url(x#a)", "url(#a) red", "url(#a)url(#b)", "url(#a))", "glass"]
        {
            assert_eq!(reference(value), None, "{value}");
        }
    }

    #[test]
    fn properties_are_of_appearance() {
        assert!(is_property("fill") && is_property("stroke-width") && is_property("rx"));
        assert!(
            !is_property("d")
                && !is_property("clip-path")
                && !is_property("drag")
                && !is_property("position")
                && !is_property("transition")
        );
    }
}

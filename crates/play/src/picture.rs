//! The scene at the time shown as a standalone SVG file, for programs without a page.

use crate::Play;
use program::{Child, Element, Piece, Template, write_attribute};
use units::markup::escaped;

/// Beginning of a variable of the page's theme in a style.
const VARIABLE: &str = "var(--";

/// The scene at the time shown as a standalone SVG file in the colours of a light page. `ink`: colour of the text, such as
/// `#17262e`. `None` if the document has no scene.
pub fn scene_svg(play: &mut Play, ink: &str) -> Option<String> {
    let scene = play.basis().scene()?.clone();
    let values = play.scene().values().to_vec();
    let mut out = String::new();
    write_element(play, &scene.root, &values, Some(ink), &mut out);
    Some(out)
}

/// Writes an element. `ink`: colour of the text, of the root only.
fn write_element(play: &mut Play, element: &Element, values: &[f64], ink: Option<&str>, out: &mut String) {
    out.extend(["<", &element.name]);
    if let Some(ink) = ink {
        out.push_str(&format!(" xmlns=\"http://www.w3.org/2000/svg\" color=\"{ink}\" font-family=\"sans-serif\""));
    }
    let mut text = String::new();
    for attribute in &element.attributes {
        let has_value = match attribute.value.as_slice() {
            [Piece::Trail(number)] => {
                play.scene().write_trail(*number, &mut text);
                true
            }
            template => write_attribute(template, values, &mut text),
        };
        if has_value {
            out.push_str(&format!(" {}=\"{}\"", attribute.name, escaped(&without_variables(&text))));
        }
    }
    out.push('>');
    for child in &element.children {
        match child {
            Child::Element(child) => write_element(play, child, values, None, out),
            Child::Text(template) => {
                let words = words(play, template);
                out.push_str(&escaped(&if element.name == "style" { without_variables(&words) } else { words }));
            }
        }
    }
    out.push_str(&format!("</{}>", element.name));
}

/// Text of a template with the values at the time shown.
fn words(play: &mut Play, template: &Template) -> String {
    let mut words = String::new();
    for piece in template {
        match piece {
            Piece::Literal(literal) => words.push_str(literal),
            Piece::Value { index, decimals } => words.push_str(&play.scene().text(*index, *decimals)),
            Piece::Choice { .. } | Piece::Trail(_) => {}
        }
    }
    words
}

/// A style without variables of a theme: `var(--mark, #c4551d)` is `#c4551d`, and `currentColor` stands for one without a fallback.
fn without_variables(style: &str) -> String {
    let mut plain = String::with_capacity(style.len());
    let mut rest = style;
    while let Some(at) = rest.find(VARIABLE) {
        plain.push_str(&rest[..at]);
        let inside = &rest[at + VARIABLE.len()..];
        let end = inside.find(')').unwrap_or(inside.len());
        plain.push_str(inside[..end].split_once(',').map_or("currentColor", |(_, fallback)| fallback.trim()));
        rest = inside.get(end + 1..).unwrap_or_default();
    }
    plain.push_str(rest);
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn variables_give_way_to_their_fallbacks() {
        for (style, plain) in [
            ("#123456", "#123456"),
            ("var(--mark, #c4551d)", "#c4551d"),
            (".a { fill: var(--liquid, #3f9fc0); stroke: var(--x) }", ".a { fill: #3f9fc0; stroke: currentColor }"),
            ("var(--x", "currentColor"),
        ] {
            assert_eq!(without_variables(style), plain);
        }
    }
}

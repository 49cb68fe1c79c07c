//! Attributes with numeric values: line widths, positions, opacities.

use model::{Diagnostic, Span};
use units::words;

/// Permitted form of a value.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Amount {
    /// A length, positive or negative.
    Length,
    /// A list of lengths.
    Lengths,
    /// A non-negative length, or one of these words.
    Extent(&'static [&'static str]),
    /// A list of non-negative lengths, or `none`.
    Dashes,
    /// A number or a percentage.
    Number,
}

const SIZES: [&str; 9] =
    ["xx-small", "x-small", "small", "medium", "large", "x-large", "xx-large", "smaller", "larger"];

fn amount(attribute: &str) -> Option<Amount> {
    match attribute {
        "cx" | "cy" | "x1" | "y1" | "x2" | "y2" | "stroke-dashoffset" => Some(Amount::Length),
        "x" | "y" | "dx" | "dy" => Some(Amount::Lengths),
        "r" | "stroke-width" => Some(Amount::Extent(&[])),
        "width" | "height" | "rx" | "ry" => Some(Amount::Extent(&["auto"])),
        "font-size" => Some(Amount::Extent(&SIZES)),
        "stroke-dasharray" => Some(Amount::Dashes),
        "opacity" | "fill-opacity" | "stroke-opacity" | "stop-opacity" | "stroke-miterlimit" => Some(Amount::Number),
        _ => None,
    }
}

/// Reports a value that browsers would ignore. `text` has 0 in place of values of the model.
pub fn misfit(attribute: &str, text: &str, span: Span) -> Option<Diagnostic> {
    let amount = amount(attribute)?;
    let text = text.trim();
    if fits(amount, text) {
        return None;
    }
    let message = words!("`{attribute}` cannot be `{text}`");
    let hint = match amount {
        Amount::Dashes => words("write lengths of dashes and gaps, such as `5 3`, or `none`"),
        Amount::Number => words("write a number, such as `0.5`, or an expression in braces, such as `{1 - x}`"),
        Amount::Length | Amount::Lengths | Amount::Extent(_) => {
            words("write a length in units of the drawing, such as `2.5`, or an expression in braces, such as `{10*x}`")
        }
    };
    let found = Diagnostic::error("scene-refused", message, span).with_hint(hint);
    // `1,5` and `2 px` have an unambiguous correction.
    let meant: String = text.replace(',', ".").split_whitespace().collect();
    let is_one = !matches!(amount, Amount::Lengths | Amount::Dashes);
    Some(if is_one && fits(amount, &meant) { found.with_fix(span, meant) } else { found })
}

fn fits(amount: Amount, text: &str) -> bool {
    if matches!(text, "inherit" | "initial" | "unset" | "revert") {
        return true;
    }
    let extent = |text: &str| length(text).is_some_and(|length| length >= 0.0);
    let mut each =
        text.split(|letter: char| letter == ',' || letter.is_whitespace()).filter(|length| !length.is_empty());
    match amount {
        Amount::Length => length(text).is_some(),
        Amount::Lengths => each.all(|text| length(text).is_some()),
        Amount::Extent(words) => extent(text) || words.contains(&text),
        Amount::Dashes => text == "none" || each.all(extent),
        Amount::Number => number(text.strip_suffix('%').unwrap_or(text)).is_some(),
    }
}

/// A number with a CSS unit or without a unit.
fn length(text: &str) -> Option<f64> {
    const UNITS: [&str; 11] = ["px", "rem", "em", "ex", "ch", "%", "pt", "pc", "mm", "cm", "in"];
    number(UNITS.into_iter().find_map(|unit| text.strip_suffix(unit)).unwrap_or(text))
}

fn number(text: &str) -> Option<f64> {
    text.parse().ok().filter(|number: &f64| number.is_finite())
}

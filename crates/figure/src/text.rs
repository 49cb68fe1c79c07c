//! Estimate of the width of a text without a font.

use std::borrow::Cow;

/// Estimated width of a text in a font of `size`, both in pixels. It is an upper bound for the usual system fonts, so that
/// texts placed by it do not touch.
pub(crate) fn width(text: &str, size: f64) -> f64 {
    text.chars().map(advance).sum::<f64>() * size
}

/// The text, shortened with an ellipsis if it is wider than `room` pixels.
pub(crate) fn fitted(text: &str, size: f64, room: f64) -> Cow<'_, str> {
    if width(text, size) <= room {
        return Cow::Borrowed(text);
    }
    let mut used = width("…", size);
    let fits = |character: &char| {
        used += advance(*character) * size;
        used <= room
    };
    let mut short: String = text.chars().take_while(fits).collect();
    short.truncate(short.trim_end().len());
    short.push('…');
    Cow::Owned(short)
}

/// Advance width of a character, em.
fn advance(character: char) -> f64 {
    match character {
        '.' | ',' | ':' | ';' | '\'' | '′' | 'i' | 'j' | 'l' | '|' | '!' => 0.32,
        ' ' | 'f' | 't' | 'r' | 'I' | '(' | ')' | '[' | ']' | '-' | '/' | '″' => 0.40,
        '⁰'..='⁹' | '²' | '³' | '¹' | '⁻' | '₀'..='₉' => 0.44,
        'm' | 'w' | 'M' | 'W' | '@' => 0.95,
        '−' | '×' | '+' | '=' | '<' | '>' | '±' | '≈' => 0.72,
        'A'..='Z' | 'Ω' | 'Δ' => 0.72,
        '\u{300}'..='\u{36f}' => 0.0,
        // Ideographs and similar characters are one em wide.
        '\u{1100}'..='\u{11ff}' | '\u{2e80}'..='\u{d7ff}' | '\u{ff00}'..='\u{ff60}' => 1.05,
        _ => 0.64,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widths_grow_with_text_and_size() {
        assert_eq!(width("", 13.0), 0.0);
        assert!(width("−0.25", 13.0) > width("0.25", 13.0));
        assert!((width("10", 20.0) - 25.6).abs() < 1e-9);
        // DejaVu Sans, the widest usual font, has digits of 0.636 em and a point of 0.318 em.
        assert!(width("0.25", 100.0) > 0.95 * (3.0 * 63.6 + 31.8));
    }

    #[test]
    fn long_texts_end_in_an_ellipsis() {
        let cases = [
            ("Displacement", 200.0, "Displacement"),
            ("Displacement", 60.0, "Displac…"),
            ("Two words", 45.0, "Two…"),
            ("", 10.0, ""),
            ("Displacement", 0.0, "…"),
        ];
        for (text, room, expected) in cases {
            assert_eq!(fitted(text, 13.0, room), expected);
        }
    }
}

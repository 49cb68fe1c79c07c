//! Texts inside HTML, SVG, MathML and other XML.

use std::fmt::{self, Display, Formatter};

/// A text as the content of an element or as an attribute. Markup is made harmless, and characters that
/// XML forbids become U+FFFD.
#[derive(Clone, Copy, Debug)]
pub struct Escaped<'a>(pub &'a str);

impl Display for Escaped<'_> {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        // What needs no change is written in one piece.
        let mut written = 0;
        for (place, character) in self.0.char_indices() {
            let instead = match character {
                '&' => "&amp;",
                '<' => "&lt;",
                '>' => "&gt;",
                '"' => "&quot;",
                '\'' => "&#39;",
                '\u{0}'..='\u{8}' | '\u{b}' | '\u{c}' | '\u{e}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => "\u{fffd}",
                _ => continue,
            };
            formatter.write_str(&self.0[written..place])?;
            formatter.write_str(instead)?;
            written = place + character.len_utf8();
        }
        formatter.write_str(&self.0[written..])
    }
}

/// [`Escaped`] as a text of its own.
pub fn escaped(text: &str) -> String {
    Escaped(text).to_string()
}

#[cfg(test)]
mod tests {
    use super::escaped;

    #[test]
    fn markup_is_harmless_and_what_xml_forbids_is_gone() {
        assert_eq!(escaped("a<b> & \"c\" 'd'"), "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
        assert_eq!(escaped("\u{0}\t\n\u{1f}\u{ffff}ω"), "\u{fffd}\t\n\u{fffd}\u{fffd}ω");
    }
}

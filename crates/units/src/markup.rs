//! Escaping of texts for HTML, SVG, MathML and other XML.

use std::fmt::{self, Display, Formatter};

/// A text as the content of an element or attribute: markup is escaped, and characters forbidden in XML become U+FFFD.
#[derive(Clone, Copy, Debug)]
pub struct Escaped<'a>(pub &'a str);

impl Display for Escaped<'_> {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        pieces(self.0, &mut |piece| formatter.write_str(piece))
    }
}

/// [`Escaped`] as a string.
pub fn escaped(text: &str) -> String {
    let mut written = String::with_capacity(text.len());
    let _ = pieces(text, &mut |piece| {
        written.push_str(piece);
        Ok(())
    });
    written
}

/// Passes the escaped text to `write` in pieces; a stretch without changes is one piece.
fn pieces(text: &str, write: &mut dyn FnMut(&str) -> fmt::Result) -> fmt::Result {
    let mut written = 0;
    for (place, character) in text.char_indices() {
        let instead = match character {
            '&' => "&amp;",
            '<' => "&lt;",
            '>' => "&gt;",
            '"' => "&quot;",
            '\'' => "&#39;",
            '\u{0}'..='\u{8}' | '\u{b}' | '\u{c}' | '\u{e}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => "\u{fffd}",
            _ => continue,
        };
        write(&text[written..place])?;
        write(instead)?;
        written = place + character.len_utf8();
    }
    write(&text[written..])
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

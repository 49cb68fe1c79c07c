//! Escaping of characters that a terminal would execute instead of showing: escape sequences that move the cursor or
//! rename the window, and marks that reverse the direction of the text (Boucher & Anderson, Trojan Source, 2021).

use codespan_reporting::term::termcolor::{ColorSpec, WriteColor};
use std::borrow::Cow;
use std::io::{self, Write};

/// Text with such characters escaped as `\u{1b}`. Tabs and line ends are kept.
pub fn visible(text: &str) -> Cow<'_, str> {
    if !text.contains(is_obeyed) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 16);
    let mut rest = text;
    while let Some(letter) = rest.chars().next() {
        rest = &rest[letter.len_utf8()..];
        // A carriage return is harmless only in a line end.
        if is_obeyed(letter) && !(letter == '\r' && rest.starts_with('\n')) {
            shown.extend(letter.escape_unicode());
        } else {
            shown.push(letter);
        }
    }
    Cow::Owned(shown)
}

fn is_obeyed(letter: char) -> bool {
    letter.is_control() && !matches!(letter, '\n' | '\t')
        || matches!(letter, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// Writer for a terminal that escapes text as [`visible`] does. Colours set through [`WriteColor`] pass.
#[derive(Debug)]
pub struct Visible<W> {
    inner: W,
    /// Start of a character or of a line end whose rest has not been written yet.
    part: Vec<u8>,
}

impl<W> Visible<W> {
    /// Writer to `inner`.
    pub fn new(inner: W) -> Self {
        Self { inner, part: Vec::new() }
    }
}

impl<W: Write> Visible<W> {
    /// Writes the first `length` bytes of the held-back text.
    fn pass(&mut self, length: usize) -> io::Result<()> {
        let text: Vec<u8> = self.part.drain(..length).collect();
        self.inner.write_all(visible(&String::from_utf8_lossy(&text)).as_bytes())
    }
}

impl<W: Write> Write for Visible<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.part.extend_from_slice(bytes);
        let whole = match std::str::from_utf8(&self.part) {
            Err(error) if error.error_len().is_none() => error.valid_up_to(),
            // A final carriage return may be the first half of a line end.
            _ => self.part.len() - usize::from(self.part.ends_with(b"\r")),
        };
        self.pass(whole)?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.pass(self.part.len())?;
        self.inner.flush()
    }
}

impl<W: WriteColor> WriteColor for Visible<W> {
    fn supports_color(&self) -> bool {
        self.inner.supports_color()
    }

    fn set_color(&mut self, color: &ColorSpec) -> io::Result<()> {
        self.inner.set_color(color)
    }

    fn reset(&mut self) -> io::Result<()> {
        self.inner.reset()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_terminal_would_obey_is_shown() {
        for (text, shown) in [
            ("y [m]\tγ\n", "y [m]\tγ\n"),
            ("\u{1b}]0;p\u{7}", "\\u{1b}]0;p\\u{7}"),
            ("a\u{9b}2Jb\u{7f}\u{0}", "a\\u{9b}2Jb\\u{7f}\\u{0}"),
            ("\u{202e}cba\u{2066}\u{200f}", "\\u{202e}cba\\u{2066}\\u{200f}"),
            ("over\rwritten\r\n", "over\\u{d}written\r\n"),
        ] {
            assert_eq!(visible(text), shown);
            // The result does not depend on the division of the bytes.
            for parts in [1, 2, 3, 5] {
                let mut writer = Visible::new(Vec::new());
                text.as_bytes().chunks(parts).for_each(|bytes| writer.write_all(bytes).expect("memory"));
                writer.flush().expect("memory");
                assert_eq!(String::from_utf8_lossy(&writer.inner), shown, "in parts of {parts}");
            }
        }
    }
}

//! Positions of the protocol: lines from 0, and UTF-16 code units within a line.

use lsp_types::{Position, Range};
use model::Span;

/// Position of a byte offset.
pub fn position(text: &str, offset: usize) -> Position {
    let offset = text.floor_char_boundary(offset);
    let start = text[..offset].rfind('\n').map_or(0, |end| end + 1);
    let line = text[..start].matches('\n').count();
    Position::new(line as u32, text[start..offset].encode_utf16().count() as u32)
}

/// The positions of a span.
pub fn range(text: &str, span: Span) -> Range {
    Range::new(position(text, span.start), position(text, span.end.max(span.start)))
}

/// Byte offset of a position. A position behind the end of its line gives the end of the line, one behind the last line
/// the end of the text.
pub fn offset(text: &str, position: Position) -> usize {
    let lines = text.split_inclusive('\n').take(position.line as usize);
    let start: usize = lines.map(str::len).sum();
    let line = text[start..].lines().next().unwrap_or_default();
    let mut units = 0;
    for (at, letter) in line.char_indices() {
        if units >= position.character as usize {
            return start + at;
        }
        units += letter.len_utf16();
    }
    start + line.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_count_units_of_utf_16() {
        let text = "a\nγ𝛼b\r\nc";
        for (wanted, line, character) in [("a", 0, 0), ("γ", 1, 0), ("𝛼", 1, 1), ("b", 1, 3), ("c", 2, 0)] {
            let at = text.find(wanted).expect("it is there");
            assert_eq!(position(text, at), Position::new(line, character), "{wanted}");
            assert_eq!(offset(text, Position::new(line, character)), at, "{wanted}");
        }
        assert_eq!(offset(text, Position::new(1, 99)), text.find('\r').expect("it is there"));
        assert_eq!(offset(text, Position::new(9, 0)), text.len());
        assert_eq!(position(text, 99), Position::new(2, 1));
    }
}

//! The names of quantities as symbols.

use crate::views::*;
use units::alphabet::{self, greek_letter};

/// A name typeset: `h_l` as MathML. Labels say the same in words, so readers of the screen need not hear it.
pub fn symbol(name: &str) -> HtmlSpan {
    span().class("symbol").attr("aria-hidden", "true").inner_html(units::mathml::typeset_name(name))
}

/// A text whose indices stand below the line: `h_l` in a label.
pub fn with_indices(text: &str) -> HtmlSpan {
    span().each(alphabet::with_indices(text), |(piece, is_index)| match is_index {
        true => View::from(sub().child(piece.to_owned())),
        false => View::from(piece.to_owned()),
    })
}

/// What a quantity is called, and its symbol beside the last word, from which no line break parts it. A name that is a word, such as
/// `drag`, is no symbol: beside *Air drag* it would only be read twice.
pub fn name_and_symbol(label: &str, name: &str) -> HtmlSpan {
    if !label.is_empty() && is_word(name) {
        return span().child(label.to_owned());
    }
    let (start, last) = label.rsplit_once(' ').map_or(("", label), |(start, last)| (start, last));
    let start = if start.is_empty() { String::new() } else { format!("{start} ") };
    span().child(start).child(span().class("unbroken").child(last.to_owned()).child(symbol(name)))
}

fn is_word(name: &str) -> bool {
    name.len() > 3 && name.bytes().all(|letter| letter.is_ascii_alphabetic()) && greek_letter(name).is_none()
}

//! Typeset names of quantities.

use crate::views::*;
use units::alphabet::{self, greek_letter};

/// A typeset name: `h_l` as MathML. Hidden from screen readers, because the label has the same meaning.
pub fn symbol(name: &str) -> HtmlSpan {
    span().class("symbol").attr("aria-hidden", "true").inner_html(units::mathml::typeset_name(name))
}

/// A text with lowered indices: `h_l` in a label.
pub fn with_indices(text: &str) -> HtmlSpan {
    span().each(alphabet::with_indices(text), |(piece, is_index)| match is_index {
        true => View::from(sub().child(piece.to_owned())),
        false => View::from(piece.to_owned()),
    })
}

/// Label of a quantity, followed by its symbol without a line break. A name that is a word, such as `drag`, is not
/// shown as a symbol: beside *Air drag* it would only repeat the label.
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

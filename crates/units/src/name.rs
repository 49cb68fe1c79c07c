//! Short identifiers of long texts.

use crate::fnv;

/// Identifier of a list of texts: 16 hexadecimal digits of their hash ([`fnv`]). It is the same in every version of the program.
pub fn name_of(parts: &[&str]) -> String {
    // 0xff never occurs in UTF-8, so it separates the texts unambiguously.
    let hash = parts.iter().fold(fnv::START, |hash, part| fnv::hashed(hash, part.bytes().chain([0xff])));
    format!("{hash:016x}")
}

#[cfg(test)]
mod tests {
    use super::name_of;

    #[test]
    fn texts_that_are_divided_differently_have_other_names() {
        assert_ne!(name_of(&["ab", "c"]), name_of(&["a", "bc"]));
    }
}

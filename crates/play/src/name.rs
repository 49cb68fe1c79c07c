//! Short identifiers of long texts.

/// Identifier of a list of texts: 16 hexadecimal digits of their FNV-1a hash
/// (<http://www.isthe.com/chongo/tech/comp/fnv/>). It is the same in every version of the program.
pub fn name_of(parts: &[&str]) -> String {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    for part in parts {
        // 0xff never occurs in UTF-8, so it separates the texts unambiguously.
        for byte in part.bytes().chain([0xff]) {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
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

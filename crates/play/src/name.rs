//! Short names for what has long ones.

/// A name for some texts by their content: 16 hexadecimal digits of the FNV-1a hash
/// (<http://www.isthe.com/chongo/tech/comp/fnv/>). The same texts have the same name in every version.
pub fn name_of(parts: &[&str]) -> String {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    for part in parts {
        // A byte that no text has parts them.
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

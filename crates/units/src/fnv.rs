//! Hash of bytes: FNV-1a with 64 bits (<http://www.isthe.com/chongo/tech/comp/fnv/>). It is the same in every version of the
//! program and on all machines, and has no security purpose.

/// Hash of no bytes.
pub const START: u64 = 0xcbf2_9ce4_8422_2325;

/// Hash of the bytes behind `hash`, which is [`START`] or that of the bytes before.
#[inline]
pub fn hashed(hash: u64, bytes: impl IntoIterator<Item = u8>) -> u64 {
    bytes.into_iter().fold(hash, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Test vectors of the authors.
    #[test]
    fn the_hash_is_the_published_one() {
        for (text, expected) in
            [("", 0xcbf2_9ce4_8422_2325), ("a", 0xaf63_dc4c_8601_ec8c), ("foobar", 0x8594_4171_f739_67e8)]
        {
            assert_eq!(hashed(START, text.bytes()), expected, "{text}");
        }
        assert_eq!(hashed(hashed(START, *b"foo"), *b"bar"), hashed(START, *b"foobar"));
    }
}

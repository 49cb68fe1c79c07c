//! Hash of texts.

use units::split_mix::{GOLDEN, scramble};

/// Hash of texts. Their ends count, so that `ab`, `c` and `a`, `bc` differ.
pub(super) fn hash(texts: &[&str]) -> u64 {
    // 255 stands in no text in UTF-8.
    let bytes = texts.iter().flat_map(|text| text.bytes().chain([255]));
    bytes.fold(0, |hash: u64, byte| scramble(hash.wrapping_add(GOLDEN) ^ u64::from(byte)))
}

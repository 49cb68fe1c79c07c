//! Unpacks the laboratory's module inside the page: browsers bring gzip, which leaves a fifth more to send than LZMA.

use lzma_rust2::{Action, LzmaStream};

/// Where the header of an `.lzma` file holds the number of bytes that come out, little-endian.
const SIZE: std::ops::Range<usize> = 5..13;

/// What an `.lzma` file holds whose header tells the size; none if the file is damaged.
#[must_use]
pub fn unpack(packed: &[u8]) -> Option<Vec<u8>> {
    let size = u64::from_le_bytes(packed.get(SIZE)?.try_into().ok()?);
    let size = usize::try_from(size).ok()?;
    let mut unpacked = Vec::new();
    // A damaged header may tell any size.
    unpacked.try_reserve_exact(size).ok()?;
    unpacked.resize(size, 0);
    let result = LzmaStream::new_mem_limit(u32::MAX, None).process(packed, &mut unpacked, Action::Finish).ok()?;
    (result.bytes_produced == size).then_some(unpacked)
}

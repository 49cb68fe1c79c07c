//! Unpacks the laboratory's module inside the page. Browsers bring gzip for that, which leaves a third more to send than what
//! is done here: the module's bytes in streams of one kind each, then LZMA.

pub mod streams;

use lzma_rust2::{Action, LzmaStream};

/// Where the header of an `.lzma` file holds the number of bytes that come out, little-endian.
const SIZE: std::ops::Range<usize> = 5..13;

/// The module that is packed as the `.lzma` file of its [`streams`]; none if the file is damaged. Its header must tell the
/// size.
#[must_use]
pub fn unpack(packed: &[u8]) -> Option<Vec<u8>> {
    streams::join(&decompress(packed)?)
}

fn decompress(packed: &[u8]) -> Option<Vec<u8>> {
    let size = u64::from_le_bytes(packed.get(SIZE)?.try_into().ok()?);
    let size = usize::try_from(size).ok()?;
    let mut unpacked = Vec::new();
    // A damaged header may tell any size.
    unpacked.try_reserve_exact(size).ok()?;
    unpacked.resize(size, 0);
    let result = LzmaStream::new_mem_limit(u32::MAX, None).process(packed, &mut unpacked, Action::Finish).ok()?;
    (result.bytes_produced == size).then_some(unpacked)
}

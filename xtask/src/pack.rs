//! Packs the laboratory's module for the page, where the browser inflates it and `crates/unpack` puts it together.

use anyhow::{Result, bail};
use std::num::NonZeroU64;

/// How often a better way is looked for; more make the page no smaller.
const SEARCHES: NonZeroU64 = NonZeroU64::MIN.saturating_add(14);

/// gzip of the module's streams, which are joined once to see that it comes out the same.
pub fn pack(module: &[u8]) -> Result<Vec<u8>> {
    let Some(streams) = unpack::split(module) else { bail!("the module is larger than a module can be") };
    if unpack::join(&streams).as_deref() != Some(module) {
        bail!("the module does not come out of its streams as it went in: look into crates/unpack");
    }
    // Each stream is of another kind, and needs codes of its own: as many blocks as it likes.
    let options =
        zopfli::Options { iteration_count: SEARCHES, maximum_block_splits: u16::MAX, ..zopfli::Options::default() };
    let mut packed = Vec::new();
    zopfli::compress(options, zopfli::Format::Gzip, streams.as_slice(), &mut packed)?;
    Ok(packed)
}

#[cfg(test)]
mod tests {
    use super::pack;
    use flate2::read::GzDecoder;
    use std::io::Read as _;

    #[test]
    fn what_is_packed_comes_out_again() {
        let line = |number: u32| format!("local.get {}\ni32.const {}\n", number % 7, number * number % 97);
        for bytes in [Vec::new(), vec![7], vec![0; 100_000], (0..2000).map(line).collect::<String>().into_bytes()] {
            let packed = pack(&bytes).unwrap();
            assert!(packed.len() < bytes.len() / 2 + 100, "{} bytes for {}", packed.len(), bytes.len());
            let mut streams = Vec::new();
            GzDecoder::new(packed.as_slice()).read_to_end(&mut streams).unwrap();
            assert_eq!(unpack::join(&streams), Some(bytes));
        }
    }
}

//! Packs the laboratory's module for the page, where `crates/unpack` unpacks it.

use anyhow::{Result, bail};
use lzma_rust2::{DICT_SIZE_MAX, DICT_SIZE_MIN, EncodeMode, LzmaOptions, LzmaWriter, MfType};
use std::io::Write as _;

/// The packed module; it is unpacked once to see that it comes out the same.
pub fn pack(module: &[u8]) -> Result<Vec<u8>> {
    let Some(streams) = unpack::streams::split(module) else { bail!("the module is larger than a module can be") };
    let packed = compress(&streams)?;
    if unpack::unpack(&packed).as_deref() != Some(module) {
        bail!("the module does not come out of its packing as it went in: look into crates/unpack");
    }
    Ok(packed)
}

/// An `.lzma` file.
fn compress(bytes: &[u8]) -> std::io::Result<Vec<u8>> {
    let size = u32::try_from(bytes.len()).unwrap_or(u32::MAX);
    let options = LzmaOptions {
        // All of it is in sight, and the page takes no memory for more.
        dict_size: size.clamp(DICT_SIZE_MIN, DICT_SIZE_MAX),
        // What made the module smallest. Nothing in it is aligned, hence no bits of the place.
        lc: 2,
        lp: 0,
        pb: 0,
        mode: EncodeMode::Normal,
        nice_len: LzmaOptions::NICE_LEN_MAX,
        mf: MfType::Bt4,
        ..LzmaOptions::default()
    };
    let mut writer = LzmaWriter::new_use_header(Vec::new(), &options, Some(bytes.len() as u64))?;
    writer.write_all(bytes)?;
    writer.finish()
}

#[cfg(test)]
mod tests {
    use super::pack;
    use unpack::unpack;

    /// Text of which much returns, but never the same for long.
    fn sample() -> Vec<u8> {
        let line = |number: u32| format!("local.get {}\ni32.const {}\n", number % 7, number * number % 97);
        (0..2000).map(line).collect::<String>().into_bytes()
    }

    #[test]
    fn what_is_packed_comes_out_again() {
        for bytes in [Vec::new(), vec![7], vec![0; 100_000], sample()] {
            let packed = pack(&bytes).unwrap();
            assert!(packed.len() < bytes.len() / 2 + 50, "{} bytes for {}", packed.len(), bytes.len());
            assert_eq!(unpack(&packed).as_ref(), Some(&bytes));
        }
    }

    #[test]
    fn of_a_damaged_file_nothing_comes_out() {
        let packed = pack(&sample()).unwrap();
        for length in [0, 12, 13, 100, packed.len() / 2] {
            assert_eq!(unpack(&packed[..length]), None, "{length} bytes");
        }
        let mut endless = packed;
        endless[5..13].fill(0xfe);
        assert_eq!(unpack(&endless), None);
    }
}

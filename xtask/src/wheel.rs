//! Smaller wheels: the files of a ZIP archive, deflated by zopfli.

use anyhow::{Context, Result, ensure};
use flate2::read::DeflateDecoder;
use std::io::Read;
use std::num::NonZeroU64;

/// Number of iterations of zopfli; more make the wheel no more than a thousandth smaller.
const SEARCHES: NonZeroU64 = NonZeroU64::new(5).expect("not 0");
/// Length of a header in the directory, and of a header before a file, without names.
const HEADER: usize = 46;
const LOCAL: usize = 30;
/// Length of the end of the directory, without a comment.
const END: usize = 22;
/// Method "deflate".
const DEFLATE: usize = 8;
/// Flag of sizes that follow the file.
const LATE_SIZES: u8 = 8;

/// The archive with its deflated files made smaller. Names, dates and attributes stay; comments and extra fields do not.
///
/// # Errors
/// Bytes that are no archive without a comment, or a file that cannot be inflated.
pub fn repacked(archive: &[u8]) -> Result<Vec<u8>> {
    let end = archive.len().checked_sub(END).and_then(|end| archive.get(end..)).context("no archive")?;
    ensure!(end.starts_with(b"PK\x05\x06"), "the archive has a comment, or is none");
    let count = word(end, 10)?;
    let (mut at, mut packed, mut directory) = (long(end, 16)?, Vec::new(), Vec::new());
    for _ in 0..count {
        let mut header = archive.get(at..at + HEADER).context("the directory is too short")?.to_vec();
        ensure!(header.starts_with(b"PK\x01\x02"), "the directory is broken");
        let lengths = [word(&header, 28)?, word(&header, 30)?, word(&header, 32)?];
        let name = archive.get(at + HEADER..at + HEADER + lengths[0]).context("a name is too short")?;
        at += HEADER + lengths.iter().sum::<usize>();
        let before = long(&header, 42)?;
        let local = archive.get(before..before + LOCAL).context("a file is not there")?;
        let first = before + LOCAL + word(local, 26)? + word(local, 28)?;
        let content = archive.get(first..first + long(&header, 20)?).context("a file is too short")?;
        let content = if word(&header, 10)? == DEFLATE { smaller(content)? } else { content.to_vec() };
        header[8] &= !LATE_SIZES;
        header[20..24].copy_from_slice(&u32::try_from(content.len())?.to_le_bytes());
        header[30..34].fill(0);
        header[42..46].copy_from_slice(&u32::try_from(packed.len())?.to_le_bytes());
        packed.extend(b"PK\x03\x04");
        packed.extend(&header[6..32]);
        packed.extend(name);
        packed.extend(content);
        directory.extend(header);
        directory.extend(name);
    }
    let mut end = end.to_vec();
    end[12..16].copy_from_slice(&u32::try_from(directory.len())?.to_le_bytes());
    end[16..20].copy_from_slice(&u32::try_from(packed.len())?.to_le_bytes());
    Ok([packed, directory, end].concat())
}

/// Deflated bytes, deflated again.
fn smaller(deflated: &[u8]) -> Result<Vec<u8>> {
    let mut content = Vec::new();
    DeflateDecoder::new(deflated).read_to_end(&mut content)?;
    let options = zopfli::Options { iteration_count: SEARCHES, ..zopfli::Options::default() };
    let mut packed = Vec::new();
    zopfli::compress(options, zopfli::Format::Deflate, content.as_slice(), &mut packed)?;
    Ok(if packed.len() < deflated.len() { packed } else { deflated.to_vec() })
}

/// Number of two bytes.
fn word(bytes: &[u8], at: usize) -> Result<usize> {
    let bytes: &[u8; 2] = bytes.get(at..).and_then(|rest| rest.first_chunk()).context("a header is too short")?;
    Ok(usize::from(u16::from_le_bytes(*bytes)))
}

/// Number of four bytes.
fn long(bytes: &[u8], at: usize) -> Result<usize> {
    let bytes: &[u8; 4] = bytes.get(at..).and_then(|rest| rest.first_chunk()).context("a header is too short")?;
    Ok(u32::from_le_bytes(*bytes) as usize)
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::Compression;
    use flate2::write::DeflateEncoder;
    use std::io::Write;

    /// An archive with one deflated file, packed badly, whose sizes are in the directory alone.
    fn archive(name: &str, content: &[u8]) -> Vec<u8> {
        let mut encoder = DeflateEncoder::new(Vec::new(), Compression::fast());
        encoder.write_all(content).unwrap();
        let packed = encoder.finish().unwrap();
        let sizes = [7_u32, packed.len() as u32, content.len() as u32];
        let facts = |sizes: [u32; 3]| {
            let words = [20_u16, u16::from(LATE_SIZES), DEFLATE as u16, 0, 0x21].map(u16::to_le_bytes).concat();
            [words, sizes.map(u32::to_le_bytes).concat(), vec![name.len() as u8, 0, 0, 0]].concat()
        };
        let file = [b"PK\x03\x04", facts([0; 3]).as_slice(), name.as_bytes(), &packed].concat();
        let header = [b"PK\x01\x02\x14\0", facts(sizes).as_slice(), &[0; 6], &[1, 2, 3, 4], &[0; 4]].concat();
        let length = (HEADER + name.len()) as u32;
        let end = [b"PK\x05\x06\0\0\0\0\x01\0\x01\0", length.to_le_bytes().as_slice()].concat();
        let end = [end.as_slice(), &(file.len() as u32).to_le_bytes(), &[0; 2]].concat();
        [file.as_slice(), &header, name.as_bytes(), &end].concat()
    }

    #[test]
    fn a_repacked_archive_is_smaller_and_has_the_same_file() {
        let content: Vec<u8> = (0..20_000_u32).map(|place| (place * place / 7 % 23) as u8).collect();
        let before = archive("meniscus.so", &content);
        let after = repacked(&before).unwrap();
        assert!(after.len() < before.len());
        let size = long(&after, 18).unwrap();
        let first = LOCAL + "meniscus.so".len();
        assert_eq!(&after[LOCAL..first], b"meniscus.so");
        let mut found = Vec::new();
        DeflateDecoder::new(&after[first..first + size]).read_to_end(&mut found).unwrap();
        assert_eq!(found, content);
        // The checksum and the attributes are kept, the flag of late sizes is not.
        assert_eq!((after[6], long(&after, 14).unwrap(), long(&after, 22).unwrap()), (0, 7, content.len()));
        assert_eq!(after[first + size + 38..][..4], [1, 2, 3, 4]);
        assert_eq!(repacked(&after).unwrap(), after);
        assert!(repacked(&before[..before.len() - 1]).is_err());
        assert!(repacked(b"PK").is_err());
    }
}

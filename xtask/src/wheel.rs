//! Wheels: ZIP archives with a list of their files, deflated by zopfli.

use anyhow::{Context, Result, ensure};
use base64::Engine as _;
use flate2::Crc;
use flate2::read::DeflateDecoder;
use sha2::{Digest, Sha256};
use std::io::Read;
use std::num::NonZeroU64;

/// Number of iterations of zopfli; more make the wheel no more than a thousandth smaller.
const SEARCHES: NonZeroU64 = NonZeroU64::new(5).expect("not 0");
/// Length of a header in the directory, and of a header before a file, without names.
const HEADER: usize = 46;
const LOCAL: usize = 30;
/// Length of the end of the directory, without a comment.
const END: usize = 22;
/// Methods "stored" and "deflate".
const STORED: usize = 0;
const DEFLATE: usize = 8;
/// Flag of sizes that follow the file.
const LATE_SIZES: u8 = 8;

/// A file of an archive.
#[derive(Clone)]
pub struct File {
    /// Path in the archive.
    pub name: String,
    pub content: Vec<u8>,
    /// Header in the directory, with date and attributes.
    header: [u8; HEADER],
}

impl File {
    /// A file with the date and the attributes of another one.
    pub fn like(other: &Self, name: &str, content: Vec<u8>) -> Self {
        Self { name: name.to_owned(), content, header: other.header }
    }
}

/// The files of an archive.
///
/// # Errors
/// Bytes that are no archive without a comment, or a file that cannot be inflated.
pub fn files(archive: &[u8]) -> Result<Vec<File>> {
    let end = archive.len().checked_sub(END).and_then(|end| archive.get(end..)).context("no archive")?;
    ensure!(end.starts_with(b"PK\x05\x06"), "the archive has a comment, or is none");
    let (mut at, mut files) = (long(end, 16)?, Vec::new());
    for _ in 0..word(end, 10)? {
        let header = archive.get(at..).and_then(|rest| rest.first_chunk::<HEADER>());
        let header = *header.context("the directory is too short")?;
        ensure!(header.starts_with(b"PK\x01\x02"), "the directory is broken");
        let lengths = [word(&header, 28)?, word(&header, 30)?, word(&header, 32)?];
        let name = archive.get(at + HEADER..at + HEADER + lengths[0]).context("a name is too short")?;
        at += HEADER + lengths.iter().sum::<usize>();
        let before = long(&header, 42)?;
        let local = archive.get(before..before + LOCAL).context("a file is not there")?;
        let first = before + LOCAL + word(local, 26)? + word(local, 28)?;
        let packed = archive.get(first..first + long(&header, 20)?).context("a file is too short")?;
        let mut content = Vec::new();
        match word(&header, 10)? {
            STORED => content.extend(packed),
            DEFLATE => DeflateDecoder::new(packed).read_to_end(&mut content).map(drop)?,
            other => anyhow::bail!("method {other} of compression"),
        }
        files.push(File { name: std::str::from_utf8(name)?.to_owned(), content, header });
    }
    Ok(files)
}

/// An archive of these files, as small as possible. It has their names, dates and attributes, without comments and extra fields.
///
/// # Errors
/// A file of more than 4 GB.
pub fn archive(files: &[File]) -> Result<Vec<u8>> {
    let (mut packed, mut directory) = (Vec::new(), Vec::new());
    for File { name, content, header } in files {
        let deflated = deflated(content)?;
        let (method, data) = if deflated.len() < content.len() { (DEFLATE, &deflated) } else { (STORED, content) };
        let mut crc = Crc::new();
        crc.update(content);
        let mut header = *header;
        header[8] &= !LATE_SIZES;
        header[10] = method as u8;
        header[16..20].copy_from_slice(&crc.sum().to_le_bytes());
        header[20..24].copy_from_slice(&u32::try_from(data.len())?.to_le_bytes());
        header[24..28].copy_from_slice(&u32::try_from(content.len())?.to_le_bytes());
        header[28..30].copy_from_slice(&u16::try_from(name.len())?.to_le_bytes());
        header[30..34].fill(0);
        header[42..46].copy_from_slice(&u32::try_from(packed.len())?.to_le_bytes());
        packed.extend(b"PK\x03\x04");
        packed.extend(&header[6..32]);
        packed.extend(name.as_bytes());
        packed.extend(data);
        directory.extend(header);
        directory.extend(name.as_bytes());
    }
    let count = u16::try_from(files.len())?.to_le_bytes();
    let sizes = [directory.len(), packed.len()].map(|size| u32::try_from(size).map(u32::to_le_bytes));
    let [size, start] = sizes;
    let end = [b"PK\x05\x06\0\0\0\0".as_slice(), &count, &count, &size?, &start?, &[0; 2]].concat();
    Ok([packed, directory, end].concat())
}

/// Content of the list of files (`RECORD`) of a wheel. The list itself, whose path is `own`, stands in it without a hash.
pub fn record(files: &[File], own: &str) -> Vec<u8> {
    let hash = |content: &[u8]| base64::engine::general_purpose::URL_SAFE_NO_PAD.encode(Sha256::digest(content));
    let listed = files.iter().filter(|file| file.name != own);
    let mut lines: String =
        listed.map(|file| format!("{},sha256={},{}\n", file.name, hash(&file.content), file.content.len())).collect();
    lines.push_str(&format!("{own},,\n"));
    lines.into_bytes()
}

/// Deflated bytes.
fn deflated(content: &[u8]) -> Result<Vec<u8>> {
    let options = zopfli::Options { iteration_count: SEARCHES, ..zopfli::Options::default() };
    let mut packed = Vec::new();
    zopfli::compress(options, zopfli::Format::Deflate, content, &mut packed)?;
    Ok(packed)
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
    fn badly_packed(name: &str, content: &[u8]) -> Vec<u8> {
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
        let before = badly_packed("meniscus.so", &content);
        let repacked = |bytes: &[u8]| files(bytes).and_then(|files| archive(&files));
        let after = repacked(&before).unwrap();
        assert!(after.len() < before.len());
        let size = long(&after, 18).unwrap();
        let first = LOCAL + "meniscus.so".len();
        assert_eq!(&after[LOCAL..first], b"meniscus.so");
        let mut found = Vec::new();
        DeflateDecoder::new(&after[first..first + size]).read_to_end(&mut found).unwrap();
        assert_eq!(found, content);
        // The attributes are kept, the flag of late sizes is not.
        let mut crc = Crc::new();
        crc.update(&content);
        assert_eq!(
            (after[6], long(&after, 14).unwrap(), long(&after, 22).unwrap()),
            (0, crc.sum() as usize, content.len())
        );
        assert_eq!(after[first + size + 38..][..4], [1, 2, 3, 4]);
        assert_eq!(repacked(&after).unwrap(), after);
        assert!(repacked(&before[..before.len() - 1]).is_err());
        assert!(repacked(b"PK").is_err());
    }

    #[test]
    fn a_record_lists_sizes_and_hashes() {
        let files = files(&badly_packed("a/RECORD", b"old")).unwrap();
        let listed = [files[0].clone(), File::like(&files[0], "a/b.py", Vec::new())];
        let expected = "a/b.py,sha256=47DEQpj8HBSa-_TImW-5JCeuQeRkm5NMpJWZG3hSuFU,0\na/RECORD,,\n";
        assert_eq!(String::from_utf8(record(&listed, "a/RECORD")).unwrap(), expected);
    }
}

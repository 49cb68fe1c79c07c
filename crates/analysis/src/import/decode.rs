//! Decoding of bytes to text, with an error for files that are not text.

use super::forms;
use super::lines;
use super::program::Program;
use super::refusal::{ImportError, Refusal};
use std::borrow::Cow;
use units::{Words, words};

/// Number of bytes examined to decide if they are text.
const LOOK: usize = 8192;

/// Least ratio of the bytes of a text to its NUL bytes, which loggers write on a reset or a loss of power.
const NUL_PART: usize = 4;

/// Known file types, by their first bytes, with their names.
const KINDS: [(&[u8], Words); 10] = [
    (b"PK\x03\x04", words("a ZIP archive, as XLSX, ODS and TRZ are")),
    (b"%PDF", words("a PDF")),
    (b"\x89PNG", words("a picture")),
    (b"\xff\xd8\xff", words("a picture")),
    (b"GIF8", words("a picture")),
    (b"\x1f\x8b", words("a compressed file")),
    (b"\xd0\xcf\x11\xe0", words("an old Excel or Word file")),
    (b"\0\0\0\x18ftyp", words("a film")),
    (b"\0\0\0\x20ftyp", words("a film")),
    (b"RIFF", words("a film or a sound")),
];

/// Checks the beginning of a file, some thousand bytes, before the rest is read.
///
/// # Errors
/// These bytes cannot begin a text with a table.
pub fn look(start: &[u8]) -> Result<(), ImportError> {
    let start = start.get(..LOOK).unwrap_or(start);
    let refuse = |reason| Err(ImportError::new(None, reason));
    if let Some((_, name)) = KINDS.iter().find(|(magic, _)| start.starts_with(magic)) {
        return refuse(Refusal::Kind { name: name.clone() });
    }
    let text = characters(start);
    let no_text = |byte: u8| byte < 0x20 && !matches!(byte, 0 | b'\t' | b'\n' | b'\r' | 0x0b | 0x0c | 0x1a);
    let nuls = text.bytes().filter(|byte| *byte == 0).count();
    if text.bytes().any(no_text) || NUL_PART * nuls > text.len() {
        return refuse(Refusal::Binary);
    }
    let text = text.trim_start();
    let begins = |tag: &&str| text.get(..tag.len()).is_some_and(|first| first.eq_ignore_ascii_case(tag));
    if forms::is_html(text) {
        return Ok(());
    }
    if ["<?xml", "<!doctype", "<html"].iter().any(begins) {
        if let Some(program) = Program::of_xml(text) {
            return refuse(Refusal::Program(program));
        }
        return refuse(Refusal::Markup);
    }
    Ok(())
}

/// Decodes a text and normalises its line ends to `\n` or `\r\n`: UTF-8, UTF-16 with a byte-order mark, else Windows-1252.
pub(super) fn decode(bytes: &[u8]) -> Result<Cow<'_, str>, ImportError> {
    look(bytes)?;
    let text = characters(bytes);
    if text.trim_start().is_empty() {
        return Err(ImportError::new(None, Refusal::Empty));
    }
    Ok(lines::settled(text))
}

/// Decodes like [`decode`], reusing the bytes without a copy if possible.
pub(super) fn decode_owned(bytes: Vec<u8>) -> Result<String, ImportError> {
    match decode(&bytes)? {
        Cow::Borrowed(text) if text.len() == bytes.len() => {}
        text => return Ok(text.into_owned()),
    }
    Ok(String::from_utf8(bytes).unwrap_or_default())
}

/// Decodes bytes: UTF-8, UTF-16 with a byte-order mark, else Windows-1252.
pub(crate) fn characters(bytes: &[u8]) -> Cow<'_, str> {
    match bytes {
        [0xff, 0xfe, rest @ ..] => utf16(rest, u16::from_le_bytes),
        [0xfe, 0xff, rest @ ..] => utf16(rest, u16::from_be_bytes),
        [0xef, 0xbb, 0xbf, rest @ ..] => plain(rest),
        _ if every_second_is_nul(bytes, 1) => utf16(bytes, u16::from_le_bytes),
        _ if every_second_is_nul(bytes, 0) => utf16(bytes, u16::from_be_bytes),
        _ => plain(bytes),
    }
}

/// True if the bytes at even (`from` 0) or odd places (`from` 1) of the beginning are zero and no others: UTF-16 of Latin
/// letters without a byte-order mark.
fn every_second_is_nul(bytes: &[u8], from: usize) -> bool {
    let start = bytes.get(..bytes.len().min(256)).unwrap_or_default();
    start.len() >= 8 && start.iter().enumerate().all(|(place, byte)| (*byte == 0) == (place % 2 == from))
}

fn utf16(bytes: &[u8], word: fn([u8; 2]) -> u16) -> Cow<'_, str> {
    let words = bytes.chunks_exact(2).map(|pair| word([pair[0], pair[1]]));
    Cow::Owned(char::decode_utf16(words).map(|character| character.unwrap_or(char::REPLACEMENT_CHARACTER)).collect())
}

/// Characters of Windows-1252 from 0x80 to 0x9f; five bytes are undefined.
const WINDOWS: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}', '\u{90}', '‘', '’',
    '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];

/// Decodes UTF-8, or else Windows-1252, which equals Latin-1 except for [`WINDOWS`] and has a character for every byte.
fn plain(bytes: &[u8]) -> Cow<'_, str> {
    match core::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => {
            let character = |byte: &u8| {
                let special = byte.checked_sub(0x80).and_then(|place| WINDOWS.get(usize::from(place)).copied());
                special.unwrap_or(char::from(*byte))
            };
            Cow::Owned(bytes.iter().map(character).collect())
        }
    }
}

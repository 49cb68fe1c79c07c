//! Detection of the container format by the first bytes.

use super::FilmError;

/// Supported container format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Format {
    Mp4,
    Matroska,
    Avi,
}

/// First bytes of film formats that are not supported.
const OTHERS: [(&[u8], &str); 7] = [
    (&[0x30, 0x26, 0xb2, 0x75, 0x8e, 0x66], "WMV"),
    (b"FLV", "FLV"),
    (b"OggS", "Ogg"),
    (&[0, 0, 1, 0xba], "MPEG"),
    (&[0, 0, 1, 0xb3], "MPEG"),
    (b".RMF", "RealMedia"),
    (b"YUV4MPEG2", "Y4M"),
];

/// First box types of files of the MP4 family.
const BOXES: [&[u8; 4]; 9] = [b"ftyp", b"moov", b"mdat", b"wide", b"free", b"skip", b"pnot", b"styp", b"uuid"];
/// Brands of still pictures in such files.
const PICTURES: [&[u8; 4]; 5] = [b"heic", b"heix", b"mif1", b"avif", b"msf1"];

/// Container format by the first bytes, at most 512.
///
/// # Errors
///
/// The file is not a film, or has a format that is not supported.
pub(super) fn format(start: &[u8]) -> Result<Format, FilmError> {
    let begins = |with: &[u8]| start.starts_with(with);
    let four = |at: usize| start.get(at..at + 4).unwrap_or_default();
    if begins(b"GIF8") {
        return Err(FilmError::Gif);
    }
    if begins(&[0x89, b'P', b'N', b'G']) || begins(&[0xff, 0xd8, 0xff]) || (begins(b"RIFF") && four(8) == b"WEBP") {
        return Err(FilmError::Picture);
    }
    if begins(&[0x1a, 0x45, 0xdf, 0xa3]) {
        return Ok(Format::Matroska);
    }
    if begins(b"RIFF") && four(8) == b"AVI " {
        return Ok(Format::Avi);
    }
    if four(4) == b"ftyp" && PICTURES.iter().any(|brand| four(8) == *brand) {
        return Err(FilmError::Picture);
    }
    if BOXES.iter().any(|kind| four(4) == *kind) {
        return Ok(Format::Mp4);
    }
    if let Some((_, name)) = OTHERS.iter().find(|(bytes, _)| begins(bytes)) {
        return Err(FilmError::OtherFormat(name));
    }
    // Packets of a transport stream begin with 0x47. They have 188 bytes, in AVCHD cameras 192.
    let packets = |first: usize, length: usize| [0, 1].iter().all(|n| start.get(first + n * length) == Some(&0x47));
    if packets(0, 188) || packets(4, 192) {
        return Err(FilmError::OtherFormat("MPEG-TS"));
    }
    Err(FilmError::NotAFilm)
}

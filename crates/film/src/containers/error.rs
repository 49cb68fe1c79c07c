//! Errors of opening a film file.

use super::codec::{Codec, Coding};
use super::limits::MOST_SAMPLES;
use units::number::fixed;
use units::{Language, Words, words};

/// Reason why a file cannot be opened as a film.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FilmError {
    /// The file is empty.
    Empty,
    /// The first bytes match no film format.
    NotAFilm,
    /// Animated GIF: its times are rounded to 0.01 s and often changed by the program that made it.
    Gif,
    /// Still picture.
    Picture,
    /// Film format that is not supported, with its name.
    OtherFormat(&'static str),
    /// The file holds no video track.
    NoVideo,
    /// The video track has no frames.
    NoFrames,
    /// The frames are encrypted.
    Encrypted,
    /// The browser has no decoder for this codec. Never returned by the readers, only by the decoding side.
    NoDecoder(Codec),
    /// The file ends before the list of frames.
    Truncated {
        /// Size of the file in bytes.
        bytes: u64,
    },
    /// Part of the file with invalid or contradictory content.
    Damaged {
        /// Name of the part in the format.
        part: &'static str,
    },
    /// The frames are compressed once more, or one block holds several. No camera does this.
    Packed,
    /// The film has more than [`MOST_SAMPLES`] frames, or a table or number of parts beyond the
    /// limits.
    TooLarge,
}

/// Advice to convert the film to a supported format.
const CONVERT: Words = words(
    "convert it to MP4 with H.264 without changing its times, for instance with `ffmpeg -i FILM -fps_mode passthrough -c:v libx264 -pix_fmt yuv420p FILM.mp4`",
);

/// File size as text, such as `15 MB`.
pub(super) fn size(bytes: u64) -> String {
    match bytes {
        0..1_000 => format!("{bytes} B"),
        1_000..1_000_000 => format!("{} kB", bytes / 1_000),
        _ => format!("{} MB", fixed(bytes as f64 / 1e6, 0, Language::English.style())),
    }
}

impl FilmError {
    /// Message: the fault and its remedy.
    pub fn words(&self) -> Words {
        match self {
            Self::Empty => words("the file is empty; copy it again"),
            Self::NotAFilm => words("the file is not a film; MP4, MOV, WebM, MKV and AVI are read"),
            Self::Gif => words(
                "this is an animated GIF, whose times are rounded to 0.01 s; use the film that it was made from, or convert it to MP4 if there is none",
            ),
            Self::Picture => words("this is a picture, not a film; MP4, MOV, WebM, MKV and AVI are read"),
            Self::OtherFormat(name) => {
                words!("{name} films are not read; {convert}", name = Words::same(*name), convert = CONVERT)
            }
            Self::NoVideo => words("the file holds no video; if it is a sound recording, choose the film instead"),
            Self::NoFrames => words(
                "the video in the file has no frames; the recording was stopped at once or the file is cut off: copy or record it again",
            ),
            Self::Encrypted => words("the film is encrypted and cannot be read; use a film of your own camera"),
            Self::NoDecoder(Codec { coding: Coding::Hevc, .. }) => words(
                "the film is coded in HEVC (H.265), which this browser cannot decode. iPhones film in HEVC unless Settings > Camera > Formats is set to Most Compatible: set it so and film again, or convert the film to MP4 with H.264",
            ),
            Self::NoDecoder(codec) => words!(
                "the film is coded in {name}, which this browser cannot decode; the program `meniscus track` reads it with ffmpeg, or {convert}",
                name = Words::same(codec.label().to_owned()),
                convert = CONVERT
            ),
            Self::Truncated { bytes } => words!(
                "the file ends after {} and before the list of its frames, without which they cannot be found; copy it again, or, if the recording was interrupted, repair it with a tool such as `untrunc`",
                size(*bytes)
            ),
            Self::Damaged { part } => words!(
                "the file is damaged: its part `{part}` contradicts itself; copy it again, or {convert}",
                part = Words::same(*part),
                convert = CONVERT
            ),
            Self::Packed => words!("the frames are packed in a way that is not read; {convert}", convert = CONVERT),
            Self::TooLarge => words!("the film has more than {MOST_SAMPLES} frames; cut out the part that you need"),
        }
    }
}

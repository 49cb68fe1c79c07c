//! Video codings and the codec strings that WebCodecs expects (W3C, WebCodecs Codec Registry).

use super::bytes::Bytes;
use std::fmt::Write;

/// Video coding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coding {
    /// H.264 (AVC).
    H264,
    /// H.265 (HEVC).
    Hevc,
    /// VP8.
    Vp8,
    /// VP9.
    Vp9,
    /// AV1.
    Av1,
    /// Motion JPEG: one JPEG picture per frame.
    Jpeg,
    /// MPEG-4 Part 2 (XVID, DivX). No browser decodes it.
    Mpeg4,
    /// Apple ProRes. No browser decodes it.
    ProRes,
    /// Uncompressed grey values, one byte per pixel.
    Raw,
    /// Another coding, which no browser decodes.
    Other,
}

impl Coding {
    /// True if some browsers decode this coding.
    pub fn is_in_browsers(self) -> bool {
        !matches!(self, Self::Mpeg4 | Self::ProRes | Self::Other)
    }

    /// Display name; `None` for [`Coding::Other`].
    fn name(self) -> Option<&'static str> {
        Some(match self {
            Self::H264 => "H.264",
            Self::Hevc => "HEVC (H.265)",
            Self::Vp8 => "VP8",
            Self::Vp9 => "VP9",
            Self::Av1 => "AV1",
            Self::Jpeg => "Motion JPEG",
            Self::Mpeg4 => "MPEG-4 Part 2 (XVID, DivX)",
            Self::ProRes => "Apple ProRes",
            Self::Raw => "Y8",
            Self::Other => return None,
        })
    }
}

/// Configuration of a decoder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Codec {
    /// Video coding.
    pub coding: Coding,
    /// Codec string, such as `avc1.64001f`. Motion JPEG, which an image decoder reads, has the media type `image/jpeg`.
    /// A coding that no browser decodes has its name in the file.
    pub name: String,
    /// `description` of the WebCodecs configuration: the record `avcC` or `hvcC`; empty for other codings.
    pub description: Vec<u8>,
}

impl Codec {
    fn of(coding: Coding, name: impl Into<String>) -> Self {
        Self { coding, name: name.into(), description: Vec::new() }
    }

    /// Display name of the coding.
    pub fn label(&self) -> &str {
        self.coding.name().unwrap_or(&self.name)
    }

    /// Codec by a four-character code, as in AVI, QuickTime and Windows headers in Matroska (fourcc.org; RIFF tags of
    /// ffmpeg).
    pub(super) fn of_four(four: [u8; 4]) -> Self {
        match &four.map(|byte| byte.to_ascii_uppercase()) {
            b"MJPG" | b"JPEG" | b"DMB1" => Self::jpeg(),
            b"XVID" | b"DIVX" | b"DX50" | b"FMP4" | b"MP4V" | b"MP4S" | b"M4S2" | b"3IV2" | b"\x04\0\0\0" => {
                Self::of(Coding::Mpeg4, printable(&four))
            }
            b"APCO" | b"APCS" | b"APCN" | b"APCH" | b"AP4H" | b"AP4X" => Self::of(Coding::ProRes, printable(&four)),
            [0, 0, 0, 0] => Self::other(b"RGB"),
            _ => Self::other(&four),
        }
    }

    /// Unknown coding with its name in the file.
    pub(super) fn other(name: &[u8]) -> Self {
        Self::of(Coding::Other, printable(name))
    }

    pub(super) fn jpeg() -> Self {
        Self::of(Coding::Jpeg, "image/jpeg")
    }

    pub(super) fn vp8() -> Self {
        Self::of(Coding::Vp8, "vp8")
    }

    /// H.264 from the record `avcC` (ISO/IEC 14496-15, 5.3.3.1). `entry`: `avc1` or `avc3`. `None` for an invalid
    /// record.
    pub(super) fn h264(entry: &str, record: &[u8]) -> Option<Self> {
        let [1, profile, compatibility, level, ..] = record else { return None };
        let name = format!("{entry}.{profile:02x}{compatibility:02x}{level:02x}");
        Some(Self { coding: Coding::H264, name, description: record.to_vec() })
    }

    /// H.264 of unknown profile, until the first frame is read.
    pub(super) fn h264_without_record() -> Self {
        Self::of(Coding::H264, "avc1")
    }

    /// H.264 from the start of a frame, for files without a record, such as Matroska recordings of browsers. The
    /// parameter set stands before each key frame, after a start code (Rec. ITU-T H.264, 7.3.2.1.1 and B.1). `None` if
    /// it is not found.
    pub(super) fn h264_of_frame(start: &[u8]) -> Option<Self> {
        start.windows(7).find_map(|window| match window {
            [0, 0, 1, unit, profile, compatibility, level] if unit & 0x1f == 7 => {
                Some(Self::of(Coding::H264, format!("avc1.{profile:02x}{compatibility:02x}{level:02x}")))
            }
            _ => None,
        })
    }

    /// HEVC from the record `hvcC` (ISO/IEC 14496-15, 8.3.3.1; codec string: E.3). `entry`: `hvc1` or `hev1`. `None`
    /// for an invalid record.
    pub(super) fn hevc(entry: &str, record: &[u8]) -> Option<Self> {
        let mut bytes = Bytes(record);
        bytes.u8()?;
        let general = bytes.u8()?;
        let compatibility = bytes.u32()?.reverse_bits();
        let constraints = bytes.take(6)?;
        let level = bytes.u8()?;
        let space = ["", "A", "B", "C"].get(usize::from(general >> 6))?;
        let tier = if general & 0x20 == 0 { 'L' } else { 'H' };
        let mut name = format!("{entry}.{space}{}.{compatibility:x}.{tier}{level}", general & 0x1f);
        let last = constraints.iter().rposition(|&byte| byte != 0).map_or(0, |at| at + 1);
        for byte in constraints.iter().take(last) {
            write!(name, ".{byte:x}").ok()?;
        }
        Some(Self { coding: Coding::Hevc, name, description: record.to_vec() })
    }

    /// VP9 with profile, level (10 times the level number, 0 if unknown) and bit depth.
    pub(super) fn vp9(profile: u8, level: u8, depth: u8) -> Self {
        let level = if level == 0 { 10 } else { level };
        Self::of(Coding::Vp9, format!("vp09.{profile:02}.{level:02}.{depth:02}"))
    }

    /// VP9 from the box `vpcC` (VP Codec ISO Media File Format Binding, version 1). `None` if the box is too short.
    pub(super) fn vp9_of_box(content: &[u8]) -> Option<Self> {
        let [_, _, _, _, profile, level, depth, ..] = content else { return None };
        Some(Self::vp9(*profile, *level, depth >> 4))
    }

    /// VP9 from the private data of WebM: features as identifier, length, value (WebM Container Guidelines).
    pub(super) fn vp9_of_features(content: &[u8]) -> Self {
        let (mut profile, mut level, mut depth) = (0, 0, 8);
        let mut bytes = Bytes(content);
        while let Some((feature, length)) = bytes.u8().zip(bytes.u8()) {
            match (feature, bytes.take(usize::from(length))) {
                (1, Some(&[value])) => profile = value,
                (2, Some(&[value])) => level = value,
                (3, Some(&[value])) => depth = value,
                (_, Some(_)) => {}
                (_, None) => break,
            }
        }
        Self::vp9(profile, level, depth)
    }

    /// VP9 from the first byte of a frame, which holds the profile (VP9 Bitstream Specification, 6.2). Profiles 2 and 3
    /// have 10 or 12 bits; 10 is assumed. `None` for an empty frame.
    pub(super) fn vp9_of_frame(start: &[u8]) -> Option<Self> {
        let first = *start.first()?;
        let profile = (first >> 5 & 1) | (first >> 3 & 2);
        Some(Self::vp9(profile, 0, if profile < 2 { 8 } else { 10 }))
    }

    /// AV1 from the record `av1C` (AV1 Codec ISO Media File Format Binding, 2.3.3). `None` if the record is too short.
    pub(super) fn av1(record: &[u8]) -> Option<Self> {
        let [_, sequence, depth, ..] = record else { return None };
        let tier = if depth & 0x80 == 0 { 'M' } else { 'H' };
        let bits = match (depth & 0x40 != 0, depth & 0x20 != 0) {
            (false, _) => 8,
            (true, false) => 10,
            (true, true) => 12,
        };
        Some(Self::of(Coding::Av1, format!("av01.{}.{:02}{tier}.{bits:02}", sequence >> 5, sequence & 0x1f)))
    }
}

/// First 40 characters of a name in a file, with `?` for unprintable ones.
fn printable(name: &[u8]) -> String {
    let printable = |&byte: &u8| if byte.is_ascii_graphic() { char::from(byte) } else { '?' };
    name.iter().take(40).map(printable).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// RFC 6381, the specifications named above, and what `MediaInfo` prints for such records.
    #[test]
    fn codec_strings() {
        let avc = Codec::h264("avc1", &[1, 0x64, 0, 0x1f, 0xff, 0xe1]).unwrap();
        assert_eq!((avc.name.as_str(), avc.description.len()), ("avc1.64001f", 6));
        let iphone = [1, 1, 0x60, 0, 0, 0, 0xb0, 0, 0, 0, 0, 0, 123];
        assert_eq!(Codec::hevc("hvc1", &iphone).unwrap().name, "hvc1.1.6.L123.b0");
        let ten_bits = [1, 0x22, 0x20, 0, 0, 0, 0xb0, 0, 1, 0, 0, 0, 153];
        assert_eq!(Codec::hevc("hev1", &ten_bits).unwrap().name, "hev1.2.4.H153.b0.0.1");
        assert_eq!(Codec::vp9_of_box(&[1, 0, 0, 0, 2, 31, 0xa2, 9]).unwrap().name, "vp09.02.31.10");
        assert_eq!(Codec::vp9_of_features(&[1, 1, 0, 2, 1, 21, 3, 1, 8, 4, 1, 1]).name, "vp09.00.21.08");
        assert_eq!(Codec::vp9_of_frame(&[0x82]).unwrap().name, "vp09.00.10.08");
        assert_eq!(Codec::vp9_of_frame(&[0x92]).unwrap().name, "vp09.02.10.10");
        let frame = [0, 0, 0, 1, 9, 0xf0, 0, 0, 0, 1, 0x67, 0x42, 0xc0, 0x0c, 0xda];
        assert_eq!(Codec::h264_of_frame(&frame).unwrap().name, "avc1.42c00c");
        assert_eq!(Codec::av1(&[0x81, 0x08, 0x0c, 0]).unwrap().name, "av01.0.08M.08");
        assert_eq!(Codec::av1(&[0x81, 0x4d, 0xe0, 0]).unwrap().name, "av01.2.13H.12");
        assert_eq!((Codec::h264("avc1", &[1, 2]), Codec::hevc("hvc1", &[1]), Codec::av1(&[])), (None, None, None));
    }
}

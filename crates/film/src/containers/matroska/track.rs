//! Video tracks of Matroska (RFC 9559, 5.1.4).

use super::super::FilmError;
use super::super::codec::Codec;
use super::super::film::{Orientation, lowest_terms};
use super::ebml::{Elements, find, float, unsigned};

/// Determines the codec from the start of a frame.
type ByFrame = fn(&[u8]) -> Option<Codec>;

/// Properties of the chosen video track.
#[derive(Debug)]
pub(super) struct Track {
    pub(super) number: u64,
    pub(super) codec: Codec,
    /// Determines the profile from the first frame, if the track header lacks it.
    pub(super) ask_frame: Option<ByFrame>,
    pub(super) size: [u32; 2],
    pub(super) pixel_aspect: [u32; 2],
    /// `None` for an angle that is not a multiple of 90 degrees.
    pub(super) orientation: Option<Orientation>,
    pub(super) stated_rate: Option<f64>,
}

/// All video tracks in the content of `Tracks`, each with the reason if it cannot be read.
pub(super) fn tracks(content: &[u8]) -> Vec<Result<Track, FilmError>> {
    let entries = Elements(content).filter(|(id, _)| *id == 0xae).map(|(_, content)| content);
    let videos = entries.filter(|content| find(content, 0x83).and_then(unsigned) == Some(1));
    videos.map(track).collect()
}

fn track(content: &[u8]) -> Result<Track, FilmError> {
    let damaged = FilmError::Damaged { part: "TrackEntry" };
    let Some(number) = find(content, 0xd7).and_then(unsigned) else { return Err(damaged) };
    let Some(video) = find(content, 0xe0) else { return Err(FilmError::Damaged { part: "Video" }) };
    if let Some(encodings) = find(content, 0x6d80) {
        let encrypted = Elements(encodings).any(|(_, encoding)| find(encoding, 0x5033).and_then(unsigned) == Some(1));
        return Err(if encrypted { FilmError::Encrypted } else { FilmError::Packed });
    }
    let name = find(content, 0x86).unwrap_or_default();
    let name = name.split(|&byte| byte == 0).next().unwrap_or_default();
    let record = find(content, 0x63a2);
    let mut ask_frame = None::<ByFrame>;
    let codec = match (name, record) {
        (b"V_MPEG4/ISO/AVC", Some(record)) => Codec::h264("avc1", record),
        (b"V_MPEG4/ISO/AVC", None) => {
            ask_frame = Some(Codec::h264_of_frame);
            Some(Codec::h264_without_record())
        }
        (b"V_MPEGH/ISO/HEVC", Some(record)) => Codec::hevc("hvc1", record),
        (b"V_VP8", _) => Some(Codec::vp8()),
        (b"V_VP9", Some(features)) if !features.is_empty() => Some(Codec::vp9_of_features(features)),
        (b"V_VP9", _) => {
            ask_frame = Some(Codec::vp9_of_frame);
            Some(Codec::vp9(0, 0, 8))
        }
        (b"V_AV1", Some(record)) => Codec::av1(record),
        (b"V_MJPEG", _) => Some(Codec::jpeg()),
        (b"V_MS/VFW/FOURCC", Some(header)) => {
            header.get(16..).and_then(|rest| rest.first_chunk()).copied().map(Codec::of_four)
        }
        (b"V_MPEG4/ISO/SP" | b"V_MPEG4/ISO/ASP" | b"V_MPEG4/ISO/AP", _) => Some(Codec::of_four(*b"mp4v")),
        (b"V_PRORES", _) => Some(Codec::of_four(*b"apcn")),
        (b"V_MPEGH/ISO/HEVC" | b"V_AV1", None) => None,
        _ => Some(Codec::other(name)),
    };
    let codec = codec.ok_or(FilmError::Damaged { part: "CodecPrivate" })?;
    let pixels = |id| find(video, id).and_then(unsigned).and_then(|value| u32::try_from(value).ok());
    let size = [pixels(0xb0).unwrap_or(0), pixels(0xba).unwrap_or(0)];
    let stated_rate = find(content, 0x0023_e383).and_then(unsigned).filter(|&nanoseconds| nanoseconds > 0);
    Ok(Track {
        number,
        codec,
        ask_frame,
        size,
        pixel_aspect: pixel_aspect(size, pixels(0x54b0), pixels(0x54ba)),
        orientation: find(video, 0x7670).map_or(Some(Orientation::default()), orientation),
        stated_rate: stated_rate.map(|nanoseconds| 1e9 / nanoseconds as f64),
    })
}

/// Pixel aspect ratio from the display size, which may have any unit. `size` in px.
fn pixel_aspect([width, height]: [u32; 2], shown_width: Option<u32>, shown_height: Option<u32>) -> [u32; 2] {
    let (Some(shown_width), Some(shown_height)) = (shown_width, shown_height) else { return [1, 1] };
    let across = u64::from(shown_width) * u64::from(height);
    let down = u64::from(shown_height) * u64::from(width);
    lowest_terms(across, down).unwrap_or([1, 1])
}

/// Orientation of a flat picture: roll in degrees, counter-clockwise, after a yaw of 180 degrees, which mirrors it (RFC
/// 9559, 5.1.4.1.28.44 to 46). `None` for other angles.
fn orientation(projection: &[u8]) -> Option<Orientation> {
    let angle = |id| find(projection, id).and_then(float).unwrap_or(0.0);
    let (yaw, turns) = (angle(0x7673).abs(), (-angle(0x7675) / 90.0).round());
    let straight =
        (angle(0x7675) + 90.0 * turns).abs() < 0.5 && turns.abs() <= 4.0 && (yaw < 0.5 || (yaw - 180.0).abs() < 0.5);
    straight.then(|| Orientation { quarter_turns: (turns as i32).rem_euclid(4) as u8, mirrored: yaw > 90.0 })
}

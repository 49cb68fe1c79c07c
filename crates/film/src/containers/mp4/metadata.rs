//! Frame rate at recording, from the metadata of a movie.

use super::super::bytes::Bytes;
use super::boxes::{Boxes, find, follow};

/// Metadata key of Android for the recording rate, in slow-motion and normal films.
const CAPTURE_RATE: &[u8] = b"com.android.capture.fps";

/// Frames per second at recording, from `meta` or `udta/meta` in the content of `moov`.
pub(super) fn capture_rate(movie: &[u8]) -> Option<f64> {
    [&[b"meta"] as &[&[u8; 4]], &[b"udta", b"meta"]].iter().find_map(|path| rate_in(follow(movie, path)?))
}

/// Searches a `meta` box of named values (QuickTime File Format, Metadata). `keys` lists the names; the type of each
/// box in `ilst` is the index of its name, from 1.
fn rate_in(meta: &[u8]) -> Option<f64> {
    // The `meta` of QuickTime begins with its first box, that of MP4 with version and flags.
    let boxes = if meta.get(4..8) == Some(b"hdlr") { meta } else { meta.get(4..)? };
    let names = Boxes(find(boxes, b"keys")?.get(8..)?);
    let number = 1 + u32::try_from(names.map(|(_, name)| name).position(|name| name == CAPTURE_RATE)?).ok()?;
    let mut data = Bytes(follow(boxes, &[b"ilst", &number.to_be_bytes(), b"data"])?);
    let kind = data.u32()?;
    data.take(4)?;
    let rate = match kind {
        1 => std::str::from_utf8(data.0).ok()?.trim().parse().ok()?,
        21 | 22 => f64::from(data.u32()?),
        23 => f64::from(f32::from_bits(data.u32()?)),
        24 => f64::from_bits(data.u64()?),
        _ => return None,
    };
    (rate.is_finite() && rate > 0.0 && rate <= 1e6).then_some(rate)
}

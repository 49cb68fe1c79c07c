//! What cameras add to a movie: the rate at which frames were taken.

use super::super::bytes::Bytes;
use super::boxes::{Boxes, find, follow};

/// The name under which Android writes it, in movies of slow motion and of normal speed.
const CAPTURE_RATE: &[u8] = b"com.android.capture.fps";

/// Frames that were taken in a second, in the content of `moov`: in its `meta`, or in that of `udta`.
pub(super) fn capture_rate(movie: &[u8]) -> Option<f64> {
    [&[b"meta"] as &[&[u8; 4]], &[b"udta", b"meta"]].iter().find_map(|path| rate_in(follow(movie, path)?))
}

/// In a `meta` of named values (QuickTime File Format, Metadata): `keys` has the names, `ilst` boxes whose types are the
/// numbers of the names from 1.
fn rate_in(meta: &[u8]) -> Option<f64> {
    // QuickTime's `meta` begins with its first box, that of MP4 with version and flags.
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

//! Content of a hand-in that this program makes.

use flate2::Compression;
use flate2::write::ZlibEncoder;
use saved::hand_in::HandIn;
use std::io::Write;
use std::time::{SystemTime, UNIX_EPOCH};

/// The deflated text of a hand-in.
pub fn packed(hand_in: &HandIn) -> Vec<u8> {
    let text = hand_in.write();
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::best());
    // Writing to memory cannot fail; without compression the text is carried as it is.
    match encoder.write_all(text.as_bytes()).and_then(|()| encoder.finish()) {
        Ok(packed) => packed,
        Err(_) => text.into_bytes(),
    }
}

/// Present time in milliseconds since 1970.
pub fn now() -> u64 {
    SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |time| time.as_millis() as u64)
}

//! Encoding of grey pictures as PNG files (ISO/IEC 15948).

use packed::checksum;

/// Maximum length of a stored block in a zlib stream, in bytes.
const LONGEST_BLOCK: usize = 65_535;

/// PNG file with 16 grey values, half a byte per pixel. `grey`: values from 0 to 255, row by row. The rounding error of
/// a pixel is added to the next one, which preserves the mean of an area (R. W. Floyd & L. Steinberg, Proc. SID 17
/// (1976) 75, along the row only). The data are not compressed, because camera noise hardly compresses and the page
/// would need the code.
pub fn png(width: usize, height: usize, grey: &[u8]) -> Vec<u8> {
    let mut rows = Vec::with_capacity(height * (width / 2 + 2));
    for row in grey.chunks_exact(width.max(1)).take(height) {
        // Filter type 0 (none).
        rows.push(0);
        let mut error = 0;
        let mut level = |value: &u8| {
            let wanted = i32::from(*value) + error;
            let level = ((wanted + 8) / 17).clamp(0, 15);
            error = wanted - 17 * level;
            level as u8
        };
        for pair in row.chunks(2) {
            let high = pair.first().map_or(0, &mut level);
            let low = pair.get(1).map_or(0, &mut level);
            rows.push(high << 4 | low);
        }
    }
    let mut out = b"\x89PNG\r\n\x1a\n".to_vec();
    let size = [width, height].map(|side| (side as u32).to_be_bytes());
    chunk(&mut out, b"IHDR", &[&size[0][..], &size[1], &[4, 0, 0, 0, 0]].concat());
    chunk(&mut out, b"IDAT", &stored(&rows));
    chunk(&mut out, b"IEND", &[]);
    out
}

fn chunk(out: &mut Vec<u8>, kind: &[u8; 4], content: &[u8]) {
    out.extend((content.len() as u32).to_be_bytes());
    let checked = [kind, content].concat();
    out.extend(&checked);
    out.extend(checksum(&checked).to_be_bytes());
}

/// zlib stream (RFC 1950) of stored blocks.
fn stored(bytes: &[u8]) -> Vec<u8> {
    let mut out = vec![0x78, 0x01];
    let mut blocks = bytes.chunks(LONGEST_BLOCK).peekable();
    while let Some(block) = blocks.next() {
        let length = block.len() as u16;
        out.push(u8::from(blocks.peek().is_none()));
        out.extend(length.to_le_bytes());
        out.extend((!length).to_le_bytes());
        out.extend(block);
    }
    // Checksum Adler-32.
    let (a, b) = bytes.iter().fold((1_u32, 0_u32), |(a, b), byte| {
        let a = (a + u32::from(*byte)) % 65_521;
        (a, (a + b) % 65_521)
    });
    out.extend((b << 16 | a).to_be_bytes());
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The smallest picture, byte by byte: one pixel of grey 255.
    #[test]
    fn one_white_pixel() {
        let file = png(1, 1, &[255]);
        assert_eq!(&file[..8], b"\x89PNG\r\n\x1a\n");
        assert_eq!(&file[12..29], b"IHDR\0\0\0\x01\0\0\0\x01\x04\0\0\0\0");
        // Filter 0 and the pixel in the upper half of a byte; Adler-32 of 00 f0 is 00f200f1.
        assert_eq!(&file[41..54], b"\x78\x01\x01\x02\0\xfd\xff\0\xf0\0\xf2\0\xf1");
        assert_eq!(&file[file.len() - 12..], b"\0\0\0\0IEND\xae\x42\x60\x82");
    }

    /// A grey value halfway between two of the 16 levels: pixels alternate between both, and the mean is preserved.
    #[test]
    fn the_mean_of_an_area_stays() {
        let rows = png(100, 1, &[128; 100]);
        let pixels = &rows[49..99];
        let sum: u32 = pixels.iter().map(|byte| u32::from(byte >> 4) + u32::from(byte & 15)).sum();
        assert!((f64::from(sum) * 17.0 / 100.0 - 128.0).abs() < 0.2, "{sum}");
    }
}

//! CRC-32, the checksum of ZIP archives and PNG pictures.

/// CRC-32 of each byte value.
const CHECKS: [u32; 256] = {
    let mut table = [0; 256];
    let mut byte = 0;
    while byte < 256 {
        let mut check = byte as u32;
        let mut bit = 0;
        while bit < 8 {
            check = if check & 1 == 1 { 0xEDB8_8320 ^ (check >> 1) } else { check >> 1 };
            bit += 1;
        }
        table[byte] = check;
        byte += 1;
    }
    table
};

/// CRC-32 as in ZIP, of bytes that come in pieces.
#[derive(Clone, Copy, Debug)]
pub struct Checksum(u32);

impl Default for Checksum {
    fn default() -> Self {
        Self(u32::MAX)
    }
}

impl Checksum {
    /// Adds the next piece.
    pub fn add(&mut self, bytes: &[u8]) {
        let next = |check: u32, byte: &u8| CHECKS[((check ^ u32::from(*byte)) & 0xff) as usize] ^ (check >> 8);
        self.0 = bytes.iter().fold(self.0, next);
    }

    /// Checksum of all pieces so far.
    pub fn value(self) -> u32 {
        !self.0
    }
}

/// CRC-32 (ISO 3309) of some bytes, as used in ZIP archives and PNG pictures.
pub fn checksum(bytes: &[u8]) -> u32 {
    let mut checksum = Checksum::default();
    checksum.add(bytes);
    checksum.value()
}

#[cfg(test)]
mod tests {
    use super::checksum;

    #[test]
    fn the_checksum_is_the_published_one() {
        assert_eq!(checksum(b"123456789"), 0xCBF4_3926);
        assert_eq!(checksum(b""), 0);
    }
}

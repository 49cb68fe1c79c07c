//! A ZIP archive whose files are stored as they are (PKWARE, APPNOTE.TXT 6.3.3). Made again it has the same bytes: the time
//! in it is the first that the format has.

/// The first of January 1980.
const DATE: u16 = 0x0021;
/// Version 2.0, and names in UTF-8.
const VERSION: u16 = 20;
const UTF8: u16 = 0x0800;

/// An archive that grows.
#[derive(Debug, Default)]
pub struct Archive {
    bytes: Vec<u8>,
    directory: Vec<u8>,
    files: u16,
}

impl Archive {
    /// Adds a file.
    pub fn add(&mut self, name: &str, content: &[u8]) {
        let start = self.bytes.len() as u32;
        let size = content.len() as u32;
        // What both headers of a file say about it.
        let mut facts = Vec::with_capacity(26);
        for word in [VERSION, UTF8, 0, 0, DATE] {
            facts.extend(word.to_le_bytes());
        }
        for word in [checksum(content), size, size] {
            facts.extend(word.to_le_bytes());
        }
        for word in [name.len() as u16, 0] {
            facts.extend(word.to_le_bytes());
        }
        self.bytes.extend(b"PK\x03\x04");
        self.bytes.extend(&facts);
        self.bytes.extend(name.as_bytes());
        self.bytes.extend(content);
        self.directory.extend(b"PK\x01\x02");
        self.directory.extend(VERSION.to_le_bytes());
        self.directory.extend(&facts);
        // No comment, first disk, no attributes.
        self.directory.extend([0; 10]);
        self.directory.extend(start.to_le_bytes());
        self.directory.extend(name.as_bytes());
        self.files += 1;
    }

    /// The whole archive.
    pub fn finish(mut self) -> Vec<u8> {
        let start = self.bytes.len() as u32;
        let size = self.directory.len() as u32;
        self.bytes.extend(&self.directory);
        self.bytes.extend(b"PK\x05\x06\0\0\0\0");
        self.bytes.extend(self.files.to_le_bytes());
        self.bytes.extend(self.files.to_le_bytes());
        self.bytes.extend(size.to_le_bytes());
        self.bytes.extend(start.to_le_bytes());
        self.bytes.extend([0; 2]);
        self.bytes
    }
}

/// CRC-32 of a byte for each value, bit by bit.
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

/// The CRC-32 of the archive format, of bytes that come one piece after the other.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Checksum(u32);

impl Default for Checksum {
    fn default() -> Self {
        Self(u32::MAX)
    }
}

impl Checksum {
    /// Takes the next piece.
    pub fn add(&mut self, bytes: &[u8]) {
        let next = |check: u32, byte: &u8| CHECKS[((check ^ u32::from(*byte)) & 0xff) as usize] ^ (check >> 8);
        self.0 = bytes.iter().fold(self.0, next);
    }

    /// That of all pieces so far.
    pub fn value(self) -> u32 {
        !self.0
    }
}

/// The CRC-32 (ISO 3309) of some bytes, as ZIP archives and PNG pictures have it.
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

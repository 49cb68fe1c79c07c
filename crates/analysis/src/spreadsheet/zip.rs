//! Writer of a ZIP archive with stored files (PKWARE, APPNOTE.TXT 6.3.3). Its bytes are reproducible: all files have the
//! earliest date of the format.

use packed::checksum;

/// 1 January 1980.
const DATE: u16 = 0x0021;
/// Version 2.0, and the flag for names in UTF-8.
const VERSION: u16 = 20;
const UTF8: u16 = 0x0800;

/// Archive under construction.
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
        // Fields common to both headers of a file.
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

    /// Bytes of the archive.
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

//! Files in ZIP archives and their XML as streams, with bounds on the memory that a hostile file can use.

mod archive;
pub mod bytes;
mod checksum;
mod gathering;
mod part;
mod xml;

pub use archive::{Archive, Stored};
pub use checksum::{Checksum, checksum};
pub use gathering::Gathering;
pub use part::Part;
pub use xml::{Tag, Token, Xml};

/// True if a file begins like a ZIP archive.
pub fn is_archive(start: &[u8]) -> bool {
    start.starts_with(b"PK\x03\x04")
}

/// Reason why an archive, or XML, cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Defect {
    /// It is truncated, changed, or contradicts the directory of the archive.
    Damaged,
    /// It needs a password.
    Protected,
    /// A file would expand too much.
    Expands {
        /// Size in the archive, in bytes.
        packed: u64,
        /// Expanded size, in bytes.
        expanded: u64,
    },
}

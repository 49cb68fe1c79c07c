//! Files in ZIP archives and their XML as streams, with bounds on the memory that a hostile file can use.

mod archive;
mod gathering;
mod part;
mod xml;

pub(crate) use archive::Archive;
pub use gathering::Gathering;
pub(crate) use part::Part;
pub(crate) use xml::{Tag, Token, Xml};

/// True if a file begins like a ZIP archive.
pub(crate) fn is_archive(start: &[u8]) -> bool {
    start.starts_with(b"PK\x03\x04")
}

/// Reason why an archive, or XML, cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Defect {
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

//! Files in ZIP archives and their XML as streams, with bounds on what a hostile file can make a reader hold.

mod archive;
mod gathering;
mod part;
mod xml;

pub(crate) use archive::Archive;
pub use gathering::Gathering;
pub(crate) use part::Part;
pub(crate) use xml::{Tag, Token, Xml};

/// Whether a file begins as a ZIP archive does.
pub(crate) fn is_archive(start: &[u8]) -> bool {
    start.starts_with(b"PK\x03\x04")
}

/// Why an archive, or XML, cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Defect {
    /// It is broken off, changed, or not as the archive's directory says.
    Damaged,
    /// It needs a password.
    Protected,
    /// A file would expand to too much.
    Expands {
        /// Its size in the archive, in bytes.
        packed: u64,
        /// Its size when expanded, in bytes.
        expanded: u64,
    },
}

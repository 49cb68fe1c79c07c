//! Files in ZIP archives and their XML as streams, with bounds on the memory that a hostile file can use. Workbooks, projects
//! of Tracker and simulations of WebEJS are such archives.
//!
//! [`Archive`] has the directory, [`Part`] the expanding content of one file, [`Xml`] its tokens. [`Gathering`] asks for the
//! bytes of an archive that are needed, so that one with a large film is not read whole.
//!
//! - **Invariant:** size, expansion ratio, length of a token and nesting are checked before anything is stored.
//! - **Invariant:** no I/O: bytes come in, and missing ranges are named.
//!
//! ```
//! use packed::{Archive, Defect, checksum};
//!
//! assert_eq!(checksum(b"123456789"), 0xcbf4_3926);
//! assert_eq!(Archive::open(b"no archive".to_vec()).err(), Some(Defect::Damaged));
//! ```

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

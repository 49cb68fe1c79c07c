//! Identification of a film at the next visit.

use units::fnv;

/// Key by which a film is recognised, since films are not stored.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FilmIdentity {
    /// Name of the file.
    pub name: String,
    /// Size of the file in bytes.
    pub size: u64,
    /// Hash of the first bytes of the file.
    pub hash: String,
}

impl FilmIdentity {
    /// Number of hashed bytes.
    pub const START: usize = 1 << 20;

    /// Identity of a file of `size` bytes with the first bytes `start`, of which at most [`Self::START`] count.
    ///
    /// The hash ([`fnv`]) distinguishes the films of one user and has no security purpose.
    pub fn new(name: &str, size: u64, start: &[u8]) -> Self {
        let hash = fnv::hashed(fnv::START, start.iter().take(Self::START).copied());
        let name = name.chars().take(200).collect();
        Self { name, size, hash: format!("{hash:016x}") }
    }

    /// True if size and hash are equal, whatever the names.
    pub fn is_same_film(&self, other: &Self) -> bool {
        self.size == other.size && self.hash == other.hash
    }
}

//! What a film is known by at the next visit.

/// What a film is known by: no film is stored.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FilmIdentity {
    /// The name of its file.
    pub name: String,
    /// How many bytes the file has.
    pub size: u64,
    /// The hash of its beginning.
    pub hash: String,
}

impl FilmIdentity {
    /// How many bytes of the beginning are hashed.
    pub const START: usize = 1 << 20;

    /// That of a file of `size` bytes that begins with these; what follows the first MiB does not count.
    ///
    /// The hash is FNV-1a with 64 bits (draft-eastlake-fnv): it tells films of one person apart, and nothing depends on it that
    /// somebody could want to forge.
    pub fn new(name: &str, size: u64, start: &[u8]) -> Self {
        let mut hash = 0xcbf2_9ce4_8422_2325_u64;
        for byte in start.iter().take(Self::START) {
            hash = (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        }
        let name = name.chars().take(200).collect();
        Self { name, size, hash: format!("{hash:016x}") }
    }

    /// Whether two files have the same bytes, as far as one can tell, whatever their names.
    pub fn is_same_film(&self, other: &Self) -> bool {
        self.size == other.size && self.hash == other.hash
    }
}

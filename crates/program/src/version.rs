//! Version of the program and number of its results' bits.

/// The number as a literal, for the texts made at compile time.
macro_rules! bits {
    () => {
        1
    };
}

/// Version of the program.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Number of the bits of all results: runs, draws, fits, cycles and tracks of two programs with the same number are equal to the
/// last bit. A change that moves a bit of any result raises it (`crates/probe/bits.txt` ties it to the golden results).
pub const BITS: u32 = bits!();

/// Version and number of the bits as reports and `--version` state them, such as `0.2.0 (bits 1)`.
pub const VERSION_AND_BITS: &str = concat!(env!("CARGO_PKG_VERSION"), " (bits ", bits!(), ")");

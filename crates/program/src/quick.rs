//! Maps and sets that are looked into very often, such as those of nodes and of names.

use std::collections::{HashMap, HashSet};
use std::hash::{BuildHasherDefault, Hasher};

/// A map with short keys. Whoever chooses all keys can make it slow; the bounds of a model bound that too.
pub type QuickMap<Key, Value> = HashMap<Key, Value, BuildHasherDefault<QuickHasher>>;

/// The same without values.
pub type QuickSet<Key> = HashSet<Key, BuildHasherDefault<QuickHasher>>;

/// Mixes each word by one multiplication, as Firefox and rustc do ("FxHash"); the hash of the standard library takes several times
/// as long, and more so in WebAssembly.
#[derive(Clone, Copy, Debug, Default)]
pub struct QuickHasher(u64);

/// 2^64 times the inverse golden ratio, rounded to an odd number.
const FACTOR: u64 = 0x9E37_79B9_7F4A_7C15;

impl Hasher for QuickHasher {
    fn write(&mut self, bytes: &[u8]) {
        for part in bytes.chunks(8) {
            let word = part.iter().fold(0, |word, byte| word << 8 | u64::from(*byte));
            self.write_u64(word);
        }
    }

    fn write_u8(&mut self, value: u8) {
        self.write_u64(u64::from(value));
    }

    fn write_u32(&mut self, value: u32) {
        self.write_u64(u64::from(value));
    }

    fn write_u64(&mut self, value: u64) {
        self.0 = (self.0.rotate_left(5) ^ value).wrapping_mul(FACTOR);
    }

    fn write_usize(&mut self, value: usize) {
        self.write_u64(value as u64);
    }

    fn write_isize(&mut self, value: isize) {
        self.write_u64(value as u64);
    }

    /// The product's high bits depend on all bits of the word, and a table looks at the low ones: as many as the largest graph needs.
    fn finish(&self) -> u64 {
        self.0.rotate_left(20)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::hash::{BuildHasher, Hash};

    fn low_bits<T: Hash>(values: impl Iterator<Item = T>) -> usize {
        let builder = BuildHasherDefault::<QuickHasher>::default();
        let places: HashSet<u64> = values.map(|value| builder.hash_one(value) % 1024).collect();
        places.len()
    }

    #[test]
    fn keys_spread_over_a_table() {
        // Of 1024 places, 1024 keys by chance take 647.
        assert!(low_bits((0..1024_u32).map(|number| (3_u8, number))) > 500);
        assert!(low_bits((0..1024).map(|number| f64::from(number).to_bits())) > 500);
        assert!(low_bits((0..1024).map(|number| format!("omega_{number}"))) > 500);
    }
}

//! Catalogues: the texts of a language by the hash of the English text, so that a page does not carry the English twice.

use super::list::Language;
use std::sync::OnceLock;

/// The texts of one language.
#[derive(Debug, Default)]
pub struct Catalogue {
    /// Hashes of the English texts, ascending.
    hashes: Vec<u32>,
    /// Number of English texts that could be translated.
    of: u32,
    /// The texts in the same order. They live as long as the program: each language is installed at most once.
    texts: Vec<&'static str>,
}

/// Number of bytes of a hash.
const HASH: usize = 4;
/// Separates the texts of a packed catalogue; no text contains it.
const END: char = '\0';

static CATALOGUES: [OnceLock<Catalogue>; Language::ALL.len()] = [const { OnceLock::new() }; Language::ALL.len()];
static PROVIDER: OnceLock<fn(Language) -> Catalogue> = OnceLock::new();

/// States where catalogues come from that are not installed when a text of their language is asked for. The first
/// call counts.
pub fn provide(provider: fn(Language) -> Catalogue) {
    let _ = PROVIDER.set(provider);
}

/// The text in a language; the English one if the catalogue lacks it.
pub(super) fn translated(language: Language, english: &'static str) -> &'static str {
    if language == Language::English || english.is_empty() {
        return english;
    }
    let slot = &CATALOGUES[language as usize];
    let catalogue = slot.get().or_else(|| {
        let provider = PROVIDER.get()?;
        Some(slot.get_or_init(|| provider(language)))
    });
    catalogue.and_then(|catalogue| catalogue.text(english)).unwrap_or(english)
}

impl Language {
    /// A constant text in this language.
    pub fn say(self, english: &'static str) -> &'static str {
        translated(self, english)
    }

    /// Several constant texts in this language.
    pub fn say_all<const COUNT: usize>(self, english: [&'static str; COUNT]) -> [&'static str; COUNT] {
        english.map(|text| translated(self, text))
    }
}

impl Catalogue {
    /// Packs pairs of an English text and its translation, which may be empty if it is missing: the number of English texts,
    /// the number of translations, and the hashes of these, as 32-bit integers, the lower byte first; then the translations,
    /// each with its end.
    ///
    /// # Errors
    /// Two English texts with the same hash: reword one of them.
    pub fn pack<'a>(pairs: impl IntoIterator<Item = (&'a str, &'a str)>) -> Result<Vec<u8>, [&'a str; 2]> {
        let mut pairs: Vec<(u32, &str, &str)> = pairs.into_iter().map(|(key, text)| (hash(key), key, text)).collect();
        let of = count(pairs.len());
        pairs.retain(|(.., text)| !text.is_empty());
        pairs.sort_unstable();
        if let Some(same) = pairs.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            return Err([same[0].1, same[1].1]);
        }
        let mut packed: Vec<u8> = [of, count(pairs.len())].into_iter().flat_map(u32::to_le_bytes).collect();
        packed.extend(pairs.iter().flat_map(|(hash, ..)| hash.to_le_bytes()));
        packed.extend(pairs.iter().flat_map(|(.., text)| text.bytes().chain([END as u8])));
        Ok(packed)
    }

    /// Reads a packed catalogue; what is damaged is left out.
    pub fn unpack(packed: &[u8]) -> Self {
        let read = || {
            let (of, rest) = packed.split_first_chunk::<HASH>()?;
            let (count, rest) = rest.split_first_chunk::<HASH>()?;
            let count = usize::try_from(u32::from_le_bytes(*count)).ok()?;
            let (hashes, texts) = rest.split_at_checked(count.checked_mul(HASH)?)?;
            let (hashes, _) = hashes.as_chunks::<HASH>();
            let texts: &'static str = Box::leak(String::from_utf8_lossy(texts).into());
            let hashes = hashes.iter().map(|hash| u32::from_le_bytes(*hash)).collect();
            Some(Self { hashes, of: u32::from_le_bytes(*of), texts: texts.split(END).collect() })
        };
        read().unwrap_or_default()
    }

    /// Translation of an English text.
    fn text(&self, english: &str) -> Option<&'static str> {
        self.texts.get(self.hashes.binary_search(&hash(english)).ok()?).copied()
    }

    /// Part of the texts that a language has, from 0 to 1.
    pub fn share(language: Language) -> f64 {
        let catalogue = CATALOGUES[language as usize].get().filter(|catalogue| catalogue.of > 0);
        catalogue.map_or(f64::from(u8::from(language == Language::English)), |catalogue| {
            catalogue.hashes.len() as f64 / f64::from(catalogue.of)
        })
    }

    /// True if the texts of a language are there, without asking the provider.
    pub fn is_installed(language: Language) -> bool {
        language == Language::English || CATALOGUES[language as usize].get().is_some()
    }

    /// Makes this the catalogue of a language. The first one of a language counts.
    pub fn install(self, language: Language) {
        let _ = CATALOGUES[language as usize].set(self);
    }
}

fn count(texts: usize) -> u32 {
    u32::try_from(texts).unwrap_or(u32::MAX)
}

/// 32-bit FNV-1a of a text.
const fn hash(text: &str) -> u32 {
    let bytes = text.as_bytes();
    let (mut hash, mut index) = (0x811c_9dc5_u32, 0);
    while index < bytes.len() {
        hash = (hash ^ bytes[index] as u32).wrapping_mul(0x0100_0193);
        index += 1;
    }
    hash
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_packed_catalogue_holds_its_texts() {
        let packed = Catalogue::pack([("time", "tiempo"), ("length", "longitud"), ("mass", ""), ("", "x")]).unwrap();
        let catalogue = Catalogue::unpack(&packed);
        assert_eq!((catalogue.hashes.len(), catalogue.of), (3, 4));
        for (key, text) in [("time", Some("tiempo")), ("length", Some("longitud")), ("mass", None)] {
            assert_eq!(catalogue.text(key), text, "{key}");
        }
        for end in 0..packed.len() {
            Catalogue::unpack(&packed[..end]);
        }
        assert_eq!(Catalogue::pack([("a", "b"), ("a", "c")]), Err(["a", "a"]));
    }
}

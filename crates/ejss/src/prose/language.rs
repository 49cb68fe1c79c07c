//! Language of a text, by its commonest words.

use units::Language;

const WORDS: [(Language, [&str; 14]); 3] = [
    (
        Language::English,
        ["the", "of", "and", "is", "to", "in", "with", "for", "this", "are", "by", "on", "you", "that"],
    ),
    (Language::Spanish, ["el", "los", "las", "una", "del", "y", "con", "para", "se", "un", "por", "en", "es", "la"]),
    (Language::Portuguese, ["o", "os", "as", "uma", "do", "da", "em", "um", "com", "para", "não", "são", "e", "ao"]),
];

/// Language of a plain text; English for a short or another one.
pub(crate) fn language_of(text: &str) -> Language {
    let mut best = (0, Language::English);
    let words: Vec<String> = text.split(|letter: char| !letter.is_alphabetic()).map(str::to_lowercase).collect();
    for (language, common) in WORDS {
        let count = words.iter().filter(|word| common.contains(&word.as_str())).count();
        // A letter that only one language has weighs more than a word that two share.
        let letters = match language {
            Language::Spanish => text.matches(['ñ', '¿', '¡', 'á', 'ó', 'í']).count(),
            Language::Portuguese => text.matches(['ã', 'õ', 'ç', 'ê', 'â']).count(),
            _ => 0,
        };
        if count + letters > best.0 {
            best = (count + letters, language);
        }
    }
    if best.0 < 2 { Language::English } else { best.1 }
}

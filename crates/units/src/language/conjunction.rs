//! Enumerations in a sentence.

use super::list::Language;

/// The word before the last part of an enumeration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Conjunction {
    /// All of them.
    And,
    /// One of them.
    Or,
}

impl Conjunction {
    /// Parts as an enumeration: `a, b and c`.
    pub fn join(self, parts: &[String], language: Language) -> String {
        match parts.split_last() {
            Some((end, [])) => end.clone(),
            Some((end, rest)) => [rest.join(", ").as_str(), self.before(end, language), end].concat(),
            None => String::new(),
        }
    }

    /// The conjunction between blanks, as it stands before a word. Spanish "y" and "o" become "e" and "u" before the same
    /// sound: `x` e `y`.
    fn before(self, word: &str, language: Language) -> &'static str {
        let begins = |sounds: [char; 4]| word.trim_start_matches('`').starts_with(sounds);
        match self {
            Self::And if language == Language::Spanish && begins(['i', 'I', 'y', 'Y']) => " e ",
            Self::Or if language == Language::Spanish && begins(['o', 'O', 'ó', 'Ó']) => " u ",
            Self::And => language.say(" and "),
            Self::Or => language.say(" or "),
        }
    }
}

impl Language {
    /// Enumeration as text: `a, b and c`.
    pub fn join(self, parts: &[String]) -> String {
        Conjunction::And.join(parts, self)
    }
}

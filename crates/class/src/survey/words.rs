//! Frequent words of free texts.

use super::stop_words::{Known, known};
use frostem::Stemmer;
use std::collections::{BTreeMap, BTreeSet};
use units::Language;
use units::order::sort_by;

/// Number of persons from which a word is shown.
const LEAST_PERSONS: usize = 2;
/// Maximum length of a word, in characters; longer ones are left out.
const LONGEST: usize = 40;

/// A word with the number of persons who have used it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Word {
    /// Its most frequent form, in lower case; behind `no` or `not` if it was negated.
    pub text: String,
    /// Number of persons who have used one of its forms.
    pub persons: usize,
}

/// A word in a comment.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Token {
    /// A word in lower case.
    Word(String),
    /// `no`, `not` or `não`.
    Negation(&'static str),
    /// End of a clause.
    Break,
}

/// Words that at least two persons have used, each person counted once; the most frequent first, and equally frequent ones
/// in alphabetical order. Forms with the same stem are one word. Each text is the comment of one person.
pub fn frequent_words(comments: &[String]) -> Vec<Word> {
    let tokens: Vec<Vec<Token>> = comments.iter().map(|comment| tokens(comment)).collect();
    let known = known();
    let majority = language(&known, tokens.iter().flatten(), 0);
    // Persons who have used each form, by the stem.
    let mut forms: BTreeMap<String, BTreeMap<String, BTreeSet<usize>>> = BTreeMap::new();
    for (person, tokens) in tokens.iter().enumerate() {
        let Some(own) = known.get(language(&known, tokens, majority)) else { continue };
        let stemmer = Stemmer::new(own.stemmer);
        let mut negation = None;
        for token in tokens {
            match token {
                Token::Break => negation = None,
                // Portuguese *no* means *in the*.
                Token::Negation("no") if own.language == Language::Portuguese => {}
                Token::Negation(word) => negation = Some(*word),
                Token::Word(word) if known.iter().any(|one| one.stop_words.contains(word.as_str())) => {}
                Token::Word(word) => {
                    let stem = if word.chars().all(is_latin) { stemmer.stem(word).into_owned() } else { word.clone() };
                    let [stem, form] = match negation.take() {
                        Some(negation) => [stem, word.clone()].map(|text| format!("{negation} {text}")),
                        None => [stem, word.clone()],
                    };
                    forms.entry(stem).or_default().entry(form).or_default().insert(person);
                }
            }
        }
    }
    let word = |forms: BTreeMap<String, BTreeSet<usize>>| {
        let persons = forms.values().flatten().collect::<BTreeSet<_>>().len();
        // The first of the most frequent forms.
        let commonest = forms.into_iter().rev().max_by_key(|(_, persons)| persons.len());
        commonest.filter(|_| persons >= LEAST_PERSONS).map(|(text, _)| Word { text, persons })
    };
    let mut words: Vec<Word> = forms.into_values().filter_map(word).collect();
    sort_by(&mut words, |one, other| other.persons.cmp(&one.persons).then_with(|| one.text.cmp(&other.text)));
    words
}

/// Place of the language with the most stop words; `otherwise` if that has as many, or else the first one.
fn language<'a>(known: &[Known], tokens: impl IntoIterator<Item = &'a Token>, otherwise: usize) -> usize {
    let mut counts = vec![0_usize; known.len()];
    for token in tokens {
        for (count, one) in counts.iter_mut().zip(known) {
            *count += usize::from(matches!(token, Token::Word(word) if one.stop_words.contains(word.as_str())));
        }
    }
    let most = counts.iter().copied().max().unwrap_or_default();
    let found = [otherwise].into_iter().chain(0..counts.len()).find(|index| counts.get(*index) == Some(&most));
    found.unwrap_or(otherwise)
}

/// Words of at least two letters, in lower case with their accents; everything else divides them.
fn tokens(comment: &str) -> Vec<Token> {
    let text = comment.to_lowercase().replace('’', "'");
    let mut tokens = Vec::new();
    for piece in text.split_inclusive(|letter: char| !(letter.is_alphabetic() || letter == '\'')) {
        let word = piece.trim_end_matches(|letter: char| !(letter.is_alphabetic() || letter == '\''));
        let end = piece[word.len()..].chars().next();
        let word = word.trim_matches('\'');
        match word {
            "no" => tokens.push(Token::Negation("no")),
            "não" => tokens.push(Token::Negation("não")),
            "not" | "cannot" => tokens.push(Token::Negation("not")),
            word if word.ends_with("n't") => tokens.push(Token::Negation("not")),
            word => {
                let word = word.strip_suffix("'s").unwrap_or(word);
                let letters = word.chars().count();
                if (2..=LONGEST).contains(&letters) {
                    tokens.push(Token::Word(word.to_owned()));
                }
            }
        }
        if end.is_some_and(|end| !matches!(end, ' ' | '-' | '"' | '«' | '»' | '\u{a0}')) {
            tokens.push(Token::Break);
        }
    }
    tokens
}

/// True for the letters of the languages that are stemmed. Words with others are their own stems.
fn is_latin(letter: char) -> bool {
    letter.is_ascii_lowercase()
        || matches!(letter, 'á' | 'é' | 'í' | 'ó' | 'ú' | 'ü' | 'ñ' | 'à' | 'â' | 'ê' | 'ô' | 'ã' | 'õ' | 'ç' | '\'')
}

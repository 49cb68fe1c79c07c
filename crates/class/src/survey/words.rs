//! Frequent words of free texts.

use super::stop_words::StopWords;
use frostem::{Algorithm, Stemmer};
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
    /// `no` or `not`.
    Negation(&'static str),
    /// End of a clause.
    Break,
}

/// Words that at least two persons have used, each person counted once; the most frequent first, and equally frequent ones
/// in alphabetical order. Forms with the same stem are one word. Each text is the comment of one person.
pub fn frequent_words(comments: &[String]) -> Vec<Word> {
    let tokens: Vec<Vec<Token>> = comments.iter().map(|comment| tokens(comment)).collect();
    let stop_words = StopWords::new();
    let majority = language(&stop_words, tokens.iter().flatten(), Language::English);
    // Persons who have used each form, by the stem.
    let mut forms: BTreeMap<String, BTreeMap<String, BTreeSet<usize>>> = BTreeMap::new();
    for (person, tokens) in tokens.iter().enumerate() {
        let language = language(&stop_words, tokens, majority);
        let stemmer = Stemmer::new(language.pick(Algorithm::English, Algorithm::Spanish));
        let mut negation = None;
        for token in tokens {
            match token {
                Token::Break => negation = None,
                Token::Negation(word) => negation = Some(*word),
                Token::Word(word) if stop_words.contains(word) => {}
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

/// Language with more stop words; `otherwise` if both have as many.
fn language<'a>(stop_words: &StopWords, tokens: impl IntoIterator<Item = &'a Token>, otherwise: Language) -> Language {
    let (mut english, mut spanish) = (0, 0);
    for token in tokens {
        if let Token::Word(word) = token {
            english += usize::from(stop_words.english.contains(word.as_str()));
            spanish += usize::from(stop_words.spanish.contains(word.as_str()));
        }
    }
    match english.cmp(&spanish) {
        std::cmp::Ordering::Greater => Language::English,
        std::cmp::Ordering::Less => Language::Spanish,
        std::cmp::Ordering::Equal => otherwise,
    }
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
    letter.is_ascii_lowercase() || matches!(letter, 'á' | 'é' | 'í' | 'ó' | 'ú' | 'ü' | 'ñ' | '\'')
}

//! The tokens and how they are spelled.

use crate::Span;
use std::ops::Range;

/// One token and where it stands.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Token {
    pub(crate) kind: TokenKind,
    pub(crate) span: Span,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum TokenKind {
    Number(f64),
    /// A name in ASCII, the primes directly after it, and where the name alone ends.
    Name {
        text: String,
        order: u32,
        end: usize,
    },
    Keyword(Keyword),
    Symbol(Symbol),
    /// `.x` after brackets, a parenthesis or primes: which component of a vector, from 0, and the primes after it.
    Component {
        axis: usize,
        order: u32,
    },
    /// ² after what it raises.
    Raised(i16),
    /// Primes that do not follow a name.
    Primes,
    /// A text, without its quotation marks.
    Text(String),
    /// `[...]` and what stands inside.
    Brackets(Range<usize>),
    Newline,
    /// What a diagnostic has already been said about.
    Unknown,
    End,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Keyword {
    Parameter,
    Independent,
    When,
    In,
    If,
    Then,
    Else,
    And,
    Or,
    Not,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Symbol {
    Plus,
    Minus,
    Star,
    Slash,
    Caret,
    Root,
    Equals,
    EqualTo,
    NotEqualTo,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    LeftParenthesis,
    RightParenthesis,
    LeftBrace,
    RightBrace,
    Comma,
    Semicolon,
    Dots,
    Colon,
}

pub(super) const KEYWORDS: &[(&str, Keyword)] = &[
    ("parameter", Keyword::Parameter),
    ("independent", Keyword::Independent),
    ("when", Keyword::When),
    ("in", Keyword::In),
    ("if", Keyword::If),
    ("then", Keyword::Then),
    ("else", Keyword::Else),
    ("and", Keyword::And),
    ("or", Keyword::Or),
    ("not", Keyword::Not),
];

/// What can stand second in a symbol, be it ours or another tool's.
pub(super) const JOINED: &[u8] = b"=<>*/";

/// The symbol that a character is unless one of [`JOINED`] follows: nearly all symbols of a model are found so, without going through
/// the lists.
pub(super) fn lone(character: char) -> Option<Symbol> {
    Some(match character {
        '+' => Symbol::Plus,
        '-' => Symbol::Minus,
        '*' => Symbol::Star,
        '/' => Symbol::Slash,
        '^' => Symbol::Caret,
        '=' => Symbol::Equals,
        '(' => Symbol::LeftParenthesis,
        ')' => Symbol::RightParenthesis,
        ',' => Symbol::Comma,
        _ => return None,
    })
}

/// Longer spellings first.
pub(super) const SYMBOLS: &[(&str, Symbol)] = &[
    ("..", Symbol::Dots),
    ("…", Symbol::Dots),
    ("==", Symbol::EqualTo),
    ("!=", Symbol::NotEqualTo),
    ("<>", Symbol::NotEqualTo),
    ("≠", Symbol::NotEqualTo),
    ("<=", Symbol::LessOrEqual),
    ("≤", Symbol::LessOrEqual),
    (">=", Symbol::GreaterOrEqual),
    ("≥", Symbol::GreaterOrEqual),
    ("<", Symbol::Less),
    (">", Symbol::Greater),
    ("=", Symbol::Equals),
    ("+", Symbol::Plus),
    ("-", Symbol::Minus),
    ("−", Symbol::Minus),
    ("–", Symbol::Minus),
    ("*", Symbol::Star),
    ("·", Symbol::Star),
    ("⋅", Symbol::Star),
    ("∙", Symbol::Star),
    ("×", Symbol::Star),
    ("/", Symbol::Slash),
    ("÷", Symbol::Slash),
    ("⁄", Symbol::Slash),
    ("∕", Symbol::Slash),
    ("^", Symbol::Caret),
    ("√", Symbol::Root),
    ("(", Symbol::LeftParenthesis),
    (")", Symbol::RightParenthesis),
    ("{", Symbol::LeftBrace),
    ("}", Symbol::RightBrace),
    (",", Symbol::Comma),
    (";", Symbol::Semicolon),
    (":", Symbol::Colon),
];

/// What other languages write, the symbol it stands for here, and how that is written.
pub(super) const FOREIGN: &[(&str, TokenKind, &str)] = &[
    ("**", TokenKind::Symbol(Symbol::Caret), "^"),
    ("&&", TokenKind::Keyword(Keyword::And), "and"),
    ("||", TokenKind::Keyword(Keyword::Or), "or"),
    (":=", TokenKind::Symbol(Symbol::Equals), "="),
    ("=>", TokenKind::Symbol(Symbol::GreaterOrEqual), ">="),
    ("=<", TokenKind::Symbol(Symbol::LessOrEqual), "<="),
    ("!", TokenKind::Keyword(Keyword::Not), "not"),
];

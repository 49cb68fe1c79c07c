//! Tokens and their spelling.

use crate::Span;
use std::ops::Range;

/// One token and its place.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Token {
    pub(crate) kind: TokenKind,
    pub(crate) span: Span,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum TokenKind {
    Number(f64),
    /// A name in ASCII, the number of primes directly after it, and the byte at which the name itself ends.
    Name {
        text: String,
        order: u32,
        end: usize,
    },
    Keyword(Keyword),
    Symbol(Symbol),
    /// `.x` after brackets, a parenthesis or primes: index of the component of a vector, from 0, and the number of primes
    /// after it.
    Component {
        axis: usize,
        order: u32,
    },
    /// A superscript exponent such as ².
    Raised(i16),
    /// Primes that do not follow a name.
    Primes,
    /// A text, without its quotation marks.
    Text(String),
    /// `[...]`; the byte range of its content.
    Brackets(Range<usize>),
    Newline,
    /// Text about which a diagnostic was reported.
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

/// Bytes that can stand second in a symbol of the language or of another tool.
pub(super) const JOINED: &[u8] = b"=<>*/";

/// Symbol of a single character, valid unless one of [`JOINED`] follows. Finds nearly all symbols of a model without
/// searching the lists.
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

/// Spellings of symbols, longer ones first.
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

/// Operators of other languages, the token each stands for, and its spelling here.
pub(super) const FOREIGN: &[(&str, TokenKind, &str)] = &[
    ("**", TokenKind::Symbol(Symbol::Caret), "^"),
    ("&&", TokenKind::Keyword(Keyword::And), "and"),
    ("||", TokenKind::Keyword(Keyword::Or), "or"),
    (":=", TokenKind::Symbol(Symbol::Equals), "="),
    ("=>", TokenKind::Symbol(Symbol::GreaterOrEqual), ">="),
    ("=<", TokenKind::Symbol(Symbol::LessOrEqual), "<="),
    ("!", TokenKind::Keyword(Keyword::Not), "not"),
];

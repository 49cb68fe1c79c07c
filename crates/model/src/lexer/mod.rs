//! From characters to tokens. The lexer never fails: unreadable text becomes [`TokenKind::Unknown`] with a diagnostic.

mod brackets;
mod component;
mod derivative;
mod foreign;
mod spanish;
mod token;

pub(crate) use token::{Keyword, Symbol, Token, TokenKind};

use crate::spanish_functions::in_english;
use crate::{Diagnostic, Span, limits};
use std::ops::Range;
use token::{FOREIGN, JOINED, KEYWORDS, SYMBOLS, lone};
use units::alphabet::{greek_name, lowered, primes, without_accent};
use units::words;

/// Typical number of bytes per token, including blanks.
const USUAL: usize = 3;

/// Tokens of `source[range]`, ending with [`TokenKind::End`]. `range` must lie on character boundaries.
pub(crate) fn tokens(source: &str, range: Range<usize>) -> (Vec<Token>, Vec<Diagnostic>) {
    let mut lexer = Lexer {
        source,
        at: range.start,
        end: range.end,
        tokens: Vec::with_capacity(range.len() / USUAL),
        diagnostics: Vec::new(),
        strange: Vec::new(),
    };
    while let Some(character) = lexer.peek() {
        lexer.token(character);
    }
    lexer.push(TokenKind::End, range.end);
    (lexer.tokens, lexer.diagnostics)
}

struct Lexer<'a> {
    source: &'a str,
    at: usize,
    end: usize,
    tokens: Vec<Token>,
    diagnostics: Vec<Diagnostic>,
    /// Invalid characters of this line; each is reported once.
    strange: Vec<char>,
}

impl<'a> Lexer<'a> {
    fn rest(&self) -> &'a str {
        self.source.get(self.at..self.end).unwrap_or_default()
    }

    /// The byte `ahead` bytes after the position. All bytes of a non-ASCII character are 128 or more.
    fn byte(&self, ahead: usize) -> Option<u8> {
        self.source.as_bytes().get(self.at + ahead).filter(|_| self.at + ahead < self.end).copied()
    }

    fn peek(&self) -> Option<char> {
        match self.byte(0)? {
            byte if byte.is_ascii() => Some(char::from(byte)),
            _ => self.rest().chars().next(),
        }
    }

    /// Consumes ASCII characters while `wanted` is true, and returns them.
    fn skip_ascii(&mut self, wanted: impl Fn(u8) -> bool) -> &'a str {
        let start = self.at;
        while self.byte(0).is_some_and(|byte| byte.is_ascii() && wanted(byte)) {
            self.at += 1;
        }
        &self.source[start..self.at]
    }

    fn push(&mut self, kind: TokenKind, start: usize) {
        self.tokens.push(Token { kind, span: Span::new(start, self.at) });
    }

    /// Consumes characters while `wanted` is true, and returns them.
    fn skip(&mut self, wanted: impl Fn(char) -> bool) -> &'a str {
        let rest = self.rest();
        let length = rest.find(|c| !wanted(c)).unwrap_or(rest.len());
        self.at += length;
        &rest[..length]
    }

    fn token(&mut self, first: char) {
        let start = self.at;
        match first {
            '\n' => {
                self.at += 1;
                self.strange.clear();
                self.push(TokenKind::Newline, start);
            }
            '#' => {
                self.skip(|c| c != '\n');
            }
            '0'..='9' => self.number(),
            '.' if self.byte(1).is_some_and(|byte| byte.is_ascii_digit()) => self.number(),
            'a'..='z' | 'A'..='Z' => self.name(),
            ' ' => self.at += 1,
            '"' | '“' | '„' | '«' => self.text(first),
            '.' if self.at_component() => self.component(),
            '[' => self.brackets(),
            c if is_blank(c) => {
                self.skip(is_blank);
            }
            'º' if matches!(self.tokens.last(), Some(Token { kind: TokenKind::Number(_), .. })) => {
                self.at += first.len_utf8();
                self.degree_sign(first, start);
            }
            c if c == '_' || c.is_alphabetic() && primes(c).is_none() && lowered(c).is_none() => self.name(),
            c if primes(c).is_some() => {
                self.skip(|c| primes(c).is_some());
                self.push(TokenKind::Primes, start);
            }
            c if units::raised(c).is_some() => self.raised(),
            _ => self.symbol(first),
        }
    }

    /// True if a single point comes next.
    fn at_point(&self) -> bool {
        self.byte(0) == Some(b'.') && self.byte(1) != Some(b'.')
    }

    /// Digits with a point and an exponent. `0..30` is the number 0 and two dots.
    fn number(&mut self) {
        let start = self.at;
        let is_digit = |byte: u8| byte.is_ascii_digit();
        self.skip_ascii(is_digit);
        if self.at_point() {
            self.at += 1;
            self.skip_ascii(is_digit);
        }
        if let Some(b'e' | b'E') = self.byte(0) {
            let sign = usize::from(matches!(self.byte(1), Some(b'+' | b'-')));
            if self.byte(1 + sign).is_some_and(is_digit) {
                self.at += 1 + sign;
                self.skip_ascii(is_digit);
            }
        }
        if self.at_point() {
            self.skip_ascii(|byte| byte.is_ascii_digit() || byte == b'.');
            let text = &self.source[start..self.at];
            let wrong = words!("`{text}` is not a number: it has a second point");
            self.diagnostics.push(Diagnostic::error("malformed-number", wrong, Span::new(start, self.at)));
            return self.push(TokenKind::Unknown, start);
        }
        let value: f64 = self.source[start..self.at].parse().unwrap_or(f64::INFINITY);
        if value.is_finite() {
            return self.push(TokenKind::Number(value), start);
        }
        let span = Span::new(start, self.at);
        let wrong = words("this number is too large");
        self.diagnostics
            .push(Diagnostic::error("malformed-number", wrong, span).with_note(words("the largest is about 1.8e308")));
        self.push(TokenKind::Unknown, start);
    }

    /// Consumes the letters and digits of a name, transcribed to ASCII. Also returns the place of a character that a name
    /// cannot contain.
    fn letters(&mut self) -> (String, Option<Span>) {
        let mut text = String::new();
        let mut foreign = None;
        let mut below = false;
        loop {
            let plain = self.skip_ascii(|byte| byte == b'_' || byte.is_ascii_alphanumeric());
            text.push_str(plain);
            below &= plain.is_empty();
            let Some(c) = self.peek().filter(|c| !c.is_ascii()) else { break };
            if let Some(digit) = lowered(c) {
                if !below && !text.ends_with('_') {
                    text.push('_');
                }
                text.push(digit);
            } else if let Some(name) = greek_name(c) {
                text.push_str(name);
            } else if c.is_alphabetic() && primes(c).is_none() {
                foreign = foreign.or(Some(Span::new(self.at, self.at + c.len_utf8())));
                text.push(c);
            } else {
                break;
            }
            below = lowered(c).is_some();
            self.at += c.len_utf8();
        }
        (text, foreign)
    }

    /// Reports a letter at `span` that a name cannot contain. `text`: the name that begins at `start`. Returns the name that
    /// is meant: an accented word of a function in Spanish is the function, another word loses its accents.
    fn foreign_letter(&mut self, text: String, span: Span, start: usize) -> String {
        let whole = Span::new(start, self.at);
        let written = &self.source[whole.range()];
        if let Some(ours) = in_english(written).filter(|_| self.rest().trim_start().starts_with('(')) {
            let wrong = words!("`{written}` is written `{ours}` here");
            self.diagnostics.push(Diagnostic::error("unknown-function", wrong, whole).meaning(ours));
            return ours.to_owned();
        }
        let letter = &self.source[span.range()];
        let wrong = words!("`{letter}` cannot be part of a name");
        let hint = words("names are made of the letters a to z, Greek letters, digits and _");
        let mut found = Diagnostic::error("name-character", wrong, span).with_hint(hint);
        // Without its tilde, `año` is another word.
        let plain: String = text.chars().map(without_accent).collect();
        if plain.is_ascii() && !text.contains(['ñ', 'Ñ']) {
            found = found.with_fix(whole, plain);
        }
        self.diagnostics.push(found);
        text
    }

    fn name(&mut self) {
        if self.textbook_derivative() || self.spanish() {
            return;
        }
        let start = self.at;
        let (mut text, mut foreign) = self.letters();
        // `landing.x`: a value remembered by an event.
        let member = self.byte(0) == Some(b'.') && self.rest()[1..].starts_with(char::is_alphabetic);
        if member && !self.is_foreign_collection(&text) {
            self.at += 1;
            let (member, more) = self.letters();
            text = format!("{text}.{member}");
            foreign = foreign.or(more);
            // `landing.r.x`: a component of such a value.
            text += self.axis_here().map_or("", |(_, name)| name);
        }
        if let Some(span) = foreign {
            text = self.foreign_letter(text, span, start);
        }
        if let Some((_, keyword)) = KEYWORDS.iter().find(|(word, _)| *word == text) {
            return self.push(TokenKind::Keyword(*keyword), start);
        }
        let mut end = self.at;
        let mut order = self.primes();
        // `r'.x` is the same as `r.x'`.
        if order > 0
            && let Some((_, axis)) = self.axis_here()
        {
            text += axis;
            end = self.at;
            order += self.primes();
        }
        if order > limits::ORDER {
            let wrong = words!("{order} primes are too many");
            let note = words!("derivatives up to the order {} are possible", limits::ORDER);
            let diagnostic = Diagnostic::error("order-too-high", wrong, Span::new(end, self.at)).with_note(note);
            self.diagnostics.push(diagnostic);
            return self.push(TokenKind::Unknown, start);
        }
        self.push(TokenKind::Name { text, order, end }, start);
    }

    fn text(&mut self, opening: char) {
        let start = self.at;
        let closing: &[char] = match opening {
            '“' => &['”', '"'],
            '„' => &['“', '”', '"'],
            '«' => &['»', '"'],
            _ => &['"'],
        };
        self.at += opening.len_utf8();
        let inside = self.skip(|c| c != '\n' && !closing.contains(&c));
        if let Some(mark) = self.peek().filter(|c| *c != '\n') {
            self.at += mark.len_utf8();
            return self.push(TokenKind::Text(inside.to_owned()), start);
        }
        let after_name = self.tokens.last().is_some_and(|token| {
            token.span.end == start && matches!(token.kind, TokenKind::Name { .. } | TokenKind::Primes)
        });
        self.at = start + opening.len_utf8() + inside.trim_end().len();
        let mut diagnostic = Diagnostic::error(
            "unclosed-text",
            words("this text has no closing quotation mark"),
            Span::new(start, self.at),
        );
        diagnostic = if after_name {
            diagnostic
                .with_hint(words("for the second derivative write two primes: y''"))
                .with_fix(Span::new(start, start + opening.len_utf8()), "''")
        } else {
            let end = Span::new(self.at, self.at);
            diagnostic.with_hint(words("end it with \" on the same line")).with_fix(end, "\"")
        };
        self.diagnostics.push(diagnostic);
        self.push(TokenKind::Unknown, start);
    }

    fn raised(&mut self) {
        let start = self.at;
        let digits: String = self.skip(|c| units::raised(c).is_some()).chars().filter_map(units::raised).collect();
        if let Ok(exponent) = digits.parse() {
            return self.push(TokenKind::Raised(exponent), start);
        }
        let span = Span::new(start, self.at);
        self.diagnostics.push(Diagnostic::error("malformed-number", words("this is not an exponent"), span));
        self.push(TokenKind::Unknown, start);
    }

    fn symbol(&mut self, first: char) {
        let is_doubled = matches!(first, '+' | '-') && self.byte(1) == u8::try_from(first).ok();
        let is_joined = is_doubled || self.byte(1).is_some_and(|next| JOINED.contains(&next));
        if let Some(symbol) = lone(first).filter(|_| !is_joined) {
            self.at += 1;
            return self.push(TokenKind::Symbol(symbol), self.at - 1);
        }
        if self.foreign() {
            return;
        }
        let start = self.at;
        let rest = self.rest();
        // The longer spelling wins: `!=` is not a foreign `!`, and `**` is not two stars.
        let known = SYMBOLS.iter().find(|(text, _)| rest.starts_with(text));
        let foreign = FOREIGN.iter().find(|(text, _, _)| rest.starts_with(text));
        if let Some((text, symbol)) = known
            && foreign.is_none_or(|(other, _, _)| other.len() <= text.len())
        {
            self.at += text.len();
            return self.push(TokenKind::Symbol(*symbol), start);
        }
        if let Some((text, kind, ours)) = foreign {
            self.at += text.len();
            let wrong = words!("`{text}` is written `{ours}` here");
            let span = Span::new(start, self.at);
            // A word such as `and` needs blanks around it.
            let is_word = ours.starts_with(|c: char| c.is_alphabetic());
            let apart = |is_blank: bool| if is_word && !is_blank { " " } else { "" };
            let (before, after) = (&self.source[..start], &self.source[self.at..]);
            let written = format!(
                "{}{ours}{}",
                apart(before.ends_with(char::is_whitespace)),
                apart(after.starts_with(char::is_whitespace))
            );
            self.diagnostics.push(Diagnostic::error("foreign-operator", wrong, span).with_fix(span, written));
            return self.push(kind.clone(), start);
        }
        self.at += first.len_utf8();
        if self.degree_sign(first, start) {
            return;
        }
        if !self.strange.contains(&first) {
            self.strange.push(first);
            self.diagnostics.push(strange_character(first, Span::new(start, self.at)));
        }
        self.push(TokenKind::Unknown, start);
    }
}

fn strange_character(character: char, span: Span) -> Diagnostic {
    let shown = if character.is_control() { format!("U+{:04X}", character as u32) } else { character.to_string() };
    let wrong = words!("the character `{shown}` has no meaning in a model");
    let diagnostic = Diagnostic::error("unexpected-character", wrong, span);
    match character {
        '%' => diagnostic.with_hint(words("a percentage is written 5 [%], a remainder mod(a, b)")),
        '\u{307}' | '\u{308}' => diagnostic.with_hint(words("derivatives are written with primes: y' and y''")),
        '$' => diagnostic.with_hint(words("formulas in $...$ belong to the prose around the model")),
        '\\' => diagnostic.with_hint(words("write names without a backslash: omega_0, sqrt(x)")),
        ']' => Diagnostic::error("unmatched-bracket", words("this `]` closes nothing"), span),
        _ => diagnostic,
    }
}

/// All blanks except line ends. A carriage return is a blank.
pub(crate) fn is_blank(c: char) -> bool {
    c != '\n' && (c.is_whitespace() || matches!(c, '\u{200B}' | '\u{FEFF}' | '\u{2060}' | '\u{2062}'))
}

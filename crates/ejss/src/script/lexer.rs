//! Tokens of a JavaScript text. What cannot be read is an error with its line.

use super::token::{Token, TokenKind};
use crate::refusal::Unreadable;

/// Operators and brackets, longest first.
const SIGNS: [&str; 47] = [
    ">>>=", "===", "!==", ">>>", "<<=", ">>=", "**=", "...", "=>", "==", "!=", "<=", ">=", "&&", "||", "??", "++",
    "--", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<", ">>", "**", "{", "}", "(", ")", "[", "]", ";", ",",
    "<", ">", "+", "-", "*", "/", "%", "!", "?", ":",
];
/// Operators of one character that do not fit into the list above.
const MORE_SIGNS: [&str; 5] = ["=", ".", "&", "|", "^"];
/// Upper bound of the number of tokens of a text.
const MOST_TOKENS: usize = 50_000;

/// Tokens of a text, the last of which is [`TokenKind::End`].
///
/// # Errors
/// A character that begins no token, a text or comment without an end, or too many tokens.
pub(super) fn tokens(source: &str) -> Result<Vec<Token>, Unreadable> {
    let mut lexer = Lexer { source, at: 0, line: 1, after_line_end: false, tokens: Vec::new() };
    while lexer.next()? {
        if lexer.tokens.len() > MOST_TOKENS {
            return Err(Unreadable::new(lexer.line, crate::refusal::Obstacle::TooLong));
        }
    }
    Ok(lexer.tokens)
}

struct Lexer<'a> {
    source: &'a str,
    at: usize,
    line: usize,
    after_line_end: bool,
    tokens: Vec<Token>,
}

impl Lexer<'_> {
    /// Reads one token. Returns false at the end.
    fn next(&mut self) -> Result<bool, Unreadable> {
        self.skip_blanks()?;
        let rest = self.rest();
        let Some(first) = rest.chars().next() else {
            self.push(TokenKind::End, 0);
            return Ok(false);
        };
        if first.is_ascii_digit() || first == '.' && rest[1..].starts_with(|next: char| next.is_ascii_digit()) {
            return self.number();
        }
        if first.is_alphabetic() || matches!(first, '_' | '$') {
            let length = rest.find(|letter: char| !is_part_of_name(letter)).unwrap_or(rest.len());
            let name = rest[..length].to_owned();
            self.push(TokenKind::Name(name), length);
            return Ok(true);
        }
        if matches!(first, '"' | '\'' | '`') {
            return self.text(first);
        }
        if first == '/' && !self.tokens.last().is_some_and(|token| token.kind.ends_operand()) {
            return self.pattern();
        }
        let sign = SIGNS.into_iter().chain(MORE_SIGNS).find(|sign| rest.starts_with(sign));
        let sign = sign.ok_or_else(|| self.obstacle(format!("{first}")))?;
        self.push(TokenKind::Sign(sign), sign.len());
        Ok(true)
    }

    fn rest(&self) -> &str {
        self.source.get(self.at..).unwrap_or_default()
    }

    fn push(&mut self, kind: TokenKind, length: usize) {
        self.tokens.push(Token { kind, line: self.line, after_line_end: self.after_line_end });
        self.after_line_end = false;
        self.at += length;
    }

    fn obstacle(&self, sign: String) -> Unreadable {
        Unreadable::new(self.line, crate::refusal::Obstacle::Sign(sign))
    }

    fn skip_blanks(&mut self) -> Result<(), Unreadable> {
        loop {
            let rest = self.rest();
            let Some(first) = rest.chars().next() else { return Ok(()) };
            if first == '\n' || first == '\u{2028}' || first == '\u{2029}' {
                self.line += 1;
                self.after_line_end = true;
                self.at += first.len_utf8();
            } else if first.is_whitespace() || matches!(first, '\u{feff}' | '\0') {
                self.at += first.len_utf8();
            } else if rest.starts_with("//") || rest.starts_with("<!--") {
                self.at += rest.find('\n').unwrap_or(rest.len());
            } else if rest.starts_with("/*") {
                let length = rest.find("*/").ok_or_else(|| self.obstacle("/*".to_owned()))? + 2;
                let ends = rest[..length].matches('\n').count();
                self.line += ends;
                self.after_line_end |= ends > 0;
                self.at += length;
            } else {
                return Ok(());
            }
        }
    }

    fn number(&mut self) -> Result<bool, Unreadable> {
        let rest = self.rest();
        let bytes = rest.as_bytes();
        if let Some(digits) = rest.strip_prefix("0x").or_else(|| rest.strip_prefix("0X")) {
            let length = digits.find(|digit: char| !digit.is_ascii_hexdigit()).unwrap_or(digits.len());
            let value = u32::from_str_radix(&digits[..length], 16).map_err(|_| self.obstacle("0x".to_owned()))?;
            self.push(TokenKind::Number(value.to_string(), f64::from(value)), length + 2);
            return Ok(true);
        }
        let digits = |from: usize| bytes[from..].iter().take_while(|byte| byte.is_ascii_digit()).count();
        let mut length = digits(0);
        if bytes.get(length) == Some(&b'.') {
            length += 1 + digits(length + 1);
        }
        if matches!(bytes.get(length), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(bytes.get(length + 1), Some(b'+' | b'-')));
            let exponent = digits(length + 1 + sign);
            if exponent > 0 {
                length += 1 + sign + exponent;
            }
        }
        let text = &rest[..length];
        let value: f64 = text.parse().map_err(|_| self.obstacle(text.to_owned()))?;
        if rest[length..].starts_with(is_part_of_name) {
            return Err(self.obstacle(rest.chars().take(length + 1).collect()));
        }
        let text = text.to_owned();
        self.push(TokenKind::Number(text, value), length);
        Ok(true)
    }

    fn text(&mut self, quote: char) -> Result<bool, Unreadable> {
        let line = self.line;
        let mut text = String::new();
        let mut letters = self.rest().char_indices().skip(1);
        while let Some((at, letter)) = letters.next() {
            match letter {
                _ if letter == quote => {
                    let length = at + 1;
                    self.push(TokenKind::Text(text), length);
                    return Ok(true);
                }
                '\\' => match letters.next().map(|(_, letter)| letter) {
                    Some('n' | 'r' | 't') => text.push(' '),
                    Some('u') => {
                        let digits: String = letters.by_ref().take(4).map(|(_, digit)| digit).collect();
                        let letter = u32::from_str_radix(&digits, 16).ok().and_then(char::from_u32);
                        text.push(letter.unwrap_or(char::REPLACEMENT_CHARACTER));
                    }
                    Some('\n') | None => {}
                    Some(letter) => text.push(letter),
                },
                '\n' if quote != '`' => break,
                // A template with values in it is no constant text.
                '$' if quote == '`' => break,
                _ => text.push(letter),
            }
        }
        Err(Unreadable::new(line, crate::refusal::Obstacle::Sign(quote.to_string())))
    }

    fn pattern(&mut self) -> Result<bool, Unreadable> {
        let mut in_class = false;
        let mut letters = self.rest().char_indices().skip(1);
        while let Some((at, letter)) = letters.next() {
            match letter {
                '\\' => _ = letters.next(),
                '[' => in_class = true,
                ']' => in_class = false,
                '\n' => break,
                '/' if !in_class => {
                    let rest = &self.rest()[at + 1..];
                    let flags = rest.find(|flag: char| !flag.is_ascii_lowercase()).unwrap_or(rest.len());
                    self.push(TokenKind::Pattern, at + 1 + flags);
                    return Ok(true);
                }
                _ => {}
            }
        }
        Err(self.obstacle("/".to_owned()))
    }
}

fn is_part_of_name(letter: char) -> bool {
    letter.is_alphanumeric() || matches!(letter, '_' | '$')
}

//! Position of the parser in the tokens, and its diagnostics.

use crate::lexer::{Keyword, Symbol, Token, TokenKind};
use crate::{Diagnostic, Span, StatedUnit};
use std::ops::Range;
use units::order::sort_by_key;
use units::{Unit, Words, words};

/// Marker of a failure that was already reported; the rest of the statement is skipped.
#[derive(Clone, Copy, Debug)]
pub(super) struct Told;

/// Result of parsing; an error has already been reported.
pub(super) type Read<T> = Result<T, Told>;

/// Sequential reader of tokens.
pub(super) struct Cursor<'a> {
    pub(super) source: &'a str,
    tokens: Vec<Token>,
    at: usize,
    /// Current nesting depth of parentheses, prefixes and branches.
    pub(super) depth: usize,
    diagnostics: Vec<Diagnostic>,
}

impl<'a> Cursor<'a> {
    /// Cursor at the first token. `tokens` must end with [`TokenKind::End`].
    pub(super) fn new(source: &'a str, tokens: Vec<Token>, diagnostics: Vec<Diagnostic>) -> Self {
        Self { source, tokens, at: 0, depth: 0, diagnostics }
    }

    /// Returns all diagnostics in text order.
    pub(super) fn finish(mut self) -> Vec<Diagnostic> {
        sort_by_key(&mut self.diagnostics, |diagnostic| diagnostic.span().start);
        self.diagnostics
    }

    fn token(&self, ahead: usize) -> Option<&Token> {
        self.tokens.get((self.at + ahead).min(self.tokens.len().saturating_sub(1)))
    }

    /// The next token.
    pub(super) fn peek(&self) -> &TokenKind {
        self.peek_ahead(0)
    }

    /// The token `ahead` tokens after the next one.
    pub(super) fn peek_ahead(&self, ahead: usize) -> &TokenKind {
        self.token(ahead).map_or(&TokenKind::End, |token| &token.kind)
    }

    /// Place of the next token.
    pub(super) fn span(&self) -> Span {
        self.span_ahead(0)
    }

    /// Place of the token `ahead` tokens after the next one.
    pub(super) fn span_ahead(&self, ahead: usize) -> Span {
        self.token(ahead).map(|token| token.span).unwrap_or_default()
    }

    /// Place of the preceding token; at the beginning, the empty place there.
    pub(super) fn last_span(&self) -> Span {
        match self.at.checked_sub(1).and_then(|at| self.tokens.get(at)) {
            Some(token) => token.span,
            None => Span::new(self.span().start, self.span().start),
        }
    }

    /// Advances and returns the place of the token. Never advances past the end.
    pub(super) fn advance(&mut self) -> Span {
        let span = self.span();
        if self.at + 1 < self.tokens.len() {
            self.at += 1;
        }
        span
    }

    /// Advances over a name or a text and returns it. The text is moved out of the token, since no token is read twice.
    pub(super) fn take_text(&mut self) -> String {
        let text = match self.tokens.get_mut(self.at).map(|token| &mut token.kind) {
            Some(TokenKind::Name { text, .. } | TokenKind::Text(text)) => std::mem::take(text),
            _ => String::new(),
        };
        self.advance();
        text
    }

    /// Moves back by one token if that is a line end.
    pub(super) fn back_to_line_end(&mut self) {
        if let Some(before) = self.at.checked_sub(1)
            && self.tokens.get(before).is_some_and(|token| token.kind == TokenKind::Newline)
        {
            self.at = before;
        }
    }

    /// Consumes the symbol if it comes next.
    pub(super) fn take(&mut self, symbol: Symbol) -> Option<Span> {
        matches!(self.peek(), TokenKind::Symbol(next) if *next == symbol).then(|| self.advance())
    }

    /// Consumes the keyword if it comes next.
    pub(super) fn take_keyword(&mut self, keyword: Keyword) -> Option<Span> {
        matches!(self.peek(), TokenKind::Keyword(next) if *next == keyword).then(|| self.advance())
    }

    /// Consumes the brace that opens a block; it may stand at the beginning of the next line.
    pub(super) fn open_brace(&mut self) -> Option<Span> {
        if *self.peek() == TokenKind::Newline && *self.peek_ahead(1) == TokenKind::Symbol(Symbol::LeftBrace) {
            self.skip_lines();
        }
        self.take(Symbol::LeftBrace)
    }

    /// Error for a missing opening brace. At the end of a line its place is `before`.
    pub(super) fn brace_expected(&self, code: &'static str, before: Span) -> Diagnostic {
        let wrong = words!("`{{` is expected here, not {found}", found = self.found());
        Diagnostic::error(code, wrong, if self.at_line_end() { before } else { self.span() })
    }

    /// True if this name comes next, without primes.
    pub(super) fn at_word(&self, word: &str) -> bool {
        matches!(self.peek(), TokenKind::Name { text, order: 0, .. } if text == word)
    }

    /// True at this word followed by a name. The word is reserved only there.
    pub(super) fn begins_with(&self, word: &str) -> bool {
        self.at_word(word) && matches!(self.peek_ahead(1), TokenKind::Name { .. })
    }

    /// Skips line ends.
    pub(super) fn skip_lines(&mut self) {
        while *self.peek() == TokenKind::Newline {
            self.advance();
        }
    }

    /// True at the end of a line or of the text.
    pub(super) fn at_line_end(&self) -> bool {
        matches!(self.peek(), TokenKind::Newline | TokenKind::End)
    }

    /// Skips to the end of the line, or to a closing brace or a semicolon if `in_braces`.
    pub(super) fn skip_rest(&mut self, in_braces: bool) {
        let mut braces = 0_usize;
        while *self.peek() != TokenKind::End {
            match self.peek() {
                TokenKind::Symbol(Symbol::LeftBrace) => braces += 1,
                TokenKind::Symbol(Symbol::RightBrace) if braces > 0 => braces -= 1,
                TokenKind::Symbol(Symbol::RightBrace | Symbol::Semicolon) if in_braces => return,
                TokenKind::Newline if braces == 0 => return,
                _ => {}
            }
            self.advance();
        }
    }

    /// Adds a diagnostic.
    pub(super) fn say(&mut self, diagnostic: Diagnostic) {
        self.diagnostics.push(diagnostic);
    }

    /// Adds a diagnostic and returns the failure.
    pub(super) fn fail<T>(&mut self, diagnostic: Diagnostic) -> Read<T> {
        // An unknown token was already reported; errors after it are consequences.
        if *self.peek() != TokenKind::Unknown {
            self.say(diagnostic);
        }
        Err(Told)
    }

    /// Description of the next token.
    pub(super) fn found(&self) -> Words {
        match self.peek() {
            TokenKind::Newline => words("the end of the line"),
            TokenKind::End => words("the end"),
            TokenKind::Text(_) => words("a text"),
            _ => Words::same(format!("`{}`", &self.source[self.span().range()])),
        }
    }

    /// Parses the unit at the byte range `inside` of brackets. Errors in it are reported.
    pub(super) fn unit(&mut self, inside: Range<usize>) -> Read<Unit> {
        let text = &self.source[inside.clone()];
        Unit::parse(text).map_err(|error| {
            let brackets = Span::new(inside.start - 1, inside.end + 1);
            self.say(Diagnostic::of_unit(error, inside.start, brackets));
            Told
        })
    }

    /// Parses `in [unit]` if it comes next. An invalid unit is reported and left out.
    pub(super) fn stated_unit(&mut self) -> Read<Option<StatedUnit>> {
        let Some(keyword) = self.take_keyword(Keyword::In) else {
            return Ok(None);
        };
        let span = self.span();
        let TokenKind::Brackets(inside) = self.peek().clone() else {
            let wrong = words!("after `in` a unit in brackets is expected, not {found}", found = self.found());
            let hint = words("such as in [m/s]; ranges belong to parameters");
            let at = if self.at_line_end() { keyword } else { span };
            let diagnostic = Diagnostic::error("missing-unit", wrong, at).with_hint(hint);
            return self.fail(match self.bare_unit() {
                Some(unit) => diagnostic.with_fix(unit.span, format!("[{}]", unit.text)),
                None => diagnostic,
            });
        };
        self.advance();
        let unit = self.unit(inside).ok();
        Ok(unit.map(|unit| StatedUnit { unit, span }))
    }
}

//! Line ends that end a statement: those outside parentheses that do not follow an operator.
//!
//! A line that clearly begins a statement (`m = ...`, `y(0) = ...`, `parameter ...`) always ends the one before. No
//! expression continues like that, and a missing parenthesis then spoils only one statement.

use crate::lexer::{Keyword, Symbol, Token, TokenKind};

/// Removes the line ends within statements.
pub(super) fn statement_lines(mut tokens: Vec<Token>) -> Vec<Token> {
    let mut keeps = kept(&tokens).into_iter();
    tokens.retain(|_| keeps.next().unwrap_or(true));
    tokens
}

/// Removes all line ends.
pub(super) fn one_line(mut tokens: Vec<Token>) -> Vec<Token> {
    tokens.retain(|token| token.kind != TokenKind::Newline);
    tokens
}

fn kept(tokens: &[Token]) -> Vec<bool> {
    let mut last = &TokenKind::Newline;
    let mut keeps = Vec::with_capacity(tokens.len());
    for (token, goes_on) in tokens.iter().zip(goes_on(tokens)) {
        let keep = token.kind != TokenKind::Newline || !goes_on && *last != TokenKind::Newline;
        if keep {
            last = &token.kind;
        }
        keeps.push(keep);
    }
    keeps
}

/// For each token, true if it is a line end after which the statement continues.
pub(crate) fn goes_on(tokens: &[Token]) -> Vec<bool> {
    let mut parentheses: usize = 0;
    let mut last = &TokenKind::Newline;
    let mut found = Vec::with_capacity(tokens.len());
    for (index, token) in tokens.iter().enumerate() {
        let mut goes_on = false;
        match &token.kind {
            TokenKind::Newline => {
                let begins = begins_statement(&tokens[index + 1..]);
                goes_on = *last != TokenKind::Newline && !begins && (parentheses > 0 || continues(last));
                if begins {
                    parentheses = 0;
                }
            }
            TokenKind::Symbol(Symbol::LeftParenthesis) => parentheses += 1,
            TokenKind::Symbol(Symbol::RightParenthesis) => parentheses = parentheses.saturating_sub(1),
            TokenKind::Symbol(Symbol::LeftBrace | Symbol::RightBrace) => parentheses = 0,
            _ => {}
        }
        if !goes_on {
            last = &token.kind;
        }
        found.push(goes_on);
    }
    found
}

/// True if a statement continues after a line that ends in this token.
fn continues(last: &TokenKind) -> bool {
    match last {
        TokenKind::Symbol(symbol) => {
            !matches!(symbol, Symbol::RightParenthesis | Symbol::LeftBrace | Symbol::RightBrace | Symbol::Semicolon)
        }
        TokenKind::Keyword(_) => true,
        _ => false,
    }
}

/// True if these tokens can only be the beginning of a statement.
fn begins_statement(tokens: &[Token]) -> bool {
    let mut kinds = tokens.iter().map(|token| &token.kind).skip_while(|kind| **kind == TokenKind::Newline);
    let equals = TokenKind::Symbol(Symbol::Equals);
    match kinds.next() {
        Some(TokenKind::Keyword(Keyword::Parameter | Keyword::Independent | Keyword::When)) => true,
        Some(TokenKind::Name { .. }) => match kinds.next() {
            Some(TokenKind::Symbol(Symbol::LeftParenthesis)) => {
                let zero = matches!(kinds.next(), Some(TokenKind::Number(_)));
                let closed = kinds.next() == Some(&TokenKind::Symbol(Symbol::RightParenthesis));
                zero && closed && kinds.next() == Some(&equals)
            }
            other => other == Some(&equals),
        },
        _ => false,
    }
}

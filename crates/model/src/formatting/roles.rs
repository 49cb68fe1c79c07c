//! Roles of tokens with respect to their neighbours: sign or operator, point of a table, bound of a range.

use crate::lexer::{Symbol, Token, TokenKind};

/// Role of a token with respect to its neighbours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    Number,
    Name,
    Keyword,
    /// `=`, a comparison, or `+` and `-` of a sum.
    Operator,
    /// An operator without blanks: of a product or power, and of a sum in the bounds of a range.
    Tight,
    /// A unary sign.
    Sign,
    Opening,
    Closing,
    Brace,
    Separator,
    Colon,
    Dots,
    Text,
    /// A unit or an index.
    Brackets,
    /// Attached to the token before it: primes, components, superscript digits.
    Attached,
    Unknown,
    /// A point of a table or a mark between points.
    Point,
    Comment,
}

/// Words before an expression. All of them are also valid names: only the blanks around a following `-` tell a sign from an
/// operator.
const WORDS: [&str; 14] = [
    "of",
    "at",
    "from",
    "until",
    "against",
    "points",
    "within",
    "than",
    "step",
    "changes",
    "every",
    "by",
    "histogram",
    "assigned",
];

/// Role of each token.
pub(super) fn roles(source: &str, tokens: &[Token]) -> Vec<Role> {
    let in_range = in_ranges(tokens);
    let points = points(tokens);
    let mut roles: Vec<Role> = Vec::with_capacity(tokens.len());
    // Index of the last token that is not a line end: a sum may continue on the next line.
    let mut last: Option<usize> = None;
    for (index, token) in tokens.iter().enumerate() {
        let before = last.map(|last| roles[last]);
        let role = match &token.kind {
            _ if points[index] => Role::Point,
            TokenKind::Number(_) => Role::Number,
            TokenKind::Name { .. } => Role::Name,
            TokenKind::Keyword(_) => Role::Keyword,
            TokenKind::Text(_) => Role::Text,
            TokenKind::Brackets(_) => Role::Brackets,
            TokenKind::Component { .. } | TokenKind::Raised(_) | TokenKind::Primes => Role::Attached,
            TokenKind::Symbol(Symbol::Plus | Symbol::Minus) => {
                let follows_word =
                    last.is_some_and(|last| is_sign_after_word(source, &tokens[last..], token.span.start));
                match before {
                    Some(before) if is_end_of_operand(before) && !follows_word => {
                        if in_range[index] {
                            Role::Tight
                        } else {
                            Role::Operator
                        }
                    }
                    _ => Role::Sign,
                }
            }
            TokenKind::Symbol(symbol) => of_symbol(*symbol),
            TokenKind::Unknown | TokenKind::Newline | TokenKind::End => Role::Unknown,
        };
        roles.push(role);
        if token.kind != TokenKind::Newline {
            last = Some(index);
        }
    }
    roles
}

fn of_symbol(symbol: Symbol) -> Role {
    match symbol {
        Symbol::Plus
        | Symbol::Minus
        | Symbol::Equals
        | Symbol::EqualTo
        | Symbol::NotEqualTo
        | Symbol::Less
        | Symbol::LessOrEqual
        | Symbol::Greater
        | Symbol::GreaterOrEqual => Role::Operator,
        Symbol::Star | Symbol::Slash | Symbol::Caret => Role::Tight,
        Symbol::Root => Role::Sign,
        Symbol::LeftParenthesis => Role::Opening,
        Symbol::RightParenthesis => Role::Closing,
        Symbol::LeftBrace | Symbol::RightBrace => Role::Brace,
        Symbol::Comma | Symbol::Semicolon => Role::Separator,
        Symbol::Dots => Role::Dots,
        Symbol::Colon => Role::Colon,
    }
}

fn is_end_of_operand(role: Role) -> bool {
    matches!(role, Role::Number | Role::Name | Role::Closing | Role::Brackets | Role::Attached | Role::Text)
}

/// True for `of -x`: a `-` at byte `sign` after the first of `tokens`, which is one of [`WORDS`], with a blank before it
/// and none after it.
fn is_sign_after_word(source: &str, tokens: &[Token], sign: usize) -> bool {
    let is_word = tokens.first().is_some_and(|token| WORDS.contains(&&source[token.span.range()]));
    let apart = tokens.first().is_some_and(|token| token.span.end < sign);
    let close = source[sign..].chars().nth(1).is_some_and(|next| !next.is_whitespace());
    is_word && apart && close
}

/// For each token, true if it is a point of a table.
fn points(tokens: &[Token]) -> Vec<bool> {
    let mut table = false;
    let mut inside = false;
    let kinds = tokens.iter().map(|token| match &token.kind {
        TokenKind::Name { text, order: 0, .. } if text == "table" && !inside => {
            table = true;
            false
        }
        TokenKind::Symbol(Symbol::LeftBrace) => {
            inside = table;
            table = false;
            false
        }
        TokenKind::Symbol(Symbol::RightBrace) => {
            inside = false;
            false
        }
        TokenKind::Newline => false,
        _ => inside,
    });
    kinds.collect()
}

/// For each token, true if it is `+` or `-` in the bounds of a range, as in `for i in 0..N+1`.
fn in_ranges(tokens: &[Token]) -> Vec<bool> {
    let mut found = vec![false; tokens.len()];
    for (index, _) in tokens.iter().enumerate().filter(|(_, token)| token.kind == TokenKind::Symbol(Symbol::Dots)) {
        mark_bound(tokens, index + 1..tokens.len(), &mut found);
        mark_bound(tokens, (0..index).rev(), &mut found);
    }
    found
}

/// Marks the signs of the sum that the tokens form in this order, up to the first token that cannot belong to it.
fn mark_bound(tokens: &[Token], order: impl Iterator<Item = usize>, found: &mut [bool]) {
    let mut depth = 0_usize;
    let mut operand = false;
    for index in order {
        match &tokens[index].kind {
            TokenKind::Symbol(Symbol::LeftParenthesis | Symbol::RightParenthesis) => {
                let is_outer = depth == 0;
                let opens = !operand && is_outer;
                if opens {
                    depth += 1;
                } else if is_outer {
                    return;
                } else {
                    depth -= 1;
                    operand = true;
                }
            }
            TokenKind::Newline | TokenKind::End => return,
            _ if depth > 0 => {}
            TokenKind::Symbol(Symbol::Plus | Symbol::Minus) => {
                found[index] = true;
                operand = false;
            }
            TokenKind::Symbol(Symbol::Star | Symbol::Slash | Symbol::Caret) => operand = false,
            TokenKind::Number(_) | TokenKind::Name { .. } if !operand => operand = true,
            _ => return,
        }
    }
}

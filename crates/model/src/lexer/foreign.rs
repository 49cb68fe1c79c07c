//! Syntax of other tools that newcomers use. It is reported, and the line is lexed as it was meant, to avoid errors that
//! follow from the first.

use super::Lexer;
use super::token::{Symbol, TokenKind};
use crate::{Diagnostic, Span};
use units::words;

/// Names of function modules in other languages.
const COLLECTIONS: [&str; 5] = ["Math", "math", "np", "numpy", "cmath"];

/// Compound assignment operators.
const CHANGES: [&str; 4] = ["+=", "-=", "*=", "/="];

impl Lexer<'_> {
    /// Consumes syntax of other tools. Returns true if there was any.
    pub(super) fn foreign(&mut self) -> bool {
        let rest = self.rest();
        if rest.starts_with("//") || rest.starts_with("/*") {
            self.foreign_comment();
        } else if CHANGES.iter().any(|text| rest.starts_with(text)) {
            self.change();
        } else if rest.starts_with("++") || rest.starts_with("--") {
            return self.increment();
        } else if rest.starts_with('?') {
            self.choice();
        } else if rest.starts_with('|') {
            return self.bars();
        } else {
            return rest.starts_with('.') && self.member();
        }
        true
    }

    /// `// a comment`, to the end of the line.
    fn foreign_comment(&mut self) {
        let start = self.at;
        self.skip(|c| c != '\n');
        let span = Span::new(start, start + 2);
        let wrong = words("a comment begins with `#` here");
        self.diagnostics.push(Diagnostic::error("foreign-comment", wrong, span).with_fix(span, "#"));
    }

    /// `n += 1`
    fn change(&mut self) {
        let start = self.at;
        self.at += 2;
        let text = &self.source[start..self.at];
        let wrong = words!("`{text}` changes a value step by step; what stands here holds at every moment");
        let diagnostic = Diagnostic::error("foreign-assignment", wrong, Span::new(start, self.at));
        let diagnostic = match self.name_before(start).map(str::to_owned) {
            Some(name) => diagnostic
                .with_hint(words!("for a rate of change write `{name}' = ...`"))
                .with_hint(words!("in the action of an event write `{name} = {name} {} ...`", &text[..1]))
                .with_fix(Span::new(start, self.at), format!("= {name} {}", &text[..1])),
            None => diagnostic,
        };
        self.diagnostics.push(diagnostic);
        self.push(TokenKind::Symbol(Symbol::Equals), start);
    }

    /// `n++` at the end of an action. Returns true if it is one: `a--b` is a difference.
    fn increment(&mut self) -> bool {
        let start = self.at;
        let span = Span::new(start, start + 2);
        let ends = self.rest()[2..].trim_start_matches([' ', '\t']).starts_with(['}', ',', ';', '\n', '#']);
        let Some(name) = self.name_before(start).filter(|_| ends || self.rest().len() == 2).map(str::to_owned) else {
            return false;
        };
        self.at = span.end;
        let text = &self.source[span.range()];
        let wrong = words!("`{text}` is not an operator here: an action states the new value");
        let sum = format!("= {name} {} 1", &text[..1]);
        self.diagnostics.push(
            Diagnostic::error("foreign-assignment", wrong, span)
                .with_hint(words!("write `{name} {sum}`", sum = sum.clone()))
                .with_fix(span, format!(" {sum}")),
        );
        self.push(TokenKind::Symbol(Symbol::Equals), start);
        self.push(TokenKind::Unknown, start);
        true
    }

    /// `|y|`. Returns true if there is a second bar.
    fn bars(&mut self) -> bool {
        let line = self.rest().split(['\n', '#']).next().unwrap_or_default();
        let inside = line[1..].split_once('|').map(|(inside, _)| inside).filter(|inside| !inside.trim().is_empty());
        let Some(inside) = inside else { return false };
        let start = self.at;
        self.at += inside.len() + 2;
        let span = Span::new(start, self.at);
        let wrong = words!("`|{inside}|` is written `abs({inside})` here");
        let diagnostic = Diagnostic::error("foreign-operator", wrong, span);
        self.diagnostics.push(diagnostic.with_fix(span, format!("abs({inside})")));
        self.push(TokenKind::Unknown, start);
        true
    }

    /// `a > b ? x : y`. The rest of the line is skipped because it cannot be interpreted without its beginning.
    fn choice(&mut self) {
        let start = self.at;
        self.at += 1;
        let wrong = words("`?` and `:` choose nothing here");
        self.diagnostics.push(
            Diagnostic::error("foreign-choice", wrong, Span::new(start, self.at))
                .with_hint(words("write: if CONDITION then ... else ...")),
        );
        self.skip(|c| !matches!(c, '\n' | '#'));
        self.push(TokenKind::Unknown, start);
    }

    /// True if a point after this name is syntax of another tool: `Math.sin`.
    pub(super) fn is_foreign_collection(&self, name: &str) -> bool {
        COLLECTIONS.contains(&name)
    }

    /// Reduces `Math.sin` to `sin`. Returns true if the point belongs to such a name.
    fn member(&mut self) -> bool {
        let Some(collection) = self.name_before(self.at).filter(|name| COLLECTIONS.contains(name)) else {
            return false;
        };
        let start = self.at - collection.len();
        let member = self.rest()[1..].split(|c: char| !c.is_alphanumeric()).next().unwrap_or_default();
        if !member.starts_with(|c: char| c.is_alphabetic()) {
            return false;
        }
        let end = self.at + 1 + member.len();
        let meant = match member {
            "PI" => "pi",
            "pow" => "^",
            other => other,
        };
        let wrong = words!("`{collection}.{member}` is written `{meant}` here");
        let span = Span::new(start, end);
        let mut diagnostic = Diagnostic::error("foreign-name", wrong, span);
        if meant != "^" {
            diagnostic = diagnostic.with_fix(span, meant);
        }
        self.diagnostics.push(diagnostic);
        self.tokens.pop();
        if meant == member {
            self.at += 1;
            return true;
        }
        self.at = end;
        let name = TokenKind::Name { text: meant.to_owned(), order: 0, end };
        self.push(if meant == "pi" { name } else { TokenKind::Unknown }, start);
        true
    }

    /// Name that ends before the byte `at`, ignoring blanks.
    fn name_before(&self, at: usize) -> Option<&str> {
        let token = self.tokens.last()?;
        let TokenKind::Name { text, order: 0, .. } = &token.kind else { return None };
        self.source[token.span.end..at].trim().is_empty().then_some(text.as_str())
    }
}

//! Keywords in Spanish, and English words of other tools. The line is lexed as it was meant, so that a single message names
//! the words to use.

use super::Lexer;
use super::token::{KEYWORDS, TokenKind};
use crate::{Diagnostic, Edit, Span};
use units::alphabet::without_accent;
use units::words;

/// Context in which a foreign word is unambiguous.
#[derive(Clone, Copy, PartialEq)]
enum Place {
    /// At the beginning of a statement, before a name, a number or a text.
    Start,
    /// Between two operands, which need an operator between them.
    Between,
    /// At the start of an operand, before another one.
    Before,
    /// Alone in braces.
    Action,
}

/// Foreign words without accents and capitals, and the words that they stand for.
const WORDS: &[(&str, &str, Place)] = &[
    ("parametro", "parameter", Place::Start),
    ("parametros", "parameter", Place::Start),
    ("constante", "parameter", Place::Start),
    ("constantes", "parameter", Place::Start),
    ("independiente", "independent", Place::Start),
    ("funcion", "function", Place::Start),
    ("cuando", "when", Place::Start),
    ("evento", "when", Place::Start),
    ("si", "when", Place::Start),
    ("cada", "every", Place::Start),
    ("boton", "button", Place::Start),
    ("tabla", "table", Place::Start),
    ("discreta", "discrete", Place::Start),
    ("discreto", "discrete", Place::Start),
    ("interruptor", "switch", Place::Start),
    ("eleccion", "choice", Place::Start),
    ("opcion", "choice", Place::Start),
    ("grupo", "group", Place::Start),
    ("aleatorio", "random", Place::Start),
    ("semilla", "random", Place::Start),
    ("tamano", "size", Place::Start),
    ("siguiente", "next", Place::Start),
    ("proximo", "next", Place::Start),
    ("oculto", "hidden", Place::Start),
    ("oculta", "hidden", Place::Start),
    ("si", "if", Place::Before),
    ("no", "not", Place::Before),
    ("entonces", "then", Place::Between),
    ("sino", "else", Place::Between),
    ("y", "and", Place::Between),
    ("o", "or", Place::Between),
    ("en", "in", Place::Between),
    ("paso", "step", Place::Between),
    ("asignado", "assigned", Place::Between),
    ("asignada", "assigned", Place::Between),
    ("desde", "from", Place::Between),
    ("hasta", "until", Place::Between),
    ("como", "as", Place::Between),
    ("para", "for", Place::Between),
    ("sea", "let", Place::Before),
    ("parar", "stop", Place::Action),
    ("detener", "stop", Place::Action),
    ("alto", "stop", Place::Action),
];

impl Lexer<'_> {
    /// Consumes a Spanish keyword at the current position if the context leaves no other meaning. Returns true if there was
    /// one.
    pub(super) fn spanish(&mut self) -> bool {
        let start = self.at;
        let written = self.rest().split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or_default();
        let plain: String = written.chars().map(without_accent).collect::<String>().to_lowercase();
        let mut end = start + written.len();
        let meant = WORDS.iter().find(|(word, _, place)| *word == plain && self.can_stand(*place, start, end));
        let Some((_, mut ours, place)) = meant.copied() else { return false };
        // `si` is `when` before an event; a condition with an alternative is `if`.
        if (plain.as_str(), place) == ("si", Place::Start) && !self.line_after(end).contains('{') {
            ours = "if";
        }
        // `si no`: `else` in two words.
        if plain == "si" && ours == "if" && self.ends_in_operand() {
            let rest = self.line_after(end);
            let blanks = rest.len() - rest.trim_start().len();
            if rest.trim_start().starts_with("no ") {
                (ours, end) = ("else", end + blanks + 2);
            }
        }
        self.at = end;
        self.say_english(Span::new(start, end), ours);
        match KEYWORDS.iter().find(|(word, _)| *word == ours) {
            Some((_, keyword)) => self.push(TokenKind::Keyword(*keyword), start),
            None => self.push(TokenKind::Name { text: ours.to_owned(), order: 0, end }, start),
        }
        true
    }

    /// Reports the English word. Further words of a line add only a remedy to the first message.
    fn say_english(&mut self, span: Span, ours: &str) {
        let edit = Edit { span, text: ours.to_owned() };
        let written = &self.source[span.range()];
        let hint = words!("write `{ours}` for `{written}`");
        let earlier = self.spanish_before(span.start).and_then(|at| self.diagnostics.get_mut(at));
        if let Some(earlier) = earlier {
            earlier.hints.push(hint);
            if let Some(fix) = earlier.fixes.first_mut() {
                fix.edits.push(edit);
            }
            return;
        }
        let wrong = words!("`{written}` is not a word of the language: its words are English");
        let diagnostic = Diagnostic::error("unknown-word", wrong, span).with_hint(hint);
        self.diagnostics.push(diagnostic.with_fixes(vec![edit]));
    }

    /// Index of the message about an earlier Spanish word of the line.
    fn spanish_before(&self, start: usize) -> Option<usize> {
        let last = self.diagnostics.last().filter(|last| last.code == "unknown-word")?;
        (!self.source[last.span().start..start].contains('\n')).then(|| self.diagnostics.len() - 1)
    }

    fn can_stand(&self, place: Place, start: usize, end: usize) -> bool {
        let rest = self.line_after(end);
        let next = rest.trim_start().chars().next();
        let apart = rest.starts_with(char::is_whitespace);
        let is_operand = |c: char| c.is_alphanumeric() || matches!(c, '"' | '“' | '«');
        let before_operand = apart && next.is_some_and(is_operand);
        match place {
            Place::Start => self.begins_statement() && before_operand,
            Place::Between => {
                let goes_on = before_operand || (apart && next.is_some_and(|c| matches!(c, '[' | '(' | '-')));
                // At the end of a line, the second operand stands on the next one.
                let joins_lines = rest.trim().is_empty() && self.source[start..end].len() > 1;
                // `y` and `o` are also names: they join conditions only after other Spanish words of the line.
                let is_name = end == start + 1 && self.spanish_before(start).is_none();
                !is_name && self.ends_in_operand() && (goes_on || joins_lines) && self.touches_nothing(start)
            }
            Place::Before => {
                let in_parentheses = next == Some('(') && self.line_after(end).contains("entonces");
                !self.begins_statement() && (before_operand || in_parentheses) || self.is_second_half(start, end)
            }
            Place::Action => {
                let before = self.source[..start].trim_end_matches([' ', '\t']);
                let ends = next.is_none_or(|c| matches!(c, '}' | ',' | '#'));
                before.ends_with(['{', ',', '\n']) && ends
            }
        }
    }

    /// True for `si no` after an operand: the alternative of a condition, in two words.
    fn is_second_half(&self, start: usize, end: usize) -> bool {
        &self.source[start..end] == "si"
            && self.ends_in_operand()
            && self.line_after(end).trim_start().starts_with("no ")
    }

    fn touches_nothing(&self, start: usize) -> bool {
        self.source[..start].ends_with([' ', '\t', '\n', ')', ']'])
    }

    /// Rest of the line after the byte `end`.
    fn line_after(&self, end: usize) -> &str {
        self.source.get(end..self.end).unwrap_or_default().lines().next().unwrap_or_default()
    }

    fn begins_statement(&self) -> bool {
        match self.tokens.last().map(|token| &token.kind) {
            None | Some(TokenKind::Newline) => true,
            Some(TokenKind::Name { text, .. }) => text == "hidden",
            _ => false,
        }
    }

    fn ends_in_operand(&self) -> bool {
        use super::token::Symbol::{RightBrace, RightParenthesis};
        match self.tokens.last().map(|token| &token.kind) {
            Some(
                TokenKind::Number(_)
                | TokenKind::Text(_)
                | TokenKind::Brackets(_)
                | TokenKind::Raised(_)
                | TokenKind::Symbol(RightParenthesis | RightBrace),
            ) => true,
            Some(TokenKind::Name { text, .. }) => !matches!(text.as_str(), "let" | "stop" | "step" | "from" | "until"),
            _ => false,
        }
    }
}

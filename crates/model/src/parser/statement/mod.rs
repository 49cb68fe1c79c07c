//! Statements, and recovery after errors. The valid parts of a wrong statement are kept, so that the names that it defines
//! are known to the other statements.

mod button;
mod choice;
mod declaration;
mod discrete;
mod drawn;
mod event;
mod family;
mod function;
mod group;
mod map;
mod random;
mod switch;
mod table;

use super::cursor::{Cursor, Read, Told};
use super::expression::Tree;
use super::unread;
use crate::lexer::{Keyword, Symbol, TokenKind};
use crate::{
    Diagnostic, Expression, ExpressionKind, Members, Name, ParameterForm, Quoted, Span, Statement, StatementKind,
};
use units::{Words, words};

/// Words of other languages, and the keyword that each stands for here.
const OTHER_WORDS: &[(&str, &[&str])] = &[
    (
        "parameter",
        &["parameters", "param", "par", "const", "constant", "let", "var", "input", "int", "float", "double", "real"],
    ),
    ("independent", &["variable"]),
    ("function", &["def", "func", "fn"]),
    ("when", &["event", "on", "while"]),
];

/// Words of mechanics by which other programs derive equations of motion.
const VARIATIONAL: [&str; 5] = ["lagrangian", "lagrange", "hamiltonian", "lagrangiano", "hamiltoniano"];

/// The parsed part of a statement, and the result; after an error the end of the statement is not checked.
pub(super) type Salvaged = (StatementKind, Read<()>);

impl Cursor<'_> {
    /// Parses all statements up to the end of the tokens.
    pub(super) fn statements(&mut self) -> Vec<Statement> {
        let mut statements = Vec::new();
        loop {
            self.skip_lines();
            if *self.peek() == TokenKind::End {
                return statements;
            }
            let first = statements.is_empty();
            statements.push(self.statement(first));
        }
    }

    fn statement(&mut self, first: bool) -> Statement {
        let start = self.span();
        self.depth = 0;
        let hides_parameter = self.at_word("hidden") && *self.peek_ahead(1) == TokenKind::Keyword(Keyword::Parameter);
        let hidden = self.begins_with("hidden") || hides_parameter;
        if hidden {
            self.advance();
        }
        let (kind, mut read) = match self.peek() {
            TokenKind::Keyword(_) if *self.peek_ahead(1) == TokenKind::Symbol(Symbol::Equals) => {
                (nothing(start), self.plain_name(&words("a quantity")).map(|_| ()))
            }
            TokenKind::Name { .. } if self.begins_with("discrete") => self.discrete(),
            TokenKind::Name { .. } if self.begins_with("function") => self.function(),
            TokenKind::Name { .. } if self.is_every() => self.every(),
            TokenKind::Name { .. } if self.is_button() => self.button(),
            TokenKind::Name { .. } if self.is_group() => self.group(),
            TokenKind::Name { .. } if self.begins_with("next") => self.next_value(),
            TokenKind::Name { .. } if self.begins_with("switch") => self.switch(),
            TokenKind::Name { .. } if self.begins_with("random") => self.random(),
            TokenKind::Name { .. } if self.begins_with("choice") => self.choice(),
            TokenKind::Name { .. } if self.begins_with("size") => self.size(),
            TokenKind::Name { .. } if self.is_table() => self.table(first),
            TokenKind::Name { .. } if self.begins_with("for") => (nothing(start), self.no_loop()),
            TokenKind::Name { .. } if self.at_variational() => (nothing(start), self.variational()),
            TokenKind::Name { .. } if self.meant_word().is_some() => (nothing(start), self.unknown_word()),
            TokenKind::Keyword(Keyword::Parameter) => self.parameter(),
            TokenKind::Keyword(Keyword::Independent) => self.independent(),
            TokenKind::Keyword(Keyword::When) => self.event(),
            _ => self.equation(),
        };
        let mut label = None;
        let mut over = Vec::new();
        if read.is_ok() {
            match self.over() {
                Ok(read) => over = read,
                Err(reported) => read = Err(reported),
            }
        }
        if read.is_ok() {
            label = self.label();
            read = self.statement_end(&kind, label.as_ref());
        }
        if read.is_err() {
            self.skip_rest(false);
        } else if hidden {
            self.require_value(&kind, start);
        }
        let statement = Statement { kind, hidden, over, label, span: start.to(self.last_span()) };
        self.check_button(&statement);
        self.check_group(&statement);
        statement
    }

    /// Reports `hidden` before a statement that would not appear among the values.
    fn require_value(&mut self, kind: &StatementKind, hidden: Span) {
        let gives_value = match kind {
            StatementKind::Definition { .. }
            | StatementKind::Members { .. }
            | StatementKind::Discrete { .. }
            | StatementKind::InitialValue { .. } => true,
            StatementKind::Parameter(parameter) => parameter.form == ParameterForm::Number,
            StatementKind::Event { extras, .. } => extras.next,
            _ => false,
        };
        if gives_value {
            return;
        }
        let wrong = words(
            "only a parameter, a definition, a discrete quantity or an unknown with its initial value can be hidden",
        );
        self.say(Diagnostic::error("hidden-form", wrong, hidden).with_hint(words("such as: hidden m = rho*L")));
    }

    /// The keyword that was probably meant, if a statement begins with two names.
    fn meant_word(&self) -> Option<&'static str> {
        let TokenKind::Name { .. } = self.peek_ahead(1) else {
            return None;
        };
        let lower = self.source[self.span().range()].to_lowercase();
        let is_meant = |(ours, others): &&(&str, &[&str])| *ours == lower || others.contains(&lower.as_str());
        OTHER_WORDS.iter().find(is_meant).map(|(ours, _)| *ours)
    }

    /// True at `lagrangian L = ...` and its like.
    fn at_variational(&self) -> bool {
        let lower = self.source[self.span().range()].to_lowercase();
        VARIATIONAL.contains(&lower.as_str()) && matches!(self.peek_ahead(1), TokenKind::Name { .. })
    }

    fn variational(&mut self) -> Read<()> {
        let wrong = words("equations of motion are not derived from an energy here");
        self.fail(
            Diagnostic::error("unknown-word", wrong, self.span())
                .with_hint(words("write them out, one for each coordinate, such as: m*x'' = -k*x")),
        )
    }

    fn unknown_word(&mut self) -> Read<()> {
        let wrong = words!("{found} is not a word of the language", found = self.found());
        let diagnostic = Diagnostic::error("unknown-word", wrong, self.span());
        let meant = self.meant_word().unwrap_or_default();
        self.fail(diagnostic.meaning(meant))
    }

    fn no_loop<T>(&mut self) -> Read<T> {
        let wrong = words("there are no loops: what `for` is stated for stands before it");
        self.fail(
            Diagnostic::error("foreign-loop", wrong, self.span())
                .with_hint(words("the members of a family: `x[i] = i*a for i in 1..N`"))
                .with_hint(words(
                    "a sum: `sum(x[i] for i in 1..N)`; something at equal intervals: `every 0.1 [s] { ... }`",
                )),
        )
    }

    /// Parses a text in quotation marks, if it comes next.
    pub(super) fn label(&mut self) -> Option<Quoted> {
        let TokenKind::Text(_) = self.peek() else {
            return None;
        };
        let span = self.span();
        Some(Quoted { text: self.take_text(), span })
    }

    /// Parses a definition, an initial value or an equation.
    fn equation(&mut self) -> Salvaged {
        let start = self.span();
        let left = match self.expression() {
            Ok(left) => left,
            Err(reported) => return (nothing(start), Err(reported)),
        };
        if let Err(reported) = self.equals(&left) {
            return (nothing(left.expression.span), Err(reported));
        }
        let read = self.expression();
        let right = read.map(|tree| tree.expression);
        let mut outcome = right.as_ref().map(|_| ()).map_err(|reported| *reported);
        let right = right.unwrap_or_else(|_| unread(self.last_span().after()));
        let bare = !left.parenthesised;
        let left = left.expression;
        if bare && self.component_at_start(&left) {
            return (nothing(left.span), Err(Told));
        }
        match left.kind {
            ExpressionKind::Name { name, order: 0 } if bare => {
                let name = Name { text: name, span: left.span };
                let unit = outcome.and_then(|()| self.stated_unit());
                let outcome = unit.as_ref().map(|_| ()).map_err(|reported| *reported);
                (StatementKind::Definition { name, value: right, unit: unit.unwrap_or(None) }, outcome)
            }
            ExpressionKind::InitialValue { name, order } if bare => {
                let text_end = self.source[left.span.range()].find(['(']).unwrap_or_default();
                let written = self.source[left.span.start..left.span.start + text_end].trim_end();
                let name_only = written.trim_end_matches(|c| units::alphabet::primes(c).is_some());
                let span = Span::new(left.span.start, left.span.start + name_only.len());
                let unit = outcome.and_then(|()| self.stated_unit());
                let outcome = unit.as_ref().map(|_| ()).map_err(|reported| *reported);
                let name = Name { text: name, span };
                (StatementKind::InitialValue { name, order, value: right, unit: unit.unwrap_or(None) }, outcome)
            }
            ExpressionKind::Member { order, at_start, .. } if bare && (order == 0 || at_start) => {
                let what = if at_start { Members::InitialValues } else { Members::Definitions };
                let unit = outcome.and_then(|()| self.stated_unit());
                let outcome = unit.as_ref().map(|_| ()).map_err(|reported| *reported);
                (StatementKind::Members { what, left, value: right, unit: unit.unwrap_or(None) }, outcome)
            }
            ExpressionKind::Call { ref function, ref arguments } if bare => {
                if let [Expression { kind: ExpressionKind::Number { .. }, span }] = arguments.as_slice()
                    && program::functions::Function::named(&function.text).is_none()
                    && outcome.is_ok()
                {
                    let name = &function.text;
                    let wrong = words!("the start is at 0: a value is given for {name}(0) only");
                    self.say(Diagnostic::error("initial-value-not-at-zero", wrong, *span));
                    outcome = Err(Told);
                }
                (StatementKind::Equation { left, right }, outcome)
            }
            _ => (StatementKind::Equation { left, right }, outcome),
        }
    }

    /// Consumes the `=` after a left side.
    fn equals(&mut self, left: &Tree) -> Read<()> {
        if self.take(Symbol::Equals).is_some() {
            return Ok(());
        }
        let span = left.expression.span;
        if let ExpressionKind::Binary(crate::BinaryOperator::Equal, first, _) = &left.expression.kind
            && !left.parenthesised
        {
            let place = first.span.after();
            let sign = self.source[first.span.end..span.end].find("==").map(|at| first.span.end + at);
            let place = sign.map_or(place, |at| Span::new(at, at + 2));
            let wrong = words("`==` compares; an equation is written with one `=`");
            return self.fail(Diagnostic::error("missing-equals", wrong, place).with_fix(place, "="));
        }
        if !self.at_line_end() && !matches!(self.peek(), TokenKind::Text(_)) {
            return self.unexpected_after_expression();
        }
        let mut diagnostic =
            Diagnostic::error("missing-equals", words("this is an expression, but not a statement"), span);
        diagnostic = if self.next_line_continues() {
            let end = self.last_span().after();
            // The next line belongs to the same mistake.
            self.advance();
            diagnostic.with_label(end, words("the statement ends with its line")).with_hint(words(
                "to go on with the next line, end this one with the operator, or put all into parentheses",
            ))
        } else {
            let diagnostic =
                diagnostic.with_hint(words("a definition is written NAME = EXPRESSION, an equation LEFT = RIGHT"));
            let is_rate = self.source[span.range()].contains(|c| units::alphabet::primes(c).is_some());
            if is_rate { diagnostic.with_fix(span.after(), " = 0") } else { diagnostic }
        };
        self.fail(diagnostic)
    }

    fn next_line_continues(&self) -> bool {
        use Symbol::{Caret, Equals, Minus, Plus, RightParenthesis, Slash, Star};
        matches!(
            self.peek_ahead(1),
            TokenKind::Symbol(Plus | Minus | Star | Slash | Caret | Equals | RightParenthesis)
                | TokenKind::Keyword(Keyword::And | Keyword::Or | Keyword::Then | Keyword::Else | Keyword::In)
        ) && *self.peek() == TokenKind::Newline
    }

    /// Parses a name without primes.
    pub(super) fn plain_name(&mut self, what: &Words) -> Read<Name> {
        let span = self.span();
        match self.peek() {
            TokenKind::Name { order: 0, .. } => Ok(Name { text: self.take_text(), span }),
            TokenKind::Name { .. } => {
                let wrong = words!("{what} cannot have a prime");
                self.fail(Diagnostic::error("unexpected-token", wrong, span))
            }
            TokenKind::Keyword(_) => {
                let wrong = words!("{found} is a word of the language and cannot be a name", found = self.found());
                self.fail(Diagnostic::error("reserved-word", wrong, span))
            }
            _ => {
                let wrong = words!("the name of {what} is expected here, not {found}", found = self.found());
                let place = if self.at_line_end() { self.last_span() } else { span };
                self.fail(Diagnostic::error("missing-name", wrong, place))
            }
        }
    }
}

/// Placeholder for an unreadable statement.
pub(super) fn nothing(span: Span) -> StatementKind {
    StatementKind::Equation { left: unread(span), right: unread(span) }
}

//! Parser of the JavaScript subset, by precedence. Its depth is bounded.

use super::lexer::tokens;
use super::token::{Token, TokenKind};
use super::tree::{Expression, Function, Node, Operator, Statement, StatementKind};
use crate::refusal::{Obstacle, Unreadable};

/// Greatest depth of nesting and greatest number of operators in a row.
pub(super) const DEEPEST: usize = 200;

/// Statements of a page of code.
///
/// # Errors
/// The first place that is no JavaScript of the subset.
pub(crate) fn parse_program(source: &str) -> Result<Vec<Statement>, Unreadable> {
    let mut parser = Parser::new(source)?;
    let mut statements = Vec::new();
    while parser.peek().kind != TokenKind::End {
        statements.extend(parser.statement()?);
    }
    Ok(statements)
}

/// A single expression, such as the value of a variable.
///
/// # Errors
/// The text is no expression of the subset.
pub(crate) fn parse_expression(source: &str) -> Result<Expression, Unreadable> {
    let mut parser = Parser::new(source)?;
    let expression = parser.expression()?;
    parser.skip(";");
    if parser.peek().kind == TokenKind::End { Ok(expression) } else { Err(parser.unexpected()) }
}

pub(super) struct Parser {
    tokens: Vec<Token>,
    /// Token behind the last one.
    end: Token,
    at: usize,
    depth: usize,
}

impl Parser {
    fn new(source: &str) -> Result<Self, Unreadable> {
        let tokens = tokens(source)?;
        let line = tokens.last().map_or(1, |token| token.line);
        let end = Token { kind: TokenKind::End, line, after_line_end: true };
        Ok(Self { tokens, end, at: 0, depth: 0 })
    }

    pub(super) fn peek(&self) -> &Token {
        self.tokens.get(self.at).unwrap_or(&self.end)
    }

    pub(super) fn take(&mut self) -> Token {
        let token = self.peek().clone();
        self.at = (self.at + 1).min(self.tokens.len());
        token
    }

    pub(super) fn skip(&mut self, sign: &str) -> bool {
        let found = self.peek().kind.is_sign(sign);
        if found {
            self.take();
        }
        found
    }

    pub(super) fn skip_word(&mut self, word: &str) -> bool {
        let found = self.peek().kind.is_name(word);
        if found {
            self.take();
        }
        found
    }

    pub(super) fn need(&mut self, sign: &str) -> Result<(), Unreadable> {
        if self.skip(sign) { Ok(()) } else { Err(self.unexpected()) }
    }

    pub(super) fn unexpected(&self) -> Unreadable {
        let token = self.peek();
        let sign = match &token.kind {
            TokenKind::Number(text, _) | TokenKind::Name(text) => text.clone(),
            TokenKind::Text(text) => format!("\"{text}\""),
            TokenKind::Sign(sign) => (*sign).to_owned(),
            TokenKind::Pattern => "/".to_owned(),
            TokenKind::End => return Unreadable::new(token.line, Obstacle::End),
        };
        Unreadable::new(token.line, Obstacle::Sign(sign.chars().take(40).collect()))
    }

    /// Calls `inner` one level deeper.
    pub(super) fn deeper<T>(
        &mut self,
        inner: impl FnOnce(&mut Self) -> Result<T, Unreadable>,
    ) -> Result<T, Unreadable> {
        self.depth += 1;
        let result =
            if self.depth > DEEPEST { Err(Unreadable::new(self.peek().line, Obstacle::TooLong)) } else { inner(self) };
        self.depth -= 1;
        result
    }

    /// One statement; `None` for an empty one.
    fn statement(&mut self) -> Result<Option<Statement>, Unreadable> {
        self.deeper(Self::statement_inside)
    }

    fn statement_inside(&mut self) -> Result<Option<Statement>, Unreadable> {
        if self.skip(";") {
            return Ok(None);
        }
        let line = self.peek().line;
        let word = if let TokenKind::Name(word) = &self.peek().kind { word.clone() } else { String::new() };
        let kind = match word.as_str() {
            "var" | "let" | "const" if word == "var" || self.names_follow() => {
                self.take();
                let names = self.declarations()?;
                self.end_of_statement()?;
                StatementKind::Declaration(names)
            }
            "if" => {
                self.take();
                self.need("(")?;
                let condition = self.expression()?;
                self.need(")")?;
                let yes = self.body()?;
                let no = if self.skip_word("else") { self.body()? } else { Vec::new() };
                StatementKind::If(condition, yes, no)
            }
            "return" => {
                self.take();
                let ends = self.peek().after_line_end || self.peek().kind.is_sign("}") || self.peek().kind.is_sign(";");
                let value = if ends || self.peek().kind == TokenKind::End { None } else { Some(self.expression()?) };
                self.end_of_statement()?;
                StatementKind::Return(value)
            }
            "function" => {
                self.take();
                StatementKind::Function(self.function()?)
            }
            "for" => self.for_loop()?,
            "while" => {
                self.take();
                self.need("(")?;
                let condition = self.expression()?;
                self.need(")")?;
                StatementKind::Other("while", vec![condition], self.body()?)
            }
            "do" => {
                self.take();
                let body = self.body()?;
                if !self.skip_word("while") {
                    return Err(self.unexpected());
                }
                self.need("(")?;
                let condition = self.expression()?;
                self.need(")")?;
                self.skip(";");
                StatementKind::Other("do", vec![condition], body)
            }
            "switch" => self.switch()?,
            "try" => {
                self.take();
                let mut body = self.body()?;
                if self.skip_word("catch") {
                    if self.skip("(") {
                        self.take();
                        self.need(")")?;
                    }
                    body.extend(self.body()?);
                }
                if self.skip_word("finally") {
                    body.extend(self.body()?);
                }
                StatementKind::Other("try", Vec::new(), body)
            }
            "break" | "continue" | "throw" => {
                self.take();
                let value = if word == "throw" { vec![self.expression()?] } else { Vec::new() };
                self.end_of_statement()?;
                StatementKind::Other(if word == "throw" { "throw" } else { "break" }, value, Vec::new())
            }
            _ if self.skip("{") => StatementKind::Block(self.until_brace()?),
            _ => {
                let expression = self.expression()?;
                self.end_of_statement()?;
                StatementKind::Expression(expression)
            }
        };
        Ok(Some(Statement { kind, line }))
    }

    /// True if the token after the next one is a name: `let` and `const` are names themselves elsewhere.
    fn names_follow(&self) -> bool {
        matches!(self.tokens.get(self.at + 1).map(|token| &token.kind), Some(TokenKind::Name(_)))
    }

    fn declarations(&mut self) -> Result<Vec<(String, Option<Expression>)>, Unreadable> {
        let mut names = Vec::new();
        loop {
            let TokenKind::Name(name) = self.peek().kind.clone() else { return Err(self.unexpected()) };
            self.take();
            let value = if self.skip("=") { Some(self.assignment()?) } else { None };
            names.push((name, value));
            if !self.skip(",") {
                return Ok(names);
            }
        }
    }

    /// A statement ends by `;`, before `}`, at a line end or at the end of the text.
    fn end_of_statement(&mut self) -> Result<(), Unreadable> {
        let token = self.peek();
        let ends = token.after_line_end || token.kind.is_sign("}") || token.kind == TokenKind::End;
        if self.skip(";") || ends { Ok(()) } else { Err(self.unexpected()) }
    }

    /// Statements of a branch or loop: a block or a single statement.
    fn body(&mut self) -> Result<Vec<Statement>, Unreadable> {
        if self.skip("{") { self.until_brace() } else { Ok(self.statement()?.into_iter().collect()) }
    }

    fn until_brace(&mut self) -> Result<Vec<Statement>, Unreadable> {
        let mut statements = Vec::new();
        while !self.skip("}") {
            if self.peek().kind == TokenKind::End {
                return Err(self.unexpected());
            }
            statements.extend(self.statement()?);
        }
        Ok(statements)
    }

    /// Function after its word.
    pub(super) fn function(&mut self) -> Result<Function, Unreadable> {
        let name = match self.peek().kind.clone() {
            TokenKind::Name(name) => {
                self.take();
                name
            }
            _ => String::new(),
        };
        self.need("(")?;
        let mut arguments = Vec::new();
        while !self.skip(")") {
            let TokenKind::Name(argument) = self.take().kind else { return Err(self.unexpected()) };
            arguments.push(argument);
            if !self.skip(",") && !self.peek().kind.is_sign(")") {
                return Err(self.unexpected());
            }
        }
        self.need("{")?;
        Ok(Function { name, arguments, body: self.until_brace()? })
    }

    fn for_loop(&mut self) -> Result<StatementKind, Unreadable> {
        self.take();
        self.need("(")?;
        let mut head = Vec::new();
        let mut body = Vec::new();
        if self.skip_word("var") || self.names_follow() && (self.skip_word("let") || self.skip_word("const")) {
            let line = self.peek().line;
            let names = self.declarations()?;
            body.push(Statement { kind: StatementKind::Declaration(names), line });
        } else if !self.peek().kind.is_sign(";") {
            head.push(self.expression()?);
        }
        if self.skip_word("in") || self.skip_word("of") {
            head.push(self.expression()?);
        } else {
            self.need(";")?;
            if !self.peek().kind.is_sign(";") {
                head.push(self.expression()?);
            }
            self.need(";")?;
            if !self.peek().kind.is_sign(")") {
                head.push(self.expression()?);
            }
        }
        self.need(")")?;
        body.extend(self.body()?);
        Ok(StatementKind::Other("for", head, body))
    }

    /// `switch`, as conditions if each case ends by `break` or `return`.
    fn switch(&mut self) -> Result<StatementKind, Unreadable> {
        let line = self.take().line;
        self.need("(")?;
        let subject = self.expression()?;
        self.need(")")?;
        self.need("{")?;
        let mut cases: Vec<(Vec<Expression>, bool, Vec<Statement>)> = Vec::new();
        let mut is_plain = true;
        while !self.skip("}") {
            let mut values = Vec::new();
            let mut is_default = false;
            while self.peek().kind.is_name("case") || self.peek().kind.is_name("default") {
                if self.take().kind.is_name("case") {
                    values.push(self.expression()?);
                } else {
                    is_default = true;
                }
                self.need(":")?;
            }
            let mut body = Vec::new();
            while !(self.peek().kind.is_name("case")
                || self.peek().kind.is_name("default")
                || self.peek().kind.is_sign("}"))
            {
                if self.peek().kind == TokenKind::End {
                    return Err(self.unexpected());
                }
                body.extend(self.statement()?);
            }
            let is_last = self.peek().kind.is_sign("}");
            match body.last().map(|last| &last.kind) {
                Some(StatementKind::Other("break", ..)) => _ = body.pop(),
                Some(StatementKind::Return(_)) => {}
                _ => is_plain &= is_last,
            }
            is_plain &= !is_default || is_last;
            cases.push((values, is_default, body));
        }
        if !is_plain {
            let statements = cases.into_iter().flat_map(|(_, _, body)| body).collect();
            return Ok(StatementKind::Other("switch", vec![subject], statements));
        }
        let mut otherwise = Vec::new();
        for (values, is_default, body) in cases.into_iter().rev() {
            if is_default {
                otherwise = body;
                continue;
            }
            let conditions = values.into_iter().map(|value| {
                let node = Node::Binary(Operator::Equal, Box::new(subject.clone()), Box::new(value));
                Expression { node, line }
            });
            let either = |left: Expression, right: Expression| Expression {
                node: Node::Binary(Operator::Or, Box::new(left), Box::new(right)),
                line,
            };
            let Some(condition) = conditions.reduce(either) else { continue };
            otherwise = vec![Statement { kind: StatementKind::If(condition, body, otherwise), line }];
        }
        Ok(StatementKind::Block(otherwise))
    }
}

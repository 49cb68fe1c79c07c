//! Expressions, by precedence.

use super::parser::{DEEPEST, Parser};
use super::token::TokenKind;
use super::tree::{Expression, Node, Operator};
use crate::refusal::{Obstacle, Unreadable};

impl Parser {
    /// Expression with commas, of which all parts but the last one are kept as [`Node::Other`].
    pub(super) fn expression(&mut self) -> Result<Expression, Unreadable> {
        let first = self.assignment()?;
        if !self.peek().kind.is_sign(",") {
            return Ok(first);
        }
        let line = first.line;
        let mut parts = vec![first];
        while self.skip(",") {
            parts.push(self.assignment()?);
        }
        Ok(Expression { node: Node::Other(",", parts), line })
    }

    pub(super) fn assignment(&mut self) -> Result<Expression, Unreadable> {
        self.deeper(|parser| {
            let target = parser.conditional()?;
            let operator = match &parser.peek().kind {
                TokenKind::Sign("=") => None,
                TokenKind::Sign("+=") => Some(Operator::Plus),
                TokenKind::Sign("-=") => Some(Operator::Minus),
                TokenKind::Sign("*=") => Some(Operator::Times),
                TokenKind::Sign("/=") => Some(Operator::Over),
                TokenKind::Sign("%=") => Some(Operator::Remainder),
                TokenKind::Sign("**=") => Some(Operator::Power),
                TokenKind::Sign("&=" | "|=" | "^=" | "<<=" | ">>=" | ">>>=") => Some(Operator::Bits),
                _ => return Ok(target),
            };
            if !matches!(target.node, Node::Name(_) | Node::Member(..) | Node::Index(..)) {
                return Err(parser.unexpected());
            }
            parser.take();
            let value = parser.assignment()?;
            let line = target.line;
            Ok(Expression { node: Node::Assignment(Box::new(target), operator, Box::new(value)), line })
        })
    }

    fn conditional(&mut self) -> Result<Expression, Unreadable> {
        let condition = self.binary(0)?;
        if !self.skip("?") {
            return Ok(condition);
        }
        let yes = self.assignment()?;
        self.need(":")?;
        let no = self.assignment()?;
        let line = condition.line;
        Ok(Expression { node: Node::Conditional(Box::new(condition), Box::new(yes), Box::new(no)), line })
    }

    /// Operators that bind at least as strongly as `least`.
    fn binary(&mut self, least: u8) -> Result<Expression, Unreadable> {
        self.deeper(|parser| {
            let mut left = parser.unary()?;
            let mut count = 0;
            while let TokenKind::Sign(sign) = parser.peek().kind {
                let Some((operator, strength)) = binary_operator(sign) else { break };
                if strength < least {
                    break;
                }
                count += 1;
                if count > DEEPEST {
                    return Err(Unreadable::new(parser.peek().line, Obstacle::TooLong));
                }
                parser.take();
                // The power is right associative.
                let right = parser.binary(if operator == Operator::Power { strength } else { strength + 1 })?;
                let line = left.line;
                left = Expression { node: Node::Binary(operator, Box::new(left), Box::new(right)), line };
            }
            Ok(left)
        })
    }

    fn unary(&mut self) -> Result<Expression, Unreadable> {
        self.deeper(|parser| {
            let line = parser.peek().line;
            let node = match parser.peek().kind.clone() {
                TokenKind::Sign(sign @ ("-" | "+" | "!" | "~")) => {
                    parser.take();
                    let inner = Box::new(parser.unary()?);
                    let operator = match sign {
                        "-" => Operator::Minus,
                        "+" => Operator::Plus,
                        "!" => Operator::Not,
                        _ => Operator::Bits,
                    };
                    Node::Unary(operator, inner)
                }
                TokenKind::Sign(sign @ ("++" | "--")) => {
                    parser.take();
                    let target = parser.unary()?;
                    step(target, sign, line)
                }
                TokenKind::Name(word) if matches!(word.as_str(), "typeof" | "void" | "delete" | "await") => {
                    parser.take();
                    Node::Other("typeof", vec![parser.unary()?])
                }
                TokenKind::Name(word) if word == "new" => {
                    parser.take();
                    Node::Other("new", vec![parser.postfix()?])
                }
                _ => return parser.postfix(),
            };
            Ok(Expression { node, line })
        })
    }

    fn postfix(&mut self) -> Result<Expression, Unreadable> {
        let mut value = self.operand()?;
        let mut count = 0;
        loop {
            let line = value.line;
            count += 1;
            if count > DEEPEST {
                return Err(Unreadable::new(line, Obstacle::TooLong));
            }
            let token = self.peek().clone();
            let node = match token.kind {
                TokenKind::Sign(".") => {
                    self.take();
                    let TokenKind::Name(member) = self.take().kind else { return Err(self.unexpected()) };
                    Node::Member(Box::new(value), member)
                }
                TokenKind::Sign("[") => {
                    self.take();
                    let index = self.expression()?;
                    self.need("]")?;
                    Node::Index(Box::new(value), Box::new(index))
                }
                TokenKind::Sign("(") => {
                    self.take();
                    let arguments = self.list(")")?;
                    Node::Call(Box::new(value), arguments)
                }
                TokenKind::Sign(sign @ ("++" | "--")) if !token.after_line_end => {
                    self.take();
                    // Its value would be the one before the step; it is used as a statement only.
                    let stepped = Expression { node: step(value, sign, line), line };
                    return Ok(Expression { node: Node::Other("++", vec![stepped]), line });
                }
                _ => return Ok(value),
            };
            value = Expression { node, line };
        }
    }

    /// Expressions with commas up to a closing bracket.
    fn list(&mut self, end: &str) -> Result<Vec<Expression>, Unreadable> {
        let mut parts = Vec::new();
        while !self.skip(end) {
            parts.push(self.assignment()?);
            if !self.skip(",") && !self.peek().kind.is_sign(end) {
                return Err(self.unexpected());
            }
        }
        Ok(parts)
    }

    fn operand(&mut self) -> Result<Expression, Unreadable> {
        let line = self.peek().line;
        let node = match self.peek().kind.clone() {
            TokenKind::Number(text, value) => Node::Number(text, value),
            TokenKind::Text(text) => Node::Text(text),
            TokenKind::Pattern => Node::Other("/", Vec::new()),
            TokenKind::Name(name) => match name.as_str() {
                "true" => Node::Truth(true),
                "false" => Node::Truth(false),
                "undefined" | "null" => Node::Nothing,
                "function" => {
                    self.take();
                    return Ok(Expression { node: Node::Function(self.function()?), line });
                }
                "var" | "if" | "else" | "for" | "while" | "do" | "return" | "switch" | "case" | "default" => {
                    return Err(self.unexpected());
                }
                _ => Node::Name(name),
            },
            TokenKind::Sign("(") => {
                self.take();
                let inner = self.expression()?;
                self.need(")")?;
                return Ok(inner);
            }
            TokenKind::Sign("[") => {
                self.take();
                return Ok(Expression { node: Node::Array(self.list("]")?), line });
            }
            TokenKind::Sign("{") => {
                self.take();
                return self.object(line);
            }
            TokenKind::Sign(_) | TokenKind::End => return Err(self.unexpected()),
        };
        self.take();
        Ok(Expression { node, line })
    }

    fn object(&mut self, line: usize) -> Result<Expression, Unreadable> {
        let mut parts = Vec::new();
        while !self.skip("}") {
            match self.take().kind {
                TokenKind::Name(_) | TokenKind::Text(_) | TokenKind::Number(..) => {}
                _ => return Err(self.unexpected()),
            }
            self.need(":")?;
            parts.push(self.assignment()?);
            if !self.skip(",") && !self.peek().kind.is_sign("}") {
                return Err(self.unexpected());
            }
        }
        Ok(Expression { node: Node::Other("{", parts), line })
    }
}

/// `target += 1` or `target -= 1`.
fn step(target: Expression, sign: &str, line: usize) -> Node {
    let operator = if sign == "++" { Operator::Plus } else { Operator::Minus };
    let one = Expression { node: Node::Number("1".to_owned(), 1.0), line };
    Node::Assignment(Box::new(target), Some(operator), Box::new(one))
}

/// Operator and strength of a binary sign.
fn binary_operator(sign: &str) -> Option<(Operator, u8)> {
    Some(match sign {
        "||" | "??" => (Operator::Or, 1),
        "&&" => (Operator::And, 2),
        "|" => (Operator::Bits, 3),
        "^" => (Operator::Bits, 4),
        "&" => (Operator::Bits, 5),
        "==" | "===" => (Operator::Equal, 6),
        "!=" | "!==" => (Operator::Different, 6),
        "<" => (Operator::Less, 7),
        "<=" => (Operator::LessOrEqual, 7),
        ">" => (Operator::Greater, 7),
        ">=" => (Operator::GreaterOrEqual, 7),
        "<<" | ">>" | ">>>" => (Operator::Bits, 8),
        "+" => (Operator::Plus, 9),
        "-" => (Operator::Minus, 9),
        "*" => (Operator::Times, 10),
        "/" => (Operator::Over, 10),
        "%" => (Operator::Remainder, 10),
        "**" => (Operator::Power, 11),
        _ => return None,
    })
}

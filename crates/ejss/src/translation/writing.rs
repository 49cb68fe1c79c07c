//! Values as text of the document's language.

use super::value::Value;
use crate::prose::{cut, visible};
use crate::script::Operator;

/// Longest line of a statement, in characters, before it is divided.
const LONGEST_LINE: usize = 110;

/// Longest text in quotation marks, in characters.
const LONGEST_TEXT: usize = 70;

/// Strength of an operator; the weakest is 0.
const IF: u8 = 0;
const OR: u8 = 1;
const AND: u8 = 2;
const NOT: u8 = 3;
const COMPARISON: u8 = 4;
const SUM: u8 = 5;
const PRODUCT: u8 = 6;
const SIGN: u8 = 7;
const POWER: u8 = 8;

/// Text of a value. `spelling`: the name in the document for a key.
pub(super) fn written(value: &Value, spelling: &dyn Fn(&str) -> String) -> String {
    let mut text = String::new();
    Writer { text: &mut text, spelling }.value(value, IF, true);
    text
}

struct Writer<'a> {
    text: &'a mut String,
    spelling: &'a dyn Fn(&str) -> String,
}

impl Writer<'_> {
    /// Appends a value in a place that needs at least this strength. `is_first`: nothing stands before it in the parenthesis,
    /// so that a sign needs none.
    fn value(&mut self, value: &Value, least: u8, is_first: bool) {
        let strength = strength(value);
        if strength < least || strength == SIGN && !is_first {
            self.text.push('(');
            self.inside(value, true);
            self.text.push(')');
        } else {
            self.inside(value, is_first);
        }
    }

    fn inside(&mut self, value: &Value, is_first: bool) {
        match value {
            Value::Number(text, _) => self.text.push_str(text),
            Value::Text(text) => self.text.push_str(&quoted(text)),
            // Only discrete quantities and switches take these words, which the language knows there.
            Value::Truth(truth) => self.text.push_str(if *truth { "true" } else { "false" }),
            Value::Nothing => self.text.push('0'),
            Value::Name(name) | Value::Past(name) => self.name(name),
            Value::Start(name) => {
                self.name(name);
                self.text.push_str("(0)");
            }
            Value::Negative(inner) => {
                self.text.push('-');
                self.value(inner, PRODUCT, false);
            }
            Value::Not(inner) => {
                self.text.push_str("not ");
                self.value(inner, COMPARISON, true);
            }
            Value::Binary(operator, left, right) => {
                let (sign, own) = sign(*operator);
                // Sums and products are read from the left; comparisons and powers stand in no row.
                let (on_left, on_right) = match own {
                    COMPARISON | POWER => (own + 1, own + 1),
                    OR | AND => (own, own),
                    _ => (own, own + 1),
                };
                self.value(left, on_left, is_first);
                self.text.push_str(sign);
                self.value(right, on_right, own <= COMPARISON);
            }
            Value::If(condition, yes, no) => {
                self.text.push_str("if ");
                self.value(condition, OR, true);
                self.text.push_str(" then ");
                self.value(yes, OR, true);
                self.text.push_str(" else ");
                self.value(no, IF, true);
            }
            Value::Call("pi", _) => self.text.push_str("pi"),
            Value::Call(name, parts) => {
                self.text.push_str(name);
                self.list(parts);
            }
            Value::Own(name, parts) => {
                self.name(name);
                self.list(parts);
            }
            Value::Join(parts) => parts.iter().for_each(|part| self.inside(part, true)),
            Value::Decimals(inner, _) => self.inside(inner, true),
        }
    }

    fn name(&mut self, name: &str) {
        let name = (self.spelling)(name);
        self.text.push_str(&name);
    }

    fn list(&mut self, parts: &[Value]) {
        self.text.push('(');
        for (index, part) in parts.iter().enumerate() {
            if index > 0 {
                self.text.push_str(", ");
            }
            self.value(part, IF, true);
        }
        self.text.push(')');
    }
}

fn strength(value: &Value) -> u8 {
    match value {
        Value::If(..) => IF,
        Value::Not(_) => NOT,
        Value::Negative(_) => SIGN,
        Value::Binary(operator, ..) => sign(*operator).1,
        _ => POWER + 1,
    }
}

fn sign(operator: Operator) -> (&'static str, u8) {
    match operator {
        Operator::Plus => (" + ", SUM),
        Operator::Minus => (" - ", SUM),
        Operator::Times => ("*", PRODUCT),
        Operator::Over => ("/", PRODUCT),
        Operator::Power => ("^", POWER),
        Operator::Equal => (" == ", COMPARISON),
        Operator::Different => (" != ", COMPARISON),
        Operator::Less => (" < ", COMPARISON),
        Operator::LessOrEqual => (" <= ", COMPARISON),
        Operator::Greater => (" > ", COMPARISON),
        Operator::GreaterOrEqual => (" >= ", COMPARISON),
        Operator::And => (" and ", AND),
        Operator::Or => (" or ", OR),
        // These never come into a value.
        Operator::Remainder | Operator::Not | Operator::Bits => (" ? ", IF),
    }
}

/// Text in quotation marks, without what would end it.
pub(super) fn quoted(text: &str) -> String {
    let text = visible(text).replace('"', "'").replace('\\', "/").replace('`', "'");
    format!("\"{}\"", cut(text.trim(), LONGEST_TEXT))
}

/// Statement `left = right` on lines of bounded length. `behind`: unit, label and comment.
pub(super) fn statement(left: &str, right: &str, behind: &str) -> String {
    if left.len() + right.len() + behind.len() < LONGEST_LINE {
        return format!("{left} = {right}{behind}");
    }
    format!("{left} = (\n    {}\n){behind}", divided(right))
}

/// Text inside a parenthesis, with line ends behind blanks and operators, but not in a text in quotation marks.
fn divided(text: &str) -> String {
    let mut lines = String::new();
    let (mut length, mut is_text) = (0, false);
    for letter in text.chars() {
        if letter == '"' {
            is_text = !is_text;
        }
        let can_end = !is_text && length > LONGEST_LINE - 30 && matches!(letter, ' ' | '*' | '/' | ',');
        if letter != ' ' || !can_end {
            lines.push(letter);
            length += 1;
        }
        if can_end {
            lines.push_str("\n    ");
            length = 0;
        }
    }
    lines
}

//! Texts of a drawing: constant texts and values in them.

use super::super::facts::Facts;
use super::super::run::{Phase, Run};
use super::super::value::{Kind, Value};
use super::super::writing::written;
use super::item::in_text;
use crate::place::{Place, Section};
use crate::prose::plain_text;
use crate::refusal::Obstacle;
use crate::script::parse_expression;

/// Texts and values of an expression such as `"x = " + _view._format(x, "0.00")`.
pub(super) fn parts(facts: &Facts, source: &str) -> Result<Vec<Value>, Obstacle> {
    let expression = parse_expression(source).map_err(|unreadable| unreadable.obstacle)?;
    let mut run = Run::new(facts, Phase::Function, Place::new(Section::View, ""));
    let value = run.value(&expression).map_err(|reason| reason.obstacle)?;
    match (run.kind(&value), value) {
        (_, Value::Join(parts)) => Ok(parts),
        (Some(Kind::Number | Kind::Text), value) => Ok(vec![value]),
        _ => Err(Obstacle::Kinds),
    }
}

/// Content of an element with these parts.
pub(super) fn content(parts: &[Value], spelling: &dyn Fn(&str) -> String) -> String {
    let mut content = String::new();
    for part in parts {
        match part {
            Value::Text(text) => content.push_str(&in_text(&keep_blanks(text))),
            Value::Decimals(value, decimals) => {
                content.push_str(&format!("{{{}:.{decimals}}}", written(value, spelling)))
            }
            value => content.push_str(&format!("{{{}}}", written(value, spelling))),
        }
    }
    content
}

/// Text without markup; blanks at its ends separate it from a value.
fn keep_blanks(text: &str) -> String {
    let blank = |is_there: bool| if is_there { " " } else { "" };
    format!("{}{}{}", blank(text.starts_with(' ')), plain_text(text), blank(text.trim() != "" && text.ends_with(' ')))
}

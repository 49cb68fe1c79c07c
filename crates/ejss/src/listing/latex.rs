//! Expressions of JavaScript as formulas.

use crate::script::{Expression, Node, Operator};
use units::alphabet::{greek_letter, greek_name};

/// LaTeX of an expression; `None` where it has no usual notation.
pub(super) fn formula(expression: &Expression) -> Option<String> {
    Some(match &expression.node {
        Node::Number(text, _) => text.clone(),
        Node::Name(own) => name(own),
        Node::Unary(Operator::Minus, inner) => format!("-{}", factor(inner)?),
        Node::Unary(Operator::Plus, inner) => formula(inner)?,
        Node::Binary(Operator::Over, left, right) => format!("\\frac{{{}}}{{{}}}", formula(left)?, formula(right)?),
        Node::Binary(operator, left, right) => {
            let sign = match operator {
                // A sign in front of a product needs no parentheses.
                Operator::Times if matches!(left.node, Node::Unary(Operator::Minus, _)) => {
                    return Some(format!("{}\\,{}", formula(left)?, factor(right)?));
                }
                Operator::Plus => return Some(format!("{}+{}", formula(left)?, term(right)?)),
                Operator::Minus => return Some(format!("{}-{}", formula(left)?, term(right)?)),
                Operator::Times => return Some(format!("{}\\,{}", factor(left)?, factor(right)?)),
                Operator::Less => "<",
                Operator::LessOrEqual => "\\le ",
                Operator::Greater => ">",
                Operator::GreaterOrEqual => "\\ge ",
                Operator::Equal => "=",
                Operator::Different => "\\ne ",
                _ => return None,
            };
            format!("{}{sign}{}", formula(left)?, formula(right)?)
        }
        Node::Assignment(target, None, value) => format!("{}={}", formula(target)?, formula(value)?),
        Node::Index(object, index) => format!("{{{}}}_{{{}}}", formula(object)?, formula(index)?),
        Node::Call(callee, arguments) => call(callee, arguments)?,
        Node::Member(object, member) if object.name() == Some("Math") && member == "PI" => "\\pi ".to_owned(),
        _ => return None,
    })
}

fn call(callee: &Expression, arguments: &[Expression]) -> Option<String> {
    let all: Option<Vec<String>> = arguments.iter().map(formula).collect();
    let all = all?;
    if let Node::Member(object, function) = &callee.node {
        object.name().filter(|name| *name == "Math")?;
        let first = all.first()?;
        return Some(match function.as_str() {
            "sqrt" => format!("\\sqrt{{{first}}}"),
            "abs" => format!("\\left|{first}\\right|"),
            "exp" => format!("e^{{{first}}}"),
            "pow" => format!("{{{}}}^{{{}}}", factor(arguments.first()?)?, all.get(1)?),
            "log" => format!("\\ln\\left({first}\\right)"),
            "sin" | "cos" | "tan" => format!("\\{function}\\left({first}\\right)"),
            _ => format!("\\mathrm{{{}}}\\left({}\\right)", plain(function)?, all.join(", ")),
        });
    }
    Some(format!("{}\\left({}\\right)", name(callee.name()?), all.join(", ")))
}

/// A sum on the right of a sign stands in parentheses.
fn term(expression: &Expression) -> Option<String> {
    let inner = formula(expression)?;
    let needs = matches!(
        &expression.node,
        Node::Binary(Operator::Plus | Operator::Minus, ..) | Node::Unary(..) | Node::Assignment(..)
    );
    Some(if needs { format!("\\left({inner}\\right)") } else { inner })
}

fn factor(expression: &Expression) -> Option<String> {
    match &expression.node {
        Node::Binary(Operator::Times | Operator::Over, ..) => formula(expression),
        Node::Binary(..) => Some(format!("\\left({}\\right)", formula(expression)?)),
        _ => term(expression),
    }
}

/// LaTeX of a name: `omega0` is an omega with index 0.
pub(super) fn name(name: &str) -> String {
    let ascii: String =
        name.chars().map(|letter| greek_name(letter).map_or_else(|| letter.to_string(), str::to_owned)).collect();
    let letters: String = ascii.chars().filter(|letter| letter.is_alphanumeric() || *letter == '_').collect();
    let at = letters.find(|letter: char| letter == '_' || letter.is_ascii_digit()).unwrap_or(letters.len());
    let (base, index) = letters.split_at(at);
    let base = match base {
        "" => return format!("\\mathrm{{{}}}", plain(&letters).unwrap_or_default()),
        base if greek_letter(base).is_some()
            && base.chars().next().is_some_and(char::is_lowercase)
            && base != "omicron" =>
        {
            format!("\\{base} ")
        }
        base if base.chars().count() == 1 => base.to_owned(),
        base => format!("\\mathrm{{{base}}}"),
    };
    let index: String = index.chars().filter(|letter| *letter != '_').collect();
    if index.is_empty() { base } else { format!("{{{base}}}_{{\\mathrm{{{index}}}}}") }
}

fn plain(name: &str) -> Option<String> {
    let letters: String = name.chars().filter(char::is_ascii_alphanumeric).collect();
    (!letters.is_empty()).then_some(letters)
}

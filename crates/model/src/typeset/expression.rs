//! Expressions as MathML: fractions, powers, roots and products without a sign, with as few parentheses as possible.

use crate::vectors::Vectors;
use crate::{BinaryOperator, Expression, ExpressionKind, Name, UnaryOperator};
use program::functions::Function;
use units::markup::escaped;
use units::mathml::{has_power_of_ten, is_word, name, number, unit_after_number};

/// Binding strength of the outermost operation of an expression.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
pub(super) enum Level {
    Branches,
    Or,
    And,
    Not,
    Comparison,
    Sum,
    Product,
    Operand,
}

/// Writes expressions as MathML. Text values are translated.
pub(super) struct Typesetter<'a> {
    pub(super) translate: &'a dyn Fn(&str) -> String,
    /// Vectors of the model.
    pub(super) vectors: &'a Vectors,
}

/// Position of an expression: in exponents, fractions are written with a slash.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Place {
    Line,
    Exponent,
}

pub(super) fn level(expression: &Expression, place: Place) -> Level {
    use BinaryOperator::{Add, And, Divide, Multiply, Or, Power, Subtract};
    match &expression.kind {
        ExpressionKind::If(..) => Level::Branches,
        ExpressionKind::Reduction { function, .. } if function.text == "sum" => Level::Sum,
        ExpressionKind::Unary(UnaryOperator::Not, _) => Level::Not,
        ExpressionKind::Unary(UnaryOperator::Negate, _) => Level::Sum,
        ExpressionKind::Binary(Or, ..) => Level::Or,
        ExpressionKind::Binary(And, ..) => Level::And,
        ExpressionKind::Binary(Add | Subtract, ..) => Level::Sum,
        ExpressionKind::Binary(Multiply | Divide, ..) if leading_minus(expression) => Level::Sum,
        ExpressionKind::Binary(Multiply, ..) => Level::Product,
        ExpressionKind::Binary(Divide, ..) if place == Place::Exponent => Level::Product,
        ExpressionKind::Binary(Divide | Power, ..) => Level::Operand,
        ExpressionKind::Binary(..) => Level::Comparison,
        ExpressionKind::Number { value, .. } if *value < 0.0 => Level::Sum,
        ExpressionKind::Number { unit: Some(unit), .. } if !unit.text.is_empty() => Level::Product,
        ExpressionKind::Number { value, .. } if has_power_of_ten(*value) => Level::Product,
        _ => Level::Operand,
    }
}

/// True if a product or quotient begins with a minus sign.
fn leading_minus(expression: &Expression) -> bool {
    match &expression.kind {
        ExpressionKind::Unary(UnaryOperator::Negate, _) => true,
        ExpressionKind::Binary(BinaryOperator::Multiply | BinaryOperator::Divide, left, _) => leading_minus(left),
        ExpressionKind::Number { value, .. } => *value < 0.0,
        _ => false,
    }
}

/// A factor of a product.
enum Factor<'a> {
    Plain(&'a Expression),
    /// Factors of the numerator and of the denominator.
    Quotient(Vec<Factor<'a>>, Vec<&'a Expression>),
}

/// Factors of a product or quotient from left to right, without the minus sign before the first; the flag is true if there
/// was one. `a/b/c` is one quotient.
fn factors(expression: &Expression) -> (bool, Vec<Factor<'_>>) {
    match &expression.kind {
        ExpressionKind::Binary(BinaryOperator::Multiply, left, right) => {
            let (negative, mut all) = factors(left);
            match factors(right) {
                (false, more) => all.extend(more),
                (true, _) => all.push(Factor::Plain(right)),
            }
            (negative, all)
        }
        ExpressionKind::Binary(BinaryOperator::Divide, above, below) => {
            let (negative, mut above) = factors(above);
            if let [Factor::Quotient(_, before)] = above.as_mut_slice() {
                before.push(below);
                return (negative, above);
            }
            (negative, vec![Factor::Quotient(above, vec![below])])
        }
        ExpressionKind::Unary(UnaryOperator::Negate, operand) => match factors(operand) {
            (false, all) => (true, all),
            (true, _) => (true, vec![Factor::Plain(operand)]),
        },
        _ => (false, vec![Factor::Plain(expression)]),
    }
}

impl Typesetter<'_> {
    /// An expression as one MathML element.
    pub(super) fn expression(&self, expression: &Expression) -> String {
        self.set(expression, Place::Line)
    }

    /// The expression, in parentheses if it is a sum.
    pub(super) fn term(&self, expression: &Expression) -> String {
        self.at_least(expression, Level::Product, Place::Line)
    }

    fn set(&self, expression: &Expression, place: Place) -> String {
        match &expression.kind {
            ExpressionKind::Number { value, unit: None } => number(*value),
            ExpressionKind::Number { value, unit: Some(unit) } => {
                format!("<mrow>{}{}</mrow>", number(*value), unit_after_number(unit))
            }
            ExpressionKind::Text(text) => format!("<mtext>{}</mtext>", escaped(&(self.translate)(text))),
            ExpressionKind::Name { name, order } => self.name(name, *order, None),
            ExpressionKind::InitialValue { name, order } => at_start_of_run(&self.name(name, *order, None)),
            ExpressionKind::Member { name, indices, order, at_start } => {
                let member = self.indexed(name, &self.indices(indices), *order, None);
                if *at_start { at_start_of_run(&member) } else { member }
            }
            ExpressionKind::Reduction { function, body, over } => self.reduction(function, body, over),
            ExpressionKind::Tuple { parts, unit } => self.tuple(parts, unit.as_ref()),
            ExpressionKind::Component { of, axis } => self.component_of(of, *axis, None),
            ExpressionKind::Unary(UnaryOperator::Not, operand) => {
                format!("<mrow><mo>¬</mo>{}</mrow>", self.at_least(operand, Level::Operand, place))
            }
            ExpressionKind::Binary(BinaryOperator::Power, base, exponent) => self.power(base, exponent, place),
            ExpressionKind::Unary(UnaryOperator::Negate, _)
            | ExpressionKind::Binary(BinaryOperator::Multiply | BinaryOperator::Divide, ..) => {
                let (negative, factors) = factors(expression);
                let product = self.product(&factors, place);
                if negative { format!("<mrow><mo>−</mo>{product}</mrow>") } else { product }
            }
            ExpressionKind::Binary(operator, left, right) => self.infix(*operator, left, right, place),
            ExpressionKind::Call { function, arguments } if self.vectors.is_operation(&function.text) => {
                self.operation(function, arguments)
            }
            ExpressionKind::Call { function, arguments } => self.function(function, arguments, None, true),
            ExpressionKind::If(condition, yes, no) => self.branches(condition, yes, no),
            ExpressionKind::Expansion(expansion) => self.set(&expansion.body, place),
            ExpressionKind::Error => "<mtext>?</mtext>".to_owned(),
        }
    }

    /// The expression, in parentheses if it binds less tightly than `least`.
    pub(super) fn at_least(&self, expression: &Expression, least: Level, place: Place) -> String {
        let inside = self.set(expression, place);
        if self.level(expression, place) < least { parenthesised(&inside) } else { inside }
    }

    fn infix(&self, operator: BinaryOperator, left: &Expression, right: &Expression, place: Place) -> String {
        let (sign, own, right_least) = match operator {
            BinaryOperator::Or => ("∨", Level::Or, Level::Or),
            BinaryOperator::And => ("∧", Level::And, Level::And),
            BinaryOperator::Add => ("+", Level::Sum, Level::Sum),
            BinaryOperator::Subtract => ("−", Level::Sum, Level::Product),
            BinaryOperator::Less => ("&lt;", Level::Sum, Level::Sum),
            BinaryOperator::LessOrEqual => ("≤", Level::Sum, Level::Sum),
            BinaryOperator::Greater => ("&gt;", Level::Sum, Level::Sum),
            BinaryOperator::GreaterOrEqual => ("≥", Level::Sum, Level::Sum),
            BinaryOperator::NotEqual => ("≠", Level::Sum, Level::Sum),
            _ => ("=", Level::Sum, Level::Sum),
        };
        // `a + -b` needs parentheses, and so does `a - -b`; `a < -b` does not.
        let after_sign = matches!(operator, BinaryOperator::Add | BinaryOperator::Subtract);
        let right_least = if after_sign && leading_minus(right) { Level::Operand } else { right_least };
        let left = self.at_least(left, own, place);
        let right = self.at_least(right, right_least, place);
        format!("<mrow>{left}<mo>{sign}</mo>{right}</mrow>")
    }

    fn product(&self, factors: &[Factor<'_>], place: Place) -> String {
        match factors {
            [Factor::Plain(only)] => return self.at_least(only, Level::Product, place),
            [Factor::Quotient(above, below)] => return self.quotient(above, below, place),
            _ => {}
        }
        let mut row = String::from("<mrow>");
        let mut before = None;
        for (index, factor) in factors.iter().enumerate() {
            if let Some(before) = before {
                row += separator(before, factor);
            }
            before = Some(factor);
            let last = index + 1 == factors.len();
            row += &match factor {
                Factor::Quotient(above, below) => {
                    let quotient = self.quotient(above, below, place);
                    if place == Place::Exponent { parenthesised(&quotient) } else { quotient }
                }
                Factor::Plain(factor) => match &factor.kind {
                    // Otherwise the next factor would seem to belong to the argument: sin(x) y instead of sin x y.
                    ExpressionKind::Call { function, arguments }
                        if !last && !self.vectors.is_operation(&function.text) =>
                    {
                        self.function(function, arguments, None, false)
                    }
                    // A number with a unit is itself a product, but needs no parentheses.
                    ExpressionKind::Number { value, .. } if *value >= 0.0 => self.set(factor, place),
                    _ => self.at_least(factor, Level::Operand, place),
                },
            };
        }
        row + "</mrow>"
    }

    /// A fraction; in exponents with a slash.
    fn quotient(&self, above: &[Factor<'_>], below: &[&Expression], place: Place) -> String {
        let below_factors: Vec<Factor<'_>> = below.iter().map(|factor| Factor::Plain(factor)).collect();
        if place == Place::Line {
            let alone = |factors: &[Factor<'_>]| match factors {
                // A sum needs no parentheses in a numerator or denominator.
                [Factor::Plain(only)] => self.set(only, place),
                several => self.product(several, place),
            };
            return format!("<mfrac>{}{}</mfrac>", alone(above), alone(&below_factors));
        }
        let above = self.product(above, place);
        let below = match below {
            [only] => self.at_least(only, Level::Operand, place),
            _ => parenthesised(&self.product(&below_factors, place)),
        };
        format!("<mrow>{above}<mo lspace=\"0\" rspace=\"0\">/</mo>{below}</mrow>")
    }

    fn power(&self, base: &Expression, exponent: &Expression, place: Place) -> String {
        let above = self.set(exponent, Place::Exponent);
        match &base.kind {
            ExpressionKind::Name { name, order } => self.name(name, *order, Some(above)),
            ExpressionKind::Member { name, indices, order, at_start: false } => {
                self.indexed(name, &self.indices(indices), *order, Some(above))
            }
            ExpressionKind::Component { of, axis } => self.component_of(of, *axis, Some(above)),
            ExpressionKind::Call { function, arguments } if self.vectors.is_operation(&function.text) => {
                format!("<msup>{}{above}</msup>", self.operation_as_base(function, arguments))
            }
            // sin²(x) is usual notation; sin⁻¹ would be read as the inverse function.
            ExpressionKind::Call { function, arguments } if is_classical(function) && is_positive_number(exponent) => {
                self.function(function, arguments, Some(&above), false)
            }
            ExpressionKind::Call { function, arguments } if has_own_brackets(function, arguments) => {
                format!("<msup>{}{above}</msup>", self.function(function, arguments, None, true))
            }
            ExpressionKind::Number { value, unit: None } if *value >= 0.0 && !has_power_of_ten(*value) => {
                format!("<msup>{}{above}</msup>", number(*value))
            }
            _ => format!("<msup>{}{above}</msup>", parenthesised(&self.set(base, place))),
        }
    }

    /// Left side of a user-defined function: its name and arguments.
    pub(super) fn declared(&self, function: &Name, parameters: &[Name]) -> String {
        let parameters: Vec<String> = parameters.iter().map(|parameter| name(&parameter.text, 0, None)).collect();
        let inside = parenthesised(&format!("<mrow>{}</mrow>", parameters.join("<mo>,</mo>")));
        format!("<mrow>{}<mo>&#x2061;</mo>{inside}</mrow>", name(&function.text, 0, None))
    }

    /// A function call. If `bare`, the parentheses around a single name may be left out: cos φ.
    fn function(&self, function: &Name, arguments: &[Expression], exponent: Option<&str>, bare: bool) -> String {
        if let ([argument], None) = (arguments, exponent) {
            let inside = || self.set(argument, Place::Line);
            match function.text.as_str() {
                "sqrt" => return format!("<msqrt>{}</msqrt>", inside()),
                "cbrt" => return format!("<mroot>{}<mn>3</mn></mroot>", inside()),
                "abs" => return fenced("|", &inside(), "|"),
                "floor" => return fenced("⌊", &inside(), "⌋"),
                "ceil" => return fenced("⌈", &inside(), "⌉"),
                "exp" => {
                    let above = self.set(argument, Place::Exponent);
                    return format!("<msup><mi mathvariant=\"normal\">e</mi>{above}</msup>");
                }
                _ => {}
            }
        }
        let mut sign = function_sign(&function.text);
        if let Some(exponent) = exponent {
            sign = format!("<msup>{sign}{exponent}</msup>");
        }
        let inside = match arguments {
            [argument] => {
                let inside = self.set(argument, Place::Line);
                let is_short = matches!(argument.kind, ExpressionKind::Name { order: 0, .. });
                if bare && is_short && is_classical(function) {
                    return format!("<mrow>{sign}<mo>&#x2061;</mo><mspace width=\"0.1667em\"/>{inside}</mrow>");
                }
                inside
            }
            several => {
                let several: Vec<String> = several.iter().map(|argument| self.expression(argument)).collect();
                format!("<mrow>{}</mrow>", several.join("<mo>,</mo>"))
            }
        };
        format!("<mrow>{sign}<mo>&#x2061;</mo>{}</mrow>", parenthesised(&inside))
    }
}

/// The initial value of a name: `name(0)`.
pub(super) fn at_start_of_run(name: &str) -> String {
    format!("<mrow>{name}<mo>&#x2061;</mo>{}</mrow>", parenthesised("<mn>0</mn>"))
}

pub(super) fn parenthesised(inside: &str) -> String {
    fenced("(", inside, ")")
}

/// `inside` between two brackets, which stretch only around tall content, because fonts add space around stretched
/// brackets.
pub(super) fn fenced(open: &str, inside: &str, close: &str) -> String {
    let grows = ["<mfrac", "<mtable", "<mroot"].iter().any(|high| inside.contains(high));
    let stretchy = if grows { "" } else { " stretchy=\"false\"" };
    format!("<mrow><mo form=\"prefix\"{stretchy}>{open}</mo>{inside}<mo form=\"postfix\"{stretchy}>{close}</mo></mrow>")
}

/// Separator between two factors: invisible between letters, a space beside words and functions, a dot before numbers and
/// after units.
fn separator(before: &Factor<'_>, after: &Factor<'_>) -> &'static str {
    if starts_with_number(after) || ends_with_unit(before) {
        "<mo>⋅</mo>"
    } else if is_wide(before) || is_wide(after) {
        "<mo>&#x2062;</mo><mspace width=\"0.1667em\"/>"
    } else {
        "<mo>&#x2062;</mo>"
    }
}

fn starts_with_number(factor: &Factor<'_>) -> bool {
    let Factor::Plain(expression) = factor else {
        return false;
    };
    match &expression.kind {
        ExpressionKind::Number { .. } => true,
        ExpressionKind::Binary(BinaryOperator::Power, base, _) => matches!(base.kind, ExpressionKind::Number { .. }),
        _ => false,
    }
}

fn ends_with_unit(factor: &Factor<'_>) -> bool {
    let Factor::Plain(expression) = factor else {
        return false;
    };
    matches!(&expression.kind, ExpressionKind::Number { unit: Some(unit), .. } if !unit.text.is_empty())
}

/// True if a factor would run into its neighbour: words, functions and fractions.
fn is_wide(factor: &Factor<'_>) -> bool {
    let Factor::Plain(expression) = factor else {
        return true;
    };
    let base = match &expression.kind {
        ExpressionKind::Binary(BinaryOperator::Power, base, _) => base,
        _ => *expression,
    };
    match &base.kind {
        ExpressionKind::Name { name, .. }
        | ExpressionKind::InitialValue { name, .. }
        | ExpressionKind::Member { name, .. } => is_word(name),
        ExpressionKind::Call { function, .. } => !matches!(function.text.as_str(), "sqrt" | "exp" | "abs"),
        _ => false,
    }
}

/// Functions whose sign can be followed by a bare argument and can carry an exponent: cos φ, sin²(x).
fn is_classical(function: &Name) -> bool {
    matches!(function.text.as_str(), "sin" | "cos" | "tan" | "sinh" | "cosh" | "tanh" | "ln" | "log10")
}

fn is_positive_number(exponent: &Expression) -> bool {
    matches!(exponent.kind, ExpressionKind::Number { value, unit: None } if value > 0.0)
}

/// True for calls with brackets of their own, which an exponent may follow directly.
fn has_own_brackets(function: &Name, arguments: &[Expression]) -> bool {
    arguments.len() == 1 && matches!(function.text.as_str(), "abs" | "floor" | "ceil")
}

/// Printed name of a function.
pub(super) fn function_sign(function: &str) -> String {
    let printed = match function {
        "asin" => "arcsin",
        "acos" => "arccos",
        "atan" => "arctan",
        "asinh" => "arsinh",
        "acosh" => "arcosh",
        "atanh" => "artanh",
        "sign" => "sgn",
        "log10" => return "<msub><mi>log</mi><mn>10</mn></msub>".to_owned(),
        // A user-defined function.
        other if Function::named(other).is_none() => return name(other, 0, None),
        other => other,
    };
    if printed.chars().count() == 1 {
        return format!("<mi mathvariant=\"normal\">{}</mi>", escaped(printed));
    }
    format!("<mi>{}</mi>", escaped(printed))
}

//! `if` in textbook notation: cases after a brace.

use super::expression::Typesetter;
use crate::{BinaryOperator, Expression, ExpressionKind};

impl Typesetter<'_> {
    /// Cases after a brace. The last case shows its condition if that is one of the remaining relations less, equal or
    /// greater.
    pub(super) fn branches(&self, condition: &Expression, yes: &Expression, no: &Expression) -> String {
        let mut rows = vec![(self.expression(yes), Some(self.expression(condition)))];
        let mut left_over = Remaining::after(condition);
        let mut rest = no;
        while let ExpressionKind::If(condition, yes, no) = &rest.kind {
            rows.push((self.expression(yes), Some(self.expression(condition))));
            left_over = left_over.and_then(|remaining| remaining.without(condition));
            rest = no;
        }
        let last = left_over.and_then(|remaining| {
            let sign = remaining.sign()?;
            let (left, right) = (self.expression(remaining.left), self.expression(remaining.right));
            Some(format!("<mrow>{left}<mo>{sign}</mo>{right}</mrow>"))
        });
        rows.push((self.expression(rest), last));
        let mut table = String::new();
        for (value, condition) in rows {
            let condition = condition.unwrap_or_default();
            table += &format!(
                "<mtr><mtd style=\"text-align:left\">{value}</mtd><mtd style=\"text-align:left\">{condition}</mtd></mtr>"
            );
        }
        format!("<mrow><mo fence=\"true\" form=\"prefix\">{{</mo><mtable>{table}</mtable></mrow>")
    }
}

/// Relations between two expressions (less, equal, greater) that no condition has covered yet.
struct Remaining<'a> {
    left: &'a Expression,
    right: &'a Expression,
    /// True if not yet covered: less, equal, greater.
    relations: [bool; 3],
}

impl<'a> Remaining<'a> {
    fn after(condition: &'a Expression) -> Option<Self> {
        let ExpressionKind::Binary(_, left, right) = &condition.kind else {
            return None;
        };
        Self { left, right, relations: [true; 3] }.without(condition)
    }

    fn without(mut self, condition: &Expression) -> Option<Self> {
        let ExpressionKind::Binary(operator, left, right) = &condition.kind else {
            return None;
        };
        let asked = match operator {
            BinaryOperator::Less => [true, false, false],
            BinaryOperator::LessOrEqual => [true, true, false],
            BinaryOperator::Equal => [false, true, false],
            BinaryOperator::GreaterOrEqual => [false, true, true],
            BinaryOperator::Greater => [false, false, true],
            BinaryOperator::NotEqual => [true, false, true],
            _ => return None,
        };
        if !same(self.left, left) || !same(self.right, right) {
            return None;
        }
        for (remains, asked) in self.relations.iter_mut().zip(asked) {
            *remains &= !asked;
        }
        Some(self)
    }

    fn sign(&self) -> Option<&'static str> {
        Some(match self.relations {
            [true, false, false] => "&lt;",
            [true, true, false] => "≤",
            [false, true, false] => "=",
            [false, true, true] => "≥",
            [false, false, true] => "&gt;",
            [true, false, true] => "≠",
            _ => return None,
        })
    }
}

/// True if two expressions are equal apart from their places.
fn same(one: &Expression, other: &Expression) -> bool {
    match (&one.kind, &other.kind) {
        (ExpressionKind::Unary(a, x), ExpressionKind::Unary(b, y)) => a == b && same(x, y),
        (ExpressionKind::Binary(a, x, v), ExpressionKind::Binary(b, y, w)) => a == b && same(x, y) && same(v, w),
        (ExpressionKind::Call { function: a, arguments: x }, ExpressionKind::Call { function: b, arguments: y }) => {
            a.text == b.text && x.len() == y.len() && x.iter().zip(y).all(|(x, y)| same(x, y))
        }
        (ExpressionKind::If(..), _) => false,
        (a, b) => a == b,
    }
}

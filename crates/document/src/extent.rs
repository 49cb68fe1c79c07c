//! How large an expression is, in one pass over it.

use model::{Expression, ExpressionKind};

/// How large an expression is.
#[derive(Default)]
pub struct Extent {
    /// How many expressions it consists of, itself included.
    pub nodes: usize,
    /// How many levels it has.
    pub depth: usize,
    /// Whether something in it could not be read.
    pub has_gap: bool,
}

impl Extent {
    /// That of an expression.
    pub fn of(expression: &Expression) -> Self {
        let mut extent = Self::default();
        extent.add(expression, 1);
        extent
    }

    /// Counts what stands at this level and below.
    fn add(&mut self, expression: &Expression, level: usize) {
        self.nodes += 1;
        self.depth = self.depth.max(level);
        self.has_gap |= matches!(expression.kind, ExpressionKind::Error);
        expression.for_each_operand(|operand| self.add(operand, level + 1));
    }
}

//! Size of an expression, determined in one pass.

use model::{Expression, ExpressionKind};

/// Size of an expression.
#[derive(Default)]
pub struct Extent {
    /// Number of nodes, including the root.
    pub nodes: usize,
    /// Height of the tree.
    pub depth: usize,
    /// True if part of it could not be parsed.
    pub has_gap: bool,
}

impl Extent {
    /// Measures an expression.
    pub fn of(expression: &Expression) -> Self {
        let mut extent = Self::default();
        extent.add(expression, 1);
        extent
    }

    /// Adds an expression at level `level` and all below it.
    fn add(&mut self, expression: &Expression, level: usize) {
        self.nodes += 1;
        self.depth = self.depth.max(level);
        self.has_gap |= matches!(expression.kind, ExpressionKind::Error);
        expression.for_each_operand(|operand| self.add(operand, level + 1));
    }
}

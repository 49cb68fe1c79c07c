//! Models made of arbitrary bytes, for tests and fuzzing.

/// Text of a model. Each byte decides one thing about it; where they end, zeros follow.
pub fn text(bytes: &[u8]) -> String {
    let mut bytes = Bytes(bytes);
    let mut text = "independent s
parameter p = 0.7 in -5..5
table line(s) { 0 0.3  1 2  2.5 -1  4 0.5 }
smooth table curve(x) { -3 -2  -1 -0.4  0 0.1  1 0.4  3 2 }
"
    .to_owned();
    let rates = 1 + bytes.next(3);
    text += &format!("x'' = {}\n", bytes.expression(5));
    for rate in 0..rates {
        text += &format!("{}' = {}\n", ["a", "b", "c"][rate], bytes.expression(4));
    }
    // Not all of them are read.
    for unread in rates..3 {
        text += &format!("{}' = 0\n", ["a", "b", "c"][unread]);
    }
    text += &format!("x(0) = {}\nx'(0) = {}\n", bytes.number(), bytes.number());
    text += &format!("a(0) = {}\nb(0) = {}\nc(0) = {}\n", bytes.number(), bytes.number(), bytes.number());
    match bytes.next(4) {
        0 => text += "when x > 1 { x' = -0.8*x' }\n",
        1 => text += "every 0.2 { a = a + p }\n",
        _ => {}
    }
    text
}

/// Bytes that are left.
struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    /// A number below `end`.
    fn next(&mut self, end: usize) -> usize {
        let Some((&first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        first as usize % end
    }

    /// A literal.
    fn number(&mut self) -> &'static str {
        ["0", "1", "-1", "0.5", "2.25", "-3.75", "1e-300", "1e200", "0.1"][self.next(9)]
    }

    /// An expression of at most this depth.
    fn expression(&mut self, depth: usize) -> String {
        const ONE: [&str; 25] = [
            "-", "abs", "sign", "sqrt", "cbrt", "exp", "ln", "log10", "sin", "cos", "tan", "asin", "acos", "atan",
            "sinh", "cosh", "tanh", "asinh", "acosh", "atanh", "floor", "ceil", "round", "line", "curve",
        ];
        const TWO: [&str; 6] = ["+", "-", "*", "/", "^", "+"];
        const CALLS: [&str; 4] = ["atan2", "min", "max", "mod"];
        const COMPARISONS: [&str; 6] = ["<", "<=", ">", ">=", "=", "!="];
        if depth == 0 {
            return match self.next(8) {
                0 => self.number().to_owned(),
                leaf => ["x", "x'", "a", "b", "c", "s", "p"][leaf - 1].to_owned(),
            };
        }
        match self.next(10) {
            0 => self.expression(0),
            1 | 2 => format!("{}({})", ONE[self.next(ONE.len())], self.expression(depth - 1)),
            3 => format!(
                "{}({}, {})",
                CALLS[self.next(CALLS.len())],
                self.expression(depth - 1),
                self.expression(depth - 1)
            ),
            4 => format!(
                "(if {} {} {} then {} else {})",
                self.expression(depth - 1),
                COMPARISONS[self.next(COMPARISONS.len())],
                self.expression(depth - 1),
                self.expression(depth - 1),
                self.expression(depth - 1)
            ),
            _ => {
                let left = self.expression(depth - 1);
                format!("({left} {} {})", TWO[self.next(TWO.len())], self.expression(depth - 1))
            }
        }
    }
}

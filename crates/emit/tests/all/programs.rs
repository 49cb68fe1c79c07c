//! Models made of arbitrary bytes, for tests and fuzzing.

use units::split_mix::SplitMix64;

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
    // Most programs stay finite for many steps, with and without switches.
    let wildness = bytes.next(5);
    let tame = wildness > 0;
    let bounded = |rate: String, damping: &str| match wildness {
        0 => rate,
        1 | 2 => format!("{damping} + (if abs({rate}) < 100 then 0.5*sin({rate}) else 0.2)"),
        _ => format!("{damping} + 0.5*sin({rate})"),
    };
    text += &format!("x'' = {}\n", bounded(bytes.expression(if tame { 3 } else { 5 }), "-2*x - 0.2*x'"));
    for name in &["a", "b", "c"][..rates] {
        let rate = bytes.expression(if tame { 3 } else { 4 });
        text += &format!("{name}' = {}\n", bounded(rate, &format!("-0.7*{name}")));
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
        2 => text += &format!("when {} > {} {{ b = b - 0.5 }}\n", bytes.expression(3), bytes.expression(2)),
        _ => {}
    }
    match bytes.next(4) {
        0 => text += "top = maximum(x)\nwhen x < 0.5*top { c = c + 1 }\n",
        1 => text += &format!("when {} < {} {{ a = -a }}\n", bytes.expression(2), bytes.number()),
        2 => text += "when s > 0.35 { x' = x' + p }\n",
        _ => {}
    }
    if bytes.next(3) == 0 {
        let (count, force) = (9 + bytes.next(8), bytes.expression(2));
        text += &format!("size N = {count}\nu[0] = 0\nu[N+1] = 0\n");
        text += &format!("u[i]'' = p*(u[i-1] - 2*u[i] + u[i+1]) - 0.3*u[i]' + 0.1*sin({force} + u[i])");
        if bytes.next(2) == 0 {
            text += " + sum(0.1*tanh(u[j] - u[i]) for j in i+1..N)";
        }
        text += " for i in 1..N\nu[i](0) = 0.1*i for i in 1..N\nu[i]'(0) = 0 for i in 1..N\n";
    }
    text
}

/// Text of the model of a seed.
pub fn of_seed(seed: u64) -> String {
    let mut random = SplitMix64::new(seed);
    let bytes: Vec<u8> = std::iter::repeat_with(|| random.bits() as u8).take(200).collect();
    text(&bytes)
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
        let number = self.next(11);
        ["0", "1", "-1", "0.5", "2.25", "-3.75", "0.1", "-0.3", "1.7", "1e-300", "1e200"][number]
    }

    /// An expression of at most this depth.
    fn expression(&mut self, depth: usize) -> String {
        const ONE: [&str; 25] = [
            "-", "abs", "sign", "sqrt", "cbrt", "exp", "ln", "log10", "sin", "cos", "tan", "asin", "acos", "atan",
            "sinh", "cosh", "tanh", "asinh", "acosh", "atanh", "floor", "ceil", "round", "line", "curve",
        ];
        const TWO: [&str; 6] = ["+", "-", "*", "/", "^", "+"];
        const CALLS: [&str; 4] = ["atan2", "min", "max", "mod"];
        const COMPARISONS: [&str; 6] = ["<", "<=", ">", ">=", "==", "!="];
        if depth == 0 {
            return match self.next(8) {
                0 => self.number().to_owned(),
                leaf => ["x", "x'", "a", "b", "c", "s", "p"][leaf - 1].to_owned(),
            };
        }
        match self.next(10) {
            0 => self.expression(0),
            // Always finite.
            9 => format!("sin({})", self.expression(0)),
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

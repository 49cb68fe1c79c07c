//! Distances in the source text: a number with a unit, alone or added to an expression.

use units::Unit;

/// Unit and step of graphical edits at a place of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Measure {
    /// Unit of lengths, without brackets; empty for pure numbers and for units of the drawing.
    pub unit: String,
    /// Step of the grid to which moved values are rounded (SI); 0 for none.
    pub step: f64,
    /// Units of the drawing per SI unit of length.
    pub scale: f64,
}

/// A number with a unit.
struct Literal<'a> {
    /// Value (SI).
    value: f64,
    /// Unit without brackets.
    unit: &'a str,
}

impl<'a> Literal<'a> {
    fn read(text: &'a str) -> Option<Self> {
        let text = text.trim();
        let (number, unit) = match text.split_once('[') {
            Some((number, unit)) => (number, unit.strip_suffix(']')?.trim()),
            None => (text, ""),
        };
        let number: String = number.split_whitespace().collect();
        if !number.ends_with(|letter: char| letter.is_ascii_digit() || letter == '.') {
            return None;
        }
        let value = number.parse::<f64>().ok().filter(|value| value.is_finite())?;
        let value = if unit.is_empty() { value } else { Unit::parse(unit).ok()?.to_si(value) };
        Some(Self { value, unit })
    }
}

/// Splits off a number with a unit that is added at the end of an expression: `y` and `+ 4 [cm]` for `y + 4 [cm]`. For a
/// number alone the expression is empty.
pub(crate) fn split_distance(text: &str) -> (&str, &str) {
    let text = text.trim();
    if Literal::read(text).is_some() {
        return ("", text);
    }
    let mut depth = 0_u32;
    for (at, letter) in text.char_indices().rev() {
        match letter {
            ')' | ']' => depth += 1,
            '(' | '[' => depth = depth.saturating_sub(1),
            '+' | '-' if depth == 0 && Literal::read(&text[at..]).is_some() => {
                let before = text[..at].trim_end();
                // In `2e-3` and `a*-1` the sign is part of the number.
                let is_added = !before.ends_with(['*', '/', '^', '(', ',', '+', '-', '=', '<', '>', 'e', 'E']);
                let is_exponent = before.ends_with(['e', 'E'])
                    && before.trim_end_matches(['e', 'E']).ends_with(|letter: char| letter.is_ascii_digit());
                return if (is_added || before.ends_with(['e', 'E']) && !is_exponent) && !before.is_empty() {
                    (before, &text[at..])
                } else {
                    (text, "")
                };
            }
            _ => {}
        }
    }
    (text, "")
}

impl Measure {
    /// Measure with the smallest step of 1, 2 or 5 times a power of ten units that is at least `least` (SI).
    pub fn round(unit: &str, least: f64, scale: f64) -> Self {
        let known = Unit::parse(unit).unwrap_or_else(|_| Unit::dimensionless());
        let number = known.from_si(least);
        let step = if number > 0.0 && number.is_finite() {
            let power = libm::pow(10.0, libm::floor(libm::log10(number)));
            let is_enough = |times: &f64| times * power >= number * (1.0 - 1e-9);
            known.to_si([1.0, 2.0, 5.0].into_iter().find(is_enough).unwrap_or(10.0) * power)
        } else {
            0.0
        };
        Self { unit: unit.to_owned(), step, scale }
    }

    /// A coordinate shifted by `by` (SI). A number is rounded to the step; to another expression a rounded distance is
    /// added.
    pub(super) fn moved(&self, text: &str, by: f64) -> String {
        if by == 0.0 {
            return text.to_owned();
        }
        let (expression, distance) = split_distance(text);
        let literal = Literal::read(distance);
        let value = self.on_step(literal.as_ref().map_or(0.0, |literal| literal.value) + by);
        let unit = literal.map(|literal| literal.unit).filter(|unit| !unit.is_empty()).unwrap_or(&self.unit);
        self.joined(expression, value, unit)
    }

    /// An expression plus a distance `value` (SI), written in `unit`.
    pub(super) fn joined(&self, expression: &str, value: f64, unit: &str) -> String {
        match expression.trim() {
            "" => self.written(value, unit),
            expression if value == 0.0 => expression.to_owned(),
            expression => {
                // Without parentheses, the distance would belong to the last branch of a conditional.
                let is_loose = expression.starts_with("if ") || expression.contains(['<', '>', '=']);
                let expression = if is_loose { format!("({expression})") } else { expression.to_owned() };
                let sign = if value < 0.0 { '-' } else { '+' };
                format!("{expression} {sign} {}", self.written(value.abs(), unit))
            }
        }
    }

    /// A length of an element increased by `by` (SI): in pixels, or like a coordinate. A number stays positive.
    pub(super) fn grown(&self, text: &str, by: f64) -> String {
        if by == 0.0 {
            return text.to_owned();
        }
        if let Some(pixels) = text.trim().strip_suffix("px").and_then(|number| number.trim().parse::<f64>().ok()) {
            return format!("{}px", (pixels + by * self.scale).round().max(1.0));
        }
        let (expression, distance) = split_distance(text);
        match Literal::read(distance) {
            Some(literal) if expression.is_empty() => {
                let unit = if literal.unit.is_empty() { &self.unit } else { literal.unit };
                self.written(self.on_step(literal.value + by).max(self.step), unit)
            }
            _ => self.moved(text, by),
        }
    }

    /// Nearest multiple of the step.
    fn on_step(&self, value: f64) -> f64 {
        if self.step > 0.0 { (value / self.step).round() * self.step } else { value }
    }

    /// Text of a distance (SI) in `unit`.
    pub(super) fn written(&self, value: f64, unit: &str) -> String {
        if value == 0.0 {
            return "0".to_owned();
        }
        match Unit::parse(unit) {
            Ok(known) if !unit.is_empty() => {
                let step = known.from_si(self.step);
                format!("{} [{unit}]", decimal(known.from_si(value), step))
            }
            _ => decimal(value, self.step),
        }
    }
}

/// A number with as many decimals as the step needs, at most 9.
fn decimal(value: f64, step: f64) -> String {
    const MOST: usize = 9;
    let is_whole = |decimals: &usize| {
        let times = step * libm::pow(10.0, *decimals as f64);
        (times - times.round()).abs() <= 1e-6 * times.abs()
    };
    let decimals = (0..MOST).find(is_whole).unwrap_or(MOST);
    let text = format!("{value:.decimals$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn centimetres() -> Measure {
        Measure { unit: "cm".to_owned(), step: 0.005, scale: 500.0 }
    }

    #[test]
    fn a_distance_is_added_to_what_stands_there() {
        let cases = [
            ("0", 0.03, "3 [cm]"),
            ("3 [cm]", -0.03, "0"),
            ("0.1 [m]", 0.005, "0.105 [m]"),
            ("-2.5 [cm]", -0.01, "-3.5 [cm]"),
            ("y", 0.04, "y + 4 [cm]"),
            ("y + 4 [cm]", -0.04, "y"),
            ("y - 4 [cm]", 0.012, "y - 3 [cm]"),
            ("y - 4 [cm]", 0.012_6, "y - 2.5 [cm]"),
            ("L*sin(theta)", 0.01, "L*sin(theta) + 1 [cm]"),
            ("L*(1 - 2)", 0.01, "L*(1 - 2) + 1 [cm]"),
            ("if a < 0 then y else 0", 0.01, "(if a < 0 then y else 0) + 1 [cm]"),
            ("-y", 0.01, "-y + 1 [cm]"),
            ("y + h", -0.01, "y + h - 1 [cm]"),
            ("x_e - 1 [cm]", 0.01, "x_e"),
            ("2e-2 [m]", 0.01, "0.03 [m]"),
        ];
        for (before, by, after) in cases {
            assert_eq!(centimetres().moved(before, by), after, "{before} by {by}");
        }
    }

    #[test]
    fn steps_are_round_in_their_unit() {
        for (unit, least, step) in
            [("cm", 0.0031, 0.005), ("cm", 0.01, 0.01), ("", 7.0, 10.0), ("km", 1100.0, 2000.0), ("m", 0.0, 0.0)]
        {
            let found = Measure::round(unit, least, 1.0).step;
            assert!((found - step).abs() < 1e-12, "{least} {unit}: {found}");
        }
    }

    #[test]
    fn lengths_stay_positive_and_pixels_stay_pixels() {
        let cases = [
            ("5px", 0.01, "10px"),
            ("5px", -0.1, "1px"),
            ("4 [cm]", 0.02, "6 [cm]"),
            ("4 [cm]", -0.2, "0.5 [cm]"),
            ("a", 0.01, "a + 1 [cm]"),
        ];
        for (before, by, after) in cases {
            assert_eq!(centimetres().grown(before, by), after, "{before} by {by}");
        }
        let drawing = Measure { unit: String::new(), step: 5.0, scale: 1.0 };
        assert_eq!(drawing.moved("12", 4.0), "15");
        assert_eq!(drawing.moved("200 - level", -10.0), "200 - level - 10");
    }
}

//! Groups of numbers with a common unit, power of ten and number of decimals.

use super::digits::{is_error, last_digit};
use super::plain::{exponent, mantissa, plain, power_shown, rounded};
use super::sign::{error_with_unit, push_power, with_unit};
use super::{Style, unit_text};
use crate::Unit;

/// Position of the last digit and power of ten of a group of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    power: i32,
    /// Decimal exponent of the last digit.
    last: i32,
}

impl Layout {
    /// Layout for numbers up to `scale`, which has `digits` significant digits; smaller numbers have the same decimals. An
    /// oscillating value then keeps its width and resolution.
    pub fn of_scale(scale: f64, digits: usize) -> Self {
        if scale == 0.0 || !scale.is_finite() {
            return Self { power: 0, last: 0 };
        }
        let first = exponent(scale, digits);
        let last = first + 1 - digits.clamp(1, 17) as i32;
        let power = power_shown(first, last, digits);
        // Digits before the decimal sign are all written.
        Self { power, last: last.min(power) }
    }

    /// Layout with this number of decimals for numbers of any size.
    pub fn of_decimals(decimals: usize) -> Self {
        Self { power: 0, last: -i32::try_from(decimals.min(400)).unwrap_or(0) }
    }

    /// Layout for values with errors (value, error), as in [`super::with_error`]. The smallest error determines the last
    /// digit, so that no error is rounded to zero. Errors that are not positive and finite, or not above rounding, are
    /// ignored; `None` if there is no other.
    pub fn of_errors(measured: impl IntoIterator<Item = (f64, f64)>) -> Option<Self> {
        let known = |(value, error): &(f64, f64)| is_error(*value, *error);
        let (mut size, mut least) = (0.0_f64, f64::INFINITY);
        for (value, error) in measured.into_iter().filter(known) {
            size = size.max(value.abs()).max(error);
            least = least.min(error);
        }
        if size == 0.0 {
            return None;
        }
        let last = last_digit(least);
        let mut power = power_shown(exponent(size, 3), last, 0);
        while power != 0 && power < last {
            power += 3;
        }
        Some(Self { power, last })
    }

    /// A number of the group as text.
    pub fn number(self, value: f64, style: Style) -> String {
        rounded(value, self.last, self.power, style)
    }

    /// A value of the group with its error as text; only the value if the error is not positive and finite.
    pub fn with_error(self, value: f64, error: f64, style: Style) -> String {
        if !is_error(value, error) {
            return self.number(value, style);
        }
        let [value, error] = [value, error].map(|number| mantissa(number, self.last, self.power, style));
        if self.power == 0 {
            return [&value, " ± ", &error].concat();
        }
        let mut text = ["(", &value, " ± ", &error, ")"].concat();
        push_power(&mut text, self.power);
        text
    }
}

/// Numbers of one quantity, given in SI units, and the unit in which they are written.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    unit: Unit,
    /// `None` if the number of significant digits is unknown.
    layout: Option<Layout>,
    style: Style,
}

/// Significant digits if the number of known digits is unknown.
const DIGITS: usize = 6;

impl Group {
    /// Group of values up to `scale` (SI units), which has `digits` significant digits.
    pub fn of_scale(unit: &Unit, scale: f64, digits: usize, style: Style) -> Self {
        let unit = unit.for_size(unit.from_si(scale).abs());
        let layout = Layout::of_scale(unit.from_si(scale).abs(), digits);
        Self { unit, layout: Some(layout), style }
    }

    /// Group of residuals or errors (SI units). The greatest determines the unit, which is finer than for values. All have
    /// the decimals that the smallest needs for `digits` significant digits, but at most three more than the greatest
    /// needs.
    pub fn of_residuals(unit: &Unit, sizes: &[f64], digits: usize, style: Style) -> Self {
        let known = sizes.iter().map(|size| size.abs()).filter(|size| size.is_finite() && *size > 0.0);
        let (least, greatest) =
            known.fold((f64::INFINITY, 0.0_f64), |(least, greatest), size| (least.min(size), greatest.max(size)));
        let unit = unit.for_residuals(unit.from_si(greatest).abs());
        let Layout { power, last } = Layout::of_scale(unit.from_si(greatest).abs(), digits);
        let finest = Layout::of_scale(unit.from_si(least).abs(), digits).last;
        let last = if least.is_finite() { last.min(finest.max(last - 3)) } else { last };
        Self { unit, layout: Some(Layout { power, last }), style }
    }

    /// Group of values with errors (value, error), both in SI units.
    pub fn of_errors(unit: &Unit, measured: &[(f64, f64)], style: Style) -> Self {
        let known = |(value, error): &&(f64, f64)| is_error(*value, *error);
        let size =
            measured.iter().filter(known).fold(0.0_f64, |size, (value, error)| size.max(value.abs()).max(*error));
        let unit = unit.for_size(unit.from_si(size).abs());
        let own = measured.iter().map(|(value, error)| (unit.from_si(*value), unit.from_si(*error)));
        let layout = Layout::of_errors(own);
        Self { unit, layout, style }
    }

    /// Unit in which the numbers are written.
    pub fn unit(&self) -> &Unit {
        &self.unit
    }

    /// The unit as displayed; empty for a pure number.
    pub fn unit_text(&self) -> String {
        unit_text(&self.unit.text)
    }

    /// A number of the group, given in SI units, without unit.
    pub fn number(&self, si: f64) -> String {
        let value = self.unit.from_si(si);
        self.layout.map_or_else(|| plain(value, DIGITS, self.style), |layout| layout.number(value, self.style))
    }

    /// A number of the group, given in SI units, with unit.
    pub fn quantity(&self, si: f64) -> String {
        with_unit(&self.number(si), &self.unit)
    }

    /// A value and its error, both given in SI units, without unit; only the value if the error is not positive and finite.
    pub fn with_error(&self, value: f64, error: f64) -> String {
        match self.layout {
            Some(layout) => layout.with_error(self.unit.from_si(value), self.unit.from_si(error), self.style),
            None => self.number(value),
        }
    }

    /// [`Group::with_error`] with the unit for both: `(0.5 ± 0.7) mm/s`.
    pub fn quantity_with_error(&self, value: f64, error: f64) -> String {
        error_with_unit(&self.with_error(value, error), &self.unit_text())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::DASH;

    const POINT: Style = Style::POINT;

    fn unit(text: &str) -> Unit {
        Unit::parse(text).unwrap()
    }

    #[test]
    fn swinging_values_keep_their_resolution() {
        for (value, scale, expected) in [
            (0.5, 0.5, "0.5000"),
            (-1.2e-17, 0.5, "0.0000"),
            (6.769e-113, 0.5, "0.0000"),
            (0.04321, 0.5, "0.0432"),
            (123.456, 200.0, "123.5"),
            (12345.6, 20_000.0, "12346"),
            (1.5e7, 2e7, "15.00×10⁶"),
            (-2e-5, 4e-4, "−20.0×10⁻⁶"),
            (0.0, 0.0, "0"),
            (f64::NAN, 1.0, "–"),
        ] {
            assert_eq!(Layout::of_scale(scale, 4).number(value, POINT), expected, "{value}");
        }
    }

    #[test]
    fn moving_quantities_take_prefixes_before_powers_of_ten() {
        for (value, scale, text, expected) in [
            (0.25, 0.5, "m", "0.2500 m"),
            (2e-5, 4e-4, "m", "0.0200 mm"),
            (6.769e-113, 0.5, "m", "0.0000 m"),
            (3.2e-8, 5e-8, "m", "32.00 nm"),
            (2.5e6, 3e6, "J", "2.500 MJ"),
            (2.5e6, 3e6, "m", "2500 km"),
            (2.5e6, 3e6, "s", "2.500×10⁶ s"),
            (2e-5, 4e-4, "1/s", "20.0×10⁻⁶ 1/s"),
            (2e-5, 4e-4, "", "20.0×10⁻⁶"),
            (2e-5, 4e-4, "m^2", "20.0 mm²"),
            (30.0, 60.0, "deg", "1719°"),
        ] {
            let group = Group::of_scale(&unit(text), scale, 4, POINT);
            assert_eq!(group.quantity(value), expected, "{value} {text}");
        }
    }

    #[test]
    fn value_and_error_share_one_unit() {
        for (value, error, text, style, expected) in [
            (0.0005, 0.0007, "m/s", POINT, "(0.5 ± 0.7) mm/s"),
            (0.0005, 0.0007, "m/s", Style::COMMA, "(0,5 ± 0,7) mm/s"),
            (0.0005, 0.0007, "1/s", POINT, "(0.0005 ± 0.0007) 1/s"),
            (0.0005, 0.0007, "", POINT, "0.0005 ± 0.0007"),
            (0.5e-6, 0.7e-6, "kg/m", POINT, "(0.5 ± 0.7)×10⁻⁶ kg/m"),
            (9.609_27, 0.0213, "m/s^2", POINT, "(9.609 ± 0.021) m/s²"),
            (0.0027, 0.0004, "m", POINT, "(0.0027 ± 0.0004) m"),
            (0.0027, f64::NAN, "m", POINT, "0.0027 m"),
            (f64::NAN, 1.0, "m", POINT, DASH),
        ] {
            let group = Group::of_errors(&unit(text), &[(value, error)], style);
            assert_eq!(group.quantity_with_error(value, error), expected, "{value} {text}");
        }
    }

    #[test]
    fn a_column_has_one_unit_and_the_same_decimals() {
        let column = [(1.234, 0.03), (0.012_34, 0.002_2), (2.0, 0.3)];
        let group = Group::of_errors(&unit("s"), &column, POINT);
        let texts = column.map(|(value, error)| group.with_error(value, error));
        assert_eq!(texts, ["1.2340 ± 0.0300", "0.0123 ± 0.0022", "2.0000 ± 0.3000"]);
        assert_eq!(group.number(f64::NAN), DASH);

        let sizes = [0.000_593_1, 0.000_886, 0.012_34];
        let group = Group::of_residuals(&unit("m"), &sizes[..2], 3, POINT);
        assert_eq!(sizes[..2].iter().map(|size| group.quantity(*size)).collect::<Vec<_>>(), ["0.593 mm", "0.886 mm"]);
        let group = Group::of_residuals(&unit("m"), &sizes, 3, POINT);
        assert_eq!(sizes.map(|size| group.quantity(size)), ["0.000593 m", "0.000886 m", "0.012340 m"]);
    }
}

//! Ticks: multiples of 1, 2 or 5 times a power of ten, as integers so that their labels are exact.

use crate::plot::Interval;
use units::number::{Style, axis_unit, common_power, leading_exponent, scaled_by, tick, write_power};

/// Distance between ticks: `mantissa * 10^exponent` with mantissa 1, 2 or 5.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Step {
    mantissa: i64,
    exponent: i32,
}

impl Step {
    /// Smallest step that is at least `size`, which must be positive, up to rounding.
    pub(crate) fn at_least(size: f64) -> Step {
        // Tolerance for rounding: 0.6 / 3 must give 0.2, not 0.5.
        let wanted = size * (1.0 - 1e-9);
        let exponent = leading_exponent(wanted);
        for mantissa in [1, 2, 5] {
            let step = Step { mantissa, exponent };
            if step.multiple(1) >= wanted {
                return step;
            }
        }
        Step { mantissa: 1, exponent: exponent + 1 }
    }

    /// Next larger step.
    pub(crate) fn larger(self) -> Step {
        match self.mantissa {
            1 => Step { mantissa: 2, ..self },
            2 => Step { mantissa: 5, ..self },
            _ => Step { mantissa: 1, exponent: self.exponent + 1 },
        }
    }

    /// Value of `count` steps.
    pub(crate) fn multiple(self, count: i64) -> f64 {
        scaled_by((count * self.mantissa) as f64, self.exponent)
    }

    /// Number of steps in a value, rounded down.
    pub(crate) fn floor(self, value: f64) -> i64 {
        libm::floor(value / self.multiple(1) + 1e-9) as i64
    }

    /// Number of steps in a value, rounded up.
    pub(crate) fn ceil(self, value: f64) -> i64 {
        libm::ceil(value / self.multiple(1) - 1e-9) as i64
    }
}

/// Ticks of an axis: the multiples of a step from `first` to `last`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Ticks {
    pub(crate) step: Step,
    pub(crate) first: i64,
    pub(crate) last: i64,
    /// Power of ten factored out of all labels and written with the unit.
    pub(crate) power: i32,
}

impl Ticks {
    /// All ticks in an interval.
    pub(crate) fn within(values: Interval, step: Step) -> Ticks {
        let (first, last) = (step.ceil(values.low), step.floor(values.high));
        let magnitude = step.multiple(first).abs().max(step.multiple(last).abs());
        Ticks { step, first, last, power: common_power(magnitude) }
    }

    /// Ticks with the smallest step for which they are at least about `spacing` pixels apart and `fits` is true; `fits`
    /// receives the ticks and their distance in pixels.
    pub(crate) fn spaced(values: Interval, pixels: f64, spacing: f64, fits: impl Fn(&Ticks, f64) -> bool) -> Ticks {
        let per_value = pixels / values.length();
        let mut step = Step::at_least(values.length() * (spacing / pixels).min(1.0));
        loop {
            let ticks = Ticks::within(values, step);
            // A single tick cannot collide.
            if ticks.last <= ticks.first || fits(&ticks, step.multiple(1) * per_value) {
                return ticks;
            }
            step = step.larger();
        }
    }

    /// Index and value of each tick.
    pub(crate) fn iter(self) -> impl Iterator<Item = (i64, f64)> {
        (self.first..=self.last).map(move |number| (number, self.step.multiple(number)))
    }

    /// Writes the label of the tick with index `number`.
    pub(crate) fn write_label(&self, out: &mut String, number: i64, style: Style) {
        let step = self.step;
        out.push_str(&tick(number * step.mantissa, step.exponent - self.power, style));
    }

    /// Width of the widest label in a font of this size, pixels.
    pub(crate) fn widest_label(&self, size: f64, style: Style) -> f64 {
        let mut label = String::new();
        let mut widest = 0.0_f64;
        // Labels get wider with magnitude and sign, so the widest one is at an end.
        for number in [self.first, self.last] {
            label.clear();
            self.write_label(&mut label, number, style);
            widest = widest.max(crate::text::width(&label, size));
        }
        widest
    }

    /// Writes the title of the axis with quantity and unit: `y [mm]`, or `b [10⁻³ 1/s]` if the unit takes no prefix.
    pub(crate) fn write_title(&self, out: &mut String, label: &str, unit: &str) {
        out.push_str(label);
        let (unit, power) = axis_unit(unit, self.power);
        if unit.is_empty() && power == 0 {
            return;
        }
        if !label.is_empty() {
            out.push(' ');
        }
        out.push('[');
        if power != 0 {
            write_power(out, power);
            if !unit.is_empty() {
                out.push(' ');
            }
        }
        out.push_str(&unit);
        out.push(']');
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(low: f64, high: f64, pixels: f64, comma: bool) -> String {
        let ticks = Ticks::spaced(Interval { low, high }, pixels, 50.0, |_, _| true);
        let mut title = String::new();
        ticks.write_title(&mut title, "y", "m");
        let labels: Vec<String> = ticks
            .iter()
            .map(|(number, value)| {
                let mut label = String::new();
                ticks.write_label(&mut label, number, Style::comma(comma));
                let read: f64 = label.replace('−', "-").replace(',', ".").parse().unwrap();
                let exact = scaled_by(read, ticks.power);
                assert!((exact - value).abs() <= 4.0 * f64::EPSILON * value.abs(), "{label} stands at {value}");
                label
            })
            .collect();
        format!("{title}: {}", labels.join(" "))
    }

    #[test]
    fn labels_are_exact() {
        let cases = [
            (-0.6, 0.6, 300.0, "y [m]: −0.6 −0.4 −0.2 0 0.2 0.4 0.6"),
            (0.0, 10.0, 600.0, "y [m]: 0 1 2 3 4 5 6 7 8 9 10"),
            (0.0, 10.0, 260.0, "y [m]: 0 2 4 6 8 10"),
            (0.0, 1.0, 150.0, "y [m]: 0 0.5 1.0"),
            (0.1, 0.7, 300.0, "y [m]: 0.1 0.2 0.3 0.4 0.5 0.6 0.7"),
            (-3e-7, 3e-7, 200.0, "y [nm]: −200 0 200"),
            (0.0, 2.5e6, 250.0, "y [10⁶ m]: 0 0.5 1.0 1.5 2.0 2.5"),
            (40.000_01, 40.000_05, 250.0, "y [m]: 40.00001 40.00002 40.00003 40.00004 40.00005"),
            (0.0, 99_000.0, 150.0, "y [m]: 0 50000"),
            (0.0, 1e300, 100.0, "y [10³⁰⁰ m]: 0 0.5 1.0"),
            (-1e-290, 1e-290, 100.0, "y [10⁻²⁹¹ m]: −10 0 10"),
        ];
        for (low, high, pixels, expected) in cases {
            assert_eq!(labels(low, high, pixels, false), expected);
        }
        assert_eq!(labels(-0.25, 0.25, 500.0, true), "y [m]: −0,25 −0,20 −0,15 −0,10 −0,05 0 0,05 0,10 0,15 0,20 0,25");
    }

    #[test]
    fn steps_are_the_smallest_that_are_large_enough() {
        for (size, mantissa, exponent) in
            [(1.0, 1, 0), (0.2, 2, -1), (0.6 / 3.0, 2, -1), (0.21, 5, -1), (5.1, 1, 1), (3e299, 5, 299)]
        {
            assert_eq!(Step::at_least(size), Step { mantissa, exponent }, "{size}");
        }
    }

    #[test]
    fn titles_join_quantity_power_and_unit() {
        let cases = [
            ("y", "m", 0, "y [m]"),
            ("Q", "", 0, "Q"),
            ("Q", "", 3, "Q [10³]"),
            ("E, T", "J", -6, "E, T [µJ]"),
            ("T", "J", 6, "T [MJ]"),
            ("b", "1/s", -3, "b [10⁻³ 1/s]"),
            ("", "m", 0, "[m]"),
        ];
        for (label, unit, power, expected) in cases {
            let ticks = Ticks { step: Step { mantissa: 1, exponent: power }, first: 0, last: 1, power };
            let mut title = String::new();
            ticks.write_title(&mut title, label, unit);
            assert_eq!(title, expected);
        }
    }
}

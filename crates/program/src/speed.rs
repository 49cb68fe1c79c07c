//! Display speed of a run.

use serde::{Deserialize, Serialize};
use units::number::{Style, plain, with_unit};
use units::{Dimension, Unit};

/// Display speed: advance of the independent variable per second of real time, initially.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Speed {
    /// SI units of the independent variable per second of real time.
    pub per_second: f64,
    /// Unit for display.
    pub unit: Unit,
}

/// Lengths of runs, in seconds, that are shown in real time; others would be too fast or too slow.
const REAL_TIME: std::ops::RangeInclusive<f64> = 1.0..=300.0;

/// Upper bound of the display time of other runs, s. With factors of 1, 2 and 5 it is at least 8 s.
const LONGEST: f64 = 20.0;

/// Significant digits of a displayed speed.
const DIGITS: usize = 4;

impl Speed {
    /// Default speed for a run that ends at `until` (SI units) with an independent variable of this unit: real time for a
    /// run of seconds, otherwise 8 to 20 s for the whole run. Without an end, one unit per second.
    pub fn chosen(until: Option<f64>, unit: &Unit) -> Self {
        match until {
            None => Self { per_second: unit.to_si(1.0), unit: unit.clone() },
            Some(until) if unit.dimension == Dimension::TIME && REAL_TIME.contains(&until) => {
                Self { per_second: 1.0, unit: Unit::si(Dimension::TIME) }
            }
            Some(until) => {
                let per_second = unit.to_si(nice(unit.from_si(until) / LONGEST));
                // Not usable at the limits of floating-point numbers.
                let usable = per_second > 0.0 && per_second.is_finite();
                Self { per_second: if usable { per_second } else { until }, unit: unit.clone() }
            }
        }
    }

    /// The speed multiplied by `times` as text: `1 d/s`, `50 ms/s`, or `10 ×` for seconds per second.
    pub fn text(&self, times: f64, style: Style) -> String {
        let per_second = self.per_second * times;
        if self.unit.text == "s" && self.per_second >= 1.0 {
            return match self.per_second == 1.0 && times < 1.0 {
                true => format!("1/{} ×", plain(1.0 / times, DIGITS, style)),
                false => format!("{} ×", plain(per_second, DIGITS, style)),
            };
        }
        let size = self.unit.from_si(per_second);
        let smaller = [0, -3, -6, -9, -12].into_iter().find_map(|power| {
            let unit = if power == 0 { Some(self.unit.clone()) } else { self.unit.with_power(power) }?;
            (unit.from_si(per_second) >= 1.0).then_some(unit)
        });
        let unit = smaller.filter(|_| size < 0.1).unwrap_or_else(|| self.unit.clone());
        let number = plain(unit.from_si(per_second), DIGITS, style);
        let compound = unit.text.contains([' ', '/']);
        if compound { format!("{} / s", with_unit(&number, &unit)) } else { format!("{}/s", with_unit(&number, &unit)) }
    }
}

/// Smallest of 1, 2, 5 times a power of ten that is at least `value`.
fn nice(value: f64) -> f64 {
    if !value.is_normal() {
        return value;
    }
    let exponent = units::number::leading_exponent(value);
    let candidates = [(1, exponent), (2, exponent), (5, exponent), (1, exponent + 1)];
    let read = |(digit, power): (u8, i32)| units::number::decimal(&format!("{digit}e{power}"));
    let found = candidates.into_iter().filter_map(read).find(|candidate| *candidate >= value);
    found.filter(|found| found.is_finite()).unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::{Speed, nice};
    use units::number::Style;
    use units::{Language, Unit};

    fn text(value: f64, unit: &str, times: f64) -> String {
        let unit = Unit::parse(unit).unwrap();
        Speed { per_second: unit.to_si(value), unit }.text(times, Style::default())
    }

    #[test]
    fn nice_factors() {
        for (value, expected) in [(0.05, 0.05), (0.0501, 0.1), (3.0, 5.0), (10.0, 10.0), (18.25, 20.0), (7e-9, 1e-8)] {
            assert_eq!(nice(value), expected);
        }
        assert!(nice(f64::MAX) >= f64::MAX && nice(5e-324) > 0.0);
    }

    #[test]
    fn runs_of_seconds_are_watched_as_they_happen_and_others_for_8_to_20_seconds() {
        let chosen = |until: f64, unit: &str| {
            let unit = Unit::parse(unit).unwrap();
            Speed::chosen(Some(unit.to_si(until)), &unit)
        };
        for (until, unit) in [(1.0, "s"), (8.0, "s"), (300.0, "s"), (2.0, "min")] {
            assert_eq!(chosen(until, unit).text(1.0, Style::default()), "1 ×", "{until} {unit}");
        }
        for (until, unit, expected) in [
            (365.0, "d", "20 d/s"),
            (1.0, "h", "0.05 h/s"),
            (3600.0, "s", "200 ×"),
            (0.002, "s", "100 µs/s"),
            (200.0, "", "10/s"),
        ] {
            let speed = chosen(until, unit);
            assert_eq!(speed.text(1.0, Style::default()), expected, "{until} {unit}");
            let watched = Unit::parse(unit).unwrap().to_si(until) / speed.per_second;
            assert!((8.0..=20.0).contains(&watched), "{until} {unit}: {watched} s");
        }
        for until in [f64::MAX, 5e-324] {
            assert!(chosen(until, "s").per_second > 0.0);
        }
        assert_eq!(Speed::chosen(None, &Unit::parse("d").unwrap()).text(1.0, Style::default()), "1 d/s");
    }

    #[test]
    fn speeds_are_written_with_their_unit() {
        for (value, unit, times, expected) in [
            (1.0, "s", 1.0, "1 ×"),
            (1.0, "s", 0.125, "1/8 ×"),
            (10.0, "s", 0.25, "2.5 ×"),
            (1.0, "d", 1.0, "1 d/s"),
            (1.0, "d", 0.125, "0.125 d/s"),
            (50.0, "ms", 1.0, "50 ms/s"),
            (0.05, "s", 1.0, "50 ms/s"),
            (2e-5, "s", 0.5, "10 µs/s"),
            (10.0, "", 2.0, "20/s"),
            (0.5, "m", 1.0, "0.5 m/s"),
        ] {
            assert_eq!(text(value, unit, times), expected, "{value} {unit} {times}");
        }
        let unit = Unit::parse("d").unwrap();
        let speed = Speed { per_second: unit.to_si(1.0), unit };
        assert_eq!(speed.text(0.5, Language::Spanish.style()), "0,5 d/s");
    }
}

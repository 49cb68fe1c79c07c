//! Mapping between the values of a parameter and the positions of its slider. Positions are integers; each stands for a
//! round number.

use crate::number;
use program::Parameter;

/// A slider with integer positions, 0 to `positions`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slider {
    /// Greatest position.
    pub positions: u32,
    /// Present position.
    pub position: u32,
    /// Number of positions in a large step (Page Up).
    pub page: u32,
}

/// Mapping between position and value.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Mapping<'a> {
    parameter: &'a Parameter,
    /// Ends of the range, in the parameter's unit.
    low: f64,
    high: f64,
    scale: Scale,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Scale {
    /// Linear: adjacent positions differ by `step`, starting at the low end. The last position is the high end.
    Even { step: f64, positions: u32 },
    /// Fine near the low end: the distance from it is proportional to this power of the position.
    Fine { power: u32 },
}

/// Maximum number of positions that is useful on a screen.
const MOST_POSITIONS: f64 = 100_000.0;

/// Number of positions of a fine slider. Adjacent values differ by a few per cent at most.
const FINE_POSITIONS: u32 = 300;

impl<'a> Mapping<'a> {
    /// Mapping for a parameter; `None` without a range.
    pub fn of(parameter: &'a Parameter) -> Option<Self> {
        let (low, high) = parameter.range?;
        let unit = &parameter.unit;
        let (low, high) = (unit.from_si(low), unit.from_si(high));
        if !(low < high && (high - low).is_finite()) {
            return None;
        }
        let step = parameter.step.map(|step| unit.from_si(step)).filter(|step| (high - low) / step <= MOST_POSITIONS);
        let default = unit.from_si(parameter.value);
        let scale = match step.filter(|step| *step > 0.0) {
            Some(step) => even(low, high, step),
            None if is_wide(low, high, default) => Scale::Fine { power: power(low, high, default) },
            None => even(low, high, round_step((high - low) / 100.0)),
        };
        Some(Self { parameter, low, high, scale })
    }

    /// Slider at the position nearest to a value (SI).
    pub fn slider(&self, value: f64) -> Slider {
        let value = self.parameter.unit.from_si(value).clamp(self.low, self.high);
        let (positions, place) = match self.scale {
            Scale::Even { step, positions } => (positions, (value - self.low) / step),
            Scale::Fine { power } => {
                let part = (value - self.low) / (self.high - self.low);
                let place = libm::pow(part, 1.0 / f64::from(power));
                (FINE_POSITIONS, place * f64::from(FINE_POSITIONS))
            }
        };
        let position = if value == self.high { positions } else { (place.round() as u32).min(positions) };
        Slider { positions, position, page: (positions / 10).max(1) }
    }

    /// Value (SI) at a position.
    pub fn value(&self, position: u32) -> f64 {
        let value = match self.scale {
            Scale::Even { step, positions } if position < positions => {
                // Rounds away the error of the sum: 0.15, not 0.15000000000000002.
                let value = self.low + f64::from(position) * step;
                number::roundest(value - step * 1e-6, value + step * 1e-6)
            }
            Scale::Fine { .. } if position == 0 => self.low,
            Scale::Fine { power } if position < FINE_POSITIONS => {
                let place = f64::from(position);
                number::roundest(self.fine(place - 0.5, power), self.fine(place + 0.5, power))
            }
            _ => self.high,
        };
        let si = self.parameter.unit.to_si(value.clamp(self.low, self.high));
        self.parameter.range.map_or(si, |(low, high)| si.max(low).min(high))
    }

    fn fine(&self, place: f64, power: u32) -> f64 {
        let part = place / f64::from(FINE_POSITIONS);
        self.low + (self.high - self.low) * libm::pow(part, f64::from(power))
    }
}

fn even(low: f64, high: f64, step: f64) -> Scale {
    let positions = ((high - low) / step - 1e-6).ceil().max(1.0);
    Scale::Even { step, positions: positions as u32 }
}

/// True if a linear slider would leave too little room for small values: the default lies in the first twentieth of a
/// range of non-negative values, or the ends differ by more than a factor of a thousand.
fn is_wide(low: f64, high: f64, default: f64) -> bool {
    low >= 0.0 && (default - low < (high - low) / 20.0 || (low > 0.0 && high / low > 1000.0))
}

/// Exponent of a fine slider: 3, or 5 if the cube would leave the default in the first twentieth of the slider.
fn power(low: f64, high: f64, default: f64) -> u32 {
    let part = (default - low) / (high - low);
    if part > 0.0 && libm::cbrt(part) < 0.05 { 5 } else { 3 }
}

/// Greatest number of the form 1, 2 or 5 times a power of ten that is at most `step`.
fn round_step(step: f64) -> f64 {
    let scientific = format!("{step:e}");
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let mantissa = units::number::decimal(mantissa).unwrap_or(1.0);
    let round = if mantissa >= 5.0 {
        5
    } else if mantissa >= 2.0 {
        2
    } else {
        1
    };
    units::number::decimal(&format!("{round}e{exponent}")).unwrap_or(step)
}

#[cfg(test)]
mod tests {
    use super::*;
    use units::Unit;

    fn parameter(unit: Unit, default: f64, low: f64, high: f64, step: Option<f64>) -> Parameter {
        Parameter {
            name: "b".to_owned(),
            label: None,
            group: None,
            value: unit.to_si(default),
            range: Some((unit.to_si(low), unit.to_si(high))),
            step: step.map(|step| unit.to_si(step)),
            unit,
            restarts: false,
            choices: program::Choices::Numbers,
            hidden: false,
            assigned: None,
        }
    }

    #[test]
    fn every_position_has_a_value_and_every_value_its_position() {
        let none = Unit::dimensionless();
        let percent = Unit::parse("%").unwrap();
        for parameter in [
            parameter(none.clone(), 3.0, 2.0, 9.0, Some(0.5)),
            parameter(none.clone(), 0.05, 0.01, 2.0, Some(0.01)),
            parameter(none.clone(), 1000.0, 50.0, 13_600.0, Some(50.0)),
            parameter(none.clone(), 9.8, 0.0, 30.0, None),
            parameter(none.clone(), 0.0, -5.0, 5.0, None),
            parameter(none.clone(), 50.0, 0.0, 20_000.0, None),
            parameter(none.clone(), 1.0, 0.001, 1000.0, None),
            parameter(none.clone(), 50.0, 0.0, 2_000_000.0, None),
            parameter(none, 1.0, 0.0, 1.0, Some(0.3)),
            parameter(percent, 10.0, 0.0, 100.0, Some(1.0)),
        ] {
            let mapping = Mapping::of(&parameter).unwrap();
            let positions = mapping.slider(parameter.value).positions;
            let mut before = f64::NEG_INFINITY;
            for position in 0..=positions {
                let value = mapping.value(position);
                assert_eq!(mapping.slider(value).position, position, "{value} of {parameter:?}");
                assert!(value > before, "{value} after {before} of {parameter:?}");
                before = value;
            }
            let (low, high) = parameter.range.unwrap();
            assert_eq!((mapping.value(0), mapping.value(positions)), (low, high));
            assert_eq!(mapping.value(u32::MAX), high);
        }
    }

    #[test]
    fn a_step_gives_the_decimals_that_one_would_write() {
        let parameter = parameter(Unit::dimensionless(), 0.05, 0.01, 2.0, Some(0.01));
        let mapping = Mapping::of(&parameter).unwrap();
        assert_eq!(mapping.value(4), 0.05);
        assert_eq!(mapping.value(14), 0.15);
        assert_eq!(mapping.slider(0.05).positions, 199);
    }

    #[test]
    fn a_wide_slider_is_fine_near_zero() {
        for (high, expected) in
            [(20_000.0, [10.0, 15.0, 20.0, 30.0, 40.0]), (2_000_000.0, [10.0, 20.0, 30.0, 40.0, 50.0])]
        {
            let parameter = parameter(Unit::dimensionless(), 50.0, 0.0, high, None);
            let mapping = Mapping::of(&parameter).unwrap();
            let value = |value: f64| mapping.value(mapping.slider(value).position);
            assert_eq!(value(50.0), 50.0);
            assert!(mapping.value(1) <= 0.001);
            assert_eq!(expected.map(value), expected, "{high}");
        }
    }

    #[test]
    fn a_range_that_is_none_has_no_slider() {
        let mut parameter = parameter(Unit::dimensionless(), 1.0, 1.0, 1.0, None);
        assert_eq!(Mapping::of(&parameter), None);
        parameter.range = None;
        assert_eq!(Mapping::of(&parameter), None);
    }
}

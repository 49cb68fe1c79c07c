//! From the numbers in the cells of a column to values in its unit, where a factor of the unit is not all.

/// How the text of a unit was read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnitReading {
    /// A temperature in °C, converted to K.
    Celsius,
    /// A temperature in °F, converted to K.
    Fahrenheit,
    /// A difference of temperatures in °C, which is one in K.
    CelsiusDifference,
    /// A difference of temperatures in °F, converted to K.
    FahrenheitDifference,
    /// The standard acceleration of gravity, converted to m/s².
    Gravity {
        /// True if the numbers are thousandths of it, `mg`.
        thousandth: bool,
    },
    /// Seconds, written as a capital letter.
    Seconds,
}

/// The conversion of the numbers of the cells: a power of ten of the heading, then the reading of the unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Conversion {
    /// The numbers were multiplied by ten to this.
    pub tens: i32,
    /// How the unit was read, if that is not plain.
    pub reading: Option<UnitReading>,
}

impl Conversion {
    /// The value in the unit of the column, for the number of a cell.
    pub(crate) fn value(self, number: f64) -> f64 {
        let number = scaled(number, self.tens);
        match self.reading {
            Some(UnitReading::Celsius) => rounded(number + 273.15),
            Some(UnitReading::Fahrenheit) => (number + 459.67) * 5.0 / 9.0,
            Some(UnitReading::FahrenheitDifference) => number * 5.0 / 9.0,
            Some(UnitReading::Gravity { thousandth: false }) => number * 9.80665,
            Some(UnitReading::Gravity { thousandth: true }) => number * 9.80665 / 1000.0,
            Some(UnitReading::CelsiusDifference | UnitReading::Seconds) | None => number,
        }
    }

    /// The number of the cell, for a value in the unit of the column.
    pub fn number(self, value: f64) -> f64 {
        let number = match self.reading {
            Some(UnitReading::Celsius) => rounded(value - 273.15),
            Some(UnitReading::Fahrenheit) => rounded(value * 9.0 / 5.0 - 459.67),
            Some(UnitReading::FahrenheitDifference) => value * 9.0 / 5.0,
            Some(UnitReading::Gravity { thousandth: false }) => value / 9.80665,
            Some(UnitReading::Gravity { thousandth: true }) => value / 9.80665 * 1000.0,
            Some(UnitReading::CelsiusDifference | UnitReading::Seconds) | None => value,
        };
        scaled(number, -self.tens)
    }

    /// True for a temperature whose zero is not that of the unit.
    pub fn is_level(self) -> bool {
        matches!(self.reading, Some(UnitReading::Celsius | UnitReading::Fahrenheit))
    }
}

/// Times ten to this; a power up to 22 is exact.
fn scaled(number: f64, tens: i32) -> f64 {
    let power = (0..tens.unsigned_abs()).fold(1.0, |power, _| power * 10.0);
    if tens < 0 { number / power } else { number * power }
}

/// A sum of two decimal numbers has their decimals: 295.55, not 295.54999999999995.
fn rounded(value: f64) -> f64 {
    if value.abs() < 1e6 { (value * 1e9).round() / 1e9 } else { value }
}

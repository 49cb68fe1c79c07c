//! Conversion of the numbers in the cells of a column to values in its unit, where a factor of the unit is not enough.

/// Reading of the text of a unit that needs a conversion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnitReading {
    /// Temperature in °C, converted to K.
    Celsius,
    /// Temperature in °F, converted to K.
    Fahrenheit,
    /// Difference of temperatures in °C, numerically equal in K.
    CelsiusDifference,
    /// Difference of temperatures in °F, converted to K.
    FahrenheitDifference,
    /// Multiples of the standard acceleration of gravity, converted to m/s².
    Gravity {
        /// True if the numbers are thousandths of it, `mg`.
        thousandth: bool,
    },
    /// Seconds, written with a capital letter.
    Seconds,
}

/// Conversion of the numbers of cells: a power of ten from the heading, then the reading of the unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Conversion {
    /// Exponent of ten by which the numbers are multiplied.
    pub tens: i32,
    /// Reading of the unit; `None` if the numbers are in the unit.
    pub reading: Option<UnitReading>,
}

impl Conversion {
    /// Value in the unit of the column for the number of a cell.
    pub fn value(self, number: f64) -> f64 {
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

    /// Number of the cell for a value in the unit of the column.
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

    /// True for a temperature scale whose zero is not 0 K.
    pub fn is_level(self) -> bool {
        matches!(self.reading, Some(UnitReading::Celsius | UnitReading::Fahrenheit))
    }
}

/// Number times ten to the power `tens`; exact for powers up to 22.
fn scaled(number: f64, tens: i32) -> f64 {
    let power = (0..tens.unsigned_abs()).fold(1.0, |power, _| power * 10.0);
    if tens < 0 { number / power } else { number * power }
}

/// Removes rounding errors of a sum of two decimal numbers: 295.55, not 295.54999999999995.
fn rounded(value: f64) -> f64 {
    if value.abs() < 1e6 { (value * 1e9).round() / 1e9 } else { value }
}

//! Units: a dimension, a factor to SI and a text.

use crate::turns::Turns;
use crate::{Dimension, UnitError, parse, table};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;
use std::fmt;
use std::sync::LazyLock;

/// A unit of measurement.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Unit {
    /// Dimension.
    pub dimension: Dimension,
    /// SI value of one unit.
    pub factor: f64,
    /// Text as written by the author, in normal form: `kg/m^3`, `Pa s`; empty for a pure number.
    pub text: String,
    /// `factor` is `multiplier / divisor`, which are exact even if it is not: 1 and 100 for a centimetre.
    multiplier: f64,
    divisor: f64,
    /// Symbols that count turns.
    turns: Turns,
}

impl Unit {
    /// Parses a unit such as `kg/m^3`, `Pa s`, `1/s`, `m s^-1`, `µm`, `J/(kg K)`. An empty text or `1` gives the pure
    /// number.
    ///
    /// # Errors
    /// A symbol is unknown, the division is ambiguous, the scale has its own zero (`degC`), or the text is malformed.
    pub fn parse(text: &str) -> Result<Self, UnitError> {
        parse::parse(text).map(|(dimension, scale, turns, text)| Self { turns, ..Self::new(dimension, scale, text) })
    }

    /// The coherent SI unit of a dimension; by name if it has one (`N`, `J`, `Pa s`), otherwise from base units (`kg/m^3`).
    pub fn si(dimension: Dimension) -> Self {
        // Parsed once: a document needs hundreds of units.
        static PREFERRED: LazyLock<Vec<Unit>> =
            LazyLock::new(|| table::PREFERRED.iter().filter_map(|text| Unit::parse(text).ok()).collect());
        let named = || PREFERRED.iter().find(|unit| unit.dimension == dimension).cloned();
        // Fast path: every named unit combines several base units.
        let combines = dimension.base().count() > 1;
        combines.then(named).flatten().unwrap_or_else(|| Self::new(dimension, (1.0, 1.0), base_text(dimension)))
    }

    /// The unit of pure numbers.
    pub fn dimensionless() -> Self {
        Self::new(Dimension::NONE, (1.0, 1.0), String::new())
    }

    pub(crate) fn new(dimension: Dimension, (multiplier, divisor): (f64, f64), text: String) -> Self {
        Self { dimension, factor: multiplier / divisor, text, multiplier, divisor, turns: Turns::NONE }
    }

    /// True if a number in this unit is its SI value.
    pub fn is_coherent(&self) -> bool {
        self.multiplier == self.divisor
    }

    /// SI value of `value` in this unit. Multiplier and divisor are exact, so that 40 in `cm` is 0.4 to the last bit.
    pub fn to_si(&self, value: f64) -> f64 {
        value * self.multiplier / self.divisor
    }

    /// Value in this unit of an SI value. Inverse of [`Self::to_si`] for numbers of up to 14 digits: 0.29 m is 29 cm, not
    /// 28.999999999999996.
    pub fn from_si(&self, si: f64) -> f64 {
        if self.multiplier == self.divisor {
            return si;
        }
        let value = si * self.divisor / self.multiplier;
        match round_to_14_digits(value) {
            Some(rounded) if self.to_si(rounded) == si => rounded,
            _ => value,
        }
    }
}

impl Unit {
    /// Exponent of 2 pi in the factor [`Self::turning`].
    fn turned(&self, quantity: &Self) -> f64 {
        let (own, other) = (self.turns, quantity.turns);
        match (own.angles == 0.0 && other.cycles == 0.0, own.cycles == 0.0 && other.angles == 0.0) {
            (true, false) if own.cycles == other.angles => own.cycles,
            (false, true) if own.angles == other.cycles => -own.angles,
            _ => 0.0,
        }
    }

    /// Factor of an SI value stated in this unit where it is taken for a quantity stated in the unit `quantity`. A
    /// frequency of 1 Hz is an angular velocity of 2 pi rad/s, 360 deg/s and 60 rpm. 1 unless one unit counts
    /// cycles and the other angles; `1/s` counts neither.
    pub fn turning(&self, quantity: &Self) -> f64 {
        match self.turned(quantity) {
            0.0 => 1.0,
            exponent => libm::pow(TAU, exponent),
        }
    }

    /// True if the unit counts cycles, like `Hz` and `kHz`, and no angles.
    pub fn counts_cycles(&self) -> bool {
        self.turns.cycles != 0.0 && self.turns.angles == 0.0
    }

    /// True if the unit counts cycles or angles.
    pub fn counts_turns(&self) -> bool {
        self.turns != Turns::NONE
    }

    /// SI value of `value` in this unit, taken for a quantity stated in the unit `quantity` of the same dimension: 60 rpm
    /// are 1 Hz. Equals [`Self::to_si`] unless one unit counts cycles and the other angles, see [`Self::turning`].
    pub fn to_si_of(&self, value: f64, quantity: &Self) -> f64 {
        let exponent = self.turned(quantity);
        if exponent == 0.0 {
            return self.to_si(value);
        }
        // The pi of degrees and of revolutions per minute cancels that of the turn: 60 rpm are 1 Hz to the last bit.
        let turn = libm::pow(TAU, exponent);
        if quantity.turns.angles == 0.0 {
            return value * (self.multiplier * turn) / self.divisor;
        }
        quantity.to_si(self.to_si(value) * (turn / quantity.multiplier) * quantity.divisor)
    }
}

/// Reads the text of a unit, see [`Unit::text`].
impl TryFrom<String> for Unit {
    type Error = UnitError;

    fn try_from(text: String) -> Result<Self, UnitError> {
        Self::parse(&text)
    }
}

impl From<Unit> for String {
    fn from(unit: Unit) -> Self {
        unit.text
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.text)
    }
}

/// A unit of base units: `kg/(m s^2)`.
fn base_text(dimension: Dimension) -> String {
    let product = |negative: bool| {
        let factors: Vec<String> = dimension
            .base()
            .filter(|(_, exponent)| (exponent.numerator() < 0) == negative)
            .map(|(symbol, exponent)| if negative { exponent.negated() } else { exponent }.power_of(symbol))
            .collect();
        (factors.len(), factors.join(" "))
    };
    match (product(false), product(true)) {
        ((_, above), (0, _)) => above,
        ((0, _), (1, below)) => format!("1/{below}"),
        ((0, _), (_, below)) => format!("1/({below})"),
        ((_, above), (1, below)) => format!("{above}/{below}"),
        ((_, above), (_, below)) => format!("{above}/({below})"),
    }
}

/// Powers of ten that are exact in an `f64`.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

/// `value` rounded to 14 decimal digits; `None` if the power of ten needed is not exact (below 1e-8, above 1e22).
fn round_to_14_digits(value: f64) -> Option<f64> {
    let size = value.abs();
    if size < 1e-8 {
        return None;
    }
    // Number of digits before the point; negative for zeros after it.
    let digits = if size >= 1.0 {
        POWERS.iter().position(|power| size < *power)? as i32
    } else {
        1 - POWERS.iter().position(|power| size * power >= 1.0)? as i32
    };
    let shift = 14 - digits;
    let power = *POWERS.get(shift.unsigned_abs() as usize)?;
    Some(if shift >= 0 { (value * power).round() / power } else { (value / power).round() * power })
}

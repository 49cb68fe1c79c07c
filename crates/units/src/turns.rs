//! Cycles and angles: two ways to count turns, which have the same dimension.

use crate::Unit;
use std::f64::consts::TAU;

/// Exponents of the symbols in a unit that count turns: `rad/s^2` has the angle once, `1/Hz` the cycle -1 times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Turns {
    /// Exponent of hertz.
    pub(crate) cycles: f64,
    /// Exponent of radians, degrees and revolutions per minute, which are angular velocities.
    pub(crate) angles: f64,
}

impl Turns {
    pub(crate) const NONE: Self = Self { cycles: 0.0, angles: 0.0 };

    /// The exponents of a product with the power `exponent` of another unit.
    pub(crate) fn times(self, other: Self, exponent: f64) -> Self {
        Self { cycles: self.cycles + exponent * other.cycles, angles: self.angles + exponent * other.angles }
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

#[cfg(test)]
mod tests {
    use super::*;

    fn unit(text: &str) -> Unit {
        Unit::parse(text).unwrap()
    }

    /// Units that count cycles, each with its factor to cycles per second, and units that count angles, each with its
    /// factor to turns per second.
    const CYCLES: [(&str, f64); 5] = [("Hz", 1.0), ("kHz", 1e3), ("mHz", 1e-3), ("MHz", 1e6), ("(Hz^2)^(1/2)", 1.0)];
    const ANGLES: [(&str, f64); 8] = [
        ("rad/s", 1.0 / TAU),
        ("rad s^-1", 1.0 / TAU),
        ("mrad/s", 1e-3 / TAU),
        ("rad/min", 1.0 / TAU / 60.0),
        ("deg/s", 1.0 / 360.0),
        ("°/s", 1.0 / 360.0),
        ("deg/min", 1.0 / 21_600.0),
        ("rpm", 1.0 / 60.0),
    ];

    #[test]
    fn cycles_and_angles_are_converted_through_the_turn() {
        let all = || CYCLES.iter().chain(&ANGLES);
        for (from, turns) in all() {
            for (to, unit_turns) in all() {
                let (own, quantity) = (unit(from), unit(to));
                let found = quantity.from_si(own.to_si_of(2.5, &quantity));
                let expected = 2.5 * turns / unit_turns;
                assert!((found / expected - 1.0).abs() < 1e-14, "2.5 {from} are {found} {to}, not {expected}");
                let scaled = quantity.from_si(own.to_si(2.5) * own.turning(&quantity));
                assert!((scaled / expected - 1.0).abs() < 1e-14, "2.5 {from} are {scaled} {to}, not {expected}");
                assert_eq!(own.counts_cycles(), CYCLES.contains(&(from, *turns)), "{from}");
            }
            // A unit that counts neither takes the number as it is.
            for neither in ["1/s", "1/min", "s^-1"].map(unit) {
                assert_eq!(unit(from).to_si_of(2.5, &neither), unit(from).to_si(2.5), "{from}");
                assert_eq!(neither.to_si_of(2.5, &unit(from)), neither.to_si(2.5), "{from}");
            }
        }
        for (from, to, value) in [("rpm", "Hz", 60.0), ("deg/s", "Hz", 360.0), ("deg/s", "kHz", 360e3)] {
            assert_eq!(unit(to).from_si(unit(from).to_si_of(value, &unit(to))), 1.0, "{from}");
            assert_eq!(unit(from).from_si(unit(to).to_si_of(1.0, &unit(from))), value, "{from}");
        }
    }

    #[test]
    fn powers_are_converted_by_powers_of_the_turn() {
        for (from, to, factor) in [
            ("Hz/s", "rad/s^2", TAU),
            ("Hz^2", "rad^2/s^2", TAU * TAU),
            ("J/Hz", "J s/rad", 1.0 / TAU),
            ("V/Hz", "V/rpm", 1.0 / TAU),
            ("m Hz", "m rad/s", TAU),
            // Neither, both, or another power.
            ("J s", "J s/rad", 1.0),
            ("rad Hz", "Hz", 1.0),
            ("rad/s^2", "Hz^2", 1.0),
            ("N m/rad", "N m", 1.0),
            ("rad", "", 1.0),
            ("m", "cm", 1.0),
        ] {
            let (one, other) = (unit(from), unit(to));
            assert!((one.turning(&other) / factor - 1.0).abs() < 1e-15, "{from} to {to}");
            assert!((other.turning(&one) * factor - 1.0).abs() < 1e-15, "{to} to {from}");
        }
    }
}

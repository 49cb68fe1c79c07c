//! Names of physical quantities, for messages: what could have this dimension?

use crate::Dimension;

/// Exponents of kg, m, s, A, K, mol, cd and what is usually meant, most usual first.
const QUANTITIES: &[([i8; 7], &[&str])] = &[
    ([0, 0, 0, 0, 0, 0, 0], &["number", "angle", "ratio"]),
    ([1, 0, 0, 0, 0, 0, 0], &["mass"]),
    ([0, 1, 0, 0, 0, 0, 0], &["length"]),
    ([0, 0, 1, 0, 0, 0, 0], &["time"]),
    ([0, 0, 0, 1, 0, 0, 0], &["electric current"]),
    ([0, 0, 0, 0, 1, 0, 0], &["temperature"]),
    ([0, 0, 0, 0, 0, 1, 0], &["amount of substance"]),
    ([0, 0, 0, 0, 0, 0, 1], &["luminous intensity"]),
    ([0, 2, 0, 0, 0, 0, 0], &["area"]),
    ([0, 3, 0, 0, 0, 0, 0], &["volume"]),
    ([0, -1, 0, 0, 0, 0, 0], &["wave number"]),
    ([0, 1, -1, 0, 0, 0, 0], &["velocity"]),
    ([0, 1, -2, 0, 0, 0, 0], &["acceleration"]),
    ([0, 1, -3, 0, 0, 0, 0], &["jerk"]),
    ([0, 0, -1, 0, 0, 0, 0], &["frequency", "angular velocity", "rate"]),
    ([0, 0, -2, 0, 0, 0, 0], &["angular acceleration", "squared frequency"]),
    ([0, 3, -1, 0, 0, 0, 0], &["volume flow"]),
    ([0, 2, -1, 0, 0, 0, 0], &["kinematic viscosity", "diffusion coefficient"]),
    ([0, 2, -2, 0, 0, 0, 0], &["energy per mass", "squared velocity"]),
    ([1, -3, 0, 0, 0, 0, 0], &["density"]),
    ([1, -2, 0, 0, 0, 0, 0], &["mass per area"]),
    ([1, -1, 0, 0, 0, 0, 0], &["mass per length", "drag coefficient"]),
    ([1, 2, 0, 0, 0, 0, 0], &["moment of inertia"]),
    ([1, 1, -1, 0, 0, 0, 0], &["momentum"]),
    ([1, 2, -1, 0, 0, 0, 0], &["angular momentum", "action"]),
    ([1, 1, -2, 0, 0, 0, 0], &["force"]),
    ([1, 2, -2, 0, 0, 0, 0], &["energy", "torque"]),
    ([1, 2, -3, 0, 0, 0, 0], &["power"]),
    ([1, -1, -2, 0, 0, 0, 0], &["pressure", "energy density"]),
    ([1, -1, -1, 0, 0, 0, 0], &["dynamic viscosity"]),
    ([1, 0, -1, 0, 0, 0, 0], &["damping constant", "mass flow"]),
    ([1, 0, -2, 0, 0, 0, 0], &["spring constant", "surface tension"]),
    ([1, 0, -3, 0, 0, 0, 0], &["intensity"]),
    ([1, -2, -2, 0, 0, 0, 0], &["pressure gradient", "specific weight"]),
    ([-1, 3, -2, 0, 0, 0, 0], &["gravitational constant"]),
    ([0, 0, 1, 1, 0, 0, 0], &["electric charge"]),
    ([1, 2, -3, -1, 0, 0, 0], &["voltage"]),
    ([1, 2, -3, -2, 0, 0, 0], &["resistance"]),
    ([-1, -2, 3, 2, 0, 0, 0], &["conductance"]),
    ([-1, -2, 4, 2, 0, 0, 0], &["capacitance"]),
    ([1, 2, -2, -2, 0, 0, 0], &["inductance"]),
    ([1, 0, -2, -1, 0, 0, 0], &["magnetic flux density"]),
    ([1, 2, -2, -1, 0, 0, 0], &["magnetic flux"]),
    ([1, 1, -3, -1, 0, 0, 0], &["electric field"]),
    ([1, 2, -2, 0, -1, 0, 0], &["heat capacity", "entropy"]),
    ([0, 2, -2, 0, -1, 0, 0], &["specific heat capacity"]),
    ([1, 1, -3, 0, -1, 0, 0], &["thermal conductivity"]),
    ([1, 2, -2, 0, -1, -1, 0], &["molar heat capacity", "gas constant"]),
    ([1, 0, 0, 0, 0, -1, 0], &["molar mass"]),
    ([0, -3, 0, 0, 0, 1, 0], &["concentration"]),
];

impl Dimension {
    /// The names of quantities that have this dimension, the most usual first; empty where none is common.
    pub fn quantity_names(&self) -> &'static [&'static str] {
        QUANTITIES
            .iter()
            .find(|(exponents, _)| Dimension::from_whole(*exponents) == *self)
            .map_or(&[], |(_, names)| names)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Unit;

    #[test]
    fn names_what_a_unit_measures() {
        for (unit, name) in [
            ("m", "length"),
            ("N", "force"),
            ("kg/s", "damping constant"),
            ("Pa s", "dynamic viscosity"),
            ("kg/m^3", "density"),
            ("V", "voltage"),
            ("ohm", "resistance"),
            ("F", "capacitance"),
            ("H", "inductance"),
            ("T", "magnetic flux density"),
            ("J/(kg K)", "specific heat capacity"),
        ] {
            assert_eq!(Unit::parse(unit).unwrap().dimension.quantity_names()[0], name, "{unit}");
        }
        assert!(Unit::parse("m^7").unwrap().dimension.quantity_names().is_empty());
    }

    #[test]
    fn each_dimension_stands_once() {
        for (index, (exponents, _)) in QUANTITIES.iter().enumerate() {
            assert!(QUANTITIES[..index].iter().all(|(earlier, _)| earlier != exponents), "{exponents:?}");
        }
    }
}

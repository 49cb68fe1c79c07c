//! Names of physical quantities by dimension, for messages.

use crate::{Dimension, Words, words};

/// Name of a physical quantity: a noun with its article, which shows the gender in languages that have one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct QuantityName(Words);

const fn named(name: Words) -> QuantityName {
    QuantityName(name)
}

impl QuantityName {
    /// Name of a quantity without dimension.
    pub const PURE_NUMBER: &'static Self = &named(words("a pure number"));

    /// The noun alone: `length`, `longitud`.
    pub fn noun(&self) -> Words {
        let name = self.0.clone();
        Words::each(move |language| {
            let name = name.text(language);
            name.split_once(' ').map_or(&*name, |(_, noun)| noun).to_owned()
        })
    }

    /// The noun with its article: `a length`, `an energy`; `una longitud`, `una energía`.
    pub fn with_article(&self) -> Words {
        self.0.clone()
    }
}

/// Exponents of kg, m, s, A, K, mol, cd, and the quantities of this dimension, the most usual first.
const QUANTITIES: &[([i8; 7], &[QuantityName])] = &[
    ([0, 0, 0, 0, 0, 0, 0], &[named(words("a number")), named(words("an angle")), named(words("a ratio"))]),
    ([1, 0, 0, 0, 0, 0, 0], &[named(words("a mass"))]),
    ([0, 1, 0, 0, 0, 0, 0], &[named(words("a length"))]),
    ([0, 0, 1, 0, 0, 0, 0], &[named(words("a time"))]),
    ([0, 0, 0, 1, 0, 0, 0], &[named(words("an electric current"))]),
    ([0, 0, 0, 0, 1, 0, 0], &[named(words("a temperature"))]),
    ([0, 0, 0, 0, 0, 1, 0], &[named(words("an amount of substance"))]),
    ([0, 0, 0, 0, 0, 0, 1], &[named(words("a luminous intensity"))]),
    ([0, 2, 0, 0, 0, 0, 0], &[named(words("an area"))]),
    ([0, 3, 0, 0, 0, 0, 0], &[named(words("a volume"))]),
    ([0, -1, 0, 0, 0, 0, 0], &[named(words("a wave number"))]),
    ([0, 1, -1, 0, 0, 0, 0], &[named(words("a velocity"))]),
    ([0, 1, -2, 0, 0, 0, 0], &[named(words("an acceleration"))]),
    ([0, 1, -3, 0, 0, 0, 0], &[named(words("a jerk"))]),
    (
        [0, 0, -1, 0, 0, 0, 0],
        &[named(words("a frequency")), named(words("an angular velocity")), named(words("a rate"))],
    ),
    ([0, 0, -2, 0, 0, 0, 0], &[named(words("an angular acceleration")), named(words("a squared frequency"))]),
    ([0, 3, -1, 0, 0, 0, 0], &[named(words("a volume flow"))]),
    ([0, 2, -1, 0, 0, 0, 0], &[named(words("a kinematic viscosity")), named(words("a diffusion coefficient"))]),
    ([0, 2, -2, 0, 0, 0, 0], &[named(words("an energy per mass")), named(words("a squared velocity"))]),
    ([1, -3, 0, 0, 0, 0, 0], &[named(words("a density"))]),
    ([1, -2, 0, 0, 0, 0, 0], &[named(words("a mass per area"))]),
    ([1, -1, 0, 0, 0, 0, 0], &[named(words("a mass per length")), named(words("a drag coefficient"))]),
    ([1, 2, 0, 0, 0, 0, 0], &[named(words("a moment of inertia"))]),
    ([1, 1, -1, 0, 0, 0, 0], &[named(words("a momentum"))]),
    ([1, 2, -1, 0, 0, 0, 0], &[named(words("an angular momentum")), named(words("an action"))]),
    ([1, 1, -2, 0, 0, 0, 0], &[named(words("a force"))]),
    ([1, 2, -2, 0, 0, 0, 0], &[named(words("an energy")), named(words("a torque"))]),
    ([1, 2, -3, 0, 0, 0, 0], &[named(words("a power"))]),
    ([1, -1, -2, 0, 0, 0, 0], &[named(words("a pressure")), named(words("an energy density"))]),
    ([1, -1, -1, 0, 0, 0, 0], &[named(words("a dynamic viscosity"))]),
    ([1, 0, -1, 0, 0, 0, 0], &[named(words("a damping constant")), named(words("a mass flow"))]),
    ([1, 0, -2, 0, 0, 0, 0], &[named(words("a spring constant")), named(words("a surface tension"))]),
    ([1, 0, -3, 0, 0, 0, 0], &[named(words("an intensity"))]),
    ([1, -2, -2, 0, 0, 0, 0], &[named(words("a pressure gradient")), named(words("a specific weight"))]),
    ([-1, 3, -2, 0, 0, 0, 0], &[named(words("a gravitational constant"))]),
    ([0, 0, 1, 1, 0, 0, 0], &[named(words("an electric charge"))]),
    ([1, 2, -3, -1, 0, 0, 0], &[named(words("a voltage"))]),
    ([1, 2, -3, -2, 0, 0, 0], &[named(words("a resistance"))]),
    ([-1, -2, 3, 2, 0, 0, 0], &[named(words("a conductance"))]),
    ([-1, -2, 4, 2, 0, 0, 0], &[named(words("a capacitance"))]),
    ([1, 2, -2, -2, 0, 0, 0], &[named(words("an inductance"))]),
    ([1, 0, -2, -1, 0, 0, 0], &[named(words("a magnetic flux density"))]),
    ([1, 2, -2, -1, 0, 0, 0], &[named(words("a magnetic flux"))]),
    ([1, 1, -3, -1, 0, 0, 0], &[named(words("an electric field"))]),
    ([1, 2, -2, 0, -1, 0, 0], &[named(words("a heat capacity")), named(words("an entropy"))]),
    ([0, 2, -2, 0, -1, 0, 0], &[named(words("a specific heat capacity"))]),
    ([1, 1, -3, 0, -1, 0, 0], &[named(words("a thermal conductivity"))]),
    ([1, 2, -2, 0, -1, -1, 0], &[named(words("a molar heat capacity")), named(words("a gas constant"))]),
    ([1, 0, 0, 0, 0, -1, 0], &[named(words("a molar mass"))]),
    ([0, -3, 0, 0, 0, 1, 0], &[named(words("a concentration"))]),
];

impl Dimension {
    /// Names of quantities of this dimension, the most usual first; empty if none is common.
    pub fn quantity_names(&self) -> &'static [QuantityName] {
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
            assert_eq!(Unit::parse(unit).unwrap().dimension.quantity_names()[0].noun().english(), name, "{unit}");
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

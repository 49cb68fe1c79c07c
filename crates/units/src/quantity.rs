//! Names of physical quantities by dimension, for messages.

use crate::{Dimension, Words};

/// Name of a physical quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct QuantityName {
    /// The English noun.
    pub english: &'static str,
    /// The Spanish noun with its article, which shows the gender.
    spanish: &'static str,
}

const fn named(english: &'static str, spanish: &'static str) -> QuantityName {
    QuantityName { english, spanish }
}

impl QuantityName {
    /// Name of a quantity without dimension.
    pub const PURE_NUMBER: Self = named("pure number", "un número puro");

    /// The noun alone: `length`, `longitud`.
    pub fn noun(self) -> Words {
        let spanish = self.spanish.split_once(' ').map_or(self.spanish, |(_, noun)| noun);
        Words { english: self.english.into(), spanish: spanish.into() }
    }

    /// The noun with its article: `a length`, `an energy`; `una longitud`, `una energía`.
    pub fn with_article(self) -> Words {
        let article = if self.english.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" };
        Words { english: format!("{article} {}", self.english).into(), spanish: self.spanish.into() }
    }
}

/// Exponents of kg, m, s, A, K, mol, cd, and the quantities of this dimension, the most usual first.
const QUANTITIES: &[([i8; 7], &[QuantityName])] = &[
    (
        [0, 0, 0, 0, 0, 0, 0],
        &[named("number", "un número"), named("angle", "un ángulo"), named("ratio", "un cociente")],
    ),
    ([1, 0, 0, 0, 0, 0, 0], &[named("mass", "una masa")]),
    ([0, 1, 0, 0, 0, 0, 0], &[named("length", "una longitud")]),
    ([0, 0, 1, 0, 0, 0, 0], &[named("time", "un tiempo")]),
    ([0, 0, 0, 1, 0, 0, 0], &[named("electric current", "una corriente eléctrica")]),
    ([0, 0, 0, 0, 1, 0, 0], &[named("temperature", "una temperatura")]),
    ([0, 0, 0, 0, 0, 1, 0], &[named("amount of substance", "una cantidad de sustancia")]),
    ([0, 0, 0, 0, 0, 0, 1], &[named("luminous intensity", "una intensidad luminosa")]),
    ([0, 2, 0, 0, 0, 0, 0], &[named("area", "un área")]),
    ([0, 3, 0, 0, 0, 0, 0], &[named("volume", "un volumen")]),
    ([0, -1, 0, 0, 0, 0, 0], &[named("wave number", "un número de onda")]),
    ([0, 1, -1, 0, 0, 0, 0], &[named("velocity", "una velocidad")]),
    ([0, 1, -2, 0, 0, 0, 0], &[named("acceleration", "una aceleración")]),
    ([0, 1, -3, 0, 0, 0, 0], &[named("jerk", "una sobreaceleración")]),
    (
        [0, 0, -1, 0, 0, 0, 0],
        &[
            named("frequency", "una frecuencia"),
            named("angular velocity", "una velocidad angular"),
            named("rate", "una tasa"),
        ],
    ),
    (
        [0, 0, -2, 0, 0, 0, 0],
        &[
            named("angular acceleration", "una aceleración angular"),
            named("squared frequency", "una frecuencia al cuadrado"),
        ],
    ),
    ([0, 3, -1, 0, 0, 0, 0], &[named("volume flow", "un caudal")]),
    (
        [0, 2, -1, 0, 0, 0, 0],
        &[
            named("kinematic viscosity", "una viscosidad cinemática"),
            named("diffusion coefficient", "un coeficiente de difusión"),
        ],
    ),
    (
        [0, 2, -2, 0, 0, 0, 0],
        &[
            named("energy per mass", "una energía por unidad de masa"),
            named("squared velocity", "una velocidad al cuadrado"),
        ],
    ),
    ([1, -3, 0, 0, 0, 0, 0], &[named("density", "una densidad")]),
    ([1, -2, 0, 0, 0, 0, 0], &[named("mass per area", "una masa por unidad de área")]),
    (
        [1, -1, 0, 0, 0, 0, 0],
        &[
            named("mass per length", "una masa por unidad de longitud"),
            named("drag coefficient", "un coeficiente de arrastre"),
        ],
    ),
    ([1, 2, 0, 0, 0, 0, 0], &[named("moment of inertia", "un momento de inercia")]),
    ([1, 1, -1, 0, 0, 0, 0], &[named("momentum", "un momento lineal")]),
    ([1, 2, -1, 0, 0, 0, 0], &[named("angular momentum", "un momento angular"), named("action", "una acción")]),
    ([1, 1, -2, 0, 0, 0, 0], &[named("force", "una fuerza")]),
    ([1, 2, -2, 0, 0, 0, 0], &[named("energy", "una energía"), named("torque", "un momento de fuerza")]),
    ([1, 2, -3, 0, 0, 0, 0], &[named("power", "una potencia")]),
    ([1, -1, -2, 0, 0, 0, 0], &[named("pressure", "una presión"), named("energy density", "una densidad de energía")]),
    ([1, -1, -1, 0, 0, 0, 0], &[named("dynamic viscosity", "una viscosidad dinámica")]),
    (
        [1, 0, -1, 0, 0, 0, 0],
        &[named("damping constant", "una constante de amortiguamiento"), named("mass flow", "un caudal másico")],
    ),
    (
        [1, 0, -2, 0, 0, 0, 0],
        &[named("spring constant", "una constante elástica"), named("surface tension", "una tensión superficial")],
    ),
    ([1, 0, -3, 0, 0, 0, 0], &[named("intensity", "una intensidad")]),
    (
        [1, -2, -2, 0, 0, 0, 0],
        &[named("pressure gradient", "un gradiente de presión"), named("specific weight", "un peso específico")],
    ),
    ([-1, 3, -2, 0, 0, 0, 0], &[named("gravitational constant", "una constante de gravitación")]),
    ([0, 0, 1, 1, 0, 0, 0], &[named("electric charge", "una carga eléctrica")]),
    ([1, 2, -3, -1, 0, 0, 0], &[named("voltage", "una tensión eléctrica")]),
    ([1, 2, -3, -2, 0, 0, 0], &[named("resistance", "una resistencia")]),
    ([-1, -2, 3, 2, 0, 0, 0], &[named("conductance", "una conductancia")]),
    ([-1, -2, 4, 2, 0, 0, 0], &[named("capacitance", "una capacidad eléctrica")]),
    ([1, 2, -2, -2, 0, 0, 0], &[named("inductance", "una inductancia")]),
    ([1, 0, -2, -1, 0, 0, 0], &[named("magnetic flux density", "una inducción magnética")]),
    ([1, 2, -2, -1, 0, 0, 0], &[named("magnetic flux", "un flujo magnético")]),
    ([1, 1, -3, -1, 0, 0, 0], &[named("electric field", "un campo eléctrico")]),
    ([1, 2, -2, 0, -1, 0, 0], &[named("heat capacity", "una capacidad calorífica"), named("entropy", "una entropía")]),
    ([0, 2, -2, 0, -1, 0, 0], &[named("specific heat capacity", "un calor específico")]),
    ([1, 1, -3, 0, -1, 0, 0], &[named("thermal conductivity", "una conductividad térmica")]),
    (
        [1, 2, -2, 0, -1, -1, 0],
        &[
            named("molar heat capacity", "una capacidad calorífica molar"),
            named("gas constant", "una constante de los gases"),
        ],
    ),
    ([1, 0, 0, 0, 0, -1, 0], &[named("molar mass", "una masa molar")]),
    ([0, -3, 0, 0, 0, 1, 0], &[named("concentration", "una concentración")]),
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
            assert_eq!(Unit::parse(unit).unwrap().dimension.quantity_names()[0].english, name, "{unit}");
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

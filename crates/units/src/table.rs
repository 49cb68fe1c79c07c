//! The symbols of units and prefixes.

use crate::Dimension;
use crate::scale::Scale;
use crate::turns::Turns;
use std::f64::consts::PI;

/// A unit symbol.
pub(crate) struct Symbol {
    pub(crate) text: &'static str,
    dimension: Base,
    pub(crate) scale: Scale,
    /// True if it takes prefixes: `cm`, but not `cmin`.
    prefixes: bool,
}

/// Symbols that count whole turns.
const CYCLES: [&str; 1] = ["Hz"];

/// Symbols that count angles.
const ANGLES: [&str; 5] = ["rad", "deg", "°", "rpm", "dps"];

impl Symbol {
    pub(crate) fn dimension(&self) -> Dimension {
        match self.dimension {
            Base::Si(exponents) => Dimension::from_whole(exponents),
            Base::Pixel => Dimension::PIXEL,
        }
    }

    /// Cycles and angles that the symbol counts.
    pub(crate) fn turns(&self) -> Turns {
        let counts = |symbols: &[&str]| if symbols.contains(&self.text) { 1.0 } else { 0.0 };
        Turns { cycles: counts(&CYCLES), angles: counts(&ANGLES) }
    }
}

/// Dimension of a unit.
enum Base {
    /// Exponents of kg, m, s, A, K, mol, cd.
    Si([i8; 7]),
    /// A distance in a picture, px.
    Pixel,
}

const fn symbol(text: &'static str, exponents: [i8; 7], scale: Scale, prefixes: bool) -> Symbol {
    Symbol { text, dimension: Base::Si(exponents), scale, prefixes }
}

/// Values of units outside the SI: SI brochure, 9th edition (2019), table 8, and ISO 80000; thermochemical calorie,
/// conventional millimetre of mercury, Julian year of 365.25 days, and the light-year made of it (IAU). A revolution per minute is an
/// angular velocity, 2 pi rad in 60 s. The pound-force of psi is 0.453 592 37 kg times 9.806 65 m/s^2, the mile of mph 1609.344 m (NIST
/// SP 811, 2008, appendix B).
#[rustfmt::skip]
const SYMBOLS: &[Symbol] = &[
    symbol("m",   [0, 1, 0, 0, 0, 0, 0], Scale::ONE, true),
    symbol("g",   [1, 0, 0, 0, 0, 0, 0], Scale::decimal(1, -3), true),
    symbol("s",   [0, 0, 1, 0, 0, 0, 0], Scale::ONE, true),
    symbol("A",   [0, 0, 0, 1, 0, 0, 0], Scale::ONE, true),
    symbol("K",   [0, 0, 0, 0, 1, 0, 0], Scale::ONE, true),
    symbol("mol", [0, 0, 0, 0, 0, 1, 0], Scale::ONE, true),
    symbol("cd",  [0, 0, 0, 0, 0, 0, 1], Scale::ONE, true),
    symbol("Hz",  [0, 0, -1, 0, 0, 0, 0], Scale::ONE, true),
    symbol("N",   [1, 1, -2, 0, 0, 0, 0], Scale::ONE, true),
    symbol("Pa",  [1, -1, -2, 0, 0, 0, 0], Scale::ONE, true),
    symbol("J",   [1, 2, -2, 0, 0, 0, 0], Scale::ONE, true),
    symbol("W",   [1, 2, -3, 0, 0, 0, 0], Scale::ONE, true),
    symbol("C",   [0, 0, 1, 1, 0, 0, 0], Scale::ONE, true),
    symbol("V",   [1, 2, -3, -1, 0, 0, 0], Scale::ONE, true),
    symbol("ohm", [1, 2, -3, -2, 0, 0, 0], Scale::ONE, true),
    symbol("Ω",   [1, 2, -3, -2, 0, 0, 0], Scale::ONE, true),
    symbol("S",   [-1, -2, 3, 2, 0, 0, 0], Scale::ONE, true),
    symbol("F",   [-1, -2, 4, 2, 0, 0, 0], Scale::ONE, true),
    symbol("Wb",  [1, 2, -2, -1, 0, 0, 0], Scale::ONE, true),
    symbol("T",   [1, 0, -2, -1, 0, 0, 0], Scale::ONE, true),
    symbol("H",   [1, 2, -2, -2, 0, 0, 0], Scale::ONE, true),
    symbol("Bq",  [0, 0, -1, 0, 0, 0, 0], Scale::ONE, true),
    symbol("Gy",  [0, 2, -2, 0, 0, 0, 0], Scale::ONE, true),
    symbol("Sv",  [0, 2, -2, 0, 0, 0, 0], Scale::ONE, true),
    symbol("kat", [0, 0, -1, 0, 0, 1, 0], Scale::ONE, true),
    symbol("rad", [0; 7], Scale::ONE, true),
    symbol("deg", [0; 7], Scale::irrational(PI, 1, 180), false),
    symbol("°",   [0; 7], Scale::irrational(PI, 1, 180), false),
    symbol("%",   [0; 7], Scale::decimal(1, -2), false),
    symbol("ppm", [0; 7], Scale::decimal(1, -6), false),
    symbol("min", [0, 0, 1, 0, 0, 0, 0], Scale::decimal(60, 0), false),
    symbol("h",   [0, 0, 1, 0, 0, 0, 0], Scale::decimal(3600, 0), false),
    symbol("d",   [0, 0, 1, 0, 0, 0, 0], Scale::decimal(86_400, 0), false),
    symbol("week", [0, 0, 1, 0, 0, 0, 0], Scale::decimal(604_800, 0), false),
    symbol("yr",  [0, 0, 1, 0, 0, 0, 0], Scale::decimal(31_557_600, 0), false),
    symbol("year", [0, 0, 1, 0, 0, 0, 0], Scale::decimal(31_557_600, 0), false),
    symbol("rpm", [0, 0, -1, 0, 0, 0, 0], Scale::irrational(PI, 1, 30), false),
    symbol("dps", [0, 0, -1, 0, 0, 0, 0], Scale::irrational(PI, 1, 180), true),
    symbol("mph", [0, 1, -1, 0, 0, 0, 0], Scale::decimal(44_704, -5), false),
    symbol("ly",  [0, 1, 0, 0, 0, 0, 0], Scale::decimal(9_460_730_472_580_800, 0), true),
    symbol("au",  [0, 1, 0, 0, 0, 0, 0], Scale::decimal(149_597_870_700, 0), false),
    symbol("u",   [1, 0, 0, 0, 0, 0, 0], Scale::decimal(166_053_906_660, -38), false),
    symbol("M",   [0, -3, 0, 0, 0, 1, 0], Scale::decimal(1, 3), true),
    symbol("L",   [0, 3, 0, 0, 0, 0, 0], Scale::decimal(1, -3), true),
    symbol("l",   [0, 3, 0, 0, 0, 0, 0], Scale::decimal(1, -3), true),
    symbol("t",   [1, 0, 0, 0, 0, 0, 0], Scale::decimal(1, 3), false),
    symbol("Å",   [0, 1, 0, 0, 0, 0, 0], Scale::decimal(1, -10), false),
    symbol("bar", [1, -1, -2, 0, 0, 0, 0], Scale::decimal(1, 5), true),
    symbol("atm", [1, -1, -2, 0, 0, 0, 0], Scale::decimal(101_325, 0), false),
    symbol("psi", [1, -1, -2, 0, 0, 0, 0], Scale::fraction(44_482_216_152_605, 6_451_600_000), false),
    symbol("mmHg", [1, -1, -2, 0, 0, 0, 0], Scale::decimal(133_322_387_415, -9), false),
    symbol("P",   [1, -1, -1, 0, 0, 0, 0], Scale::decimal(1, -1), true),
    symbol("St",  [0, 2, -1, 0, 0, 0, 0], Scale::decimal(1, -4), true),
    symbol("dyn", [1, 1, -2, 0, 0, 0, 0], Scale::decimal(1, -5), false),
    symbol("erg", [1, 2, -2, 0, 0, 0, 0], Scale::decimal(1, -7), false),
    symbol("Wh",  [1, 2, -2, 0, 0, 0, 0], Scale::decimal(3600, 0), true),
    symbol("Ah",  [0, 0, 1, 1, 0, 0, 0], Scale::decimal(3600, 0), true),
    symbol("cal", [1, 2, -2, 0, 0, 0, 0], Scale::decimal(4184, -3), true),
    symbol("in",  [0, 1, 0, 0, 0, 0, 0], Scale::decimal(254, -4), false),
    symbol("ft",  [0, 1, 0, 0, 0, 0, 0], Scale::decimal(3048, -4), false),
    symbol("lm",  [0, 0, 0, 0, 0, 0, 1], Scale::ONE, true),
    symbol("lx",  [0, -2, 0, 0, 0, 0, 1], Scale::ONE, true),
    symbol("G",   [1, 0, -2, -1, 0, 0, 0], Scale::decimal(1, -4), true),
    symbol("eV",  [1, 2, -2, 0, 0, 0, 0], Scale::decimal(1_602_176_634, -28), true),
    Symbol { text: "px", dimension: Base::Pixel, scale: Scale::ONE, prefixes: false },
];

/// Symbols of temperature scales with a zero of their own, and the size of their degree in kelvin. They are units only where a
/// difference must be meant: in a product, a quotient or a power.
const DEGREES: &[(&str, Scale)] = &[
    ("degC", Scale::ONE),
    ("°C", Scale::ONE),
    ("℃", Scale::ONE),
    ("degF", Scale::fraction(5, 9)),
    ("°F", Scale::fraction(5, 9)),
    ("℉", Scale::fraction(5, 9)),
];

/// Prefixes and their powers of ten; `da` precedes `d` so that the longer one is tried first.
const PREFIXES: &[(&str, i32)] = &[
    ("da", 1),
    ("Y", 24),
    ("Z", 21),
    ("E", 18),
    ("P", 15),
    ("T", 12),
    ("G", 9),
    ("M", 6),
    ("k", 3),
    ("h", 2),
    ("d", -1),
    ("c", -2),
    ("m", -3),
    ("µ", -6),
    ("u", -6),
    ("n", -9),
    ("p", -12),
    ("f", -15),
    ("a", -18),
    ("z", -21),
    ("y", -24),
];

/// Common names of units, and the symbol of each.
const OTHER_NAMES: &[(&str, &str)] = &[
    ("meter", "m"),
    ("metre", "m"),
    ("mts", "m"),
    ("centimeter", "cm"),
    ("centimetre", "cm"),
    ("millimeter", "mm"),
    ("millimetre", "mm"),
    ("kilometer", "km"),
    ("kilometre", "km"),
    ("micron", "µm"),
    ("angstrom", "Å"),
    ("cc", "cm^3"),
    ("gram", "g"),
    ("gr", "g"),
    ("gm", "g"),
    ("kilo", "kg"),
    ("kilogram", "kg"),
    ("kgs", "kg"),
    ("ton", "t"),
    ("tonne", "t"),
    ("second", "s"),
    ("sec", "s"),
    ("seg", "s"),
    ("minute", "min"),
    ("hour", "h"),
    ("hr", "h"),
    ("day", "d"),
    ("dia", "d"),
    ("día", "d"),
    ("hora", "h"),
    ("minuto", "min"),
    ("segundo", "s"),
    ("wk", "week"),
    ("semana", "week"),
    ("a", "yr"),
    ("y", "yr"),
    ("año", "yr"),
    ("annum", "yr"),
    ("ua", "au"),
    ("dalton", "u"),
    ("da", "u"),
    ("amu", "u"),
    ("uma", "u"),
    ("molar", "M"),
    ("metro", "m"),
    ("gramo", "g"),
    ("kilogramo", "kg"),
    ("litro", "L"),
    ("grado", "deg"),
    ("radián", "rad"),
    ("radiane", "rad"),
    ("kph", "km/h"),
    ("kmh", "km/h"),
    ("mps", "m/s"),
    ("ampere", "A"),
    ("amp", "A"),
    ("kelvin", "K"),
    ("mole", "mol"),
    ("candela", "cd"),
    ("hertz", "Hz"),
    ("newton", "N"),
    ("pascal", "Pa"),
    ("joule", "J"),
    ("watt", "W"),
    ("coulomb", "C"),
    ("ohm", "ohm"),
    ("volt", "V"),
    ("siemens", "S"),
    ("farad", "F"),
    ("weber", "Wb"),
    ("tesla", "T"),
    ("henry", "H"),
    ("radian", "rad"),
    ("degree", "deg"),
    ("percent", "%"),
    ("liter", "L"),
    ("litre", "L"),
    ("poise", "P"),
    ("stokes", "St"),
    ("centistokes", "cSt"),
    ("torr", "mmHg"),
    ("dyne", "dyn"),
    ("calorie", "cal"),
    ("inch", "in"),
    ("inche", "in"),
    ("foot", "ft"),
    ("feet", "ft"),
    ("lumen", "lm"),
    ("lux", "lx"),
    ("gauss", "G"),
    ("becquerel", "Bq"),
    ("gray", "Gy"),
    ("sievert", "Sv"),
    ("katal", "kat"),
    ("lightyear", "ly"),
];

/// The symbol of `text` and the power of ten of its prefix. A symbol without prefix takes precedence: `min` is a minute,
/// `cd` a candela, `Pa` a pascal.
pub(crate) fn find(text: &str) -> Option<(&'static Symbol, i32)> {
    if let Some(symbol) = SYMBOLS.iter().find(|symbol| symbol.text == text) {
        return Some((symbol, 0));
    }
    PREFIXES.iter().find_map(|(prefix, tens)| {
        let rest = text.strip_prefix(prefix)?;
        let symbol = SYMBOLS.iter().find(|symbol| symbol.prefixes && symbol.text == rest)?;
        Some((symbol, *tens))
    })
}

/// Size of a degree of a temperature scale in kelvin; `None` for another text.
pub(crate) fn degree(text: &str) -> Option<Scale> {
    DEGREES.iter().find(|(known, _)| *known == text).map(|(_, scale)| *scale)
}

/// The unit probably meant by an unknown `text`, if any.
pub(crate) fn near(text: &str) -> Option<String> {
    let lower = text.to_ascii_lowercase();
    let singular = lower.strip_suffix('s').unwrap_or(&lower);
    let named = OTHER_NAMES.iter().find(|(name, _)| *name == lower || *name == singular);
    if let Some((_, symbol)) = named {
        return Some((*symbol).to_owned());
    }
    // Wrong case only: `Kg`, `HZ`.
    let alike = |prefixes: &[&str]| {
        let prefixed = |prefix: &&str| {
            let symbols = SYMBOLS.iter().filter(|symbol| symbol.prefixes || prefix.is_empty());
            let mut texts = symbols.map(|symbol| format!("{prefix}{}", symbol.text));
            texts.find(|candidate| candidate.eq_ignore_ascii_case(text))
        };
        prefixes.iter().find_map(prefixed)
    };
    alike(&["", "k", "c", "m", "h"]).or_else(|| together(text)).or_else(|| alike(&["µ", "M", "n", "G"]))
}

/// Splits joined symbols: `N m` for `Nm`, `Pa s` for `Pas`, `kV A` for `kVA`.
fn together(text: &str) -> Option<String> {
    let usual = |part: &str| find(part).is_some_and(|(_, tens)| matches!(tens, 0 | 3));
    text.char_indices().skip(1).find_map(|(at, _)| {
        let (first, second) = text.split_at(at);
        (usual(first) && usual(second)).then(|| format!("{first} {second}"))
    })
}

/// Names of SI units by dimension, used where no unit is stated.
pub(crate) const PREFERRED: &[&str] = &[
    "N", "Pa", "J", "W", "C", "V", "ohm", "F", "Wb", "T", "H", "Pa s", "N/m", "V/m", "J/K", "W/m^2", "J/(kg K)",
    "W/(m K)",
];

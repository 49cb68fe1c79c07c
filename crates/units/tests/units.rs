//! Units as typed: meaning, conversion, printing, and errors.

use proptest::prelude::*;
use std::f64::consts::TAU;
use units::{Dimension, Exponent, Unit};

#[allow(clippy::panic, reason = "a test's way to fail")]
fn unit(text: &str) -> Unit {
    Unit::parse(text).unwrap_or_else(|error| panic!("{text}: {error}"))
}

#[test]
fn symbols_have_their_dimension_and_value() {
    for (text, dimension, factor) in [
        ("m", "m", 1.0),
        ("kg", "kg", 1.0),
        ("g", "kg", 1e-3),
        ("mg", "kg", 1e-6),
        ("t", "kg", 1e3),
        ("cm", "m", 1e-2),
        ("mm", "m", 1e-3),
        ("km", "m", 1e3),
        ("dm", "m", 1e-1),
        ("dam", "m", 10.0),
        ("µm", "m", 1e-6),
        ("μm", "m", 1e-6),
        ("um", "m", 1e-6),
        ("Å", "m", 1e-10),
        ("min", "s", 60.0),
        ("h", "s", 3600.0),
        ("d", "s", 86400.0),
        ("ms", "s", 1e-3),
        ("Hz", "s^-1", 1.0),
        ("kHz", "s^-1", 1e3),
        ("N", "kg m s^-2", 1.0),
        ("Pa", "kg m^-1 s^-2", 1.0),
        ("hPa", "kg m^-1 s^-2", 100.0),
        ("mbar", "kg m^-1 s^-2", 100.0),
        ("atm", "kg m^-1 s^-2", 101_325.0),
        ("mmHg", "kg m^-1 s^-2", 133.322387415),
        ("J", "kg m^2 s^-2", 1.0),
        ("kcal", "kg m^2 s^-2", 4184.0),
        ("eV", "kg m^2 s^-2", 1.602176634e-19),
        ("px", "px", 1.0),
        ("px/s", "s^-1 px", 1.0),
        ("W", "kg m^2 s^-3", 1.0),
        ("V", "kg m^2 s^-3 A^-1", 1.0),
        ("ohm", "kg m^2 s^-3 A^-2", 1.0),
        ("kΩ", "kg m^2 s^-3 A^-2", 1e3),
        ("mT", "kg s^-2 A^-1", 1e-3),
        ("mol", "mol", 1.0),
        ("cd", "cd", 1.0),
        ("L", "m^3", 1e-3),
        ("mL", "m^3", 1e-6),
        ("P", "kg m^-1 s^-1", 0.1),
        ("cP", "kg m^-1 s^-1", 1e-3),
        ("St", "m^2 s^-1", 1e-4),
        ("cSt", "m^2 s^-1", 1e-6),
        ("dyn/cm", "kg s^-2", 1e-3),
        ("rad", "1", 1.0),
        ("deg", "1", std::f64::consts::PI / 180.0),
        ("%", "1", 0.01),
        ("", "1", 1.0),
        ("1", "1", 1.0),
    ] {
        let unit = unit(text);
        assert_eq!(unit.dimension.to_string(), dimension, "{text}");
        assert!((unit.factor / factor - 1.0).abs() < 1e-15, "{text}: {}", unit.factor);
    }
}

#[test]
fn products_quotients_and_powers_are_read_and_written_one_way() {
    for (text, written, dimension) in [
        ("kg/m^3", "kg/m^3", "kg m^-3"),
        (" kg / m ^3 ", "kg/m^3", "kg m^-3"),
        ("kg/m³", "kg/m^3", "kg m^-3"),
        ("kg*m^2", "kg m^2", "kg m^2"),
        ("kg·m²", "kg m^2", "kg m^2"),
        ("Pa  s", "Pa s", "kg m^-1 s^-1"),
        ("m s^-1", "m s^-1", "m s^-1"),
        ("m s⁻¹", "m s^-1", "m s^-1"),
        ("m s^−1", "m s^-1", "m s^-1"),
        ("1/s", "1/s", "s^-1"),
        ("1/(m s)", "1/(m s)", "m^-1 s^-1"),
        ("J/(kg K)", "J/(kg K)", "m^2 s^-2 K^-1"),
        ("J/(kg*K)", "J/(kg K)", "m^2 s^-2 K^-1"),
        ("(m/s)^2", "(m/s)^2", "m^2 s^-2"),
        ("(m/s) kg", "(m/s) kg", "kg m s^-1"),
        ("m^(1/2)", "m^(1/2)", "m^(1/2)"),
        ("m^(-1/2)", "m^(-1/2)", "m^(-1/2)"),
        ("m^(2/4)", "m^(1/2)", "m^(1/2)"),
        ("km/h", "km/h", "m s^-1"),
        ("1/(m^(1/2) s)", "1/(m^(1/2) s)", "m^(-1/2) s^-1"),
        ("((m/s)) (m/s)", "(m/s) (m/s)", "m^2 s^-2"),
        ("(m^2)^3", "(m^2)^3", "m^6"),
        ("μm", "µm", "m"),
        ("kohm", "kohm", "kg m^2 s^-3 A^-2"),
        ("1", "", "1"),
    ] {
        let unit = unit(text);
        assert_eq!(unit.to_string(), written, "{text}");
        assert_eq!(unit.dimension.to_string(), dimension, "{text}");
        assert_eq!(Unit::parse(written), Ok(unit), "{text}: what is written reads back");
    }
}

#[test]
fn conversions_are_exact_where_they_can_be() {
    for (text, value, si) in [
        ("cm", 40.0, 0.4),
        ("cm", 2.5, 0.025),
        ("mm", 7.0, 0.007),
        ("cm", 29.0, 0.29),
        ("cm", 57.0, 0.57),
        ("m/s^2", 9.8, 9.8),
        ("g", 13.6, 0.0136),
        ("g/cm^3", 13.6, 13600.0),
        ("g/cm^3", 0.789, 789.0),
        ("km/h", 36.0, 10.0),
        ("km/h", 90.0, 25.0),
        ("cm^2", 500.0, 0.05),
        ("%", 5.0, 0.05),
        ("cSt", 1.004, 1.004e-6),
        ("mPa s", 1.002, 0.001002),
        ("min", 1.5, 90.0),
        ("mmHg", 760.0, 101_325.014_435_4),
        ("1/min", 90.0, 1.5),
        ("mL", 250.0, 0.00025),
        ("deg", 180.0, std::f64::consts::PI),
    ] {
        let unit = unit(text);
        assert_eq!(unit.to_si(value), si, "{value} {text}");
        assert_eq!(unit.from_si(si), value, "{si} in {text}");
        assert_eq!(unit.from_si(unit.to_si(-value)), -value, "-{value} {text}");
    }
    assert_eq!(unit("cm").from_si(0.0), 0.0);
    assert!(unit("cm").from_si(f64::NAN).is_nan());
    assert_eq!(unit("cm").from_si(f64::INFINITY), f64::INFINITY);
}

#[test]
fn si_units_are_named_as_people_name_them() {
    for (text, expected) in [
        ("kg m/s^2", "N"),
        ("N/m^2", "Pa"),
        ("N m", "J"),
        ("J/s", "W"),
        ("kg/(m s)", "Pa s"),
        ("kg/s^2", "N/m"),
        ("kg/s", "kg/s"),
        ("m/s", "m/s"),
        ("cm", "m"),
        ("1/s^2", "1/s^2"),
        ("1/(m s)", "1/(m s)"),
        ("kg/m^3", "kg/m^3"),
        ("m^(1/2)/s", "m^(1/2)/s"),
        ("deg", ""),
    ] {
        let si = Unit::si(unit(text).dimension);
        assert_eq!(si.text, expected, "{text}");
        assert_eq!(si.factor, 1.0);
    }
    assert!(Unit::dimensionless().dimension.is_none());
}

#[test]
fn what_is_refused_is_refused_with_the_reason() {
    for (text, code, place, message, hint) in [
        ("foo", "unknown-unit", "foo", "there is no unit `foo`", None),
        ("Kg", "unknown-unit", "Kg", "there is no unit `Kg`", Some("did you mean kg?")),
        ("HZ", "unknown-unit", "HZ", "there is no unit `HZ`", Some("did you mean Hz?")),
        ("meters", "unknown-unit", "meters", "there is no unit `meters`", Some("did you mean m?")),
        ("m/sec", "unknown-unit", "sec", "there is no unit `sec`", Some("did you mean s?")),
        ("Nm", "unknown-unit", "Nm", "there is no unit `Nm`", Some("did you mean N m?")),
        ("kVA", "unknown-unit", "kVA", "there is no unit `kVA`", Some("did you mean kV A?")),
        ("ohms", "unknown-unit", "ohms", "there is no unit `ohms`", Some("did you mean ohm?")),
        (
            "degC",
            "temperature-scale",
            "degC",
            "degC is a scale with a zero of its own, so it cannot be multiplied like a unit",
            Some(
                "give temperatures in [K] (20 degC is 293.15 [K]); a difference of 1 degC is 1 [K], as in [J/(kg degC)]",
            ),
        ),
        (
            "(ºC)",
            "temperature-scale",
            "(ºC)",
            "°C is a scale with a zero of its own, so it cannot be multiplied like a unit",
            Some(
                "give temperatures in [K] (20 degC is 293.15 [K]); a difference of 1 degC is 1 [K], as in [J/(kg degC)]",
            ),
        ),
        (
            "J/kg K",
            "ambiguous-unit",
            "/kg K",
            "it is not clear whether `K` is divided by or multiplied with",
            Some("write J/(kg K) or J K/kg"),
        ),
        (
            "J/(kg K) mol",
            "ambiguous-unit",
            "/(kg K) mol",
            "it is not clear whether `mol` is divided by or multiplied with",
            Some("write J/(kg K mol) or J mol/(kg K)"),
        ),
        (
            "1/m*s",
            "ambiguous-unit",
            "/m*s",
            "it is not clear whether `s` is divided by or multiplied with",
            Some("write 1/(m s) or s/m"),
        ),
        (
            "m/s/s",
            "ambiguous-unit",
            "/",
            "a unit has only one `/`",
            Some("put what is divided by into parentheses, such as J/(kg K), or use powers: m/s^2"),
        ),
        (
            "m2",
            "malformed-unit",
            "2",
            "a number cannot be part of a unit",
            Some("write the number before the bracket, and powers with ^, such as m^2"),
        ),
        ("m/", "malformed-unit", "", "the unit ends where a unit symbol should follow", None),
        ("m/s*", "malformed-unit", "", "the unit ends where a unit symbol should follow", None),
        ("(m", "malformed-unit", "(", "this `(` is not closed", None),
        ("m)", "malformed-unit", ")", "this `)` closes nothing", None),
        ("m+s", "malformed-unit", "+", "`+` cannot be part of a unit", None),
        (
            "m^x",
            "malformed-unit",
            "^x",
            "an exponent is a whole number or a fraction in parentheses",
            Some("such as m^2, s^-1 or m^(1/2)"),
        ),
        ("m^9999", "malformed-unit", "^9999", "an exponent of this unit is too large", None),
        (
            "m^99999999999999999999",
            "malformed-unit",
            "^99999999999999999999",
            "an exponent of this unit is too large",
            None,
        ),
        ("km^300", "malformed-unit", "km^300", "this unit is too large or too small for a number", None),
    ] {
        let error = Unit::parse(text).expect_err(text);
        assert_eq!((error.code, &text[error.range.clone()]), (code, place), "{text}");
        assert_eq!(
            (&*error.message.english(), error.hint.as_ref().map(|hint| hint.english()).as_deref()),
            (message, hint),
            "{text}"
        );
    }
}

proptest! {
    #[test]
    fn any_text_is_read_or_refused_at_a_place_in_it(text in "\\PC{0,30}") {
        if let Err(error) = Unit::parse(&text) {
            prop_assert!(text.get(error.range).is_some());
        }
    }

    #[test]
    fn texts_that_look_like_units_read_back_as_they_are_written(text in "[mskgNPah1/ ()^2*·²-]{0,16}") {
        if let Ok(unit) = Unit::parse(&text) {
            prop_assert_eq!(Unit::parse(&unit.text), Ok(unit));
        }
    }

    #[test]
    fn usual_numbers_survive_the_way_to_si_and_back(
        digits in -999_999_i64..=999_999,
        places in 0_usize..=6,
        text in prop::sample::select(vec!["cm", "mm", "g", "km/h", "g/cm^3", "cSt", "min", "h", "L", "%", "deg", "mmHg", "µm", "kPa"]),
    ) {
        let scale = [1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6][places];
        let value = digits as f64 / scale;
        let unit = unit(text);
        prop_assert_eq!(unit.from_si(unit.to_si(value)), value);
    }

    #[test]
    fn every_dimension_has_an_si_unit_that_reads_back(exponents in prop::array::uniform7(-4_i8..=4), degree in 1_u32..=3) {
        let dimension = Dimension::from_whole(exponents).root(degree).unwrap();
        let si = Unit::si(dimension);
        prop_assert_eq!(si.dimension, dimension);
        prop_assert_eq!(Unit::parse(&si.text).map(|unit| unit.dimension), Ok(dimension));
    }

    #[test]
    fn fractions_are_recognised_as_exponents(numerator in -40_i64..=40, denominator in 1_i64..=12) {
        let value = numerator as f64 / denominator as f64;
        prop_assert_eq!(Exponent::from_number(value), Exponent::new(numerator, denominator));
    }
}

/// Units that count cycles, each with its factor to cycles per second, and units that count angles, each with its
/// factor to turns per second.
const CYCLES: [(&str, f64); 5] = [("Hz", 1.0), ("kHz", 1e3), ("mHz", 1e-3), ("MHz", 1e6), ("(Hz^2)^(1/2)", 1.0)];
const ANGLES: [(&str, f64); 9] = [
    ("rad/s", 1.0 / TAU),
    ("rad s^-1", 1.0 / TAU),
    ("mrad/s", 1e-3 / TAU),
    ("rad/min", 1.0 / TAU / 60.0),
    ("deg/s", 1.0 / 360.0),
    ("°/s", 1.0 / 360.0),
    ("deg/min", 1.0 / 21_600.0),
    ("rpm", 1.0 / 60.0),
    ("dps", 1.0 / 360.0),
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

//! Units of radiation, catalysis, astronomy and technology, and degrees of temperature in composed units.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by them")]

use units::Unit;

#[test]
fn they_have_their_dimension_and_value() {
    for (text, dimension, factor) in [
        ("Bq", "s^-1", 1.0),
        ("MBq", "s^-1", 1e6),
        ("mGy", "m^2 s^-2", 1e-3),
        ("µSv/h", "m^2 s^-3", 1e-6 / 3600.0),
        ("nkat", "s^-1 mol", 1e-9),
        ("ly", "m", 9.4607304725808e15),
        ("mph", "m s^-1", 0.44704),
        ("psi", "kg m^-1 s^-2", 6894.757293168361),
        ("kWh", "kg m^2 s^-2", 3.6e6),
        ("mAh", "s A", 3.6),
        ("ppm", "1", 1e-6),
        ("dps", "s^-1", std::f64::consts::PI / 180.0),
        ("J/(kg °C)", "m^2 s^-2 K^-1", 1.0),
        ("W/(m^2 degC)", "kg s^-3 K^-1", 1.0),
        ("°C/min", "s^-1 K", 1.0 / 60.0),
        ("1/degF", "K^-1", 1.8),
        ("K/degC", "1", 1.0),
    ] {
        let unit = Unit::parse(text).unwrap_or_else(|error| panic!("{text}: {error}"));
        assert_eq!(unit.dimension.to_string(), dimension, "{text}");
        assert!((unit.factor / factor - 1.0_f64).abs() < 1e-15, "{text}: {}", unit.factor);
    }
}

/// A temperature scale alone has a zero of its own, also in parentheses; in a product, quotient or power only a difference can be meant.
#[test]
fn degrees_of_temperature_are_units_of_differences_alone() {
    for text in ["degC", "°C", "℃", "degF", "°F", "℉", "(°C)", " degC "] {
        assert_eq!(Unit::parse(text).map_err(|error| error.code), Err("temperature-scale"), "{text}");
    }
    let kelvin = Unit::parse("J/K").unwrap().dimension;
    for text in ["J/°C", "J/℃", "J degC^-1", "J (°F)^-1"] {
        assert_eq!(Unit::parse(text).unwrap().dimension, kelvin, "{text}");
    }
}

#[test]
fn a_decimal_exponent_is_told_the_fraction() {
    let error = Unit::parse("m^0.5/s").unwrap_err();
    assert_eq!(
        (error.code, error.hint.unwrap().english().as_ref()),
        ("malformed-unit", "such as m^2, s^-1 or m^(1/2)")
    );
}

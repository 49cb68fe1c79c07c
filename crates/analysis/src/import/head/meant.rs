//! Unit of a text over a column, depending on its name: `C` over a temperature, `g` over an acceleration.

use super::unit_words::{self, Level};
use crate::conversion::UnitReading;
use crate::roles::is_time;
use units::{Dimension, Unit};

/// Unit, with the conversion of the numbers if there is one.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::import) struct Meant {
    pub unit: Unit,
    pub reading: Option<UnitReading>,
}

/// Unit of this text for a column of this name; `None` if it is unknown or ambiguous.
pub(in crate::import) fn unit(text: &str, name: &str) -> Option<Meant> {
    let text = text.trim();
    if let Some(level) = unit_words::level(text).or_else(|| letter_of_level(text, name)) {
        return temperature(level, name);
    }
    // A difference of temperatures in thousandths.
    if matches!(text, "m°C" | "m˚C" | "mºC" | "milli°C") {
        let unit = Unit::parse("mK").ok()?;
        return is_difference(name).then_some(Meant { unit, reading: None });
    }
    let plain = |text: &str| Some(Meant { unit: unit_words::read(text)?, reading: None });
    match text {
        "g" | "G" | "gs" | "g's" | "g_n" | "mg" if is_acceleration(name) => {
            let unit = Unit::parse("m/s^2").ok()?;
            return Some(Meant { unit, reading: Some(UnitReading::Gravity { thousandth: text == "mg" }) });
        }
        "g_n" | "gs" | "g's" => return None,
        "S" | "mS" | "SEC" if is_duration(name) && !is_time(name) => {
            let unit = Unit::parse(if text == "mS" { "ms" } else { "s" }).ok()?;
            return Some(Meant { unit, reading: Some(UnitReading::Seconds) });
        }
        "C" if !is_charge(name) => return None,
        "S" if !is_conductance(name) && !is_time(name) => return None,
        // Instruments print capitals: neither molar nor megametres.
        "M" | "MM" if !is_concentration(name) => {
            return if text == "MM" && !is_time(name) { plain("mm") } else { None };
        }
        "pH" if !is_letter(name, "L") => return None,
        "°K" | "ºK" => return plain("K"),
        _ => {}
    }
    let unit = unit_words::read(text)?;
    // Degrees over a temperature are not an angle, and the scale is not stated.
    if is_temperature(name) && unit.dimension.is_none() && Unit::parse("deg").is_ok_and(|deg| deg.factor == unit.factor)
    {
        return None;
    }
    if !is_time(name) || unit.dimension == Dimension::TIME {
        return Some(Meant { unit, reading: None });
    }
    // Over times, capitals do not select another unit: `MS` does not mean megasiemens.
    plain(&text.to_lowercase()).filter(|meant| meant.unit.dimension == Dimension::TIME)
}

/// Reads `C` and `F` over a temperature.
fn letter_of_level(text: &str, name: &str) -> Option<Level> {
    match text {
        "C" | "c" if is_temperature(name) => Some(Level::Celsius),
        "F" if is_temperature(name) => Some(Level::Fahrenheit),
        _ => None,
    }
}

fn temperature(level: Level, name: &str) -> Option<Meant> {
    let unit = Unit::parse("K").ok()?;
    let reading = match (level, is_difference(name)) {
        (Level::Celsius, false) => UnitReading::Celsius,
        (Level::Fahrenheit, false) => UnitReading::Fahrenheit,
        (Level::Celsius, true) => UnitReading::CelsiusDifference,
        (Level::Fahrenheit, true) => UnitReading::FahrenheitDifference,
    };
    Some(Meant { unit, reading: Some(reading) })
}

/// True if a name is this letter, alone or followed by an index: `T_room`, `T1`, `T amb`.
fn is_letter(name: &str, letter: &str) -> bool {
    let Some(rest) = name.strip_prefix(letter) else { return false };
    let index = rest.trim_start_matches(['_', '.', ' ', '{', '(']);
    rest.is_empty()
        || index.len() < rest.len()
        || rest.starts_with(|first: char| first.is_ascii_digit() || first == '₀')
}

fn has_word(name: &str, words: &[&str]) -> bool {
    let name = name.to_lowercase();
    words.iter().any(|word| name.contains(word))
}

fn is_temperature(name: &str) -> bool {
    let lower = name.to_lowercase();
    let short =
        lower == "temp" || lower.starts_with("temp ") || lower.starts_with("temp_") || lower.starts_with("temp.");
    let numbered =
        lower.strip_prefix("temp").is_some_and(|rest| rest.starts_with(|first: char| first.is_ascii_digit()));
    let letter = name.trim_start_matches(['Δ', '∆', 'd']);
    short
        || numbered
        || has_word(name, &["temperat", "thermo", "celsius"])
        || is_letter(letter, "T")
        || lower.ends_with(" temp")
}

fn is_difference(name: &str) -> bool {
    let begins = ["Δ", "∆", "dT", "σ", "u(", "±"].iter().any(|sign| name.starts_with(sign));
    begins
        || has_word(
            name,
            &[
                "delta",
                "differen",
                "diferen",
                "differenz",
                "sigma",
                "err",
                "uncert",
                "incert",
                "unsicher",
                "excess",
                "exceso",
                "rise",
                "std",
            ],
        )
}

fn is_acceleration(name: &str) -> bool {
    let lower = name.to_lowercase();
    let axis = ["a", "ax", "ay", "az", "|a|"].contains(&lower.as_str()) || is_letter(name, "a");
    axis || has_word(name, &["accel", "acel", "beschl", "g-force", "gforce", "fuerza g"]) || lower.starts_with("acc")
}

fn is_duration(name: &str) -> bool {
    is_time(name)
        || is_letter(name, "T")
        || is_letter(name, "t")
        || has_word(name, &["period", "durat", "duraci", "dauer", "interval", "time", "tiempo", "zeit", "τ", "tau"])
        || ["dt", "Δt", "∆t"].contains(&name)
}

fn is_charge(name: &str) -> bool {
    is_letter(name, "q") || is_letter(name, "Q") || has_word(name, &["charg", "carga", "ladung"])
}

fn is_concentration(name: &str) -> bool {
    is_letter(name, "c") || is_letter(name, "C") || name.starts_with('[') || has_word(name, &["conc", "konz", "molar"])
}

fn is_conductance(name: &str) -> bool {
    is_letter(name, "G") || is_letter(name, "Y") || has_word(name, &["conduct", "admit", "leitw", "leitf", "σ"])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_name_decides_between_units_of_one_letter() {
        use UnitReading::{Celsius, CelsiusDifference, Gravity, Seconds};
        for (text, name, expected, reading) in [
            ("C", "T", "K", Some(Celsius)),
            ("C", "Temperature 2", "K", Some(Celsius)),
            ("°C", "water", "K", Some(Celsius)),
            ("°C", "ΔT", "K", Some(CelsiusDifference)),
            ("C", "Q", "C", None),
            ("mC", "x", "mC", None),
            ("g", "a", "m/s^2", Some(Gravity { thousandth: false })),
            ("g", "Acceleration X", "m/s^2", Some(Gravity { thousandth: false })),
            ("g", "m", "g", None),
            ("g", "mass", "g", None),
            ("G", "B", "G", None),
            ("S", "T", "s", Some(Seconds)),
            ("S", "t", "s", None),
            ("mS", "G", "mS", None),
            ("deg", "phi", "deg", None),
        ] {
            let expected = Unit::parse(expected).expect("a unit");
            let found = unit(text, name).map(|meant| (meant.unit.dimension, meant.unit.factor, meant.reading));
            assert_eq!(found, Some((expected.dimension, expected.factor, reading)), "{name} ({text})");
        }
        for (text, name) in [("C", "x"), ("S", "x"), ("deg", "Temperature"), ("°", "T"), ("g's", "m")] {
            assert_eq!(unit(text, name), None, "{name} ({text})");
        }
    }
}

//! Words for units as written over columns: `msec`, `Sekunden`, `grados`, `m/s2`.

use units::Unit;

/// Symbols of units with the words used over columns by loggers and spreadsheets, in lower case and singular; an `s`, `n`
/// or `es` at the end is ignored. Documents must use the symbols.
const WORDS: [(&str, &[&str]); 62] = [
    ("s", &["sec", "second", "seg", "segundo", "sek", "sekunde", "seconde", "secondo", "secondi"]),
    (
        "ms",
        &[
            "msec",
            "mseg",
            "millisec",
            "millisecond",
            "milli",
            "miliseg",
            "milisegundo",
            "millisegundo",
            "msek",
            "millisekunde",
            "milliseconde",
            "millisecondo",
        ],
    ),
    ("µs", &["us", "μs", "usec", "µsec", "microsec", "microsecond", "micro", "microsegundo", "mikrosekunde"]),
    ("ns", &["nsec", "nanosec", "nanosecond", "nanosegundo", "nanosekunde"]),
    ("min", &["min", "minute", "minuto", "minuta"]),
    ("h", &["hr", "hour", "hora", "stunde", "std", "heure"]),
    ("d", &["day", "día", "dia", "tag", "tage", "jour"]),
    ("m", &["meter", "metre", "metro", "mètre", "mtr", "mt"]),
    ("cm", &["centimeter", "centimetre", "centímetro", "centimetro", "centimètre", "zentimeter"]),
    ("mm", &["millimeter", "millimetre", "milímetro", "milimetro", "millimètre"]),
    ("µm", &["um", "μm", "micron", "micrometer", "micrometre", "micrómetro", "micra", "mikrometer"]),
    ("km", &["kilometer", "kilometre", "kilómetro", "kilometro", "kilomètre"]),
    ("deg", &["º", "deg", "degree", "grado", "grad", "degré", "gradi"]),
    ("rad", &["rad", "radian", "radián", "radiane", "radiant", "radiano"]),
    ("g", &["gr", "gm", "gram", "gramm", "gramo", "gramme"]),
    ("kg", &["kg", "kilogram", "kilogramm", "kilogramo", "kilogramme", "kilo"]),
    ("V", &["volt", "voltio"]),
    ("mV", &["millivolt", "milivoltio", "milivolt"]),
    ("A", &["amp", "ampere", "ampère", "amperio"]),
    ("mA", &["milliamp", "milliampere", "miliamperio"]),
    ("N", &["newton"]),
    ("Hz", &["hertz", "hercio", "herz"]),
    ("Pa", &["pascal"]),
    ("J", &["joule", "julio"]),
    ("W", &["watt", "vatio"]),
    ("K", &["kelvin"]),
    ("L", &["liter", "litre", "litro"]),
    ("%", &["percent", "prozent", "por ciento", "porcentaje"]),
    ("T", &["tesla"]),
    ("ohm", &["ohmio", "Ω"]),
    ("px", &["pixel", "píxel", "pxl"]),
    ("in", &["inch", "inche", "zoll", "pulgada"]),
    ("ft", &["foot", "feet", "fuß"]),
    ("lx", &["lux", "luxe"]),
    ("lm", &["lumen"]),
    ("G", &["gauss"]),
    ("C", &["coulomb", "culombio"]),
    ("S", &["siemen"]),
    ("F", &["farad", "faradio"]),
    // `U/min` means revolutions too, not atomic mass units per minute.
    ("N m", &["newtonmeter", "newton meter", "newton metre"]),
    ("mmHg", &["torr"]),
    ("kW h", &["kwh"]),
    ("W h", &["wh"]),
    ("deg/s", &["dps"]),
    ("m/s", &["mps", "м/с"]),
    ("s", &["с", "сек", "секунда", "секунды"]),
    ("ms", &["мс", "мсек"]),
    ("µs", &["мкс"]),
    ("min", &["мин"]),
    ("h", &["ч", "час"]),
    ("m", &["м"]),
    ("cm", &["см"]),
    ("mm", &["мм"]),
    ("km", &["км"]),
    ("kg", &["кг"]),
    ("g", &["г"]),
    ("V", &["в"]),
    ("A", &["а"]),
    ("N", &["н"]),
    ("Hz", &["гц"]),
    ("Pa", &["па"]),
    ("rpm", &["rev/min", "r/min", "u/min", "upm", "r.p.m", "revolutions per minute"]),
];

/// Temperature scale with its own zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::import) enum Level {
    Celsius,
    Fahrenheit,
}

/// Temperature scale of this name: `°C`, `degC`, `grados Celsius`, `Fahrenheit`.
pub(in crate::import) fn level(text: &str) -> Option<Level> {
    let text: String = text.trim().to_lowercase().chars().filter(|letter| !letter.is_whitespace()).collect();
    let text = text.replace(['º', '˚'], "°").replace('℃', "°c").replace('℉', "°f").replace('с', "c");
    let text = if text == "oc" { "°c".to_owned() } else { text };
    let marked = ["degrees", "degree", "deg", "grados", "grado", "grad", "°"];
    let bare = marked.iter().find_map(|mark| text.strip_prefix(mark)).unwrap_or(&text);
    let has_mark = bare.len() < text.len();
    match bare.trim_start_matches('.') {
        "c" if has_mark => Some(Level::Celsius),
        "f" if has_mark => Some(Level::Fahrenheit),
        "celsius" | "c°" => Some(Level::Celsius),
        "fahrenheit" | "f°" => Some(Level::Fahrenheit),
        _ => None,
    }
}

/// Unit of this name; `None` if unknown. The empty text and `-` are dimensionless.
pub(in crate::import) fn read(text: &str) -> Option<Unit> {
    let text = text.trim().trim_matches('$').trim_end_matches('.');
    let upright = text.strip_prefix("\\mathrm{").and_then(|rest| rest.strip_suffix('}'));
    let text = upright.unwrap_or(text);
    // `A0` and `t0` have a name for a zero, no power.
    if text.ends_with('0') && text.chars().rev().nth(1).is_some_and(char::is_alphabetic) {
        return None;
    }
    // In a quotient, degrees are differences: `°C/min`. Alone they are a temperature scale.
    let kelvin =
        (text.contains(['°', 'º', '℃']) && text.contains(['/', ' ', '·', '*', '^', '⁻']) && level(text).is_none())
            .then(|| text.replace(['º'], "°").replace("°C", "K").replace('℃', "K"));
    let text = kelvin.as_deref().unwrap_or(text);
    if text.len() > 60 {
        return None;
    }
    if matches!(text, "-" | "–" | "—") {
        return Some(Unit::dimensionless());
    }
    // Torques are in newton metres, and no file of a laboratory states nanometres by a capital.
    if matches!(text, "Nm" | "N.m" | "N·m" | "N*m" | "N-m") {
        return Unit::parse("N m").ok();
    }
    if let Some(symbol) = word(text) {
        return Unit::parse(symbol).ok();
    }
    if let Ok(unit) = Unit::parse(text) {
        return Some(unit);
    }
    if let Some(symbol) = symbol(text) {
        return Unit::parse(symbol).ok();
    }
    // A point between letters multiplies: `cm.s^-1`.
    let dotted = text.contains('.') && !text.contains(|c: char| c.is_whitespace());
    let text = &if dotted { text.replace('.', " ") } else { text.to_owned() };
    let spelled = spelled(&text.replace(" per ", "/").replace(" por ", "/").replace(" pro ", "/"));
    Unit::parse(&spelled).ok().or_else(|| Unit::parse(&divided_twice(&spelled)?).ok())
}

/// Symbol of a word of at least three letters, which is not meant as a symbol: `Grad` is not a gigaradian.
fn word(text: &str) -> Option<&'static str> {
    (text.chars().count() >= 3).then(|| symbol(text)).flatten()
}

/// Symbol of a word.
fn symbol(word: &str) -> Option<&'static str> {
    let lower = word.to_lowercase();
    let known = |word: &str| WORDS.iter().find(|(_, words)| words.contains(&word)).map(|(symbol, _)| *symbol);
    known(&lower)
        .or_else(|| known(lower.strip_suffix("es")?))
        .or_else(|| known(lower.strip_suffix(['s', 'n'])?))
        // Capitals, as printed by instruments.
        .or(match word {
            "SEC" | "Sec" | "S" => Some("s"),
            "MS" | "mS" | "Ms" => Some("ms"),
            "CM" | "Cm" => Some("cm"),
            "MM" | "Mm" => Some("mm"),
            "DEG" | "Deg" => Some("deg"),
            "RAD" | "Rad" => Some("rad"),
            "MIN" | "Min" => Some("min"),
            "KG" | "Kg" => Some("kg"),
            "hz" | "HZ" => Some("Hz"),
            _ => None,
        })
}

/// Replaces words by symbols and adds a sign before each exponent: `m/sec2` becomes `m/s^2`.
fn spelled(text: &str) -> String {
    let mut spelled = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let letters = rest.find(|character: char| !character.is_alphabetic()).unwrap_or(rest.len());
        if letters == 0 {
            spelled.push(first);
            rest = &rest[first.len_utf8()..];
            continue;
        }
        let (part, behind) = rest.split_at(letters);
        let known = Unit::parse(part).is_ok();
        let other = word(part).or_else(|| symbol(part).filter(|_| !known));
        spelled.push_str(other.unwrap_or(part));
        // A digit or a minus sign after a letter begins an exponent.
        if behind.starts_with(|character: char| character.is_ascii_digit() || character == '-') {
            spelled.push('^');
        }
        rest = behind;
    }
    spelled
}

/// Rewrites `m/s/s` as `m/(s s)`.
fn divided_twice(text: &str) -> Option<String> {
    let mut parts = text.split('/');
    let (above, first, second) = (parts.next()?, parts.next()?, parts.next()?);
    parts.next().is_none().then(|| format!("{above}/({first} {second})"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_known_by_many_words() {
        for (text, expected) in [
            ("msec", "ms"),
            ("milliseconds", "ms"),
            ("Millisekunden", "ms"),
            ("milisegundos", "ms"),
            ("seg.", "s"),
            ("Sekunden", "s"),
            ("Sec", "s"),
            ("MIN", "min"),
            ("minutos", "min"),
            ("Stunden", "h"),
            ("grados", "deg"),
            ("Grad", "deg"),
            ("mins", "min"),
            ("º", "deg"),
            ("radianes", "rad"),
            ("metros", "m"),
            ("m/s2", "m/s^2"),
            ("m/s/s", "m/s^2"),
            ("cm/sec", "cm/s"),
            ("metros por segundo", "m/s"),
            ("rad/seg", "rad/s"),
            ("s-1", "1/s"),
            ("µs", "us"),
            ("μs", "us"),
            ("", ""),
            ("-", ""),
            ("inches", "in"),
            ("feet", "ft"),
            ("Pulgadas", "in"),
            ("lux", "lx"),
            ("W/(m² °C)", "W/(m^2 K)"),
            ("°C/min", "K/min"),
        ] {
            let (unit, expected) = (read(text), Unit::parse(expected).expect("a unit"));
            let found = unit.map(|unit| (unit.dimension, unit.factor));
            assert_eq!(found, Some((expected.dimension, expected.factor)), "{text}");
        }
        for text in ["blips", "left", "ticks", "a.u.", "°C", "of the year", "y"] {
            assert!(read(text).is_none(), "{text}");
        }
        for text in ["°C", "º C", "degC", "Celsius", "grados Celsius", "℃", "Grad C", "C°", "deg. C"] {
            assert_eq!(level(text), Some(Level::Celsius), "{text}");
        }
        for text in ["C", "F", "cm", "deg", "°", "K", "gradc m"] {
            assert_eq!(level(text), None, "{text}");
        }
    }
}

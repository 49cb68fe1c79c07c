//! Texts of findings with several variants.

use crate::sampling::Gap;
use units::Language::{self, English, Spanish};
use units::number;

/// Readings of `1,295` as a decimal number and with groups of digits: `1.295` and `1295`.
pub(crate) fn readings(text: &str, language: Language) -> [String; 2] {
    let digits = |replacement: &str| text.replace([',', '.'], replacement);
    [digits(if language == Spanish { "," } else { "." }), digits("")]
}

pub(super) fn separator(line: usize, text: &str, beside: &str, thousands: bool, language: Language) -> String {
    let [decimal, large] = readings(text, language);
    let (taken, other) = if thousands { (large, decimal) } else { (decimal, large) };
    if language == Spanish {
        format!(
            "línea {line}: «{text}» se lee como {taken} y no como {other}, pues en la misma columna está «{beside}»"
        )
    } else {
        format!("line {line}: `{text}` is read as {taken} and not as {other}, as `{beside}` stands in the same column")
    }
}

pub(super) fn clock(column: &str, days: bool, wrapped: usize, minutes: bool, language: Language) -> String {
    let column = called(column, language);
    let mut text = match (days, language) {
        (false, English) => format!("{column} holds clock times; they are read as seconds from the first row"),
        (false, Spanish) => format!("{column} contiene horas; se leen como segundos desde la primera fila"),
        (true, English) => format!("{column} holds dates; they are read as seconds from the first row"),
        (true, Spanish) => format!("{column} contiene fechas; se leen como segundos desde la primera fila"),
    };
    if wrapped > 0 {
        text.push_str(&if language == Spanish {
            format!(", y el reloj volvió a cero {wrapped}×")
        } else {
            format!(", and the clock began again at zero {wrapped}×")
        });
    }
    if minutes {
        text.push_str(if language == Spanish {
            "; «12:30» se toma como 12 minutos y 30 segundos: si son horas y minutos, indícalo en el encabezado, «t [hh:mm]»"
        } else {
            "; `12:30` is taken for 12 minutes and 30 seconds: if these are hours and minutes, say so in the header, `t [hh:mm]`"
        });
    }
    text
}

pub(super) fn runs(names: &[String], language: Language) -> String {
    const SHOWN: usize = 8;
    let mut list = names.iter().take(SHOWN).cloned().collect::<Vec<_>>().join(", ");
    if names.len() > SHOWN {
        list.push_str(", …");
    }
    let count = names.len();
    let name = names.last().map_or("", String::as_str);
    if language == Spanish {
        format!("hay {count} series con su propio reloj: {list}; una columna se nombra con la suya, «{name}.y»")
    } else {
        format!("there are {count} runs, each with its own clock: {list}; a column is named with its run, `{name}.y`")
    }
}

pub(super) fn missing(gaps: &[Gap], unit: &str, language: Language) -> String {
    let count: u64 = gaps.iter().map(|gap| gap.last - gap.first + 1).sum();
    let mut text = match (count, language) {
        (1, English) => "1 frame is missing: ".to_owned(),
        (1, Spanish) => "falta 1 fotograma: ".to_owned(),
        (_, English) => format!("{count} frames are missing: "),
        (_, Spanish) => format!("faltan {count} fotogramas: "),
    };
    const SHOWN: usize = 5;
    for (index, gap) in gaps.iter().take(SHOWN).enumerate() {
        let (after, before) = (reading(gap.after, unit, language), reading(gap.before, unit, language));
        text.push_str(if index > 0 { "; " } else { "" });
        text.push_str(&match (gap.first == gap.last, language) {
            (true, English) => format!("number {} (between {after} and {before})", gap.first),
            (true, Spanish) => format!("el {} (entre {after} y {before})", gap.first),
            (false, English) => format!("{} to {} (between {after} and {before})", gap.first, gap.last),
            (false, Spanish) => format!("del {} al {} (entre {after} y {before})", gap.first, gap.last),
        });
    }
    if gaps.len() > SHOWN {
        text.push_str(if language == Spanish { "; y otros" } else { "; and others" });
    }
    text
}

pub(super) fn backwards(time: f64, unit: &str, count: usize, language: Language) -> String {
    let time = reading(time, unit, language);
    match (count, language) {
        (1, English) => format!(
            "the rows are not in the order of time: the row at {time} is earlier than the row before; fits and cycles sort the rows by time, so divide the file there if the clock began again"
        ),
        (1, Spanish) => format!(
            "las filas no siguen el orden del tiempo: la fila en {time} es anterior a la precedente; los ajustes y los ciclos ordenan las filas por tiempo, así que divide ahí el archivo si el reloj volvió a empezar"
        ),
        (_, English) => format!(
            "the rows are not in the order of time: {count} are earlier than the row before, the first at {time}; fits and cycles sort them by time"
        ),
        (_, Spanish) => format!(
            "las filas no siguen el orden del tiempo: {count} son anteriores a la precedente, la primera en {time}; los ajustes y los ciclos las ordenan por tiempo"
        ),
    }
}

/// Text for a cell that became a gap: a number beyond the range of doubles, or not a number.
pub(super) fn word(line: usize, column: &str, text: &str, language: Language) -> String {
    let has_digit = text.contains(|character: char| character.is_ascii_digit());
    let too_large = has_digit && text.replace(',', ".").parse::<f64>().is_ok_and(f64::is_infinite);
    match (too_large, language) {
        (true, English) => format!(
            "line {line}, column {column}: `{text}` is beyond the range of numbers here, ±1.8e308, and became a gap"
        ),
        (true, Spanish) => format!(
            "línea {line}, columna {column}: «{text}» está fuera del intervalo de los números aquí, ±1,8e308, y quedó como hueco"
        ),
        (false, English) => format!("line {line}, column {column}: `{text}` is not a number and became a gap"),
        (false, Spanish) => format!("línea {line}, columna {column}: «{text}» no es un número y quedó como hueco"),
    }
}

pub(super) fn rounded_step(interval: f64, rate: f64, language: Language) -> String {
    let error = interval * rate - 1.0;
    let percent = decimal(100.0 * error.abs(), 2, language);
    let (step, rate) = (decimal(interval, 9, language), decimal(rate, 5, language));
    match (error < 0.0, language) {
        (true, English) => format!(
            "the time step {step} s looks like 1/{rate} s rounded: times are too short by {percent} %, frequencies too high"
        ),
        (false, English) => format!(
            "the time step {step} s looks like 1/{rate} s rounded: times are too long by {percent} %, frequencies too low"
        ),
        (true, Spanish) => format!(
            "el paso de tiempo {step} s parece 1/{rate} s redondeado: los tiempos son un {percent} % demasiado cortos y las frecuencias demasiado altas"
        ),
        (false, Spanish) => format!(
            "el paso de tiempo {step} s parece 1/{rate} s redondeado: los tiempos son un {percent} % demasiado largos y las frecuencias demasiado bajas"
        ),
    }
}

/// Column by its label, which is a number if the file gives no name.
pub(super) fn called(label: &str, language: Language) -> String {
    match (label.bytes().all(|byte| byte.is_ascii_digit()), language) {
        (true, English) => format!("column {label}"),
        (true, Spanish) => format!("la columna {label}"),
        (false, _) => label.to_owned(),
    }
}

/// Number with its unit.
pub(super) fn reading(value: f64, unit: &str, language: Language) -> String {
    let number = decimal(value, 6, language);
    if unit.is_empty() { number } else { format!("{number} {unit}") }
}

/// Number with this many significant digits, without trailing zeros.
pub(super) fn decimal(value: f64, digits: usize, language: Language) -> String {
    number::plain(value, digits, language.style())
}

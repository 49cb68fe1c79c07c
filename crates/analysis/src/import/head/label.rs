//! One cell of a header: name of a column, unit, and run.

use super::meant::{self, Meant};
use super::power::{self, Sense};
use super::unit_words;
use crate::conversion::UnitReading;
use crate::error_name;
use crate::import::clock;
use crate::origin::UnitOrigin;
use crate::roles::is_time;
use crate::run_name;
use units::{Dimension, Unit};

/// Content of a header cell.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::import) struct Label {
    pub name: String,
    pub unit: Option<Unit>,
    pub origin: UnitOrigin,
    /// Run, for example `Run 2`.
    pub run: Option<String>,
    /// Text after the unit, for example `(camera)`.
    pub behind: String,
    /// Meaning of its clock times, from a heading such as `t [hh:mm]`.
    pub clock: Option<clock::Form>,
    /// Conversion of the numbers to values in the unit; `None` if there is none.
    pub reading: Option<UnitReading>,
    /// Exponent of ten by which the number of a cell is multiplied to give the value in the unit, with its certainty.
    pub tens: Option<(i32, Sense)>,
}

/// Reads `y [cm]`, `Time (ms) Run #1`, `Run 2: Angle (deg)`, `t / s`, `t in ms`, `Time: ms`, `time_ms`, `v_{y}`.
pub(super) fn read(cell: &str) -> Label {
    let cell = unguarded(cell.trim());
    // Stamp of a serial monitor before the names.
    if clock::read(cell).is_some() {
        return Label::default();
    }
    let (rest, run) = run_name::without(cell);
    let Some(power) = power::taken(rest) else { return Label { run, ..plain_label(rest) } };
    let label = plain_label(&power.heading);
    // A power of ten over an unknown unit is unknown too.
    if power.sense == Sense::Open || label.origin.unknown().is_some() {
        let origin = UnitOrigin::Unknown(rest.chars().take(40).collect());
        return Label { run, unit: None, origin, reading: None, tens: Some((power.tens, Sense::Open)), ..label };
    }
    Label { run, tens: Some((power.tens, power.sense)), ..label }
}

/// Reads a cell without run and power of ten.
fn plain_label(rest: &str) -> Label {
    let mut label = bracketed(rest)
        .or_else(|| behind_word(rest))
        .or_else(|| divided(rest))
        .or_else(|| behind_colon(rest))
        .or_else(|| suffix(rest))
        .or_else(|| last_word(rest))
        .unwrap_or_else(|| own_name(rest));
    label.name = plain(&label.name);
    label
}

/// Name without the apostrophe that keeps spreadsheets from reading it as a formula: `'-x (m)`.
fn unguarded(cell: &str) -> &str {
    cell.strip_prefix('\'').filter(|rest| rest.starts_with(['=', '+', '-', '@'])).unwrap_or(cell)
}

/// Removes braces of an index: `v_{y}` becomes `v_y`.
fn plain(name: &str) -> String {
    name.trim().replace("_{", "_").replace('}', "")
}

/// Unit in a text without brackets; it must contain a letter: `Sensor: 1` has none.
fn symbol(text: &str, name: &str) -> Option<Meant> {
    let has_letter = text.contains(|character: char| character.is_alphabetic() || matches!(character, '%' | '°'));
    has_letter.then(|| meant::unit(text, name)).flatten()
}

fn named(name: &str, meant: Meant, origin: UnitOrigin) -> Label {
    Label { name: name.to_owned(), unit: Some(meant.unit), origin, reading: meant.reading, ..Label::default() }
}

fn unknown(name: &str, text: &str) -> Label {
    let text = text.chars().take(40).collect();
    Label { name: name.to_owned(), origin: UnitOrigin::Unknown(text), ..Label::default() }
}

/// Unit in brackets. With several brackets, the first one that holds a unit: `a(t) (m/s^2)`, `t [ms] (camera)`.
fn bracketed(cell: &str) -> Option<Label> {
    let mut last = None;
    let mut from = 0;
    while let Some((open, close)) = brackets(cell, from) {
        from = close;
        let (before, inside) = (&cell[..open], cell[open + 1..close].trim());
        let name = before.trim_end().trim_end_matches('/').trim_end();
        let inside = without_in(inside);
        // y(t) is a function of t, not y in tonnes.
        let function = cell[open..].starts_with('(') && before.ends_with(char::is_alphanumeric) && inside == "t";
        // u(y) is the error of y, not u in some unit.
        let attached = cell[open..].starts_with('(') && before.ends_with(char::is_alphanumeric);
        let of_error = attached && error_name::of(cell).is_some();
        if function || of_error || name.is_empty() || inside.is_empty() {
            continue;
        }
        if let Some(form) = clock_form(inside) {
            return Some(Label { name: name.to_owned(), clock: Some(form), ..Label::default() });
        }
        let behind = cell[close + 1..].trim().to_owned();
        if let Some(unit) = meant::unit(inside, name) {
            return Some(Label { behind, ..named(name, unit, UnitOrigin::Heading) });
        }
        // Parentheses may hold a remark, which belongs to the name if several columns have the same: `y (left)`.
        let remark = cell[open..].starts_with('(');
        last.get_or_insert_with(|| {
            let whole = attached && !looks_like_unit(inside);
            let mut label = unknown(if whole { cell } else { name }, inside);
            if remark && !whole {
                label.behind = cell[open..].trim().to_owned();
            }
            match label.origin {
                // `time (source1)` names a device and no unit; `t (ticks)` is in an unknown one.
                UnitOrigin::Unknown(text)
                    if remark && is_time(name) && text.ends_with(|last: char| last.is_ascii_digit()) =>
                {
                    Label { origin: UnitOrigin::default(), ..label }
                }
                UnitOrigin::Unknown(text) if remark && !is_time(name) && !looks_like_unit(&text) => {
                    Label { origin: UnitOrigin::Remark(text), ..label }
                }
                origin => Label { origin, ..label },
            }
        });
    }
    last
}

/// True if an unknown text in parentheses looks like a unit and not like a remark.
pub(super) fn looks_like_unit(text: &str) -> bool {
    const UNKNOWN: [&str; 20] = [
        "db",
        "dba",
        "dbv",
        "dbm",
        "ph",
        "ppm",
        "a.u.",
        "a. u.",
        "arb",
        "arb.",
        "arb. units",
        "u.a.",
        "counts",
        "cuentas",
        "ticks",
        "adc",
        "lsb",
        "sequence",
        "samples",
        "digits",
    ];
    let mark = |letter: char| matches!(letter, '°' | 'º' | '%' | '/' | '^' | '²' | '³' | '·' | '⁻' | 'µ' | 'Ω');
    UNKNOWN.contains(&text.to_lowercase().as_str())
        || text.contains(mark)
        || (text.chars().count() <= 3 && text.chars().all(char::is_alphabetic) && text.contains(char::is_uppercase))
}

/// Positions of the next opening and closing bracket, except those of `v_{y}`.
fn brackets(cell: &str, from: usize) -> Option<(usize, usize)> {
    let mut start = from;
    while let Some(open) = cell.get(start..)?.find(['[', '(', '<', '{']).map(|place| start + place) {
        let closing = match cell.as_bytes()[open] {
            b'[' => ']',
            b'(' => ')',
            b'<' => '>',
            _ => '}',
        };
        let index = closing == '}' && cell[..open].ends_with(['_', '^']);
        // For nested brackets, as in `W/(m K)`.
        let mut depth = 0_usize;
        let end = cell[open..].char_indices().find(|(_, character)| {
            depth += usize::from(*character == char::from(cell.as_bytes()[open]));
            depth -= usize::from(*character == closing);
            depth == 0
        });
        match end {
            Some((length, _)) if !index => return Some((open, open + length)),
            _ => start = open + 1,
        }
    }
    None
}

/// Returns `ms` for `in ms`, in English, Spanish and Portuguese.
fn without_in(text: &str) -> &str {
    ["in ", "en ", "em "].iter().find_map(|word| text.strip_prefix(word)).unwrap_or(text).trim()
}

/// Meaning of clock times from `hh:mm:ss`, `mm:ss` or `h:min`.
fn clock_form(text: &str) -> Option<clock::Form> {
    let text = text.to_lowercase();
    let parts: Vec<&str> = text.split(':').collect();
    let is = |part: &str, words: [&str; 3]| words.contains(&part);
    match parts.as_slice() {
        [hours, minutes, ..] if is(hours, ["h", "hh", "hour"]) && is(minutes, ["m", "mm", "min"]) => {
            Some(clock::Form::Hours)
        }
        [minutes, seconds] if is(minutes, ["m", "mm", "min"]) && seconds.starts_with('s') => Some(clock::Form::Minutes),
        _ => None,
    }
}

/// Reads `t/ms`, `y / mm`.
fn divided(cell: &str) -> Option<Label> {
    name_and_unit(cell.split_once('/')?)
}

/// Reads `t in ms`, `tiempo en segundos`.
fn behind_word(cell: &str) -> Option<Label> {
    name_and_unit([" in ", " en ", " em "].iter().find_map(|word| cell.rsplit_once(word))?)
}

/// Reads `Time: ms`.
fn behind_colon(cell: &str) -> Option<Label> {
    name_and_unit(cell.rsplit_once(':')?)
}

/// Label from a name and a separate text. A text that is not a unit counts as an unknown unit if the name is that of a
/// time.
fn name_and_unit((name, text): (&str, &str)) -> Option<Label> {
    let (name, text) = (name.trim(), text.trim());
    if name.is_empty() || text.is_empty() {
        return None;
    }
    match symbol(text, name) {
        Some(unit) => Some(named(name, unit, UnitOrigin::Heading)),
        None => is_time(name).then(|| unknown(name, text)),
    }
}

/// Reads `time_ms`, `angle_deg`. A single letter may be an index, as in `t_A`, `v_s`; `y_min` is a minimum.
fn suffix(cell: &str) -> Option<Label> {
    let (name, text) = cell.rsplit_once('_')?;
    if name.is_empty() || text.contains(['{', '}', '^', '(']) {
        return None;
    }
    let found = symbol(text, name).filter(|_| !is_word(text) && !is_numbered(text, name))?;
    let letters = |text: &str| text.chars().filter(|character| character.is_alphabetic()).count();
    let of_time = found.unit.dimension == Dimension::TIME;
    let certain = if is_time(name) {
        of_time
    } else {
        !of_time && (letters(text) >= 2 || text.contains(['%', '°']) || (letters(name) >= 4 && letters(text) == 1))
    };
    certain.then(|| named(name, found, UnitOrigin::Suffix))
}

/// Reads `Time ms`, `angle deg`. A single letter may be a symbol, as in `Masse m`, `Zeit t`.
fn last_word(cell: &str) -> Option<Label> {
    let (name, text) = cell.rsplit_once([' ', ','])?;
    let name = name.trim_end_matches([' ', ',']);
    let found = symbol(text, name).filter(|_| !is_word(text) && !is_numbered(text, name))?;
    let certain = if is_time(name) {
        found.unit.dimension == Dimension::TIME
    } else {
        text.chars().count() >= 2 && found.unit.dimension != Dimension::TIME
    };
    (certain && !name.is_empty()).then(|| named(name, found, UnitOrigin::Heading))
}

/// True if a text is a letter and a number, which number a sensor or a pin: `Temp A0`, `Pos m2`. Over an area or a volume
/// they are a unit.
fn is_numbered(text: &str, name: &str) -> bool {
    let letters = text.trim_end_matches(|last: char| last.is_ascii_digit());
    let name = name.to_lowercase();
    let square = ["area", "área", "surface", "fläche", "flaeche", "volum"].iter().any(|word| name.contains(word));
    letters.len() < text.len() && letters.chars().count() == 1 && !square
}

/// True if a unit is also a common end of a name: `V_in`, `V in`.
fn is_word(text: &str) -> bool {
    text == "in"
}

/// Reads `millis`, `seconds`: a time named by its unit.
fn own_name(cell: &str) -> Label {
    let found = unit_words::read(cell).filter(|unit| unit.dimension == Dimension::TIME);
    match found.filter(|unit| cell.chars().count() > 3 || unit.text == "ms") {
        Some(unit) => named(cell, Meant { unit, reading: None }, UnitOrigin::Name),
        None => Label { name: cell.to_owned(), ..Label::default() },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The cell, and `run|name|unit` or `run|name|?what is not known`.
    const CELLS: [(&str, &str); 74] = [
        ("t [s]", "|t|s"),
        ("'-x (m)", "|-x|m"),
        ("'=a (m/s^2)", "|=a|m/s^2"),
        ("'t (s)", "|'t|s"),
        ("Time (msec)", "|Time|ms"),
        ("Time (MS)", "|Time|ms"),
        ("Time (milliseconds)", "|Time|ms"),
        ("t in ms", "|t|ms"),
        ("tiempo en segundos", "|tiempo|s"),
        ("time_ms", "|time|ms"),
        ("Time ms", "|Time|ms"),
        ("t, ms", "|t|ms"),
        ("t [ms] (camera)", "|t|ms"),
        ("Time: ms", "|Time|ms"),
        ("t <ms>", "|t|ms"),
        ("t {ms}", "|t|ms"),
        ("Zeit [Sekunden]", "|Zeit|s"),
        ("Tiempo (min)", "|Tiempo|min"),
        ("millis", "|millis|ms"),
        ("t/ms", "|t|ms"),
        ("t (in ms)", "|t|ms"),
        ("t (ticks)", "|t|?ticks"),
        ("t [ticks]", "|t|?ticks"),
        ("Time: ticks", "|Time|?ticks"),
        ("t / frames", "|t|?frames"),
        ("y [blips]", "|y|?blips"),
        ("y (left)", "|y|?left"),
        ("y (left) [cm]", "|y (left)|cm"),
        ("L (dB)", "|L|?dB"),
        ("v in cm/s", "|v|cm/s"),
        ("V_in", "|V_in|"),
        ("V in", "|V in|"),
        ("T (°C)", "|T|K"),
        ("T (C)", "|T|K"),
        ("a (g)", "|a|m/s^2"),
        ("v x10^-3 (m/s)", "|v|m/s"),
        ("v*1000 (m/s)", "|v|?v*1000 (m/s)"),
        ("v / 10^-3 m/s", "|v|m/s"),
        ("ω(t)", "|ω(t)|"),
        ("a(t) (m/s^2)", "|a(t)|m/s^2"),
        ("v_{y} (cm/s)", "|v_y|cm/s"),
        ("k [W/(m K)]", "|k|W/(m K)"),
        ("Time (s) Run #1", "Run 1|Time|s"),
        ("Position (cm) Run #12", "Run 12|Position|cm"),
        ("Angle Run 2", "Run 2|Angle|"),
        ("Run 2: Time (s)", "Run 2|Time|s"),
        ("Data Set 2:Time(s)", "Data Set 2|Time|s"),
        ("Latest: Position (m)", "Latest|Position|m"),
        ("Ángulo (grados) Serie 3", "Serie 3|Ángulo|deg"),
        ("y [cm] (Run 2)", "Run 2|y|cm"),
        ("Run 1", "|Run 1|"),
        ("trunk 3", "|trunk 3|"),
        ("t_A", "|t_A|"),
        ("y_min", "|y_min|"),
        ("angle_deg", "|angle|deg"),
        ("y_cm", "|y|cm"),
        ("v_s", "|v_s|"),
        ("Masse m", "|Masse m|"),
        ("Temperature [°C]", "|Temperature|K"),
        ("12:00:00.000", "||"),
        ("Temp A0", "|Temp A0|"),
        ("Pos m2", "|Pos m2|"),
        ("Pressure C1", "|Pressure C1|"),
        ("Area m2", "|Area|m^2"),
        ("Volume cm3", "|Volume|cm^3"),
        ("time (source1)", "|time|"),
        ("Torque [Nm]", "|Torque|N m"),
        ("Energy (kWh)", "|Energy|kW h"),
        ("v [cm.s^-1]", "|v|cm s^-1"),
        ("t (с)", "|t|s"),
        ("t, мс", "|t|ms"),
        ("Gyro [dps]", "|Gyro|deg/s"),
        ("T [˚C]", "|T|K"),
        ("T [oC]", "|T|K"),
    ];

    #[test]
    fn headings_are_understood() {
        let mut wrong = String::new();
        for (cell, expected) in CELLS {
            let label = read(cell);
            let unit = match (&label.unit, &label.origin) {
                (Some(unit), _) => unit.text.clone(),
                (None, origin) => origin.unknown().map(|text| format!("?{text}")).unwrap_or_default(),
            };
            let found = format!("{}|{}|{unit}", label.run.unwrap_or_default(), label.name);
            if found != expected {
                wrong.push_str(&format!("{cell}: {found} instead of {expected}\n"));
            }
        }
        assert!(wrong.is_empty(), "{wrong}");
        assert_eq!(read("t [hh:mm]").clock, Some(clock::Form::Hours));
        assert_eq!(read("t (mm:ss)").clock, Some(clock::Form::Minutes));
        assert_eq!(read("y [cm] (left)").behind, "(left)");
    }
}

//! Numbers with their names in each line, as programs of microcontrollers print them: `Temp: 23.4 C, Hum: 45 %`,
//! `10:00:01 -> x=0.1 y=2.3`.

use crate::import::head;
use crate::import::times::clock;

/// Number of lines among which the first with names is sought, and least number of lines with the same names.
const SAMPLE: usize = 40;
const LEAST: usize = 3;
/// Greatest number of names in a line, and greatest length of a name or unit in bytes.
const MOST: usize = 64;
const LONGEST: usize = 40;
/// Signs between the numbers of a line.
const BETWEEN: [char; 4] = [',', ';', '|', '\t'];

/// Table of labelled numbers.
#[derive(Debug)]
pub(super) struct LabelledTable {
    /// Head and rows with tabs.
    pub rows: String,
    /// Number of lines that have other names or none.
    pub left_out: usize,
}

/// One line: time of day or date, empty without one, and the numbers.
#[derive(Debug, PartialEq)]
struct Line<'a> {
    time: &'a str,
    numbers: Vec<Labelled<'a>>,
}

#[derive(Debug, PartialEq)]
struct Labelled<'a> {
    name: &'a str,
    value: &'a str,
    unit: &'a str,
}

/// Reads a text in which nine lines of ten have the same names before their numbers; `None` for any other text.
pub(super) fn read(text: &str) -> Option<LabelledTable> {
    let lines = || text.trim_start_matches('\u{feff}').lines().filter(|line| !line.trim().is_empty());
    let mut sample = lines().take(SAMPLE).filter_map(line);
    let first = sample.find(|line| line.numbers.len() + usize::from(!line.time.is_empty()) > 1)?;
    let mut rows = String::from(if first.time.is_empty() { "" } else { "time\t" });
    for (place, Labelled { name, unit, .. }) in first.numbers.iter().enumerate() {
        rows.push_str(if place > 0 { "\t" } else { "" });
        rows.push_str(name);
        if !unit.is_empty() {
            rows.extend([" [", unit, "]"]);
        }
    }
    let (mut count, mut left_out) = (0, 0);
    for line in lines().map(line) {
        let Some(line) = line.filter(|line| line.is_like(&first)) else {
            left_out += 1;
            continue;
        };
        count += 1;
        rows.push('\n');
        rows.push_str(line.time);
        for (place, number) in line.numbers.iter().enumerate() {
            rows.push_str(if place > 0 || !line.time.is_empty() { "\t" } else { "" });
            rows.push_str(number.value);
        }
    }
    rows.push('\n');
    (count >= LEAST && left_out * 9 <= count).then_some(LabelledTable { rows, left_out })
}

impl Line<'_> {
    /// True if both lines have the same names and units, and both a time or none.
    fn is_like(&self, other: &Line) -> bool {
        let same = |(own, other): (&Labelled, &Labelled)| own.name == other.name && own.unit == other.unit;
        self.time.is_empty() == other.time.is_empty()
            && self.numbers.len() == other.numbers.len()
            && self.numbers.iter().zip(&other.numbers).all(same)
    }
}

/// Time and labelled numbers of a line that holds nothing else.
fn line(text: &str) -> Option<Line<'_>> {
    let mut found: Option<Line> = None;
    let (mut rest, mut from) = (text, 0);
    while let Some(sign) = rest.get(from..).and_then(|part| part.find([':', '='])).map(|place| from + place) {
        let (before, after) = (&rest[..sign], rest[sign + 1..].trim_start());
        let length = number(after);
        let Some(start) = name_start(before).filter(|_| length > 0) else {
            from = sign + 1;
            continue;
        };
        let name = match &mut found {
            None => {
                let time = before[..start].trim_matches(is_edge);
                found =
                    Some(Line { time, numbers: Vec::new() }).filter(|_| time.is_empty() || clock::read(time).is_some());
                before[start..].trim_end()
            }
            Some(line) => {
                let (unit, name) = divided(before)?;
                line.numbers.last_mut()?.unit = unit;
                name
            }
        };
        let line = found.as_mut().filter(|line| line.numbers.len() < MOST && is_short(name))?;
        line.numbers.push(Labelled { name, value: &after[..length], unit: "" });
        (rest, from) = (&after[length..], 0);
    }
    let mut line = found?;
    line.numbers.last_mut()?.unit = Some(rest.trim_matches(is_edge)).filter(|unit| is_unit(unit))?;
    Some(line)
}

/// Start of the name that ends a text: words that begin with a letter, and whole numbers behind them.
fn name_start(text: &str) -> Option<usize> {
    let begin = text.rfind(|sign: char| BETWEEN.contains(&sign) || sign == '>').map_or(0, |place| place + 1);
    let is_number = |word: &str| word.bytes().all(|byte| byte.is_ascii_digit());
    let is_half = |word: &str| ["am", "pm", "AM", "PM"].contains(&word);
    let mut start = None;
    for word in text[begin..].rsplit(char::is_whitespace).filter(|word| !word.is_empty()) {
        if word.starts_with(char::is_alphabetic) && !is_half(word) {
            start = Some(word.as_ptr() as usize - text.as_ptr() as usize);
        } else if !is_number(word) {
            break;
        }
    }
    start
}

/// True for signs around times, names and units.
fn is_edge(sign: char) -> bool {
    sign.is_whitespace() || BETWEEN.contains(&sign) || matches!(sign, '-' | '>' | '[' | ']' | '(' | ')')
}

/// True for a text that can be a name or unit of a column.
fn is_short(text: &str) -> bool {
    !text.is_empty() && text.len() <= LONGEST && !text.contains(['\t', '[', ']'])
}

/// True for an empty text, and for a short word that begins with no digit.
fn is_unit(text: &str) -> bool {
    let begins = text.starts_with(|first: char| first.is_ascii_digit() || matches!(first, '.' | '+' | '-' | ':' | '='));
    text.is_empty() || (is_short(text) && !begins && !text.contains(char::is_whitespace))
}

/// Unit of the number before a text, empty without one, and the name of the number after it: ` C, Hum`, ` H`, `cm y`.
fn divided(text: &str) -> Option<(&str, &str)> {
    let (unit, name) = match text.find(BETWEEN).or_else(|| text.find(" - ")) {
        Some(cut) => text.split_at(cut),
        None => {
            let end =
                text.trim_start().find(char::is_whitespace).map_or(0, |end| end + text.len() - text.trim_start().len());
            let (unit, name) = text.split_at(end);
            let is_stated = !text.starts_with(char::is_whitespace) || head::is_unit(unit.trim());
            if is_stated { (unit, name) } else { ("", text) }
        }
    };
    let (unit, name) = (unit.trim_matches(is_edge), name.trim_matches(is_edge));
    (is_unit(unit) && !name.contains(BETWEEN) && name.starts_with(char::is_alphabetic)).then_some((unit, name))
}

/// Length of the number at the beginning of a text, `-1.5e-3`, `2,5`, `nan`; 0 without one.
fn number(text: &str) -> usize {
    let bytes = text.as_bytes();
    if bytes.get(..3).is_some_and(|word| word.eq_ignore_ascii_case(b"nan")) {
        return 3;
    }
    let digits = |from: usize| bytes[from.min(bytes.len())..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let mut end = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    let whole = digits(end);
    end += whole;
    let mut fraction = 0;
    if matches!(bytes.get(end), Some(b'.' | b',')) && (digits(end + 1) > 0 || bytes[end] == b'.') {
        fraction = digits(end + 1);
        end += 1 + fraction;
    }
    if whole + fraction == 0 {
        return 0;
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let exponent = digits(end + 1 + sign);
        end += if exponent > 0 { 1 + sign + exponent } else { 0 };
    }
    end
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(line: &str) -> Option<String> {
        let text = format!("Logger started\n{}", format!("{line}\n").repeat(12));
        let table = read(&text)?;
        assert_eq!(table.left_out, 1);
        table.rows.split_inclusive('\n').take(2).collect::<String>().into()
    }

    #[test]
    fn names_before_numbers_become_heads() {
        for (line, expected) in [
            ("Temp: 23.4 C, Hum: 45 %", "Temp [C]\tHum [%]\n23.4\t45\n"),
            ("T: 23.4 H: 50.1", "T\tH\n23.4\t50.1\n"),
            ("10:00:01 -> x=0.1 y=-2.3e-4", "time\tx\ty\n10:00:01\t0.1\t-2.3e-4\n"),
            ("[2026-01-02 10:00:01] Distance = 12.5cm", "time\tDistance [cm]\n2026-01-02 10:00:01\t12.5\n"),
            ("2026-01-02T10:00:01 Light level = 345", "time\tLight level\n2026-01-02T10:00:01\t345\n"),
            (
                "01/31/2026 11:12:56 am Sensor 1: 20,5 °C | Sensor 2: nan °C",
                "time\tSensor 1 [°C]\tSensor 2 [°C]\n01/31/2026 11:12:56 am\t20,5\tnan\n",
            ),
            ("t=0.25s,y=2.5cm", "t [s]\ty [cm]\n0.25\t2.5\n"),
            ("t: 12 ms a: 9.81 m/s^2", "t [ms]\ta [m/s^2]\n12\t9.81\n"),
        ] {
            assert_eq!(rows(line).as_deref(), Some(expected), "{line}");
        }
    }

    #[test]
    fn other_lines_are_left_to_the_rules_of_tables() {
        for line in [
            "0.1 2.3",
            "Temp: 23.4",
            "10:00:01 12.5",
            "00:42:14 1: 91.1",
            "x=1, 2, 3",
            "Run 1: 0.1 2.3 3.4",
            "0.1, 2.3, T=20",
            "Length: 50 cm long",
            "A=B",
            ": 1 = 2",
        ] {
            assert_eq!(rows(line), None, "{line}");
        }
        // Names or units that change.
        assert!(read("T: 1 C, H: 2\nT: 1 F, H: 2\nT: 1 K, H: 2\nT: 1 C, H: 2\n").is_none());
    }
}

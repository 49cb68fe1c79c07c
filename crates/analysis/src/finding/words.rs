//! Texts of findings with several variants.

use crate::sampling::Gap;
use units::number;
use units::{Language, say};

/// Readings of `1,295` as a decimal number and with groups of digits: `1.295` and `1295`.
pub(crate) fn readings(text: &str, language: Language) -> [String; 2] {
    let digits = |replacement: &str| text.replace([',', '.'], replacement);
    [digits(if language.style().decimal_comma { "," } else { "." }), digits("")]
}

pub(super) fn separator(line: usize, text: &str, beside: &str, thousands: bool, language: Language) -> String {
    let [decimal, large] = readings(text, language);
    let (taken, other) = if thousands { (large, decimal) } else { (decimal, large) };
    say!(
        language,
        "line {line}: `{text}` is read as {taken} and not as {other}, as `{beside}` stands in the same column"
    )
}

pub(super) fn clock(
    column: &str,
    (days, wrapped, minutes, month_first): (bool, usize, bool, Option<bool>),
    language: Language,
) -> String {
    let column = called(column, language);
    let mut text = match days {
        false => say!(language, "{column} holds clock times; they are read as seconds from the first row"),
        true => say!(language, "{column} holds dates; they are read as seconds from the first row"),
    };
    text.push_str(match month_first {
        Some(true) => language.say(", with the month first in each date"),
        Some(false) => language.say(", with the day first in each date"),
        None => "",
    });
    if wrapped > 0 {
        text.push_str(&say!(language, ", and the clock began again at zero {wrapped}×"));
    }
    if minutes {
        text.push_str(language.say("; `12:30` is taken for 12 minutes and 30 seconds: if these are hours and minutes, say so in the header, `t [hh:mm]`"));
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
    say!(
        language,
        "there are {count} runs, each with its own clock: {list}; a column is named with its run, `{name}.y`"
    )
}

pub(super) fn missing(gaps: &[Gap], unit: &str, language: Language) -> String {
    let count: u64 = gaps.iter().map(|gap| gap.last - gap.first + 1).sum();
    let mut text = match count {
        1 => language.say("1 frame is missing: ").to_owned(),
        _ => say!(language, "{count} frames are missing: "),
    };
    const SHOWN: usize = 5;
    for (index, gap) in gaps.iter().take(SHOWN).enumerate() {
        let (after, before) = (reading(gap.after, unit, language), reading(gap.before, unit, language));
        text.push_str(if index > 0 { "; " } else { "" });
        text.push_str(&match gap.first == gap.last {
            true => say!(language, "number {} (between {after} and {before})", gap.first),
            false => say!(language, "{} to {} (between {after} and {before})", gap.first, gap.last),
        });
    }
    if gaps.len() > SHOWN {
        text.push_str(language.say("; and others"));
    }
    text
}

pub(super) fn backwards(time: f64, unit: &str, count: usize, language: Language) -> String {
    let time = reading(time, unit, language);
    match count {
        1 => say!(
            language,
            "the rows are not in the order of time: the row at {time} is earlier than the row before; fits and cycles sort the rows by time, so divide the file there if the clock began again"
        ),
        _ => say!(
            language,
            "the rows are not in the order of time: {count} are earlier than the row before, the first at {time}; fits and cycles sort them by time"
        ),
    }
}

/// Text for a cell that became a gap: a number beyond the range of doubles, or not a number.
pub(super) fn word(line: usize, column: &str, text: &str, language: Language) -> String {
    let has_digit = text.contains(|character: char| character.is_ascii_digit());
    let too_large = has_digit && text.replace(',', ".").parse::<f64>().is_ok_and(f64::is_infinite);
    match too_large {
        true => say!(
            language,
            "line {line}, column {column}: `{text}` is beyond the range of numbers here, ±1.8e308, and became a gap"
        ),
        false => say!(language, "line {line}, column {column}: `{text}` is not a number and became a gap"),
    }
}

pub(super) fn rounded_step(interval: f64, rate: f64, language: Language) -> String {
    let error = interval * rate - 1.0;
    let percent = decimal(100.0 * error.abs(), 2, language);
    let (step, rate) = (decimal(interval, 9, language), decimal(rate, 5, language));
    if error < 0.0 {
        say!(
            language,
            "the time step {step} s looks like 1/{rate} s rounded: times are too short by {percent} %, frequencies too high"
        )
    } else {
        say!(
            language,
            "the time step {step} s looks like 1/{rate} s rounded: times are too long by {percent} %, frequencies too low"
        )
    }
}

/// Column by its label, which is a number if the file gives no name.
pub(super) fn called(label: &str, language: Language) -> String {
    match (label.bytes().all(|byte| byte.is_ascii_digit()), language) {
        (true, _) => say!(language, "column {label}"),
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

/// Note on a table from JSON.
pub(super) fn json(left_out: &[String], language: Language) -> String {
    if left_out.is_empty() {
        return language.say("the table was read from JSON").to_owned();
    }
    let names = left_out.join(", ");
    say!(language, "the table was read from JSON; these lists have another length and were left out: {names}")
}

/// Note on NUL bytes in a text.
pub(super) fn nuls(count: usize, language: Language) -> String {
    match count {
        1 => language
            .say("a NUL byte was left out; a logger writes them on a reset or a loss of power, so rows may be missing there")
            .to_owned(),
        _ => say!(
            language,
            "{count} NUL bytes were left out; a logger writes them on a reset or a loss of power, so rows may be missing there"
        ),
    }
}

/// Note on the overflows of a counter.
pub(super) fn overflow(column: &str, bits: i32, count: usize, language: Language) -> String {
    let column = called(column, language);
    match count {
        1 => say!(
            language,
            "the clock of {column} overflowed once: where it fell, 2^{bits} was added to all later times"
        ),
        _ => say!(
            language,
            "the clock of {column} overflowed {count} times: where it fell, 2^{bits} was added to all later times"
        ),
    }
}

/// Note on rows that repeat the values of the row before.
pub(super) fn repeated(columns: &[String], count: usize, of: usize, language: Language) -> String {
    let columns: Vec<String> = columns.iter().map(|column| called(column, language)).collect();
    let columns = columns.join(", ");
    say!(
        language,
        "{count} of {of} rows repeat the value of {columns} in the row before, at regular distances, as a film does that was converted to another frame rate: their times are wrong; leave these rows out, or use the original film"
    )
}

/// Note on a column of words that names the run of each row.
pub(super) fn labels(column: &str, runs: &[String], language: Language) -> String {
    let (column, names) = (called(column, language), runs.join(", "));
    let example = runs.first().map(String::as_str).unwrap_or_default();
    say!(language, "the words in {column} divide the rows: {names}; each has its own columns, such as `{example}.y`")
}

//! Times of day, durations and dates in cells, `12:00:00.050`, `01:23.4`, `2026-01-02T10:00:00`, as seconds.

/// Seconds in a day.
const DAY: f64 = 86_400.0;

/// Time or date in a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Reading {
    /// Seconds since midnight, since the full hour, or since 1 January 1970.
    pub seconds: f64,
    pub form: Form,
}

/// Notation of a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// Hours, minutes and seconds, without a date.
    Hours,
    /// Two numbers without a fraction, `12:30`: minutes and seconds, or hours and minutes.
    Two,
    /// Minutes and seconds with a fraction.
    Minutes,
    /// A date and a time.
    Moment,
    /// A date alone.
    Date,
}

/// Times in seconds from the first row, with notes for the user.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Times {
    pub seconds: Vec<f64>,
    /// Number of times the clock restarted at zero, at midnight or at the full hour.
    pub wrapped: usize,
    /// True if `12:30` was read as minutes and seconds without an indication in the file.
    pub guessed: bool,
}

/// Reads a cell without surrounding blanks.
pub(super) fn read(text: &str) -> Option<Reading> {
    // Quick exit: nearly all cells are numbers.
    if text.len() < 3 || text.len() > 40 || !text.starts_with(|first: char| first.is_ascii_digit()) {
        return None;
    }
    let (day, rest) = match date(text) {
        Some((day, rest)) => (day, rest),
        None => (None, text),
    };
    let dated = rest.len() < text.len();
    let rest = rest.trim_start_matches(['T', ' ', ',']);
    if rest.is_empty() {
        return day.map(|day| Reading { seconds: day * DAY, form: Form::Date });
    }
    let (rest, zone) = zone(rest, dated);
    let (rest, half) = half_day(rest);
    let parts: Vec<&str> = rest.split(':').collect();
    let whole = |text: &str| -> Option<f64> {
        let digits = !text.is_empty() && text.len() <= 4 && text.bytes().all(|byte| byte.is_ascii_digit());
        digits.then(|| text.parse().ok()).flatten()
    };
    let last = |text: &str| -> Option<f64> {
        let (whole_part, fraction) = text.split_once(['.', ',']).unwrap_or((text, "0"));
        let digits = fraction.bytes().all(|byte| byte.is_ascii_digit()) && fraction.len() <= 12;
        let fits = whole_part.len() <= 2 && digits && whole(whole_part)? < 60.0;
        fits.then(|| format!("{whole_part}.{fraction}0").parse().ok()).flatten()
    };
    let (seconds, form) = match parts.as_slice() {
        [hours, minutes, seconds] => {
            let minutes = whole(minutes).filter(|minutes| *minutes < 60.0)?;
            (3600.0 * half.hour(whole(hours)?)? + 60.0 * minutes + last(seconds)?, Form::Hours)
        }
        [hours, minutes] if dated || half != Half::Unstated => {
            (3600.0 * half.hour(whole(hours)?)? + 60.0 * last(minutes)?, Form::Hours)
        }
        [minutes, seconds] => {
            let form = if seconds.contains(['.', ',']) { Form::Minutes } else { Form::Two };
            (60.0 * whole(minutes)? + last(seconds)?, form)
        }
        _ => return None,
    };
    Some(match day {
        Some(day) => Reading { seconds: day * DAY + seconds - zone, form: Form::Moment },
        None => Reading { seconds, form },
    })
}

/// Times in seconds from the first row. A clock without a date restarts at midnight or at the full hour; consecutive rows
/// must be less than half a turn apart. `stated` is the meaning of `12:30` given by the header.
pub(super) fn times(readings: &[Reading], stated: Option<Form>) -> Times {
    let every = |form: Form| readings.iter().all(|reading| reading.form == form);
    let two = every(Form::Two);
    let as_hours = two && stated == Some(Form::Hours);
    let factor = if as_hours { 60.0 } else { 1.0 };
    let greatest = readings.iter().map(|reading| reading.seconds * factor).fold(0.0, f64::max);
    let turn = if every(Form::Hours) || as_hours {
        Some(DAY)
    } else if readings.iter().all(|reading| matches!(reading.form, Form::Two | Form::Minutes)) {
        Some(3600.0)
    } else {
        None
    };
    // Hours beyond 24 or minutes beyond 60 show that the clock does not restart.
    let turn = turn.filter(|turn| greatest < *turn);
    let mut times = Times { seconds: Vec::with_capacity(readings.len()), wrapped: 0, guessed: two && stated.is_none() };
    let first = readings.first().map_or(0.0, |reading| reading.seconds * factor);
    let (mut before, mut added) = (first, 0.0);
    for reading in readings {
        let now = reading.seconds * factor;
        if let Some(turn) = turn.filter(|turn| now < before - 0.5 * turn) {
            added += turn;
            times.wrapped += 1;
        }
        before = now;
        // Rounded to remove rounding errors of the difference: 0.05, not 0.0500000000029.
        times.seconds.push(((now - first + added) * 1e9).round() / 1e9);
    }
    times
}

/// Days since 1 January 1970 of the date at the beginning, and the rest of the text. The days are `None` if day and month
/// cannot be distinguished (`1/2/2026`); the date is then ignored.
fn date(text: &str) -> Option<(Option<f64>, &str)> {
    let end = text.find(['T', ' ', ',']).unwrap_or(text.len());
    let (date, rest) = text.split_at(end);
    let separator = date.chars().find(|character| !character.is_ascii_digit())?;
    if !matches!(separator, '-' | '/' | '.') {
        return None;
    }
    let mut parts = date.split(separator);
    let (first, second, third) = (parts.next()?, parts.next()?, parts.next()?);
    let number = |text: &str| -> Option<i64> {
        (!text.is_empty() && text.len() <= 4 && text.bytes().all(|byte| byte.is_ascii_digit()))
            .then(|| text.parse().ok())
            .flatten()
    };
    let (first_number, second_number, third_number) = (number(first)?, number(second)?, number(third)?);
    if parts.next().is_some() {
        return None;
    }
    if first.len() == 4 {
        return Some((Some(days(first_number, second_number, third_number)?), rest));
    }
    let year = match third.len() {
        4 => third_number,
        2 => 2000 + third_number,
        _ => return None,
    };
    if separator != '.' {
        let either = is_date(year, first_number, second_number) || is_date(year, second_number, first_number);
        return either.then_some((None, rest));
    }
    Some((Some(days(year, second_number, first_number)?), rest))
}

/// True if the date exists: no 31 February.
fn is_date(year: i64, month: i64, day: i64) -> bool {
    let leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    let last = match month {
        2 => 28 + i64::from(leap),
        4 | 6 | 9 | 11 => 30,
        _ => 31,
    };
    (1..=12).contains(&month) && (1..=last).contains(&day)
}

/// Days since 1 January 1970 in the Gregorian calendar (H. Hinnant, "chrono-compatible low-level date algorithms").
fn days(year: i64, month: i64, day: i64) -> Option<f64> {
    if !is_date(year, month, day) {
        return None;
    }
    let year = if month <= 2 { year - 1 } else { year };
    let era = year.div_euclid(400);
    let year_of_era = year - 400 * era;
    let day_of_year = (153 * (month + if month > 2 { -3 } else { 9 }) + 2) / 5 + day - 1;
    let day_of_era = 365 * year_of_era + year_of_era / 4 - year_of_era / 100 + day_of_year;
    Some((146_097 * era + day_of_era - 719_468) as f64)
}

/// Time without a trailing `Z` or `+01:00`, and the offset of the zone in seconds; offsets are only read after a date.
fn zone(text: &str, dated: bool) -> (&str, f64) {
    let text = text.trim_end();
    if let Some(rest) = text.strip_suffix('Z') {
        return (rest, 0.0);
    }
    let Some(place) = text.rfind(['+', '-']).filter(|place| dated && *place > 0) else { return (text, 0.0) };
    let digits: String = text[place + 1..].chars().filter(|character| *character != ':').collect();
    let ahead = match digits.len() {
        2 => digits.parse().ok().map(|hours: f64| 3600.0 * hours),
        4 => digits.parse().ok().map(|both: f64| 3600.0 * (both / 100.0).trunc() + 60.0 * (both % 100.0)),
        _ => None,
    };
    match ahead {
        Some(ahead) => (text[..place].trim_end(), if text[place..].starts_with('-') { -ahead } else { ahead }),
        None => (text, 0.0),
    }
}

/// Half of the day on a clock of twelve hours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Half {
    Unstated,
    Before,
    After,
}

impl Half {
    fn hour(self, hour: f64) -> Option<f64> {
        match self {
            Self::Unstated => Some(hour),
            _ if !(1.0..=12.0).contains(&hour) => None,
            Self::Before => Some(hour % 12.0),
            Self::After => Some(hour % 12.0 + 12.0),
        }
    }
}

fn half_day(text: &str) -> (&str, Half) {
    let lower = text.to_ascii_lowercase();
    for (ends, half) in [(["am", "a.m.", "a. m."], Half::Before), (["pm", "p.m.", "p. m."], Half::After)] {
        if let Some(end) = ends.iter().find(|end| lower.ends_with(**end)) {
            return (text[..text.len() - end.len()].trim_end(), half);
        }
    }
    (text, Half::Unstated)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seconds(text: &str) -> Option<(f64, Form)> {
        read(text).map(|reading| (reading.seconds, reading.form))
    }

    #[test]
    fn times_of_many_kinds_are_read() {
        for (text, expected, form) in [
            ("00:00:00.050", 0.05, Form::Hours),
            ("12:00:00,5", 43200.5, Form::Hours),
            ("25:10:00", 90600.0, Form::Hours),
            ("1:02.5", 62.5, Form::Minutes),
            ("90:02", 5402.0, Form::Two),
            ("12:00:05 AM", 5.0, Form::Hours),
            ("1:00:05 p.m.", 46805.0, Form::Hours),
            ("1970-01-02", 86400.0, Form::Date),
            ("2000-03-01T00:00:00", 951_868_800.0, Form::Moment),
            ("2000-03-01 01:00:00.25+01:00", 951_868_800.25, Form::Moment),
            ("2000-03-01T00:00:00Z", 951_868_800.0, Form::Moment),
            ("01.03.2000 00:00", 951_868_800.0, Form::Moment),
            ("3/1/2000 00:01:00", 60.0, Form::Hours),
        ] {
            assert_eq!(seconds(text), Some((expected, form)), "{text}");
        }
        for text in [
            "",
            "12",
            "1.5",
            "12:60:00",
            "12:00:61",
            "a:b",
            "1:2:3:4",
            "13:00 pm",
            "1/2",
            "2026-13-01",
            "2026-02-31",
            "29.02.2025",
            "31/2/2025 10:00:00",
            "12:",
            "-1:00",
        ] {
            assert_eq!(seconds(text), None, "{text}");
        }
    }

    #[test]
    fn midnight_is_passed() {
        let readings: Vec<Reading> =
            ["23:59:59.5", "00:00:00", "00:00:00.5"].iter().filter_map(|text| read(text)).collect();
        let times = times(&readings, None);
        assert_eq!((times.seconds.as_slice(), times.wrapped), ([0.0, 0.5, 1.0].as_slice(), 1));
    }

    #[test]
    fn what_two_numbers_mean_can_be_stated() {
        let readings: Vec<Reading> = ["12:30", "12:31"].iter().filter_map(|text| read(text)).collect();
        assert_eq!(times(&readings, None), Times { seconds: vec![0.0, 1.0], wrapped: 0, guessed: true });
        assert_eq!(times(&readings, Some(Form::Hours)), Times { seconds: vec![0.0, 60.0], wrapped: 0, guessed: false });
    }
}

//! Times of day, durations and dates in cells, `12:00:00.050`, `01:23.4`, `2026-01-02T10:00:00`, as seconds.

use super::date::{self, DAY, Order};

/// Time or date in a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::import) struct Reading {
    /// Days since 1 January 1970, 0 without a date. Apart from the seconds, so that microseconds are not lost.
    pub days: f64,
    /// Seconds since midnight or since the full hour.
    pub seconds: f64,
    pub form: Form,
    /// Order of day and month in its date.
    pub order: Order,
}

/// Notation of a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::import) enum Form {
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
pub(in crate::import) struct Times {
    pub seconds: Vec<f64>,
    /// Number of times the clock restarted at zero, at midnight or at the full hour.
    pub wrapped: usize,
    /// True if `12:30` was read as minutes and seconds without an indication in the file.
    pub guessed: bool,
    /// True if the dates have the month first, as their numbers show; `None` if their notation states the order.
    pub month_first: Option<bool>,
    /// True if day and month cannot be told apart.
    pub open: bool,
}

/// Reads a cell without surrounding blanks.
pub(in crate::import) fn read(text: &str) -> Option<Reading> {
    // Quick exit: nearly all cells are numbers.
    let named = || text.len() > 8 && text.starts_with(char::is_alphabetic) && text.contains(' ');
    if text.len() < 3 || text.len() > 40 || !(text.starts_with(|first: char| first.is_ascii_digit()) || named()) {
        return None;
    }
    let (day, rest) = match date::read(text) {
        Some((day, rest)) => (Some(day), rest),
        None => (None, text),
    };
    let dated = rest.len() < text.len();
    let rest = rest.trim_start_matches(['T', ' ', ',']);
    if rest.is_empty() {
        return day.map(|day| Reading { days: day.days, seconds: 0.0, form: Form::Date, order: day.order });
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
        // Milliseconds after a fourth colon: `10:00:00:040`.
        [hours, minutes, seconds, fraction] if fraction.len() == 3 && seconds.len() == 2 => {
            let minutes = whole(minutes).filter(|minutes| *minutes < 60.0)?;
            let seconds = last(seconds).filter(|_| seconds.len() == 2)? + whole(fraction)? / 1000.0;
            (3600.0 * half.hour(whole(hours)?)? + 60.0 * minutes + seconds, Form::Hours)
        }
        _ => return None,
    };
    Some(match day {
        Some(day) => Reading { days: day.days, seconds: seconds - zone, form: Form::Moment, order: day.order },
        None => Reading { days: 0.0, seconds, form, order: Order::Stated },
    })
}

/// Times in seconds from the first row. A clock without a date restarts at midnight or at the full hour; consecutive rows
/// must be less than half a turn apart. `stated` is the meaning of `12:30` given by the header.
pub(in crate::import) fn times(readings: &[Reading], stated: Option<Form>) -> Times {
    let mut readings = readings.to_vec();
    let settled = settle_order(&mut readings);
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
    let mut times = Times {
        seconds: Vec::with_capacity(readings.len()),
        wrapped: 0,
        guessed: two && stated.is_none(),
        month_first: settled.unwrap_or(None),
        open: settled.is_err(),
    };
    let start = readings.first().map_or(0.0, |reading| reading.days);
    let seconds = |reading: &Reading| (reading.days - start) * DAY + reading.seconds * factor;
    let first = readings.first().map_or(0.0, seconds);
    let (mut before, mut added) = (first, 0.0);
    for reading in &readings {
        let now = seconds(reading);
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

/// Gives all dates of a column the same order of day and month. Returns true if the month is first, `None` if the order
/// does not matter or is stated.
///
/// A date that has only one order decides for all. Otherwise the order that makes the steps even does.
///
/// # Errors
/// The dates contradict each other, or both orders are possible.
fn settle_order(readings: &mut [Reading]) -> Result<Option<bool>, ()> {
    let has = |wanted: Order| readings.iter().any(|reading| reading.order == wanted);
    let open = |reading: &Reading| match reading.order {
        Order::Open(other) => Some(other),
        _ => None,
    };
    let month_first = match (has(Order::DayFirst), has(Order::MonthFirst)) {
        (true, true) => return Err(()),
        (true, false) => false,
        (false, true) => true,
        (false, false) => {
            let Some(first) = readings.iter().find_map(open) else { return Ok(None) };
            // One day throughout: its order changes no difference.
            let same = |reading: &Reading| open(reading) == Some(first) && reading.days == readings[0].days;
            if readings.iter().all(same) {
                return Ok(None);
            }
            let day = |reading: &Reading| reading.days * DAY + reading.seconds;
            let month = |reading: &Reading| day(reading) + open(reading).unwrap_or(0.0) * DAY;
            let day_first = unevenness(readings.iter().map(day));
            let month_first = unevenness(readings.iter().map(month));
            match (4.0 * day_first <= month_first, 4.0 * month_first <= day_first) {
                (true, false) => false,
                (false, true) => true,
                _ => return Err(()),
            }
        }
    };
    for reading in readings.iter_mut() {
        if let Order::Open(other) = reading.order {
            reading.days += if month_first { other } else { 0.0 };
        }
    }
    Ok(Some(month_first))
}

/// Greatest step over the median of the steps; infinite if a step is negative.
fn unevenness(values: impl Iterator<Item = f64>) -> f64 {
    let values: Vec<f64> = values.collect();
    let mut steps: Vec<f64> = values.windows(2).map(|pair| pair[1] - pair[0]).collect();
    steps.sort_by(f64::total_cmp);
    match (steps.first(), steps.get(steps.len() / 2), steps.last()) {
        (Some(least), Some(median), Some(greatest)) if *least >= 0.0 && *median > 0.0 => greatest / median,
        _ => f64::INFINITY,
    }
}

/// Time without a trailing `Z` or `+01:00`, and the offset of the zone in seconds; offsets are only read after a date.
fn zone(text: &str, dated: bool) -> (&str, f64) {
    let text = text.trim_end();
    let universal = ["Z", "GMT", "UTC"].iter().find_map(|name| text.strip_suffix(name));
    if let Some(rest) = universal {
        return (rest.trim_end(), 0.0);
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
        read(text).map(|reading| (reading.days * DAY + reading.seconds, reading.form))
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
            ("20/3/2000 00:01:00", 953_510_460.0, Form::Moment),
            ("Mar 1, 2000 12:00:00 AM", 951_868_800.0, Form::Moment),
            ("Wed, 01 Mar 2000 01:00:00 +0100", 951_868_800.0, Form::Moment),
            ("1-mar-00", 951_868_800.0, Form::Date),
            ("10:00:00:040", 36000.04, Form::Hours),
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
        assert_eq!(
            times(&readings, None),
            Times { seconds: vec![0.0, 1.0], wrapped: 0, guessed: true, month_first: None, open: false }
        );
        assert_eq!(
            times(&readings, Some(Form::Hours)),
            Times { seconds: vec![0.0, 60.0], wrapped: 0, guessed: false, month_first: None, open: false }
        );
    }
}

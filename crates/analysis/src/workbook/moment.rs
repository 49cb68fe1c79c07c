//! Dates, times and durations of spreadsheets, written so that the import reads them as times.

use std::fmt::Write as _;

const SECONDS_PER_DAY: f64 = 86_400.0;
/// Latest date of a spreadsheet: the end of the year 9999, in days from the end of 1899.
const LAST_DAY: f64 = 2_958_466.0;
/// Number of days from which on a time is a moment with a date, in 1927 or later, and not a duration.
const EARLIEST_MOMENT: f64 = 10_000.0;
/// Parts of a second to which dates and times are rounded. A date is exact to fifteen digits: some microseconds.
const PER_SECOND_OF_DATES: f64 = 1e5;
const PER_SECOND: f64 = 1e6;

/// Meaning of a number with the format of a date or time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Meaning {
    /// Day, perhaps with a time of day.
    Date,
    /// Time of day, or a duration: `[h]:mm:ss`.
    Time,
}

/// Date or time, in days.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Moment {
    pub days: f64,
    pub meaning: Meaning,
}

impl Moment {
    /// Moment from a serial number: days from the end of 1899, or from the beginning of 1904.
    pub fn of_serial(serial: f64, meaning: Meaning, from_1904: bool) -> Option<Self> {
        // A format of a time of day also shows that of a moment; no duration is that long.
        let meaning = if serial >= EARLIEST_MOMENT { Meaning::Date } else { meaning };
        let shift = if from_1904 && meaning == Meaning::Date { 1462.0 } else { 0.0 };
        let days = serial + shift;
        // A number below 1 with the format of a date is a time: day numbers begin at 1.
        let meaning = if meaning == Meaning::Date && days < 1.0 { Meaning::Time } else { meaning };
        (days.abs() < LAST_DAY).then_some(Self { days, meaning })
    }

    /// Moment from ISO 8601: `2024-05-01`, `2024-05-01T12:00:00.05` or `12:00:00`; a trailing `Z` is ignored.
    pub fn of_iso(text: &str) -> Option<Self> {
        let text = text.trim();
        let (date, time) = match text.split_once(['T', ' ']) {
            Some((date, time)) => (date, Some(time)),
            None if text.contains(':') => ("", Some(text)),
            None => (text, None),
        };
        let seconds = time.map_or(Some(0.0), |time| clock(time.trim_end_matches('Z')))?;
        if date.is_empty() {
            return Some(Self { days: seconds / SECONDS_PER_DAY, meaning: Meaning::Time });
        }
        let mut parts = date.splitn(3, '-').map(|part| part.parse::<i64>().ok());
        let (year, month, day) = (parts.next()??, parts.next()??, parts.next()??);
        let valid = (1900..=9999).contains(&year) && (1..=12).contains(&month) && (1..=31).contains(&day);
        let days = valid.then(|| serial_day(year, month, day))? as f64 + seconds / SECONDS_PER_DAY;
        Some(Self { days, meaning: Meaning::Date })
    }

    /// Moment from a duration `PT00H00M00.05S` (ISO 8601, XML Schema).
    pub fn of_duration(text: &str) -> Option<Self> {
        let text = text.trim();
        let (sign, text) = text.strip_prefix('-').map_or((1.0, text), |rest| (-1.0, rest));
        let (days, time) = text.strip_prefix('P')?.split_once('T').unwrap_or((text.get(1..)?, ""));
        let mut seconds = 0.0;
        for (part, units) in [(days, &[('D', SECONDS_PER_DAY)][..]), (time, &[('H', 3600.0), ('M', 60.0), ('S', 1.0)])]
        {
            let mut rest = part;
            for (unit, factor) in units {
                if let Some((number, after)) = rest.split_once(*unit) {
                    seconds += factor * number.parse::<f64>().ok()?;
                    rest = after;
                }
            }
            if !rest.is_empty() {
                return None;
            }
        }
        let days = sign * seconds / SECONDS_PER_DAY;
        (days.abs() < LAST_DAY).then_some(Self { days, meaning: Meaning::Time })
    }

    /// Writes the moment as `2024-05-01T12:00:00.05` or `00:00:00.05`; hours of a duration continue beyond 24.
    pub fn write(self, out: &mut String) {
        let date = self.meaning == Meaning::Date;
        let per_second = if date { PER_SECOND_OF_DATES } else { PER_SECOND };
        // Rounded before it is split, so that seconds never reach 60.
        let parts = (self.days.abs() * SECONDS_PER_DAY * per_second).round() as u64;
        let (mut seconds, parts) = (parts / per_second as u64, parts % per_second as u64);
        if date {
            let (year, month, day) = calendar_day((seconds / SECONDS_PER_DAY as u64) as i64);
            seconds %= SECONDS_PER_DAY as u64;
            let _ = write!(out, "{year:04}-{month:02}-{day:02}T");
        } else if self.days < 0.0 {
            out.push('-');
        }
        let _ = write!(out, "{:02}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
        if parts > 0 {
            let digits = if date { 5 } else { 6 };
            let _ = write!(out, ".{parts:0digits$}");
            out.truncate(out.trim_end_matches('0').len());
        }
    }
}

/// Seconds for `hh:mm`, `hh:mm:ss` or `hh:mm:ss.sss`.
fn clock(text: &str) -> Option<f64> {
    let mut seconds = 0.0;
    let mut factor = 3600.0;
    for part in text.splitn(3, ':') {
        let number: f64 = part.parse().ok()?;
        if !(0.0..100.0).contains(&number) {
            return None;
        }
        seconds += factor * number;
        factor /= 60.0;
    }
    text.contains(':').then_some(seconds)
}

/// Serial day of a date: 1 is 1 January 1900, and 60 is 29 February 1900, which did not exist but is counted by all
/// spreadsheets since Lotus 1-2-3.
fn serial_day(year: i64, month: i64, day: i64) -> i64 {
    // Days from 1 March of the year 0 (Hinnant, chrono-compatible low-level date algorithms).
    let (year, month) = if month > 2 { (year, month - 3) } else { (year - 1, month + 9) };
    let days = 365 * year + year / 4 - year / 100 + year / 400 + (153 * month + 2) / 5 + day - 1;
    let serial = days - EPOCH;
    if serial > 59 { serial + 1 } else { serial }
}

/// Day number of 31 December 1899, counted from 1 March of the year 0.
const EPOCH: i64 = 693_900;

/// Year, month and day of a serial day.
fn calendar_day(serial: i64) -> (i64, i64, i64) {
    let days = if serial > 60 { serial - 1 } else { serial } + EPOCH;
    let era = days.div_euclid(146_097);
    let of_era = days.rem_euclid(146_097);
    let year = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let day = of_year - (153 * month + 2) / 5 + 1;
    let (month, next) = if month < 10 { (month + 3, 0) } else { (month - 9, 1) };
    (year + 400 * era + next, month, day)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(moment: Option<Moment>) -> String {
        let mut text = String::new();
        moment.map_or_else(
            || "none".to_owned(),
            |moment| {
                moment.write(&mut text);
                text
            },
        )
    }

    #[test]
    fn serial_numbers_are_the_dates_that_spreadsheets_show() {
        let cases = [
            (45413.5, Meaning::Date, false, "2024-05-01T12:00:00"),
            (45413.5000005787, Meaning::Date, false, "2024-05-01T12:00:00.05"),
            (1.0, Meaning::Date, false, "1900-01-01T00:00:00"),
            (59.0, Meaning::Date, false, "1900-02-28T00:00:00"),
            (61.0, Meaning::Date, false, "1900-03-01T00:00:00"),
            (43951.5, Meaning::Date, true, "2024-05-01T12:00:00"),
            (45412.999999999, Meaning::Date, false, "2024-04-30T23:59:59.99991"),
            (45412.9999999999999, Meaning::Date, false, "2024-05-01T00:00:00"),
            (36585.0, Meaning::Date, false, "2000-02-29T00:00:00"),
            (2_958_465.0, Meaning::Date, false, "9999-12-31T00:00:00"),
            (0.5, Meaning::Time, true, "12:00:00"),
            (0.25, Meaning::Date, false, "06:00:00"),
            (5.787037037037037e-7, Meaning::Time, false, "00:00:00.05"),
            (1.5, Meaning::Time, false, "36:00:00"),
            (45413.5, Meaning::Time, false, "2024-05-01T12:00:00"),
            (43951.5, Meaning::Time, true, "2024-05-01T12:00:00"),
            (-1e-5, Meaning::Time, false, "-00:00:00.864"),
            (1e300, Meaning::Date, false, "none"),
            (f64::NAN, Meaning::Date, false, "none"),
        ];
        for (serial, meaning, from_1904, expected) in cases {
            assert_eq!(written(Moment::of_serial(serial, meaning, from_1904)), expected, "{serial}");
        }
    }

    #[test]
    fn dates_and_durations_as_text_are_read() {
        let cases = [
            ("2024-05-01", "2024-05-01T00:00:00"),
            ("2024-05-01T12:00:00.050", "2024-05-01T12:00:00.05"),
            ("1900-02-28", "1900-02-28T00:00:00"),
            ("1900-03-01T00:00:00Z", "1900-03-01T00:00:00"),
            ("12:30", "12:30:00"),
            ("2024-13-01", "none"),
            ("2024", "none"),
            ("12:aa", "none"),
        ];
        for (text, expected) in cases {
            assert_eq!(written(Moment::of_iso(text)), expected, "{text}");
        }
        let cases = [
            ("PT00H00M00.05S", "00:00:00.05"),
            ("PT36H", "36:00:00"),
            ("P1DT1M", "24:01:00"),
            ("-PT1.5S", "-00:00:01.5"),
            ("PT1X", "none"),
            ("P", "00:00:00"),
            ("1", "none"),
        ];
        for (text, expected) in cases {
            assert_eq!(written(Moment::of_duration(text)), expected, "{text}");
        }
    }
}

//! Dates in cells, `2026-01-02`, `20/02/2024`, `Feb 20, 2024`, `20-Feb-24`, and the order of day and month.

/// Seconds in a day.
pub(in crate::import) const DAY: f64 = 86_400.0;

/// Order of day and month in the dates of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DateOrder {
    /// `20/02/2024`
    DayFirst,
    /// `02/20/2024`
    MonthFirst,
}

impl DateOrder {
    /// Both orders.
    pub const ALL: [Self; 2] = [Self::DayFirst, Self::MonthFirst];

    /// Name in settings: `day-first`, `month-first`.
    pub fn code(self) -> &'static str {
        match self {
            Self::DayFirst => "day-first",
            Self::MonthFirst => "month-first",
        }
    }

    /// Order of this name in settings.
    pub fn from_code(code: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|order| order.code() == code)
    }
}

/// Order of day and month in a date, from its numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::import) enum Order {
    /// The notation states it, or there is no date.
    #[default]
    Stated,
    /// The second number is no month: `2/20/2024`.
    MonthFirst,
    /// The first number is no month: `20/02/2024`.
    DayFirst,
    /// Either is possible. The value is the date with the month first minus that with the day first, days.
    Open(f64),
}

/// Date, in days since 1 January 1970 (with the day first if the order is open), and the order of its numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::import) struct Date {
    pub days: f64,
    pub order: Order,
}

/// Date at the beginning of a text, and the rest of the text.
pub(in crate::import) fn read(text: &str) -> Option<(Date, &str)> {
    if text.starts_with(|first: char| first.is_ascii_digit()) {
        numeric(text).or_else(|| named(text))
    } else {
        named(text)
    }
}

fn stated(days: f64) -> Date {
    Date { days, order: Order::Stated }
}

/// Reads `2026-01-02`, `20/02/2024`, `20.02.24`.
fn numeric(text: &str) -> Option<(Date, &str)> {
    let end = text.find(['T', ' ', ',']).unwrap_or(text.len());
    let (date, rest) = text.split_at(end);
    let separator = date.chars().find(|character| !character.is_ascii_digit())?;
    if !matches!(separator, '-' | '/' | '.') {
        return None;
    }
    let mut parts = date.split(separator);
    let (first, second, third) = (parts.next()?, parts.next()?, parts.next()?);
    let (first_number, second_number, third_number) = (number(first)?, number(second)?, number(third)?);
    if parts.next().is_some() {
        return None;
    }
    if first.len() == 4 {
        return Some((stated(days(first_number, second_number, third_number)?), rest));
    }
    let year = year(third)?;
    let day_first = days(year, second_number, first_number);
    // Points separate the numbers of dates with the day first alone.
    let month_first = days(year, first_number, second_number).filter(|_| separator != '.');
    let date = match (day_first, month_first) {
        (Some(days), None) if separator == '.' => stated(days),
        (Some(days), None) => Date { days, order: Order::DayFirst },
        (None, Some(days)) => Date { days, order: Order::MonthFirst },
        (Some(days), Some(other)) => Date { days, order: Order::Open(other - days) },
        (None, None) => return None,
    };
    Some((date, rest))
}

/// Date of three numbers in an order, as `2024-02-20`; `None` for other texts.
///
/// # Errors
/// The date has only the other order.
pub(in crate::import) fn in_order(text: &str, order: DateOrder) -> Option<Result<String, ()>> {
    let (date, _) = numeric(text).filter(|(date, rest)| rest.is_empty() && date.order != Order::Stated)?;
    let month_first = order == DateOrder::MonthFirst;
    if date.order == if month_first { Order::DayFirst } else { Order::MonthFirst } {
        return Some(Err(()));
    }
    let parts: Vec<&str> = text.split(['/', '-']).collect();
    let [first, second, third] = parts[..] else { return None };
    let (month, day) = if month_first { (first, second) } else { (second, first) };
    Some(Ok(format!("{:04}-{:02}-{:02}", year(third)?, number(month)?, number(day)?)))
}

fn number(text: &str) -> Option<i64> {
    (!text.is_empty() && text.len() <= 4 && text.bytes().all(|byte| byte.is_ascii_digit()))
        .then(|| text.parse().ok())
        .flatten()
}

fn year(text: &str) -> Option<i64> {
    match text.len() {
        4 => number(text),
        2 => Some(2000 + number(text)?),
        _ => None,
    }
}

/// First letters of the months in English, Spanish, Portuguese, German, French and Italian.
const MONTHS: [&[&str]; 12] = [
    &["jan", "ene", "gen"],
    &["feb", "fev", "fév"],
    &["mar", "mär"],
    &["apr", "abr", "avr"],
    &["may", "mai", "mag"],
    &["jun", "juin", "giu"],
    &["jul", "juil", "lug"],
    &["aug", "ago", "aoû"],
    &["sep", "set"],
    &["oct", "okt", "out", "ott"],
    &["nov"],
    &["dec", "dez", "dic", "déc"],
];

fn month(word: &str) -> Option<i64> {
    let lower = word.to_lowercase();
    let known = (3..=10).contains(&lower.chars().count()) && lower.chars().all(char::is_alphabetic);
    let begins = |names: &[&str]| names.iter().any(|name| lower.starts_with(name));
    MONTHS.iter().position(|names| known && begins(names)).map(|place| place as i64 + 1)
}

/// Next word of letters or digits after blanks and signs, and the rest.
fn word(text: &str) -> Option<(&str, &str)> {
    let text = text.trim_start_matches([' ', ',', '-', '.', '/']);
    let digits = text.starts_with(|first: char| first.is_ascii_digit());
    let inside = |letter: char| if digits { letter.is_ascii_digit() } else { letter.is_alphabetic() };
    let end = text.find(|letter: char| !inside(letter)).unwrap_or(text.len());
    (end > 0).then(|| text.split_at(end))
}

/// Reads `Feb 20, 2024`, `Tue, 20 Feb 2024`, `20-Feb-24`.
fn named(text: &str) -> Option<(Date, &str)> {
    let (first, rest) = word(text)?;
    let weekday = first.starts_with(char::is_alphabetic) && month(first).is_none();
    let (first, rest) = if weekday && first.chars().count() <= 10 { word(rest)? } else { (first, rest) };
    let (second, rest) = word(rest)?;
    let (third, rest) = word(rest)?;
    let (month, day) = match (month(first), month(second)) {
        (Some(month), _) => (month, second),
        (None, Some(month)) => (month, first),
        (None, None) => return None,
    };
    let day = number(day).filter(|_| day.len() <= 2)?;
    // In `Feb 20 10:00:00` the year is missing.
    if rest.starts_with(':') {
        return None;
    }
    Some((stated(days(year(third)?, month, day)?), rest))
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

//! The classes of a store: choosing one, and listing them.

use crate::failure::Failure;
use crate::terminal::visible::visible;
use server::store::ClassRow;
use server::{Fault, Store};
use units::{Language, say, words};

/// Milliseconds of a day.
const DAY: u64 = 86_400_000;

/// The class with this code or title, or without a name the latest.
///
/// # Errors
/// No class, or several of this title. `fails` makes the failure of a store without classes.
pub fn chosen(
    classes: Vec<ClassRow>,
    name: Option<&str>,
    fails: impl Fn(Fault) -> Failure,
) -> Result<ClassRow, Failure> {
    let Some(name) = name else { return classes.into_iter().next().ok_or_else(|| fails(Fault::Missing)) };
    let is_code = |class: &ClassRow| class.code.eq_ignore_ascii_case(name.trim());
    let found: Vec<&ClassRow> = match classes.iter().find(|class| is_code(class)) {
        Some(class) => vec![class],
        None => classes.iter().filter(|class| class.title == name).collect(),
    };
    match found.as_slice() {
        [class] => Ok((*class).clone()),
        [] => {
            Err(Failure::in_words(words!("the store has no class {name}"), words("`meniscus class list` names them")))
        }
        _ => Err(Failure::in_words(
            words!("the store has several classes {name}"),
            words("name the code instead, which `meniscus class list` shows"),
        )),
    }
}

/// One line about a class: code, title, day on which it began, number of seats, and day on which it is erased.
///
/// # Errors
/// The store cannot be read.
pub async fn line(store: &Store, class: &ClassRow, language: Language) -> Result<String, Fault> {
    let seats = store.seats(class.class.clone()).await?.len();
    let (code, title) = (&class.code, visible(&class.title));
    let (begun, erased) = (day(class.created), day(class.expires));
    Ok(say!(language, "{code}: {title}, begun on {begun}, seats: {seats}, erased on {erased}"))
}

/// Day of a time in milliseconds since 1970, in UTC: `2026-11-29` (H. Hinnant, chrono-compatible low-level date algorithms).
fn day(time: u64) -> String {
    // Days since 1 March of year 0; eras of 400 years have 146,097 days.
    let days = time / DAY + 719_468;
    let (era, of_era) = (days / 146_097, days % 146_097);
    let year = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let day = of_year - (153 * month + 2) / 5 + 1;
    let (month, later) = if month < 10 { (month + 3, 0) } else { (month - 9, 1) };
    format!("{:04}-{month:02}-{day:02}", era * 400 + year + later)
}

#[cfg(test)]
mod tests {
    use super::{DAY, day};

    #[test]
    fn days_are_those_of_the_calendar() {
        for (days, expected) in
            [(0, "1970-01-01"), (11_016, "2000-02-29"), (11_017, "2000-03-01"), (20_786, "2026-11-29")]
        {
            assert_eq!(day(days * DAY + DAY - 1), expected);
        }
    }
}

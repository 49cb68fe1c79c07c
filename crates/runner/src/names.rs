//! Arguments with a name and a value: `NAME=VALUE`, and observed quantities, `y=COLUMN`.

use analysis::import::DateOrder;
use program::Seat;

/// A name with a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Assignment {
    /// Text before the equals sign.
    pub name: String,
    /// Text after the equals sign.
    pub value: String,
}

/// Parses the number of a seat.
pub fn seat(text: &str) -> Result<Seat, String> {
    text.trim().parse().map_err(|()| "a seat is a whole number from 1, such as 7".to_owned())
}

/// Parses `NAME=VALUE`.
pub fn assignment(text: &str) -> Result<Assignment, String> {
    match text.split_once('=') {
        Some((name, value)) if !name.trim().is_empty() && !value.trim().is_empty() => {
            Ok(Assignment { name: name.trim().to_owned(), value: value.trim().to_owned() })
        }
        _ => Err("write NAME=VALUE, such as b=200 or h_l='40 [dm]'".to_owned()),
    }
}

/// Parses `BUTTON=T`. The title of the button may contain an equals sign.
pub fn press(text: &str) -> Result<Assignment, String> {
    match text.rsplit_once('=') {
        Some((name, value)) if !name.trim().is_empty() && !value.trim().is_empty() => {
            Ok(Assignment { name: name.trim().to_owned(), value: value.trim().to_owned() })
        }
        _ => Err("write BUTTON=TIME, such as Kick=3.2 or Kick='200 [ms]'".to_owned()),
    }
}

/// Splits a list of names at its commas. Commas in brackets belong to a name, as in `T[30,30]`.
pub fn names_in(text: &str) -> Vec<&str> {
    let mut names = Vec::new();
    let (mut start, mut depth) = (0, 0_usize);
    for (at, letter) in text.char_indices() {
        match letter {
            '[' | '(' => depth += 1,
            ']' | ')' => depth = depth.saturating_sub(1),
            ',' if depth == 0 => {
                names.push(text[start..at].trim());
                start = at + 1;
            }
            _ => {}
        }
    }
    names.push(text[start..].trim());
    names
}

/// Argument of `--observe y` or `--observe y=COLUMN`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Observe {
    /// Observed quantity: an expression of the model, or a name.
    pub quantity: String,
    /// Column of the data, if stated.
    pub column: Option<String>,
}

/// Parses `day-first` or `month-first`.
pub fn date_order(text: &str) -> Result<DateOrder, String> {
    DateOrder::from_code(text).ok_or_else(|| "write day-first or month-first".to_owned())
}

/// Parses `y`, `y=COLUMN`, `y'=v`, and `Run 2.y`, the `y` of a run or body.
pub fn observe(text: &str) -> Result<Observe, String> {
    let (quantity, column) = match text.split_once('=') {
        Some((quantity, column)) => (quantity.trim(), Some(column.trim())),
        None => match text.rsplit_once('.').filter(|(body, name)| is_body(body, name)) {
            Some((_, name)) => (name.trim(), Some(text.trim())),
            None => (text.trim(), None),
        },
    };
    if quantity.is_empty() || column.is_some_and(str::is_empty) {
        return Err("write NAME or NAME=COLUMN, such as y, y=2 or y=mass_A.y".to_owned());
    }
    Ok(Observe { quantity: quantity.to_owned(), column: column.map(str::to_owned) })
}

/// True if the text before a point is the name of a body, not part of an expression such as `2.5*y`.
fn is_body(body: &str, name: &str) -> bool {
    body.contains(char::is_alphabetic)
        && !body.contains(['*', '/', '+', '^', '(', ')'])
        && name.trim().starts_with(char::is_alphabetic)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commas_in_brackets_belong_to_a_name() {
        assert_eq!(names_in("t"), ["t"]);
        assert_eq!(names_in("t, T[30,30],u[1, 2]', maximum(x) ,y"), ["t", "T[30,30]", "u[1, 2]'", "maximum(x)", "y"]);
        assert_eq!(names_in("a,,b]"), ["a", "", "b]"]);
    }

    #[test]
    fn assignments_keep_their_unit() {
        let expected = Assignment { name: "h_l".to_owned(), value: "40 [cm]".to_owned() };
        assert_eq!(assignment("h_l = 40 [cm]"), Ok(expected));
        assert!(assignment("h_l").is_err());
        assert!(assignment("=3").is_err());
    }

    #[test]
    fn observations_name_a_quantity_and_perhaps_a_column() {
        let expected = Observe { quantity: "y'".to_owned(), column: Some("v".to_owned()) };
        assert_eq!(observe("y' = v"), Ok(expected));
        assert_eq!(observe("y").map(|observe| observe.column), Ok(None));
        let of_run = Observe { quantity: "y".to_owned(), column: Some("Run 2.y".to_owned()) };
        assert_eq!(observe("Run 2.y"), Ok(of_run));
        assert_eq!(observe("2.5*y").map(|observe| observe.column), Ok(None));
        assert!(observe("=v").is_err() && observe("y=").is_err() && observe("").is_err());
    }
}

//! Roles indicated by the name of a column: a time, the number of a row, the error of another column.

use crate::error_name::{self, Belongs};
use std::collections::BTreeSet;

/// Names of times, in several languages.
const TIMES: [&str; 18] = [
    "t",
    "time",
    "tiempo",
    "temps",
    "tempo",
    "zeit",
    "elapsed time",
    "elapsed",
    "tiempo transcurrido",
    "seconds",
    "timestamp",
    "time stamp",
    "zeitstempel",
    "hora",
    "uhrzeit",
    "uptime",
    "millis",
    "micros",
];
/// Names of columns that number the rows. Single letters are case-sensitive: `N` is not one.
const ROWS: [&str; 24] = [
    "#",
    "n",
    "i",
    "no",
    "nr",
    "nº",
    "n°",
    "num",
    "number",
    "número",
    "numero",
    "index",
    "idx",
    "índice",
    "indice",
    "row",
    "fila",
    "zeile",
    "obs",
    "observation",
    "point",
    "punto",
    "lfd. nr",
    "unnamed: 0",
];
/// Names of frames and steps, which follow at a constant rate.
const FRAMES: [&str; 9] = ["frame", "frames", "step", "fotograma", "cuadro", "paso", "bild", "image", "imagen"];

/// True if a column of this name may hold times: `t`, `Time`, `t (camera)`. A capital `T` may be a temperature or a period.
pub(crate) fn is_time(name: &str) -> bool {
    let stem = name.split(['(', '[']).next().unwrap_or(name).trim();
    is_word(stem)
}

fn is_word(text: &str) -> bool {
    text != "T" && TIMES.contains(&text.to_lowercase().as_str())
}

/// Part of the name of a time that distinguishes it from other times, in lower case: `a` for `tA`, `heavy` for `Time heavy`
/// and `heavy time`, `1` for `time.1`, empty for `t`. `None` for other names.
pub(super) fn tag(name: &str) -> Option<String> {
    if is_word(name.trim()) {
        return Some(String::new());
    }
    let parts = parts(name);
    (1..=parts.len().min(2)).rev().find_map(|length| {
        let (first, rest) = parts.split_at(length);
        let (before, last) = parts.split_at(parts.len() - length);
        let last = last.join(" ");
        if is_word(&first.join(" ")) {
            Some(rest.join(" ").to_lowercase())
        } else {
            // `v_t` is a terminal velocity.
            (last.chars().count() >= 4 && is_word(&last)).then(|| before.join(" ").to_lowercase())
        }
    })
}

/// True if a name ends or begins with the tag of a time: `y heavy`, `yA`, `A_y`.
pub(super) fn has_tag(name: &str, tag: &str) -> bool {
    let name = parts(name).join(" ").to_lowercase();
    name.strip_suffix(tag).is_some_and(|rest| rest.is_empty() || rest.ends_with(' '))
        || name.strip_prefix(tag).is_some_and(|rest| rest.starts_with(' '))
}

/// Words and numbers of a name: `t`, `A` for `tA`; `time`, `1` for `time.1`.
fn parts(name: &str) -> Vec<&str> {
    let mut parts = Vec::new();
    let mut start = None;
    let mut before = ' ';
    for (place, letter) in name.char_indices() {
        let divides = (before.is_numeric() != letter.is_numeric()) || (before.is_lowercase() && letter.is_uppercase());
        if start.is_some() && (!letter.is_alphanumeric() || divides) {
            parts.extend(start.take().and_then(|start| name.get(start..place)));
        }
        if letter.is_alphanumeric() {
            start.get_or_insert(place);
        }
        before = letter;
    }
    parts.extend(start.and_then(|start| name.get(start..)));
    parts
}

/// True if a column of this name numbers the rows.
pub(super) fn is_row_number(name: &str) -> bool {
    is_in(&ROWS, name)
}

/// True if a column of this name counts frames or steps.
pub(super) fn is_frame(name: &str) -> bool {
    is_in(&FRAMES, name)
}

fn is_in(list: &[&str], name: &str) -> bool {
    let name = name.trim().trim_end_matches(['.', ':']);
    let stem = name.split(['_', '.']).next().unwrap_or_default();
    let known =
        |name: &str| list.contains(&name) || (name.chars().count() > 1 && list.contains(&name.to_lowercase().as_str()));
    known(name) || (stem.chars().count() > 1 && known(stem.trim_end_matches(|letter: char| letter.is_ascii_digit())))
}

/// True if a name is that of the errors of a column in `others` (names in lower case): `sigma_t`, `dt`, `u(t)`, `err_t`; or
/// that of the errors of the column before, `±`. `u_t` and `s_t` also count as errors here: beside `t` they are not times.
pub(super) fn is_error(name: &str, others: &BTreeSet<String>) -> bool {
    let short = || {
        let name = name.to_lowercase();
        let rest = name.strip_prefix(['u', 's']).map(|rest| rest.trim_start_matches(['_', ' ']));
        rest.is_some_and(|rest| !rest.is_empty() && others.contains(rest))
    };
    match error_name::of(name) {
        Some(Belongs::To(of) | Belongs::Perhaps(of)) => others.contains(&of.to_lowercase()),
        Some(Belongs::ToPrevious) => true,
        None => short(),
    }
}

#[cfg(test)]
mod tests {
    use super::{has_tag, is_error, is_frame, is_row_number, tag};

    #[test]
    fn times_are_known_by_their_names() {
        for (name, expected) in [
            ("t", Some("")),
            ("Tiempo", Some("")),
            ("tA", Some("a")),
            ("t_2", Some("2")),
            ("t12", Some("12")),
            ("time.1", Some("1")),
            ("Time heavy", Some("heavy")),
            ("heavy time", Some("heavy")),
            ("elapsed time 2", Some("2")),
            ("t (left)", Some("left")),
            ("Zeit_links", Some("links")),
            ("time_of_flight", Some("of flight")),
            ("T", None),
            ("T_1", None),
            ("v_t", None),
            ("tau", None),
            ("temperature", None),
            ("", None),
        ] {
            assert_eq!(tag(name).as_deref(), expected, "{name}");
        }
    }

    #[test]
    fn other_names_are_known() {
        for (name, tag) in [("y heavy", "heavy"), ("yA", "a"), ("A_y", "a"), ("y.1", "1"), ("y12", "12")] {
            assert!(has_tag(name, tag), "{name} {tag}");
        }
        for (name, tag) in [("y", "a"), ("ya", "a"), ("y12", "2"), ("area", "a")] {
            assert!(!has_tag(name, tag), "{name} {tag}");
        }
        assert!(
            ["Nr", "Nr.", "#", "index", "n", "i", "No", "Fila", "Unnamed: 0"].iter().all(|name| is_row_number(name))
        );
        assert!(["N", "I", "nu", "x", "norm"].iter().all(|name| !is_row_number(name)));
        assert!(is_frame("Frame") && is_frame("frame_2") && !is_frame("f"));
        let names = ["t", "y"].map(str::to_owned).into();
        assert!(
            ["sigma_t", "dy", "Δy", "u(y)", "err_y", "y_err", "±", "s_y"].iter().all(|name| is_error(name, &names))
        );
        assert!(!is_error("delay", &names) && !is_error("y", &names));
    }
}

//! Initial texts of new statements.

use super::Section;
use crate::Outline;
use crate::assist::{self, names_in};

/// A short statement of a section with unused names, to be edited. A quantity with an initial value needs an equation,
/// which the author must write: an invented equation would run without meaning.
pub fn proposal(outline: &Outline, section: Section) -> String {
    let taken = names_in(outline);
    let free = |letters: &str| {
        let plain = letters.chars().map(String::from);
        let numbered = (1..1000).flat_map(|number| letters.chars().map(move |letter| format!("{letter}_{number}")));
        plain.chain(numbered).find(|name| !taken.contains(name)).unwrap_or_default()
    };
    let (independent, unit) = assist::independent(outline);
    let unit = Some(unit).filter(|unit| !unit.is_empty());
    let of = unit.map_or_else(String::new, |unit| format!(" [{unit}]"));
    match section {
        Section::Parameters => format!("parameter {} = 1 in 0..2", free("abcpk")),
        Section::InitialValues => format!("{}(0) = 0", free("uvwxyz")),
        Section::Equations => format!("{} = 0", free("qrsfhj")),
        Section::Events => format!("when {independent} > 1{of} {{\n    stop\n}}"),
        Section::Choices => {
            let (choice, value) = (free("cdloj"), free("abpkn"));
            format!("choice {choice} {{\n    \"A\": {value} = 1\n    \"B\": {value} = 2\n}}")
        }
        Section::Tables => format!("table {}(x) {{\n    0 0\n    1 1\n}}", free("fghF")),
    }
}

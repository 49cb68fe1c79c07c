//! The words of a report in the languages it speaks.

use units::number::Style;

/// A language of reports.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Words {
    /// Spanish; else English.
    pub spanish: bool,
}

impl Words {
    /// The language of a tag such as `es-MX`.
    pub fn of(language: &str) -> Self {
        Self { spanish: language.split(['-', '_']).next().is_some_and(|tag| tag.eq_ignore_ascii_case("es")) }
    }

    /// The tag.
    pub fn tag(self) -> &'static str {
        if self.spanish { "es" } else { "en" }
    }

    /// How numbers are written.
    pub fn style(self) -> Style {
        Style::comma(self.spanish)
    }

    /// The one or the other.
    pub fn pick(self, english: &'static str, spanish: &'static str) -> &'static str {
        if self.spanish { spanish } else { english }
    }

    /// `a, b and c`
    pub fn join(self, parts: &[String]) -> String {
        match parts.split_last() {
            Some((end, [])) => end.clone(),
            Some((end, rest)) => [&rest.join(", "), self.pick(" and ", " y "), end].concat(),
            None => String::new(),
        }
    }
}

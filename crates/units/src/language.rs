//! Languages of the interface, and texts in all of them.

use crate::number::Style;
use std::borrow::Cow;

/// A language of the interface, the messages and the reports.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Language {
    /// English; also the default for unknown languages.
    #[default]
    English,
    /// Spanish.
    Spanish,
}

impl Language {
    /// All languages, in the order of the language switch.
    pub const ALL: [Self; 2] = [Self::English, Self::Spanish];

    /// The language of a tag such as `es-MX` or a locale such as `es_ES.UTF-8`; English if it is not supported.
    pub fn of(tag: &str) -> Self {
        let primary = tag.split(['-', '_', '.', '@']).next().unwrap_or_default();
        if primary.eq_ignore_ascii_case("es") { Self::Spanish } else { Self::English }
    }

    /// Language tag for `lang` attributes.
    pub fn tag(self) -> &'static str {
        self.pick("en", "es")
    }

    /// Name of the language in the language itself.
    pub fn name(self) -> &'static str {
        self.pick("English", "Español")
    }

    /// Style of numbers.
    pub fn style(self) -> Style {
        Style::of(self.tag())
    }

    /// Enumeration as text: `a, b and c`.
    pub fn join(self, parts: &[String]) -> String {
        match parts.split_last() {
            Some((end, [])) => end.clone(),
            Some((end, rest)) => [rest.join(", ").as_str(), self.pick(" and ", " y "), end].concat(),
            None => String::new(),
        }
    }

    /// The argument for this language.
    pub fn pick<T>(self, english: T, spanish: T) -> T {
        match self {
            Self::English => english,
            Self::Spanish => spanish,
        }
    }
}

/// A text in all languages, for messages made before the language of the reader is known.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Words {
    /// The English text.
    pub english: Cow<'static, str>,
    /// The Spanish text.
    pub spanish: Cow<'static, str>,
}

/// A constant text in both languages. The macro of the same name allows values in it.
pub const fn words(english: &'static str, spanish: &'static str) -> Words {
    Words { english: Cow::Borrowed(english), spanish: Cow::Borrowed(spanish) }
}

impl Words {
    /// A text that is identical in both languages, such as a name or a number.
    pub fn same(text: impl Into<Cow<'static, str>>) -> Self {
        let english = text.into();
        Self { spanish: english.clone(), english }
    }

    /// A text made by the same function for each language.
    pub fn each(text: impl Fn(Language) -> String) -> Self {
        Self { english: text(Language::English).into(), spanish: text(Language::Spanish).into() }
    }

    /// The text in one language.
    pub fn text(&self, language: Language) -> &str {
        language.pick(&self.english, &self.spanish)
    }

    /// True if the text is empty.
    pub fn is_empty(&self) -> bool {
        self.english.is_empty()
    }
}

/// A [`Words`] with values in it: an English and a Spanish format string, with variables and arguments as in `format!`. A
/// named argument must be a [`Words`]; each text uses its own language of it.
///
/// ```
/// use units::words;
/// let (name, kind) = ("y", words("a number", "un número"));
/// let text = words!("`{name}` is {kind}", "`{name}` es {kind}", kind = kind);
/// assert_eq!((&*text.english, &*text.spanish), ("`y` is a number", "`y` es un número"));
/// ```
#[macro_export]
macro_rules! words {
    ($english:literal, $spanish:literal, $($part:ident = $value:expr),+ $(,)?) => {{
        $(let $part = &$value;)+
        $crate::Words {
            english: {
                $(let $part = &$part.english;)+
                ::std::format!($english).into()
            },
            spanish: {
                $(let $part = &$part.spanish;)+
                ::std::format!($spanish).into()
            },
        }
    }};
    ($english:literal, $spanish:literal $(, $value:expr)* $(,)?) => {
        $crate::Words {
            english: ::std::format!($english $(, $value)*).into(),
            spanish: ::std::format!($spanish $(, $value)*).into(),
        }
    };
}

/// The text as a sentence: with a capital at the beginning and a full stop at the end.
pub fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(crate::alphabet::capital);
    // A text that begins with a name of one letter keeps it unchanged.
    match first.filter(|_| letters.as_str().starts_with(char::is_alphabetic)) {
        Some(first) => format!("{first}{}.", letters.as_str()),
        None => format!("{text}."),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tags_and_locales_name_a_language() {
        for tag in ["es", "ES", "es-MX", "es_ES.UTF-8", "es.UTF-8", "es@euro"] {
            assert_eq!(Language::of(tag), Language::Spanish, "{tag}");
        }
        for tag in ["", "en", "C", "C.UTF-8", "POSIX", "est", "esperanto", "fr_FR", "é"] {
            assert_eq!(Language::of(tag), Language::English, "{tag}");
        }
    }

    #[test]
    fn parts_stand_in_the_language_of_the_whole() {
        let (count, part) = (2, words("of mass", "de masa"));
        let whole = words!("{count} quantities {part}", "{count} magnitudes {part}", part = part);
        assert_eq!(whole.text(Language::English), "2 quantities of mass");
        assert_eq!(whole.text(Language::Spanish), "2 magnitudes de masa");
    }
}

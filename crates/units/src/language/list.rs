//! The languages.

use crate::number::Style;

/// Declares the languages: name in the code, tag, and name in the language itself.
macro_rules! languages {
    ($($language:ident $tag:literal $name:literal;)*) => {
        /// A language of the interface, the messages and the reports.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
        #[allow(missing_docs, reason = "each says itself")]
        pub enum Language {
            #[default]
            $($language,)*
        }

        impl Language {
            /// All languages, in the order of the language switch.
            pub const ALL: [Self; [$($tag),*].len()] = [$(Self::$language),*];

            /// Language tag for `lang` attributes.
            pub const fn tag(self) -> &'static str {
                match self {
                    $(Self::$language => $tag,)*
                }
            }

            /// Name of the language in the language itself.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$language => $name,)*
                }
            }
        }
    };
}

/// Hands the list of languages to a macro: for each its name in the code, its tag, and its name in itself. The first is that
/// of the texts in the code, and the default for unknown languages; each other one has the catalogue `TAG.po` in
/// `crates/catalogues/languages`.
#[macro_export]
macro_rules! with_languages {
    ($then:ident) => {
        $then! {
            English "en" "English";
            Spanish "es" "Español";
            Portuguese "pt" "Português";
        }
    };
}

with_languages!(languages);

impl Language {
    /// The language of a tag such as `es-MX` or a locale such as `es_ES.UTF-8`; English if it is not supported.
    pub fn of(tag: &str) -> Self {
        let primary = tag.split(['-', '_', '.', '@']).next().unwrap_or_default();
        let known = Self::ALL.iter().find(|language| primary.eq_ignore_ascii_case(language.tag()));
        known.copied().unwrap_or_default()
    }

    /// Style of numbers.
    pub fn style(self) -> Style {
        Style::of(self.tag())
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
}

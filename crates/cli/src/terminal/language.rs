//! Language of messages.

use units::Language;

/// Environment variables that state the language, in the order of priority of POSIX.
const VARIABLES: [&str; 3] = ["LC_ALL", "LC_MESSAGES", "LANG"];

/// The requested language, otherwise that of the environment.
pub fn chosen(asked: Option<Language>) -> Language {
    asked.unwrap_or_else(|| {
        let set = VARIABLES.iter().filter_map(std::env::var_os).find(|value| !value.is_empty());
        Language::of(&set.unwrap_or_default().to_string_lossy())
    })
}

/// Parses a language tag: `es`, `es-MX`, `en`.
///
/// # Errors
/// The program does not have the language.
pub fn parse(tag: &str) -> Result<Language, String> {
    let language = Language::of(tag);
    let primary = tag.split(['-', '_']).next().unwrap_or_default();
    if primary.eq_ignore_ascii_case(language.tag()) {
        Ok(language)
    } else {
        Err(format!("the languages are {}", Language::ALL.map(Language::tag).join(" and ")))
    }
}

//! The language in which the program speaks.

use units::Language;

/// Where the system says which language a person reads, in the order in which POSIX has it.
const VARIABLES: [&str; 3] = ["LC_ALL", "LC_MESSAGES", "LANG"];

/// The language that was asked for, else that of the environment.
pub fn chosen(asked: Option<Language>) -> Language {
    asked.unwrap_or_else(|| {
        let set = VARIABLES.iter().filter_map(std::env::var_os).find(|value| !value.is_empty());
        Language::of(&set.unwrap_or_default().to_string_lossy())
    })
}

/// Reads `es`, `es-MX`, `en`.
///
/// # Errors
/// When the program does not speak the language.
pub fn parse(tag: &str) -> Result<Language, String> {
    let language = Language::of(tag);
    let primary = tag.split(['-', '_']).next().unwrap_or_default();
    if primary.eq_ignore_ascii_case(language.tag()) {
        Ok(language)
    } else {
        Err(format!("the languages are {}", Language::ALL.map(Language::tag).join(" and ")))
    }
}

//! Templates for new documents.

use units::Language;

/// A short document to start from.
#[derive(Clone, Copy, Debug)]
pub struct Template {
    /// File name without extension.
    pub name: &'static str,
    /// English, which stands for languages without a template of their own.
    english: &'static str,
    spanish: &'static str,
}

impl Template {
    /// Text in a language.
    pub fn text(&self, language: Language) -> &'static str {
        match language {
            Language::Spanish => self.spanish,
            _ => self.english,
        }
    }

    /// True for the template that contains only the structure.
    pub fn is_empty(&self) -> bool {
        self.name == TEMPLATES[0].name
    }

    /// Title in a language.
    pub fn title(&self, language: Language) -> String {
        crate::card(self.text(language)).title
    }
}

macro_rules! templates {
    ($($name:literal),*) => {
        [$(Template {
            name: $name,
            english: include_str!(concat!("../templates/en/", $name, ".md")),
            spanish: include_str!(concat!("../templates/es/", $name, ".md")),
        }),*]
    };
}

/// All templates, the shortest first.
pub const TEMPLATES: [Template; 7] =
    templates!["empty", "oscillator", "coupled-bodies", "circuit", "projectile", "formula", "map"];

/// Maximum length of a file name made from a title, in characters.
const LONGEST_NAME: usize = 60;

/// File name of a document. A document that still has the name of a template is named after its title:
/// `a-mass-on-a-spring.md`.
pub fn file_name(name: &str, text: &str) -> String {
    let (stem, ending) = name.split_once('.').unwrap_or((name, "md"));
    if !TEMPLATES.iter().any(|template| template.name == stem) {
        return name.to_owned();
    }
    let title = crate::card(text).title.to_lowercase();
    let words = title.split(|letter: char| !letter.is_alphanumeric()).filter(|word| !word.is_empty());
    let title: String = words.collect::<Vec<_>>().join("-").chars().take(LONGEST_NAME).collect();
    let title = title.trim_end_matches('-');
    if title.is_empty() { name.to_owned() } else { format!("{title}.{ending}") }
}

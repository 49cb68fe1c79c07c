//! What a new document can begin with.

use units::Language;

/// A short document to begin with.
#[derive(Clone, Copy, Debug)]
pub struct Template {
    /// What its file is called, without an ending.
    pub name: &'static str,
    english: &'static str,
    spanish: &'static str,
}

impl Template {
    /// Its text in a language.
    pub fn text(&self, language: Language) -> &'static str {
        language.pick(self.english, self.spanish)
    }

    /// Whether it says no more than where things go.
    pub fn is_empty(&self) -> bool {
        self.name == TEMPLATES[0].name
    }

    /// Its title in a language.
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

/// The templates, the shortest first.
pub const TEMPLATES: [Template; 7] =
    templates!["empty", "oscillator", "coupled-bodies", "circuit", "projectile", "formula", "map"];

//! The file with the answers to a survey, which `saved::survey` reads.

use super::{Survey, names};
use crate::Basis;
use handed::json::{self, Object};
use program::SurveyKind;

/// Version of the format.
const VERSION: u32 = 1;

impl Survey {
    /// Content of the file: title of the document and all items, texts in the document's own language. It
    /// has no name, seat or time.
    pub fn file(&self, basis: &Basis) -> String {
        let program = basis.program();
        let names = names(program);
        let items = names.iter().zip(&self.given).zip(&program.survey).enumerate();
        let items = items.map(|(index, ((name, given), item))| {
            let text = program.survey_text(&program.language, index);
            let object = Object::default()
                .with("name", json::text(name))
                .with("kind", json::text(item.kind.word()))
                .with("asked", json::text(&text.asked));
            let object = if item.kind == SurveyKind::Text {
                object.with_some("typed", (!given.typed.is_empty()).then(|| json::text(&given.typed)))
            } else {
                object
                    .with("words", json::list(text.words.iter().map(|word| json::text(word))))
                    .with("of", item.answers.to_string())
                    .with_some("chosen", given.chosen.map(|chosen| (chosen + 1).to_string()))
            };
            object.end()
        });
        // A line for each item, for those who look what they send.
        let items = items.collect::<Vec<_>>().join(",\n");
        let file = Object::default()
            .with("meniscus survey", VERSION.to_string())
            .with("document", json::text(&program.title))
            .with("items", format!("[\n{items}\n]"));
        file.end() + "\n"
    }
}

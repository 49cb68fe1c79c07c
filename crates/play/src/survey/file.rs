//! The file with the answers to a survey, which `saved::survey` reads. It is written here because pages of a single
//! simulation contain no writer of JSON.

use super::{Survey, names};
use crate::Basis;
use program::SurveyKind;
use std::fmt::Write;

/// Version of the format.
const VERSION: u32 = 1;

impl Survey {
    /// Content of the file: title of the document and all items, texts in the document's own language. It
    /// has no name, seat or time.
    pub fn file(&self, basis: &Basis) -> String {
        let program = basis.program();
        let mut out = format!("{{\"meniscus survey\":{VERSION},\"document\":");
        write_text(&mut out, &program.title);
        out.push_str(",\"items\":[");
        let mut separator = "\n";
        for (index, (name, given)) in names(program).iter().zip(&self.given).enumerate() {
            let Some(item) = program.survey.get(index) else { continue };
            let text = program.survey_text(&program.language, index);
            // Writing to a string cannot fail.
            let _ = write!(out, "{separator}{{\"name\":\"{name}\",\"kind\":\"{}\",\"asked\":", item.kind.word());
            write_text(&mut out, &text.asked);
            if item.kind == SurveyKind::Text {
                if !given.typed.is_empty() {
                    out.push_str(",\"typed\":");
                    write_text(&mut out, &given.typed);
                }
            } else {
                out.push_str(",\"words\":[");
                for (place, word) in text.words.iter().enumerate() {
                    out.push_str(if place > 0 { "," } else { "" });
                    write_text(&mut out, word);
                }
                let _ = write!(out, "],\"of\":{}", item.answers);
                if let Some(chosen) = given.chosen {
                    let _ = write!(out, ",\"chosen\":{}", chosen + 1);
                }
            }
            out.push('}');
            separator = ",\n";
        }
        out.push_str("\n]}\n");
        out
    }
}

/// Writes a text as a JSON string.
fn write_text(out: &mut String, text: &str) {
    out.push('"');
    for letter in text.chars() {
        match letter {
            '"' | '\\' => out.extend(['\\', letter]),
            control if control < ' ' => {
                let _ = write!(out, "\\u{:04x}", u32::from(control));
            }
            other => out.push(other),
        }
    }
    out.push('"');
}

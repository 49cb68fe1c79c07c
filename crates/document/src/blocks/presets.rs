//! Presets: `"Mercury": rho = 13534 [kg/m^3]`, in groups.

use crate::expressions::Expressions;
use model::{Diagnostic, Sentence, inside};
use program::Preset;
use units::words;

/// Maximum number of presets of a document.
const PRESETS: usize = 100;

/// Reads presets. `group "Liquid"` stands before the presets of a group.
pub fn read(expressions: &mut Expressions, sentences: &[Sentence], presets: &mut Vec<Preset>) {
    let source = expressions.source;
    let mut group = None;
    for sentence in sentences {
        let span = sentence.span;
        if sentence.head.is_some() {
            match sentence.title.filter(|title| title.end == span.end) {
                Some(name) => group = Some(inside(source, name).to_owned()).filter(|name| !name.trim().is_empty()),
                None => expressions.diagnostics.push(
                    Diagnostic::error("preset-syntax", words("a group is named in quotation marks"), span)
                        .with_hint(words("write `group \"Liquid\"`")),
                ),
            }
            continue;
        }
        if presets.len() == PRESETS {
            expressions.error("too-large", words!("a document cannot have more than {PRESETS} presets"), span);
            return;
        }
        presets.extend(preset(expressions, sentence, &group));
    }
}

fn preset(expressions: &mut Expressions, sentence: &Sentence, group: &Option<String>) -> Option<Preset> {
    let Some(name) = sentence.title_text(expressions.source).filter(|_| sentence.colon.is_some()) else {
        expressions.diagnostics.push(
            Diagnostic::error(
                "preset-syntax",
                words("a preset is a name in quotation marks, a colon and values"),
                sentence.span,
            )
            .with_hint(words("write `\"Mercury\": rho = 13534 [kg/m^3]`")),
        );
        return None;
    };
    let values = expressions.assignments(sentence.body.range());
    (!values.is_empty()).then(|| Preset { group: group.clone(), name: name.to_owned(), values })
}

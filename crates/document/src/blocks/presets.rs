//! Presets: `"Mercury": rho = 13534 [kg/m^3]`, in groups.

use crate::expressions::Expressions;
use crate::text::scan::{leading_text, statements};
use crate::text::source::trim;
use model::{Diagnostic, Span};
use program::Preset;
use std::ops::Range;
use units::words;

/// Maximum number of presets of a document.
const PRESETS: usize = 100;

/// Reads the presets in `range`. `group "Liquid"` stands before the presets of a group.
pub fn read(expressions: &mut Expressions, range: Range<usize>, presets: &mut Vec<Preset>) {
    let source = expressions.source;
    let mut group = None;
    for statement in statements(source, range) {
        let span = Span::new(statement.start, statement.end);
        if let Some(rest) = source[statement.clone()].strip_prefix("group") {
            let rest = trim(source, statement.end - rest.len()..statement.end);
            match leading_text(source, rest.clone()).filter(|(_, end)| *end == rest.end) {
                Some((name, _)) => group = Some(name.to_owned()).filter(|name| !name.trim().is_empty()),
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
        presets.extend(preset(expressions, statement, &group));
    }
}

fn preset(expressions: &mut Expressions, statement: Range<usize>, group: &Option<String>) -> Option<Preset> {
    let source = expressions.source;
    let span = Span::new(statement.start, statement.end);
    let name = leading_text(source, statement.clone()).filter(|(name, _)| !name.trim().is_empty());
    let values = name.and_then(|(name, end)| {
        let rest = trim(source, end..statement.end);
        source[rest.clone()].starts_with(':').then(|| (name, rest.start + 1..rest.end))
    });
    let Some((name, range)) = values else {
        expressions.diagnostics.push(
            Diagnostic::error(
                "preset-syntax",
                words("a preset is a name in quotation marks, a colon and values"),
                span,
            )
            .with_hint(words("write `\"Mercury\": rho = 13534 [kg/m^3]`")),
        );
        return None;
    };
    let values = expressions.assignments(range);
    (!values.is_empty()).then(|| Preset { group: group.clone(), name: name.to_owned(), values })
}

//! A scene's `<style>`: rules of its own, kept inside the scene.

use super::allowed::{danger, is_id, is_property};
use model::{Diagnostic, Span};
use std::ops::Range;
use units::{Words, words};

/// The class of the `svg` element, to which every rule is confined.
pub const SCENE_CLASS: &str = "authored";
/// What stands before the author's ids and classes, so that none meets one of the page.
pub const PREFIX: &str = "scene-";

/// The rules in `range` of `source` that may stand in the page.
pub fn confine(source: &str, range: Range<usize>, diagnostics: &mut Vec<Diagnostic>) -> String {
    let mut confined = String::new();
    let mut at = range.start;
    while let Some(length) = source[at..range.end].find('}') {
        let rule = at..at + length;
        at = rule.end + 1;
        match confine_rule(source, rule.clone()) {
            Ok(rule) => confined.push_str(&rule),
            Err((message, range)) => diagnostics.push(refusal(message, range)),
        }
    }
    let rest = crate::source::trim(source, at..range.end);
    if !rest.is_empty() {
        diagnostics.push(refusal(words("the rule is not closed with `}`", "la regla no se cierra con `}`"), rest));
    }
    confined
}

fn refusal(message: Words, range: Range<usize>) -> Diagnostic {
    Diagnostic::error("scene-style", message, Span::new(range.start, range.end)).with_hint(words(
        "a scene's style may set colours, strokes and fonts: `.spring { stroke: var(--accent) }`; it holds no values \
         of the model",
        "el estilo de una escena puede fijar colores, trazos y letras: `.spring { stroke: var(--accent) }`; no contiene \
         valores del modelo",
    ))
}

type Refusal = (Words, Range<usize>);

/// `selectors { declarations`
fn confine_rule(source: &str, rule: Range<usize>) -> Result<String, Refusal> {
    let text = &source[rule.clone()];
    let Some((selectors, declarations)) = text.split_once('{') else {
        return Err((
            words("a rule is `selector { property: value }`", "una regla es `selector { property: value }`"),
            rule,
        ));
    };
    let selectors: Option<Vec<String>> = selectors.split(',').map(confine_selector).collect();
    let Some(selectors) = selectors else {
        return Err((
            words("this selector cannot be confined to the scene", "este selector no se puede limitar a la escena"),
            rule.start..rule.start + text.len() - declarations.len() - 1,
        ));
    };
    let mut confined = String::new();
    let mut at = rule.end - declarations.len();
    for declaration in declarations.split(';') {
        let range = crate::source::trim(source, at..at + declaration.len());
        at += declaration.len() + 1;
        if range.is_empty() {
            continue;
        }
        let (name, value) = declaration.split_once(':').unwrap_or((declaration, ""));
        let (name, value) = (name.trim(), value.trim());
        if !is_property(name) || !is_plain(value) {
            return Err((
                words!("`{}` cannot be set in a scene", "`{}` no se puede fijar en una escena", &source[range.clone()]),
                range,
            ));
        }
        confined.push_str(&format!("{name}:{value};"));
    }
    Ok(format!("{}{{{confined}}}", selectors.join(",")))
}

/// `.authored g.scene-spring > path` from `g.spring > path`: names, classes, ids and hovering.
fn confine_selector(selector: &str) -> Option<String> {
    let mut confined = format!(".{SCENE_CLASS}");
    for part in selector.split_whitespace() {
        confined.push(' ');
        if part == ">" {
            confined.push('>');
            continue;
        }
        let part = match part.strip_suffix(":hover") {
            Some(hovered) => (hovered, ":hover"),
            None => (part, ""),
        };
        if part.0.ends_with(['.', '#']) {
            return None;
        }
        for (number, name) in part.0.split_inclusive(['.', '#']).enumerate() {
            let (name, mark) = match name.strip_suffix(['.', '#']) {
                Some(stem) => (stem, &name[stem.len()..]),
                None => (name, ""),
            };
            let only_marks = number == 0 && name.is_empty() && !mark.is_empty();
            if !is_id(name) && !only_marks {
                return None;
            }
            confined.push_str(name);
            confined.push_str(mark);
            if !mark.is_empty() {
                confined.push_str(PREFIX);
            }
        }
        confined.push_str(part.1);
    }
    (confined.len() > SCENE_CLASS.len() + 1).then_some(confined)
}

/// Whether a value consists of words, numbers, colours and harmless functions.
fn is_plain(value: &str) -> bool {
    !value.is_empty()
        && danger(value).is_none()
        && value.chars().all(|c| c.is_ascii_alphanumeric() || " #.,%()+-*/_".contains(c))
        && !value.contains("/*")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(style: &str, expected: &str, messages: &[&str]) {
        let mut diagnostics = Vec::new();
        assert_eq!(confine(style, 0..style.len(), &mut diagnostics), expected);
        assert_eq!(diagnostics.iter().map(|d| &*d.message.english).collect::<Vec<_>>(), messages);
    }

    #[test]
    fn rules_are_confined() {
        check(
            ".a, g.b > #c:hover { fill: var(--liquid); stroke-width: 2 }\npath{}",
            ".authored .scene-a,.authored g.scene-b > #scene-c:hover{fill:var(--liquid);stroke-width:2;}.authored path{}",
            &[],
        );
    }

    #[test]
    fn what_reaches_further_is_refused() {
        for rule in [
            "* { fill: red }",
            "body { fill: red",
            "@import x;",
            "a { position: fixed }",
            "a { fill: url(#b) }",
            "a { fill: u\\72l(x) }",
            "a{b{c:d}}",
            "</style> { fill: red }",
            "a { clip-path: none }",
            "[x] { fill: red }",
            ":root { fill: red }",
            "{ fill: red }",
            "a { fill: /*x }",
            ". { fill: red }",
            "a..b { fill: red }",
            "a { fill: red; --x: y }",
        ] {
            let mut diagnostics = Vec::new();
            let confined = confine(rule, 0..rule.len(), &mut diagnostics);
            assert_eq!(confined, "", "{rule}");
            assert!(!diagnostics.is_empty(), "{rule}");
        }
    }
}

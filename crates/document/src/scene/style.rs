//! The `<style>` of a scene. The page shows each scene in a shadow tree, to which its rules are confined.

use super::allowed::{danger, is_id, is_property};
use super::appearance::misfit;
use super::colours::{is_colour, palette};
use model::{Diagnostic, Span};
use std::ops::Range;
use units::{Words, words};

/// The permitted rules in `range` of `source`.
pub fn rules(source: &str, range: Range<usize>, diagnostics: &mut Vec<Diagnostic>) -> String {
    let mut allowed = String::new();
    let mut at = range.start;
    while let Some(length) = source[at..range.end].find('}') {
        let place = at..at + length;
        at = place.end + 1;
        match rule(source, place, diagnostics) {
            Ok(rule) => allowed.push_str(&rule),
            Err((message, range)) => diagnostics.push(refusal(message, range)),
        }
    }
    let rest = crate::text::source::trim(source, at..range.end);
    if !rest.is_empty() {
        diagnostics.push(refusal(words("the rule is not closed with `}`"), rest));
    }
    allowed
}

fn refusal(message: Words, range: Range<usize>) -> Diagnostic {
    Diagnostic::error("scene-style", message, Span::new(range.start, range.end)).with_hint(words(
        "a scene's style may set colours, strokes and fonts: `.spring { stroke: var(--accent) }`; it holds no values \
         of the model",
    ))
}

type Refusal = (Words, Range<usize>);

/// Checks `selectors { declarations`. Declarations that a browser would ignore are reported and left out.
fn rule(source: &str, rule: Range<usize>, diagnostics: &mut Vec<Diagnostic>) -> Result<String, Refusal> {
    let text = &source[rule.clone()];
    let Some((selectors, declarations)) = text.split_once('{') else {
        return Err((words("a rule is `selector { property: value }`"), rule));
    };
    let selectors: Option<Vec<String>> = selectors.split(',').map(selector).collect();
    let Some(selectors) = selectors else {
        return Err((
            words("this selector is not allowed in a scene"),
            rule.start..rule.start + text.len() - declarations.len() - 1,
        ));
    };
    let mut confined = String::new();
    let mut at = rule.end - declarations.len();
    for declaration in declarations.split(';') {
        let range = crate::text::source::trim(source, at..at + declaration.len());
        at += declaration.len() + 1;
        if range.is_empty() {
            continue;
        }
        let (name, value) = declaration.split_once(':').unwrap_or((declaration, ""));
        let (name, value) = (name.trim(), value.trim());
        if !is_property(name) || !is_plain(value) {
            return Err((words!("`{}` cannot be set in a scene", &source[range.clone()]), range));
        }
        if let Some(found) = misfit(name, value, Span::new(range.end - value.len(), range.end)) {
            diagnostics.push(found);
            continue;
        }
        let value = palette(value).filter(|_| is_colour(name)).unwrap_or(value);
        confined.push_str(&format!("{name}:{value};"));
    }
    Ok(format!("{}{{{confined}}}", selectors.join(",")))
}

/// A permitted selector with single blanks, such as `g.spring > path`: names, classes, ids and `:hover`.
fn selector(written: &str) -> Option<String> {
    let parts: Vec<&str> = written.split_whitespace().collect();
    let is_known = |part: &&str| {
        let name = part.strip_suffix(":hover").unwrap_or(part);
        // `#c`, `g.b`: only the element before the first mark may be missing.
        let mut names = name.split(['.', '#']);
        let element = names.next().unwrap_or_default();
        (element.is_empty() && name.len() > 1 || is_id(element)) && names.all(is_id)
    };
    let good = !parts.is_empty() && parts.iter().all(|part| *part == ">" || is_known(part));
    good.then(|| parts.join(" "))
}

/// True if a value consists of words, numbers, colours and harmless functions.
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
        assert_eq!(rules(style, 0..style.len(), &mut diagnostics), expected);
        assert_eq!(diagnostics.iter().map(|d| d.message.english()).collect::<Vec<_>>(), messages);
    }

    #[test]
    fn rules_of_a_scene_stay_as_they_are() {
        check(
            ".a, g.b > #c:hover { fill: var(--liquid); stroke-width: 2 }\npath{}",
            ".a,g.b > #c:hover{fill:var(--liquid);stroke-width:2;}path{}",
            &[],
        );
    }

    #[test]
    fn colours_of_the_page_have_their_names_and_faulty_values_are_left_out() {
        check(
            ".a { fill: mark; stroke-width: 2 } .b { fill: bleu; stroke-width: abc; opacity: 0.5 }",
            ".a{fill:var(--mark, #c4551d);stroke-width:2;}.b{opacity:0.5;}",
            &["\"bleu\" is not a colour", "`stroke-width` cannot be `abc`"],
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
            let allowed = rules(rule, 0..rule.len(), &mut diagnostics);
            assert_eq!(allowed, "", "{rule}");
            assert!(!diagnostics.is_empty(), "{rule}");
        }
    }
}

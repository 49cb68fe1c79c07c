//! Suggestions and explanations at places of a document marked by `|`.

use document::assist::{Completion, complete, explain, typeset_at};
use program::functions::{FUNCTIONS, Function};

const DOCUMENT: &str = "---\ntitle: Spring\nst\n---\n\nText {x in [c]} here.\n\n```model\nparameter k = 4 [N/m] in 1..9 \"Stiffness\"\n\
parameter m = 1 [kg]\nm*x'' = -k*x\nx(0) = 3 [cm] \"Displacement\"\nx'(0) = 0\nomega = sqrt(k/m) \"Natural frequency\"\n\
function half(u) = u/2\nE = half(k*x^2)\npa\nF = -k*o # om\n```\n\n```scene\n<svg viewBox=\"0 0 9 9\"><frame x=\"-1..1 [m]\">\
<sp from=\"(0, 0)\" to=\"(om, 0)\" stroke-width=\"2\" vi/></frame></svg>\n```\n";

fn at(before: &str, behind: &str) -> (document::Opened, usize) {
    let place = DOCUMENT.find(&format!("{before}{behind}")).expect("it stands there") + before.len();
    (document::open(&DOCUMENT.replace("\npa\n", "\n\n").replace("-k*o ", "-k*x "), &[]), place)
}

fn completed(before: &str, behind: &str) -> Completion {
    let (opened, offset) = at(before, behind);
    let program = opened.document.as_ref().map(|document| &document.program);
    assert!(program.is_some(), "{:?}", opened.diagnostics);
    complete(&document::read(DOCUMENT), program, offset)
}

/// Suggested texts, and the text that they replace.
fn texts(before: &str, behind: &str) -> (String, Vec<String>) {
    let found = completed(before, behind);
    (DOCUMENT[found.span.range()].to_owned(), found.suggestions.into_iter().map(|suggestion| suggestion.text).collect())
}

#[test]
fn suggestions_fit_their_place() {
    for (before, behind, word, first) in [
        ("\nst", "\n---", "st", "step: "),
        ("Text {x in [c", "]", "c", "cm"),
        ("\npa", "\n", "pa", "parameter"),
        ("= -k*o", " #", "o", "omega"),
        ("to=\"(om", ",", "om", "omega"),
        ("<sp", " from", "sp", "spring"),
        ("vi", "/>", "vi", "visible=\"\""),
        ("```sc", "ene", "sc", "scene"),
    ] {
        let (begun, found) = texts(before, behind);
        assert_eq!((begun.as_str(), found.first().map(String::as_str)), (word, Some(first)), "{before}: {found:?}");
    }
    // No suggestions in comments, labels, numbers and prose.
    for (before, behind) in [("# om", "\n"), ("\"Stiff", "ness"), ("x(0) = 3", " [cm]"), ("Te", "xt")] {
        assert_eq!(texts(before, behind).1, [""; 0], "{before}");
    }
}

#[test]
fn names_come_first_with_label_and_unit() {
    let found = completed("= -k*", "o #");
    let listed: Vec<(&str, String)> = found.suggestions[..7]
        .iter()
        .map(|suggestion| (suggestion.text.as_str(), suggestion.meaning.english()))
        .collect();
    assert_eq!(
        listed,
        [
            ("k", "Stiffness, parameter in N/m".to_owned()),
            ("m", "parameter in kg".to_owned()),
            ("x", "Displacement, state in m".to_owned()),
            ("omega", "Natural frequency, quantity in 1/s".to_owned()),
            ("half", "function of this document".to_owned()),
            ("E", "quantity in J".to_owned()),
            ("F", "quantity in N".to_owned()),
        ]
    );
}

#[test]
fn words_are_explained() {
    for (before, behind, word, meaning) in [
        ("sqrt(k", "/m)", "k", "Stiffness, parameter in N/m"),
        ("omega = sq", "rt(k", "sqrt", "square root"),
        ("3 [c", "m]", "cm", "length"),
        ("stroke-wi", "dth", "stroke-width", "width of the line"),
        ("F = -", "k*o", "k", "Stiffness, parameter in N/m"),
        ("\nti", "tle", "title", "title of the simulation"),
        ("\nparam", "eter m", "parameter", "a number with a slider: parameter b = 0.2 [kg/s] in 0..2"),
        ("<fra", "me x", "frame", "axes of lengths for what it holds: x=\"-2..2 [m]\""),
    ] {
        let (opened, offset) = at(before, behind);
        let program = opened.document.as_ref().map(|document| &document.program);
        let found = explain(&document::read(DOCUMENT), program, offset).unwrap_or_else(|| panic!("{before}"));
        assert_eq!((&DOCUMENT[found.span.range()], &*found.meaning.english()), (word, meaning), "{before}");
    }
}

#[test]
fn a_name_has_its_dimension_with_its_primes_and_its_statement() {
    for (before, behind, word, dimension) in [
        ("\nm*x", "'' = ", "x''", Some("acceleration")),
        ("-k*", "x\nx(0)", "x", Some("length")),
        ("\nx", "'(0) = 0", "x'", Some("velocity")),
        ("sqrt(k", "/m)", "k", Some("spring constant")),
        ("omega = sq", "rt(k", "sqrt", None),
    ] {
        let (opened, offset) = at(before, behind);
        let program = opened.document.as_ref().map(|document| &document.program);
        let found = explain(&document::read(DOCUMENT), program, offset).unwrap_or_else(|| panic!("{before}"));
        let named = found.dimension.as_ref().map(|words| words.english());
        assert_eq!((&DOCUMENT[found.span.range()], named.as_deref()), (word, dimension), "{before}");
    }
    let typeset = |before, behind| typeset_at(&document::read(DOCUMENT), at(before, behind).1);
    assert!(typeset("omega = sq", "rt(k").contains("<msqrt>"));
    assert_eq!(typeset("Te", "xt"), "");
}

#[test]
fn every_function_and_part_is_explained() {
    let found = completed("= -k*", "o #");
    for function in FUNCTIONS.iter().filter(|function| function.name != Function::STREAM) {
        let known = found.suggestions.iter().find(|suggestion| suggestion.text == function.name);
        let meaning = known.map(|suggestion| &suggestion.meaning).unwrap_or_else(|| panic!("{}", function.name));
        assert!(
            !meaning.english().is_empty() && !meaning.text(catalogues::with(units::Language::Spanish)).is_empty(),
            "{}",
            function.name
        );
    }
}

/// Any place of a document, also inside a character.
#[test]
fn no_place_is_too_strange() {
    let text = format!("{DOCUMENT}γ·“’ ```\n<svg {{ [µ");
    let outline = document::read(&text);
    for offset in 0..text.len() + 3 {
        let found = complete(&outline, None, offset);
        assert!(text.get(found.span.range()).is_some(), "{offset}");
        explain(&outline, None, offset);
    }
}

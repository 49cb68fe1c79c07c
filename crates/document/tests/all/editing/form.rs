//! Text and form agree: a value set in a cell is read there afterwards, and all other bytes are unchanged.

use super::edit::documents;
use document::edit::{Edit, EditError, Obstacle, add_statement, apply, remove_statement, set_cell};
use document::form::{CellKind, Form, Section, proposal, read as form};
use document::{open, read};
use model::Span;
use proptest::prelude::*;

const SPRING: &str = "---\ntitle: A\n---\n\nA mass m.\n\n```model\nparameter m   = 0.5 [kg] in 0.1..2 step 0.1 \"Mass\"  # of the bob\nparameter k_1 = 20  [N/m]\nswitch drag = on \"Air\"\nsize N = 3 in 1..9\nm*y'' = -k_1*y   # Newton\ny(0)  = 10 [cm] in [mm] \"Place\"\ny'(0) = 0 [m/s]\ndiscrete n = 0 \"Count\"\nE = m*y'^2/2 + k_1*y^2/2 in [mJ] \"Energy\"\nwhen y < 0 [m] {\n    n = n + 1  # once more\n}\nchoice c { \"A\": a = 1; \"B\": a = 2 }\n```\n\n```table f(x) in [m]\n0 0\n1 1\n```\n";

fn set(text: &str, number: usize, kind: CellKind, value: &str) -> Result<String, EditError> {
    set_cell(&read(text), number, kind, value).map(|edits| apply(text, &edits).unwrap())
}

/// Lines that differ between two texts with the same number of lines.
fn difference(before: &str, after: &str) -> Vec<String> {
    let lines = before.lines().zip(after.lines());
    lines.filter(|(before, after)| before != after).map(|(_, after)| after.to_owned()).collect()
}

fn cells(form: &Form, number: usize) -> Vec<(CellKind, &str)> {
    form.parts[number].cells.iter().map(|cell| (cell.kind, cell.text.as_str())).collect()
}

#[test]
fn every_statement_has_its_cells() {
    use CellKind::{Label, Name, Range, Step, Text, Unit, Value};
    let form = form(&read(SPRING));
    for (number, section, word, expected) in [
        (
            0,
            Section::Parameters,
            "parameter",
            vec![(Name, "m"), (Value, "0.5"), (Unit, "kg"), (Range, "0.1..2"), (Step, "0.1"), (Label, "Mass")],
        ),
        (
            1,
            Section::Parameters,
            "parameter",
            vec![(Name, "k_1"), (Value, "20"), (Unit, "N/m"), (Range, ""), (Step, ""), (Label, "")],
        ),
        (2, Section::Parameters, "switch", vec![(Name, "drag"), (Value, "on"), (Label, "Air")]),
        (3, Section::Parameters, "size", vec![(Name, "N"), (Value, "3"), (Range, "1..9"), (Label, "")]),
        (4, Section::Equations, "", vec![(Text, "m*y'' = -k_1*y")]),
        (5, Section::InitialValues, "", vec![(Name, "y(0)"), (Value, "10 [cm]"), (Unit, "mm"), (Label, "Place")]),
        (6, Section::InitialValues, "", vec![(Name, "y'(0)"), (Value, "0 [m/s]"), (Unit, ""), (Label, "")]),
        (7, Section::InitialValues, "discrete", vec![(Name, "n"), (Value, "0"), (Unit, ""), (Label, "Count")]),
        (8, Section::Equations, "", vec![(Text, "E = m*y'^2/2 + k_1*y^2/2 in [mJ] \"Energy\"")]),
        (9, Section::Events, "", vec![(Text, "when y < 0 [m] {\n    n = n + 1  # once more\n}")]),
        (10, Section::Choices, "", vec![(Text, "choice c { \"A\": a = 1; \"B\": a = 2 }")]),
        (11, Section::Tables, "", vec![(Text, "table f(x) in [m]\n0 0\n1 1")]),
    ] {
        assert_eq!((form.parts[number].section, form.parts[number].word.as_str()), (section, word), "{number}");
        assert_eq!(cells(&form, number), expected);
    }
    assert_eq!(form.parts.len(), 12);
    assert!(form.parts[4].typeset.starts_with("<math"));
    assert!(form.parts[0].typeset.is_empty());
    let at = |text: &str| form.at(SPRING.find(text).unwrap()).unwrap();
    assert_eq!(at("20  [N/m]"), (1, Value));
    assert_eq!(at("N/m"), (1, Unit));
    assert_eq!(at("0.1 \"Mass"), (0, Step));
    assert_eq!(at("n = n + 1"), (9, Text));
}

#[test]
fn a_cell_gets_another_text_and_its_line_keeps_its_comment_and_columns() {
    use CellKind::{Label, Name, Range, Step, Text, Unit, Value};
    for (number, kind, value, expected) in [
        (0, Value, "2", "parameter m   = 2   [kg] in 0.1..2 step 0.1 \"Mass\"  # of the bob"),
        (0, Value, "wrong", "parameter m   = wrong [kg] in 0.1..2 step 0.1 \"Mass\"  # of the bob"),
        (0, Unit, "g", "parameter m   = 0.5 [g] in 0.1..2 step 0.1 \"Mass\"  # of the bob"),
        (0, Unit, "", "parameter m   = 0.5 in 0.1..2 step 0.1 \"Mass\"  # of the bob"),
        (0, Range, "0..9", "parameter m   = 0.5 [kg] in 0..9 step 0.1 \"Mass\"  # of the bob"),
        (0, Range, "", "parameter m   = 0.5 [kg] step 0.1 \"Mass\"  # of the bob"),
        (0, Step, "", "parameter m   = 0.5 [kg] in 0.1..2 \"Mass\"  # of the bob"),
        (0, Label, "", "parameter m   = 0.5 [kg] in 0.1..2 step 0.1  # of the bob"),
        (0, Label, "Masse", "parameter m   = 0.5 [kg] in 0.1..2 step 0.1 \"Masse\" # of the bob"),
        (1, Value, "7", "parameter k_1 = 7   [N/m]"),
        (1, Range, "0..5", "parameter k_1 = 20  [N/m] in 0..5"),
        (1, Step, "1", "parameter k_1 = 20  [N/m] step 1"),
        (1, Label, "Stiffness", "parameter k_1 = 20  [N/m] \"Stiffness\""),
        (2, Value, "off", "switch drag = off \"Air\""),
        (5, Value, "2*m/(1 [kg/m])", "y(0)  = 2*m/(1 [kg/m]) in [mm] \"Place\""),
        (5, Unit, "", "y(0)  = 10 [cm] \"Place\""),
        (6, Unit, "cm/s", "y'(0) = 0 [m/s] in [cm/s]"),
        (4, Text, "m*y'' = 0", "m*y'' = 0   # Newton"),
        (9, Text, "when y < 1 [m] {\n    n = n + 1  # once more\n}", "when y < 1 [m] {"),
        (11, Text, "table f(x) in [mm]\n0 0\n1 1", "```table f(x) in [mm]"),
    ] {
        let after = set(SPRING, number, kind, value).unwrap();
        assert_eq!(difference(SPRING, &after), [expected], "{kind:?} {value}");
        assert_eq!(form(&read(&after)).parts[number].cell(kind).unwrap().text, value);
    }
    let aligned = "```model\nparameter k   = 20  [N/m]  in 1..100   \"Stiffness\"\nparameter b   = 0.1 [kg/s] in 0..5     \"Damping\"\n```\n";
    assert_eq!(set(aligned, 0, Unit, "N").unwrap(), aligned.replace("[N/m]  in", "[N]    in"));
    assert_eq!(set(aligned, 0, Unit, "[ N ]").unwrap(), set(aligned, 0, Unit, "N").unwrap());
    assert_eq!(set(aligned, 0, Unit, "[N/m]").unwrap(), aligned);
    assert_eq!(set(aligned, 1, Unit, "N").unwrap(), aligned.replace("[kg/s] in", "[N]    in"));
    assert_eq!(set(aligned, 1, Range, "0..25").unwrap(), aligned.replace("0..5     ", "0..25    "));
    let renamed = set(SPRING, 1, Name, "k").unwrap();
    assert_eq!(renamed, SPRING.replace("k_1", "k"));
    assert_eq!(set(SPRING, 6, Name, "x'(0)").unwrap().matches("x'").count(), 3);
    let mark = |mark: &str| EditError::NotOneCell(Obstacle::Mark(mark.to_owned()));
    for (number, kind, value, error) in [
        (0, Label, "a\" in 3", mark("\"")),
        (0, Unit, "m] in [s", mark("]")),
        (0, Unit, "[m] [s]", mark("]")),
        (0, Value, "5 \"Mass\"", mark("\"")),
        (0, Value, "5\n6", EditError::NotOneCell(Obstacle::LineEnd)),
        (4, Text, "", EditError::NotOneStatement),
        (4, Text, "a = 1\nb = 2", EditError::NotOneStatement),
        (9, Text, "when y < 0 [m] {\n n = 1", EditError::NotOneStatement),
        (9, Text, "```\n\n```plots", EditError::ChangesOthers),
        (4, Value, "1", EditError::UnknownCell),
        (99, Value, "1", EditError::UnknownCell),
        (0, Name, "pi", EditError::NewName("pi".to_owned())),
    ] {
        assert_eq!(set(SPRING, number, kind, value), Err(error), "{kind:?} {value}");
    }
    let windows = set(&SPRING.replace('\n', "\r\n"), 0, Value, "2").unwrap();
    assert_eq!(windows, set(SPRING, 0, Value, "2").unwrap().replace('\n', "\r\n"));
}

#[test]
fn a_value_can_be_emptied_and_typed_again() {
    let empty = set(SPRING, 1, CellKind::Value, "").unwrap();
    assert_eq!(set(&empty, 1, CellKind::Value, "20").unwrap(), SPRING);
    // A line with errors remains a row as a whole.
    for value in ["", "2 +", "m", "1e", "-"] {
        let wrong = set(SPRING, 0, CellKind::Value, value).unwrap();
        let opened = open(&wrong, &[]);
        let found = opened.diagnostics.iter().find(|(_, found)| found.severity == model::Severity::Error).unwrap();
        assert_eq!(form(&read(&wrong)).at(found.1.span().start).unwrap().0, 0, "{value}");
        assert_eq!(set(&wrong, 0, CellKind::Value, "0.5").unwrap(), SPRING, "{value}");
    }
}

#[test]
fn statements_are_added_and_removed() {
    for section in Section::ALL {
        let outline = read(SPRING);
        let added = proposal(&outline, section);
        let text = apply(SPRING, &[add_statement(&outline, section, &added).unwrap()]).unwrap();
        let found = open(&text, &[]).diagnostics.into_iter().map(|(_, found)| found);
        let errors: Vec<&str> =
            found.filter(|found| found.severity == model::Severity::Error).map(|found| found.code).collect();
        // No equation is invented; the author must write it.
        let missing = if section == Section::InitialValues { &["initial-value-without-equation"][..] } else { &[] };
        assert_eq!(errors, missing, "{added}");
        let after = form(&read(&text));
        let number =
            after.parts.iter().rposition(|part| part.section == section && added.ends_with(&text[part.span.range()]));
        let mut back = text.clone();
        for _ in 0..after.parts.len() - form(&outline).parts.len() {
            let number =
                form(&read(&back)).parts.iter().rposition(|part| added.contains(&back[part.span.range()])).unwrap();
            back = apply(&back, &[remove_statement(&read(&back), number).unwrap()]).unwrap();
        }
        assert!(number.is_some(), "{section:?}: {text}");
        assert_eq!(back, SPRING);
    }
    let plain = "---\ntitle: A\n---\nWords.\n";
    let text = apply(plain, &[add_statement(&read(plain), Section::Parameters, "parameter a = 1").unwrap()]).unwrap();
    assert_eq!(text, "---\ntitle: A\n---\nWords.\n```model\nparameter a = 1\n```\n");
    let removed = apply(SPRING, &[remove_statement(&read(SPRING), 11).unwrap()]).unwrap();
    assert!(!removed.contains("table"));
    assert_eq!(add_statement(&read(SPRING), Section::Events, "when y < 1 [m] {"), Err(EditError::NotOneStatement));
}

/// Edits that restore the text before.
pub fn inverse(before: &str, edits: &[Edit]) -> Vec<Edit> {
    let mut ordered = edits.to_vec();
    ordered.sort_by_key(|edit| edit.span.start);
    let mut shift = 0isize;
    let back = |edit: &Edit| {
        let start = edit.span.start.checked_add_signed(shift).unwrap();
        shift += edit.text.len() as isize - (edit.span.end - edit.span.start) as isize;
        Edit { span: Span::new(start, start + edit.text.len()), text: before[edit.span.range()].to_owned() }
    };
    ordered.iter().map(back).collect()
}

#[derive(Clone, Debug)]
enum Asked {
    Set(usize, usize, String),
    Add(usize),
    Remove(usize),
}

fn asked() -> impl Strategy<Value = Asked> {
    let texts = prop_oneof![
        "[0-9]{1,3}(\\.[0-9]{1,2})?",
        "(kg|m/s|cm|1/s|wide)",
        "-?[0-9]\\.\\.[0-9]{2}",
        "[A-Za-zé ]{0,9}",
        "[a-z]{1,2}(_[0-9])?( = [0-9a-z*+]{1,6})?",
        "[^\\t]{0,8}",
        "(when t > 1 \\[s\\] \\{ stop \\}|\\{|\\}|\\(|\"|```|#|in|step 2)",
    ];
    prop_oneof![
        8 => (any::<usize>(), any::<usize>(), texts).prop_map(|(part, cell, text)| Asked::Set(part, cell, text)),
        1 => (0usize..6).prop_map(Asked::Add),
        1 => any::<usize>().prop_map(Asked::Remove),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, ..ProptestConfig::default() })]

    /// Arbitrary sequences of edits of the forms of the gallery.
    #[test]
    fn text_and_form_agree(which in any::<prop::sample::Index>(), wishes in prop::collection::vec(asked(), 1..12)) {
        let all = documents();
        let original = all[which.index(all.len())].clone();
        let mut text = original.clone();
        let mut undo: Vec<Vec<Edit>> = Vec::new();
        for wish in wishes {
            let outline = read(&text);
            let before = form(&outline);
            let count = before.parts.len();
            let edits = match &wish {
                Asked::Set(part, cell, value) if count > 0 => {
                    let number = part % count;
                    let kind = before.parts[number].cells[cell % before.parts[number].cells.len()].kind;
                    let edits = set_cell(&outline, number, kind, value);
                    if let Ok(edits) = &edits && kind != CellKind::Name {
                        let after = form(&read(&apply(&text, edits).unwrap())).parts;
                        prop_assert_eq!(after.len(), count);
                        let new = &after[number];
                        let shown = new.cell(kind).map_or_else(String::new, |cell| cell.text.clone());
                        prop_assert!(shown == value.trim() || kind == CellKind::Text, "{:?} {:?}", shown, value);
                        for (other, part) in after.iter().enumerate().filter(|(other, _)| *other != number) {
                            prop_assert_eq!(cells(&before, other), part.cells.iter().map(|cell| (cell.kind, cell.text.as_str())).collect::<Vec<_>>());
                        }
                        let span = before.parts[number].span;
                        prop_assert!(edits.iter().all(|edit| span.start <= edit.span.start), "outside its statement");
                    }
                    edits
                }
                Asked::Add(section) => {
                    let section = Section::ALL[*section];
                    add_statement(&outline, section, &proposal(&outline, section)).map(|edit| vec![edit])
                }
                Asked::Remove(part) if count > 0 => remove_statement(&outline, part % count).map(|edit| vec![edit]),
                _ => Ok(Vec::new()),
            };
            let Ok(edits) = edits else { continue };
            let back = inverse(&text, &edits);
            text = apply(&text, &edits).unwrap();
            undo.push(back);
        }
        while let Some(edits) = undo.pop() {
            text = apply(&text, &edits).unwrap();
        }
        prop_assert_eq!(text, original);
    }
}

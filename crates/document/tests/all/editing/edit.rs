//! After an edit, the text contains the requested change, and all other bytes are unchanged.

use super::outline::check_places;
use crate::arbitrary::document_text;
use document::edit::{
    Edit, EditError, apply, insert_block, remove_block, rename, rename_with, replace_block, set_front_matter,
    set_parameter,
};
use document::{BlockKind, Outline, open, read};
use model::{ParameterStatement, Span, StatementKind};
use program::{Program, bundle};
use proptest::prelude::*;
use std::path::Path;

/// Texts of all documents of Meniscus, without translations.
pub fn documents() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../simulations");
    let mut texts = Vec::new();
    for folder in [folder.clone(), folder.join("theories")] {
        for entry in std::fs::read_dir(folder).unwrap().map(Result::unwrap) {
            let name = entry.file_name().into_string().unwrap();
            if name.ends_with(".md") && name.matches('.').count() == 1 {
                texts.push(std::fs::read_to_string(entry.path()).unwrap());
            }
        }
    }
    assert!(texts.len() > 10);
    texts
}

fn program(text: &str) -> Program {
    let opened = open(text, &[]);
    // At an end of a range, an event may be true at the start, which causes a warning.
    assert!(!opened.has_errors(), "{:?}", opened.diagnostics);
    opened.document.unwrap().program
}

fn bytes(program: &Program) -> Vec<u8> {
    bundle::write(program).unwrap()
}

fn parameters<'a>(outline: &'a Outline) -> Vec<&'a ParameterStatement> {
    let statements = outline.blocks().iter().flat_map(|block| &block.statements);
    let parameters = statements.filter_map(|statement| match &statement.kind {
        StatementKind::Parameter(parameter) => Some(parameter),
        _ => None,
    });
    parameters.collect()
}

/// Contents of the blocks with their kinds.
fn blocks(text: &str) -> Vec<(BlockKind, String)> {
    let outline = read(text);
    outline.blocks().iter().map(|block| (block.kind, text[block.content.range()].to_owned())).collect()
}

fn entries(text: &str) -> Vec<(String, String)> {
    let outline = read(text);
    outline.front_matter().entries.iter().map(|entry| (entry.key.clone(), entry.value.text.clone())).collect()
}

fn changed(text: &str, edit: Result<Edit, EditError>) -> String {
    apply(text, &[edit.unwrap()]).unwrap()
}

fn with_parameter(text: &str, name: &str, value: &str) -> String {
    changed(text, set_parameter(&read(text), name, value))
}

/// Up to four numeric parameters of every document get another value of their range.
#[test]
fn a_parameter_gets_another_default_and_nothing_else_changes() {
    for text in documents() {
        let before = program(&text);
        let (kept, every) = (bytes(&before), before.model.parameters.len().div_ceil(4).max(1));
        for (index, parameter) in before.model.parameters.iter().enumerate().step_by(every) {
            if parameter.choices != program::Choices::Numbers {
                continue;
            }
            let outline = read(&text);
            let statement = parameters(&outline).into_iter().find(|statement| statement.name.text == parameter.name);
            let statement = statement.expect("it is declared").clone();
            let asked = match &statement.range {
                Some(range) if statement.value == range.high => range.low,
                Some(range) => range.high,
                None => 2.0 * statement.value + 1.0,
            };
            let edited = with_parameter(&text, &parameter.name, &asked.to_string());
            let (head, tail) = (&text[..statement.value_span.start], &text[statement.value_span.end..]);
            let rest = edited.strip_prefix(head).and_then(|rest| rest.strip_prefix(&asked.to_string())).unwrap();
            assert_eq!(rest.trim_start_matches(' '), tail.trim_start_matches(' '), "{}", parameter.name);
            let mut after = program(&edited);
            assert_eq!(after.model.parameters[index].value, parameter.unit.to_si(asked));
            after.model.parameters[index].value = parameter.value;
            assert!(bytes(&after) == kept, "{} of {}", parameter.name, before.title);
            if index == 0 {
                let windows = with_parameter(&text.replace('\n', "\r\n"), &parameter.name, &asked.to_string());
                assert_eq!(windows, edited.replace('\n', "\r\n"));
            }
        }
    }
}

#[test]
fn what_follows_a_default_stays_in_its_column() {
    let model = |line: &str| format!("```model\nparameter k = 9.8 [m]\n{line}\n```\n");
    for (before, value, after) in [
        ("parameter a = 1.5 [m] in 0..9", "2", "parameter a = 2   [m] in 0..9"),
        ("parameter a = 1.5 [m] in 0..9", "2.25", "parameter a = 2.25 [m] in 0..9"),
        ("parameter abc = 1.5 [m]", "2", "parameter abc = 2 [m]"),
        ("parameter a = 5   [m] # c", "-250", "parameter a = -250 [m] # c"),
        ("parameter a=5   in 0..9", "12", "parameter a=12  in 0..9"),
        ("parameter a = 5.5", "5", "parameter a = 5"),
        ("parameter α = 5[m]", " 1e-3 ", "parameter α = 1e-3[m]"),
        ("parameter α = - 5 [wide] in 0..9", "1", "refused"),
        ("parameter a = 2*3", "1", "refused"),
        ("parameter a = x", "1", "refused"),
    ] {
        let text = model(before);
        let name = if before.contains('α') { "alpha" } else { before[10..].split([' ', '=']).next().unwrap() };
        match set_parameter(&read(&text), name, value) {
            Ok(edit) => assert_eq!(apply(&text, &[edit]).unwrap(), model(after)),
            Err(error) => assert_eq!((error, after), (EditError::UnreadableParameter(name.to_owned()), "refused")),
        }
    }
    let text = model("");
    let set = |name: &str, value: &str| set_parameter(&read(&text), name, value).unwrap_err();
    assert_eq!(set("q", "1"), EditError::UnknownParameter("q".to_owned()));
    for wrong in ["", "1,5", "1 [m]", "1 # c", "2*3", "(1)", "1e999", "x", "1\n2", "- 1", "--1", "²"] {
        assert_eq!(set("k", wrong), EditError::NotANumber(wrong.to_owned()));
    }
}

#[test]
fn front_matter_is_changed_added_to_and_removed_from() {
    let set = |text: &str, key: &str, value: Option<&str>| {
        set_front_matter(&read(text), key, value).map(|edits| apply(text, &edits).unwrap())
    };
    let text = "---\ntitle:  'A' \n# c\nstep:\n---\nB";
    for (key, value, expected) in [
        ("title", Some("C: D"), "---\ntitle:  'C: D' \n# c\nstep:\n---\nB"),
        ("step", Some("1 [s]"), "---\ntitle:  'A' \n# c\nstep: 1 [s]\n---\nB"),
        ("until", Some("9"), "---\ntitle:  'A' \n# c\nstep:\nuntil: 9\n---\nB"),
        ("vary", Some(" \"b\" "), "---\ntitle:  'A' \n# c\nstep:\nvary: \" \"b\" \"\n---\nB"),
        ("title", None, "---\n# c\nstep:\n---\nB"),
        ("until", None, text),
    ] {
        assert_eq!(set(text, key, value).unwrap(), expected);
        let windows = set(&text.replace('\n', "\r\n"), key, value).unwrap();
        assert_eq!(windows, expected.replace('\n', "\r\n"));
    }
    let title = |text: &str| set(text, "title", Some("A")).unwrap();
    assert_eq!(title(""), "---\ntitle: A\n---\n");
    assert_eq!(title("\u{feff}B\r\nC"), "\u{feff}---\r\ntitle: A\r\n---\r\nB\r\nC");
    assert_eq!(title("---"), "---\ntitle: A\n");
    assert_eq!(title("---\n\nB"), "---\n\ntitle: A\nB");
    assert_eq!(title("---\ntitle:\ntitle: B\ntitle: C\n---\n"), "---\ntitle:\ntitle: A\ntitle: C\n---\n");
    assert_eq!(set("---\ntitle: B\nstep: 1\ntitle: C", "title", None).unwrap(), "---\nstep: 1\n");
    assert_eq!(set(text, "a b", None), Err(EditError::Key("a b".to_owned())));
    assert_eq!(set(text, "title", Some("a\nb")), Err(EditError::Value("a\nb".to_owned())));
    for text in documents() {
        let edited = set(&text, "title", Some("Another")).unwrap();
        assert_eq!(program(&edited).title, "Another");
        assert_eq!(set(&edited, "title", Some(&program(&text).title)).unwrap(), text);
        let edited = set(&set(&text, "until", None).unwrap(), "until", Some("77")).unwrap();
        let edited_program = program(&edited);
        assert_eq!(edited_program.until, Some(edited_program.model.independent.unit.to_si(77.0)));
        assert_eq!(blocks(&edited), blocks(&text));
    }
}

/// Each block is replaced by another text and restored, removed and inserted again.
#[test]
fn blocks_are_replaced_removed_and_inserted() {
    for text in documents() {
        let outline = read(&text);
        let before = blocks(&text);
        for (index, block) in outline.blocks().iter().enumerate() {
            let content = &text[block.content.range()];
            let edited = changed(&text, replace_block(&outline, index, "Something else"));
            let mut expected = before.clone();
            expected[index].1 = "Something else\n".to_owned();
            let last = index + 1 == before.len() && block.kind == BlockKind::Prose;
            expected[index].1.truncate(if last { 14 } else { 15 });
            assert_eq!(blocks(&edited), expected);
            assert_eq!(changed(&edited, replace_block(&read(&edited), index, content)), text);
            let edited = changed(&text, remove_block(&outline, index));
            assert_eq!(edited, format!("{}{}", &text[..block.span.start], &text[block.span.end..]));
            // Prose around a removed block is joined, so its former place cannot be restored.
            let after = index.checked_sub(1);
            if blocks(&edited).len() == before.len() - 1 {
                let again = insert_block(&read(&edited), after, block.kind, content);
                assert_eq!(changed(&edited, again), text, "{index}");
            }
        }
    }
}

#[test]
fn no_content_breaks_out_of_its_block() {
    let text = "A\n```model\nx = 1\n```\nB\n~~~~plots\n~~~~\n";
    let replace = |index: usize, content: &str| replace_block(&read(text), index, content);
    for content in ["```", "a\n ````\nb", "```plots", "x\r\n```\r\n```model\r\ny"] {
        assert_eq!(replace(1, content), Err(EditError::ChangesOthers), "{content:?}");
    }
    assert_eq!(changed(text, replace(1, "~~~\n```js\n~~~~~")), text.replace("x = 1", "~~~\n```js\n~~~~~"));
    assert_eq!(changed(text, replace(3, "```\n~~~")), text.replace("~~~~plots\n", "~~~~plots\n```\n~~~\n"));
    assert_eq!(replace(0, "```python\nx"), Err(EditError::ChangesOthers));
    assert_eq!(replace(0, "---\ntitle: B"), Err(EditError::ChangesOthers));
    assert_eq!(changed(text, replace(2, "")), text.replace("B\n", ""));
    assert_eq!(replace(4, ""), Err(EditError::UnknownBlock(4)));

    let insert = |after: Option<usize>, kind: BlockKind, content: &str| {
        changed(text, insert_block(&read(text), after, kind, content))
    };
    let question = insert(None, BlockKind::Question, "Q\n````js\n1\n````");
    assert_eq!(question, format!("`````question\nQ\n````js\n1\n````\n`````\n{text}"));
    assert_eq!(insert(Some(3), BlockKind::Prose, "C"), format!("{text}C"));
    assert_eq!(insert(Some(2), BlockKind::Prose, "C"), text.replace("B\n", "B\nC\n"));
    assert_eq!(
        insert_block(&read("```python\nx"), Some(0), BlockKind::Model, ""),
        Err(EditError::ChangesOthers),
        "it would become code"
    );
    let crlf = "```model\r\nx = 1\r\n```";
    let edit = insert_block(&read(crlf), Some(0), BlockKind::Scene, "<svg>\n</svg>");
    assert_eq!(changed(crlf, edit), format!("{crlf}\r\n```scene\r\n<svg>\r\n</svg>\r\n```\r\n"));
    let open = "```model\nx = 1\n```plots\n```\nB";
    assert_eq!(remove_block(&read(open), 1), Err(EditError::ChangesOthers), "the model would go on");
}

#[test]
fn edits_out_of_place_are_refused() {
    let edit = |start: usize, end: usize, text: &str| Edit { span: Span::new(start, end), text: text.to_owned() };
    let text = "aébc";
    assert_eq!(apply(text, &[edit(4, 5, "x"), edit(0, 1, ""), edit(3, 3, "y")]).unwrap(), "éybx");
    assert_eq!(apply(text, &[edit(1, 1, "x"), edit(1, 3, "z"), edit(1, 1, "y")]).unwrap(), "axyzbc");
    for (start, end) in [(2, 3), (1, 2), (5, 6), (4, 3), (9, 9), (usize::MAX, 0)] {
        assert_eq!(apply(text, &[edit(start, end, "")]), Err(EditError::Place(Span::new(start, end))));
    }
    assert_eq!(apply(text, &[edit(0, 3, ""), edit(1, 1, "")]), Err(EditError::Overlap(Span::new(1, 1))));
    let long = "a\n".repeat(600_000);
    assert_eq!(insert_block(&read(&long), None, BlockKind::Model, ""), Err(EditError::TooLong));
    assert_eq!(set_front_matter(&read(&long), "title", Some("x")), Err(EditError::TooLong));
    assert_eq!(insert_block(&read(text), None, BlockKind::Prose, &long), Err(EditError::TooLong));
}

/// Contents of all blocks except `except`, without the line end that an edit may add.
fn others(text: &str, except: Option<usize>) -> Vec<(BlockKind, String)> {
    let blocks = blocks(text).into_iter().enumerate().filter(|(index, _)| Some(*index) != except);
    blocks
        .map(|(_, block)| block)
        .map(|(kind, content)| (kind, content.trim_end_matches(['\r', '\n']).to_owned()))
        .collect()
}

/// All kinds of edits of a document, with arbitrary texts.
fn edit_all(text: &str, content: &str, number: f64) {
    let outline = read(text);
    for parameter in parameters(&outline) {
        let name = &parameter.name.text;
        if let Ok(edit) = set_parameter(&outline, name, &number.to_string()) {
            let edited = apply(text, &[edit]).unwrap();
            let outline = read(&edited);
            let first = parameters(&outline).into_iter().find(|parameter| parameter.name.text == *name).unwrap();
            assert_eq!(first.value, number);
            assert_eq!(blocks(&edited).len(), blocks(text).len());
        }
    }
    for key in ["title", "until", content] {
        for value in [Some(content), None] {
            let Ok(edits) = set_front_matter(&outline, key, value) else { continue };
            let edited = apply(text, &edits).unwrap();
            check_places(&read(&edited));
            assert_eq!(read(&edited).front_matter().get(key).map(|value| value.text.as_str()), value);
            let of_others = |text: &str| entries(text).into_iter().filter(|(name, _)| name != key).collect::<Vec<_>>();
            assert_eq!(of_others(&edited), of_others(text));
            assert_eq!(blocks(&edited), blocks(text));
        }
    }
    for index in 0..=outline.blocks().len() {
        if let Ok(edit) = replace_block(&outline, index, content) {
            let edited = apply(text, &[edit]).unwrap();
            if blocks(&edited).len() == outline.blocks().len() {
                assert_eq!(others(&edited, Some(index)), others(text, Some(index)));
            }
            assert_eq!(entries(&edited), entries(text));
        }
        if let Ok(edit) = remove_block(&outline, index) {
            assert!(read(&apply(text, &[edit]).unwrap()).blocks().len() < outline.blocks().len());
        }
        let after = index.checked_sub(1);
        for kind in BlockKind::FENCED {
            let Ok(edit) = insert_block(&outline, after, kind, content) else { continue };
            let edited = apply(text, &[edit]).unwrap();
            check_places(&read(&edited));
            assert_eq!(blocks(&edited)[index].0, kind);
            assert_eq!(others(&edited, Some(index)), others(text, None));
        }
        let _ = insert_block(&outline, after, BlockKind::Prose, content);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_edit_of_any_text_gives_what_was_asked(
        text in document_text(),
        content in prop_oneof![document_text(), "[a-z: '\"]{0,9}", "\\PC{0,9}"],
        number in proptest::num::f64::NORMAL,
        windows in any::<bool>(),
    ) {
        let text = if windows { text.replace("\r\n", "\n").replace('\n', "\r\n") } else { text };
        edit_all(&text, &content, number);
        edit_all(&format!("---\ntitle: a\n---\n```model\nparameter b = 5 [kg/s]\n{text}"), &content, number);
    }

    #[test]
    fn applying_anything_is_safe(text in "\\PC{0,9}", edits in proptest::collection::vec((0..12usize, 0..12usize), 0..4)) {
        let edits: Vec<Edit> =
            edits.into_iter().map(|(start, end)| Edit { span: Span::new(start, end), text: "x".to_owned() }).collect();
        if let Ok(result) = apply(&text, &edits) {
            let removed: usize = edits.iter().map(|edit| edit.span.range().len()).sum();
            prop_assert_eq!(result.len(), text.len() - removed + edits.len());
        }
    }
}

/// Every occurrence of the quantity gets the new name, and nothing else.
#[test]
fn a_quantity_is_renamed_where_it_is_meant() {
    let source = "---\ntitle: m\n---\nThe mass m is {m in [g]}, $m$.\n\n```model\nparameter m = 1 [kg] \"m\"  # m\nparameter m_2 = 2 [m]\n\
                  x'' = -x*m/(1 [kg s^2])\nx(0) = 1\nx'(0) = 0\np = m*x'\n```\n\n```scene\n<svg viewBox=\"0 0 9 9\"><style>.m { fill: red }</style>\
                  <rect class=\"m\" fill=\"black\" width=\"{m in [g]}\"/></svg>\n```\n\n```presets\n\"m\": m = 3 [kg]\n```\n";
    let outline = read(source);
    let renamed = |offset: usize, new: &str| rename(&outline, offset, new).map(|edits| apply(source, &edits).unwrap());
    let place = source.find("= m*x'").unwrap() + 2;
    let expected = source
        .replace("{m in", "{mass in")
        .replace("parameter m =", "parameter mass =")
        .replace("-x*m/", "-x*mass/")
        .replace("= m*x'", "= mass*x'")
        .replace(": m = 3", ": mass = 3");
    assert_eq!(renamed(place, "mass").unwrap(), expected);
    // Also in translations and in `vary`.
    let varying = source.replace("title: m\n", "title: m\nvary: m_2, m\n");
    let spanish = "---\nlanguage: es\ntranslates: a.md\n---\nLa masa m es {m in [g]}.\n\n```translations\n\"m\" = \"masa m\"\n```\n";
    let edits = rename_with(&read(&varying), varying.find("= m*x'").unwrap() + 2, "mass", &[spanish]).unwrap();
    let texts: Vec<String> =
        [varying.as_str(), spanish].iter().zip(&edits).map(|(text, edits)| apply(text, edits).unwrap()).collect();
    assert_eq!(texts[0], expected.replace("title: m\n", "title: m\nvary: m_2, mass\n"));
    assert_eq!(texts[1], spanish.replace("{m in", "{mass in"));
    assert_eq!(renamed(place, "x"), Err(EditError::NewName("x".to_owned())));
    for new in ["", "2m", "a b", "sin", "pi", "if", "x'"] {
        assert_eq!(renamed(place, new), Err(EditError::NewName(new.to_owned())), "{new}");
    }
    for nothing in ["The mass", "title", "kg s^2", "# m"] {
        assert_eq!(renamed(source.find(nothing).unwrap() + 3, "mass"), Err(EditError::NoName), "{nothing}");
    }
}

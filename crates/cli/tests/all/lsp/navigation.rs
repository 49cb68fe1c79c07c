//! Where names are declared and stand, what a document contains, and changes of parts of a text.

use super::editor::{DOCUMENT, Editor, FILE};
use serde_json::{Value, json};

/// Line, first and last character of the places of a file.
fn places(found: &Value, file: &str) -> Vec<(i64, i64, i64)> {
    let all = found.as_array().unwrap().iter().filter(|one| one["uri"] == file).map(|one| &one["range"]);
    let number = |value: &Value| value.as_i64().unwrap();
    all.map(|range| {
        let [start, end] = [&range["start"], &range["end"]];
        assert_eq!(start["line"], end["line"]);
        (number(&start["line"]), number(&start["character"]), number(&end["character"]))
    })
    .collect()
}

#[test]
fn names_lead_to_what_declares_them_also_from_a_translation() {
    let folder = tempfile::tempdir().unwrap();
    let address = |name: &str| format!("file://{}/{name}", folder.path().display());
    let [document, spanish] = ["spring.md", "spring.es.md"].map(address);
    std::fs::write(folder.path().join("spring.md"), DOCUMENT.replace("-stif*", "-stiff*")).unwrap();
    let mut editor = Editor::open("en");
    let text = "---\nlanguage: es\ntranslates: spring.md\n---\n\nLa rigidez es {stiff}.\n";
    let file = json!({ "uri": spanish, "languageId": "markdown", "version": 1, "text": text });
    editor.tell("textDocument/didOpen", json!({ "textDocument": file }));
    editor.hear();
    let asked = |file: &str, line: u32, character: u32, all: bool| {
        json!({
            "textDocument": { "uri": file },
            "position": { "line": line, "character": character },
            "context": { "includeDeclaration": all },
        })
    };
    let declared = [(1, 10, 15)];
    let found = editor.ask("textDocument/definition", asked(&spanish, 5, 17, true));
    assert_eq!(places(&found, &document), declared, "{found}");
    let found = editor.ask("textDocument/references", asked(&spanish, 5, 17, true));
    assert_eq!(places(&found, &document), [(1, 10, 15), (3, 9, 14), (6, 13, 18)]);
    assert_eq!(places(&found, &spanish), [(5, 15, 20)]);
    let found = editor.ask("textDocument/references", asked(&spanish, 5, 17, false));
    assert_eq!(places(&found, &document), [(3, 9, 14), (6, 13, 18)]);
    assert_eq!(editor.ask("textDocument/definition", asked(&spanish, 5, 4, true)), Value::Null);
    assert_eq!(editor.ask("textDocument/definition", asked(&document, 1, 12, true)), Value::Null, "it is not open");
    editor.close();
}

#[test]
fn blocks_are_listed_with_what_they_declare() {
    let mut editor = Editor::open("es");
    editor.write(DOCUMENT);
    let found = editor.ask("textDocument/documentSymbol", json!({ "textDocument": { "uri": FILE } }));
    assert_eq!(
        (&found[0]["name"], &found[0]["detail"]),
        (&json!("model"), &json!("parámetros, ecuaciones y valores iniciales"))
    );
    let children = found[0]["children"].as_array().unwrap();
    let names: Vec<&str> = children.iter().map(|child| child["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["stiff", "m", "m*x'' = -stif*x", "x", "x", "omega"]);
    assert_eq!((&children[0]["detail"], &children[1]["detail"]), (&json!("Stiffness"), &json!("parámetro")));
    editor.close();
}

/// Changes of parts, each on the result of the one before, lead to the same text as a change of the whole.
#[test]
fn parts_of_a_text_change() {
    let mut editor = Editor::open("en");
    editor.write("```model\nx' = -γ*x\n```\n");
    let place = |line: u32, character: u32| json!({ "line": line, "character": character });
    let part = |start: [u32; 2], end: [u32; 2], text: &str| json!({ "range": { "start": place(start[0], start[1]), "end": place(end[0], end[1]) }, "text": text });
    let mut change = |changes: Vec<Value>| {
        let file = json!({ "uri": FILE, "version": 2 });
        editor.tell("textDocument/didChange", json!({ "textDocument": file, "contentChanges": changes }));
        let heard = editor.hear();
        let found = heard["params"]["diagnostics"].as_array().unwrap().clone();
        found.iter().map(|one| one["message"].as_str().unwrap().lines().next().unwrap().to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(change(vec![part([2, 0], [2, 0], "x(0) = 1\n")]), ["`gamma` is not known"]);
    // Characters count as units of UTF-16; `𝛼` has two.
    assert_eq!(
        change(vec![
            part([1, 6], [1, 7], "𝛼"),
            part([1, 6], [1, 8], "k"),
            part([1, 0], [1, 0], "parameter k = 2 [1/s]\n")
        ]),
        [""; 0]
    );
    // Beyond the ends, and with the end before the start.
    assert_eq!(change(vec![part([99, 0], [99, 9], "\n"), part([4, 9], [1, 0], "")]), [""; 0]);
    assert_eq!(change(vec![part([2, 5], [2, 6], ""), json!({ "text": "# Shopping\n" })]), [""; 0]);
    editor.close();
}

//! The language server, as an editor uses it.

mod editor;
mod navigation;

use editor::{DOCUMENT, Editor, FILE, at};
use serde_json::{Value, json};

#[test]
fn errors_are_reported_with_remedies_that_work() {
    for (language, message, title) in [
        ("en", "`stif` is not known\ndid you mean `stiff`?", "replace `stif` by `stiff`"),
        ("es", "no se conoce `stif`\n¿querías decir `stiff`?", "cambiar `stif` por `stiff`"),
    ] {
        let mut editor = Editor::open(language);
        let found = editor.write(DOCUMENT);
        assert_eq!(
            (found[0]["message"].as_str(), found[0]["range"]["start"]["line"].as_i64()),
            (Some(message), Some(3))
        );
        let place = found[0]["range"].clone();
        let context = json!({ "diagnostics": [] });
        let asked = json!({ "textDocument": { "uri": FILE }, "range": place, "context": context });
        let actions = editor.ask("textDocument/codeAction", asked);
        assert_eq!(actions[0]["title"], title);
        let edit = &actions[0]["edit"]["changes"][FILE][0];
        assert_eq!((&edit["range"], &edit["newText"]), (&place, &json!("stiff")));
        assert_eq!(editor.write(&DOCUMENT.replace("-stif*", "-stiff*")), json!([]));
        editor.close();
    }
}

#[test]
fn names_are_completed_explained_and_renamed() {
    let mut editor = Editor::open("en");
    editor.write(&DOCUMENT.replace("-stif*", "-stiff*"));
    let found = editor.ask("textDocument/completion", at(6, 2));
    let first = &found[0];
    assert_eq!((first["label"].as_str(), first["detail"].as_str()), (Some("omega"), Some("quantity in 1/s")));
    let hover = editor.ask("textDocument/hover", at(3, 9));
    assert_eq!(hover["contents"]["value"], "Stiffness, parameter in N/m");
    let mut renaming = at(3, 9);
    renaming["newName"] = json!("k");
    let edits = editor.ask("textDocument/rename", renaming.clone());
    assert_eq!(edits["changes"][FILE].as_array().map(Vec::len), Some(3), "{edits}");
    renaming["newName"] = json!("m");
    let refused = editor.answer("textDocument/rename", renaming);
    let expected = "`m` cannot be a name here: it has a meaning already, or characters that names do not have";
    assert_eq!(refused["error"]["message"], expected);
    editor.close();
}

#[test]
fn a_name_changes_in_translations_that_are_open_and_beside_the_file() {
    let folder = std::env::temp_dir().join(format!("meniscus rename {}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let address = |name: &str| format!("file://{}/{name}", folder.display().to_string().replace(' ', "%20"));
    let translation = |language: &str| format!("---\nlanguage: {language}\ntranslates: spring.md\n---\n\n{{stiff}}\n");
    std::fs::write(folder.join("spring.fr.md"), translation("fr")).unwrap();
    std::fs::write(folder.join("spring.es.md"), "not what the editor has").unwrap();
    std::fs::write(folder.join("spring.other.md"), "a note on {stiff}\n").unwrap();
    let mut editor = Editor::open("en");
    for (name, text) in [("spring.md", DOCUMENT.replace("-stif*", "-stiff*")), ("spring.es.md", translation("es"))] {
        let file = json!({ "uri": address(name), "languageId": "markdown", "version": 1, "text": text });
        editor.tell("textDocument/didOpen", json!({ "textDocument": file }));
        editor.hear();
    }
    let asked = json!({
        "textDocument": { "uri": address("spring.md") },
        "position": { "line": 1, "character": 12 },
        "newName": "k",
    });
    let edits = editor.ask("textDocument/rename", asked);
    let count = |name: &str| edits["changes"][address(name)].as_array().map(Vec::len);
    let counts = ["spring.md", "spring.es.md", "spring.fr.md", "spring.other.md"].map(count);
    assert_eq!(counts, [Some(3), Some(1), Some(1), None], "{edits}");
    editor.close();
    std::fs::remove_dir_all(&folder).unwrap();
}

/// A translation is checked with its document, which is open in the editor or in a file beside it.
#[test]
fn a_translation_is_checked_with_its_document() {
    let folder = std::env::temp_dir().join(format!("meniscus translation {}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let address = |name: &str| format!("file://{}/{name}", folder.display().to_string().replace(' ', "%20"));
    let document = DOCUMENT.replace("-stif*", "-stiff*");
    std::fs::write(folder.join("spring.md"), &document).unwrap();
    let translation = |label: &str| {
        format!("---\nlanguage: es\ntranslates: spring.md\n---\n\n```translations\n\"{label}\" = \"Rigidez\"\n```\n")
    };
    let mut editor = Editor::open("en");
    let open = |editor: &mut Editor, name: &str, text: &str| {
        let file = json!({ "uri": address(name), "languageId": "markdown", "version": 1, "text": text });
        editor.tell("textDocument/didOpen", json!({ "textDocument": file }));
    };
    let hear = |editor: &mut Editor, name: &str| {
        let heard = editor.hear();
        assert_eq!(heard["params"]["uri"], address(name));
        heard["params"]["diagnostics"].clone()
    };
    let unknown = |label: &str| format!("the document has no text \"{label}\"");
    let says = |found: &Value, wanted: &str| {
        let mut messages = found.as_array().unwrap().iter().map(|one| one["message"].as_str().unwrap());
        messages.any(|message| message.contains(wanted))
    };
    open(&mut editor, "spring.es.md", &translation("Stifness"));
    let found = hear(&mut editor, "spring.es.md");
    assert!(says(&found, &unknown("Stifness")) && says(&found, "did you mean \"Stiffness\"?"), "{found}");
    open(&mut editor, "spring.es.md", &translation("Stiffness"));
    assert_eq!(hear(&mut editor, "spring.es.md"), json!([]));
    // A change of the document in the editor updates the diagnostics of its translation.
    open(&mut editor, "spring.md", &document.replace("Stiffness", "Spring constant"));
    assert_eq!(hear(&mut editor, "spring.md"), json!([]));
    let found = hear(&mut editor, "spring.es.md");
    assert!(says(&found, &unknown("Stiffness")), "{found}");
    editor.tell("textDocument/didClose", json!({ "textDocument": { "uri": address("spring.md") } }));
    assert_eq!(hear(&mut editor, "spring.md"), json!([]));
    assert_eq!(hear(&mut editor, "spring.es.md"), json!([]), "the file is as it was");
    for base in ["none.md", "../spring.md", "/etc/passwd", ""] {
        open(&mut editor, "other.es.md", &translation("Stiffness").replace("spring.md", base));
        let found = hear(&mut editor, "other.es.md");
        assert!(
            base.is_empty() || found[0]["message"].as_str().unwrap().contains("is not beside it"),
            "{base}: {found}"
        );
    }
    editor.close();
    std::fs::remove_dir_all(&folder).unwrap();
}

/// No message of the editor ends the server.
#[test]
fn malformed_messages_are_answered_and_skipped() {
    let mut editor = Editor::open("en");
    let framed = |text: &[u8]| [format!("Content-Length: {}\r\n\r\n", text.len()).as_bytes(), text].concat();
    let nested = "[".repeat(100_000);
    for text in ["", "{", "nonsense", "{\"id\": }", "\u{0}", nested.as_str(), "[1, 2", "\"", "{\"a\":1}}"] {
        editor.write_bytes(&framed(text.as_bytes()));
        assert_eq!(editor.hear()["error"]["code"], -32700, "{text:.20}");
    }
    editor.write_bytes(&framed(b"{\"id\": \xff}"));
    assert_eq!(editor.hear()["error"]["code"], -32700);
    for text in
        ["1", "null", "[]", "{}", "[{\"method\": \"exit\"}]", "{\"id\": 7, \"method\": 3}", "{\"method\": null}"]
    {
        editor.write_bytes(&framed(text.as_bytes()));
        let answer = editor.hear();
        assert_eq!(answer["error"]["code"], -32600, "{text}");
        assert_eq!(answer["id"], if text.contains('7') { json!(7) } else { Value::Null });
    }
    for header in [
        "Content-Length: many\r\n\r\n",
        "Content-Type: x\r\n\r\n",
        "no header\r\n\r\n",
        "\r\n",
        "\n",
        "Content-Length: -1\n\n",
    ] {
        editor.write_bytes(header.as_bytes());
        assert_eq!(editor.hear()["error"]["code"], -32700, "{header:?}");
    }
    // A wrong length loses only its own message.
    editor.write_bytes(b"Content-Type: x\r\n\r\n{\"method\": \"lost\"}");
    assert_eq!(editor.hear()["error"]["code"], -32700);
    let methods = [
        "textDocument/completion",
        "textDocument/hover",
        "textDocument/codeAction",
        "textDocument/formatting",
        "textDocument/rename",
        "textDocument/definition",
        "textDocument/references",
        "textDocument/documentSymbol",
    ];
    for method in methods {
        for parameters in [Value::Null, json!([]), json!({}), json!("x"), json!({ "textDocument": { "uri": 3 } })] {
            assert_eq!(editor.answer(method, parameters)["error"]["code"], -32602, "{method}");
        }
    }
    for method in ["textDocument/didOpen", "textDocument/didChange", "textDocument/didClose", "no/such"] {
        for parameters in [Value::Null, json!([]), json!({ "textDocument": 3 }), json!({ "contentChanges": [] })] {
            editor.tell(method, parameters);
        }
    }
    // A change of a file that is not open.
    let file = json!({ "uri": "file:///no.md", "version": 1 });
    editor.tell("textDocument/didChange", json!({ "textDocument": file, "contentChanges": [{ "text": "x" }] }));
    assert_eq!(editor.write(&DOCUMENT.replace("-stif*", "-stiff*")), json!([]));
    assert_eq!(editor.answer("initialize", json!({ "capabilities": {} }))["error"]["code"], -32601);
    editor.close();
}

#[test]
fn a_document_is_given_the_layout() {
    let mut editor = Editor::open("en");
    editor.write("```model\nx' = -x\nx(0)=1\n```\n");
    let options = json!({ "tabSize": 8, "insertSpaces": false });
    let edits = editor.ask("textDocument/formatting", json!({ "textDocument": { "uri": FILE }, "options": options }));
    let places: Vec<_> =
        edits.as_array().unwrap().iter().map(|edit| (&edit["range"]["start"], &edit["newText"])).collect();
    let place = |character: u32| json!({ "line": 2, "character": character });
    assert_eq!(places, [(&place(4), &json!(" ")), (&place(5), &json!(" "))]);
    editor.close();
}

#[test]
fn other_markdown_and_strange_requests_are_left_alone() {
    let mut editor = Editor::open("en");
    assert_eq!(editor.write("# Shopping\n\n- 2 g of salt\n"), json!([]));
    assert_eq!(editor.ask("textDocument/hover", at(7, 99)), Value::Null);
    assert_eq!(editor.answer("textDocument/hover", json!(3))["error"]["code"], -32602);
    assert_eq!(editor.answer("no/such", json!({}))["error"]["code"], -32601);
    editor.close();
}

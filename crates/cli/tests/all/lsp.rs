//! A test editor as client of `meniscus lsp`.

use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

const FILE: &str = "file:///spring.md";
const DOCUMENT: &str = "```model\nparameter stiff = 4 [N/m] \"Stiffness\"\nparameter m = 1 [kg]\nm*x'' = -stif*x\nx(0) = 1 [m]\nx'(0) = 0\n\
                        omega = sqrt(stiff/m)\n```\n";

struct Editor {
    server: Child,
    input: Option<ChildStdin>,
    output: BufReader<ChildStdout>,
    asked: i64,
}

impl Editor {
    fn open(language: &str) -> Self {
        let mut command = Command::new(env!("CARGO_BIN_EXE_meniscus"));
        let command = command.args(["lsp", "--language", language]).stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut server = command.spawn().unwrap();
        let (input, output) = (server.stdin.take(), BufReader::new(server.stdout.take().unwrap()));
        let mut editor = Self { server, input, output, asked: 0 };
        let capabilities = editor.ask("initialize", json!({ "capabilities": {} }));
        assert_eq!(capabilities["capabilities"]["renameProvider"], true, "{capabilities}");
        editor.tell("initialized", json!({}));
        editor
    }

    fn send(&mut self, mut message: Value) {
        message["jsonrpc"] = json!("2.0");
        let text = message.to_string();
        write!(self.input.as_mut().unwrap(), "Content-Length: {}\r\n\r\n{text}", text.len()).unwrap();
    }

    fn write_bytes(&mut self, bytes: &[u8]) {
        self.input.as_mut().unwrap().write_all(bytes).unwrap();
    }

    fn tell(&mut self, method: &str, parameters: Value) {
        self.send(json!({ "method": method, "params": parameters }));
    }

    fn hear(&mut self) -> Value {
        let mut length = 0;
        loop {
            let mut line = String::new();
            self.output.read_line(&mut line).unwrap();
            match line.trim().strip_prefix("Content-Length:") {
                Some(number) => length = number.trim().parse().unwrap(),
                None if line.trim().is_empty() => break,
                None => {}
            }
        }
        let mut text = vec![0; length];
        self.output.read_exact(&mut text).unwrap();
        serde_json::from_slice(&text).unwrap()
    }

    fn answer(&mut self, method: &str, parameters: Value) -> Value {
        self.asked += 1;
        self.send(json!({ "id": self.asked, "method": method, "params": parameters }));
        self.hear()
    }

    fn ask(&mut self, method: &str, parameters: Value) -> Value {
        self.answer(method, parameters)["result"].take()
    }

    /// Opens a document and returns its diagnostics.
    fn write(&mut self, text: &str) -> Value {
        let file = json!({ "uri": FILE, "languageId": "markdown", "version": 1, "text": text });
        self.tell("textDocument/didOpen", json!({ "textDocument": file }));
        let mut heard = self.hear();
        assert_eq!(heard["method"], "textDocument/publishDiagnostics");
        heard["params"]["diagnostics"].take()
    }

    fn close(mut self) {
        assert_eq!(self.ask("shutdown", Value::Null), Value::Null);
        self.tell("exit", Value::Null);
        self.input = None;
        assert!(self.server.wait().unwrap().success());
    }
}

fn at(line: u32, character: u32) -> Value {
    json!({ "textDocument": { "uri": FILE }, "position": { "line": line, "character": character } })
}

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

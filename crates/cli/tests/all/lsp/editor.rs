//! A test editor as client of `meniscus lsp`.

use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

pub const FILE: &str = "file:///spring.md";
pub const DOCUMENT: &str = "```model\nparameter stiff = 4 [N/m] \"Stiffness\"\nparameter m = 1 [kg]\nm*x'' = -stif*x\nx(0) = 1 [m]\nx'(0) = 0\n\
                        omega = sqrt(stiff/m)\n```\n";

pub struct Editor {
    server: Child,
    input: Option<ChildStdin>,
    output: BufReader<ChildStdout>,
    asked: i64,
}

impl Editor {
    pub fn open(language: &str) -> Self {
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

    pub fn send(&mut self, mut message: Value) {
        message["jsonrpc"] = json!("2.0");
        let text = message.to_string();
        write!(self.input.as_mut().unwrap(), "Content-Length: {}\r\n\r\n{text}", text.len()).unwrap();
    }

    pub fn write_bytes(&mut self, bytes: &[u8]) {
        self.input.as_mut().unwrap().write_all(bytes).unwrap();
    }

    pub fn tell(&mut self, method: &str, parameters: Value) {
        self.send(json!({ "method": method, "params": parameters }));
    }

    pub fn hear(&mut self) -> Value {
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

    pub fn answer(&mut self, method: &str, parameters: Value) -> Value {
        self.asked += 1;
        self.send(json!({ "id": self.asked, "method": method, "params": parameters }));
        self.hear()
    }

    pub fn ask(&mut self, method: &str, parameters: Value) -> Value {
        self.answer(method, parameters)["result"].take()
    }

    /// Opens a document and returns its diagnostics.
    pub fn write(&mut self, text: &str) -> Value {
        let file = json!({ "uri": FILE, "languageId": "markdown", "version": 1, "text": text });
        self.tell("textDocument/didOpen", json!({ "textDocument": file }));
        let mut heard = self.hear();
        assert_eq!(heard["method"], "textDocument/publishDiagnostics");
        heard["params"]["diagnostics"].take()
    }

    pub fn close(mut self) {
        assert_eq!(self.ask("shutdown", Value::Null), Value::Null);
        self.tell("exit", Value::Null);
        self.input = None;
        assert!(self.server.wait().unwrap().success());
    }
}

pub fn at(line: u32, character: u32) -> Value {
    json!({ "textDocument": { "uri": FILE }, "position": { "line": line, "character": character } })
}

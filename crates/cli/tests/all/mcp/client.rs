//! A client of `meniscus mcp`: lines of JSON-RPC over its standard input and output, as the protocol has them.

use crate::common::program;
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Stdio};

/// A running server with its streams.
pub struct Client {
    child: Child,
    input: Option<ChildStdin>,
    output: BufReader<ChildStdout>,
    number: u64,
}

impl Client {
    /// Starts a server for a folder and greets it.
    pub fn open(folder: &Path) -> Self {
        Self::open_for(folder, 30)
    }

    /// The same, with a longest time of a call in seconds.
    pub fn open_for(folder: &Path, seconds: u32) -> Self {
        let mut command = program();
        command
            .args(["mcp", "--seconds", &seconds.to_string(), "--folder"])
            .arg(folder)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped());
        let mut child = command.spawn().unwrap();
        let (input, output) = (child.stdin.take(), BufReader::new(child.stdout.take().unwrap()));
        let mut client = Self { child, input, output, number: 0 };
        let greeting = client.request(
            "initialize",
            json!({ "protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": { "name": "test", "version": "1" } }),
        );
        assert_eq!(greeting["result"]["serverInfo"]["name"], "meniscus", "{greeting}");
        assert!(greeting["result"]["instructions"].as_str().unwrap().contains("guide"), "{greeting}");
        client.send(&json!({ "jsonrpc": "2.0", "method": "notifications/initialized" }).to_string());
        client
    }

    /// Writes a line.
    pub fn send(&mut self, line: &str) {
        writeln!(self.input.as_mut().unwrap(), "{line}").unwrap();
    }

    /// The answer to a request.
    pub fn request(&mut self, method: &str, params: Value) -> Value {
        self.number += 1;
        let number = self.number;
        self.send(&json!({ "jsonrpc": "2.0", "id": number, "method": method, "params": params }).to_string());
        loop {
            let mut line = String::new();
            assert!(self.output.read_line(&mut line).unwrap() > 0, "the server has ended");
            let answer: Value = serde_json::from_str(&line).unwrap();
            if answer["id"] == number {
                return answer;
            }
        }
    }

    /// The result of a call of a tool.
    fn result(&mut self, tool: &str, arguments: Value) -> Value {
        let answer = self.request("tools/call", json!({ "name": tool, "arguments": arguments }));
        assert!(answer.get("result").is_some(), "{answer}");
        answer["result"].clone()
    }

    /// The data of a call that succeeds.
    pub fn call(&mut self, tool: &str, arguments: Value) -> Value {
        let result = self.result(tool, arguments);
        assert_ne!(result["isError"], true, "{result}");
        // The text is the same data, for clients that read nothing else.
        let data = result["structuredContent"].clone();
        if data.is_object() {
            let text: Value = serde_json::from_str(result["content"][0]["text"].as_str().unwrap()).unwrap();
            assert_eq!(text, data);
        }
        data
    }

    /// The text of a call that succeeds.
    pub fn text(&mut self, tool: &str, arguments: Value) -> String {
        let result = self.result(tool, arguments);
        assert_ne!(result["isError"], true, "{result}");
        result["content"][0]["text"].as_str().unwrap().to_owned()
    }

    /// The content of a call that succeeds.
    pub fn content(&mut self, tool: &str, arguments: Value) -> Vec<Value> {
        let result = self.result(tool, arguments);
        assert_ne!(result["isError"], true, "{result}");
        result["content"].as_array().unwrap().clone()
    }

    /// The data of a call that is refused.
    pub fn refused(&mut self, tool: &str, arguments: Value) -> Value {
        let result = self.result(tool, arguments);
        assert_eq!(result["isError"], true, "{result}");
        assert!(result["structuredContent"]["error"].is_string(), "{result}");
        result["structuredContent"].clone()
    }

    /// Closes the input and asserts that the server ends by itself.
    pub fn close(mut self) {
        drop(self.input.take());
        assert!(self.child.wait().unwrap().success());
    }
}

//! Requests and their replies, as the Python sources write and read them.

#![allow(clippy::unwrap_used, reason = "a test fails by it")]

use requests::{Buffer, Host, Opened, Reply, call, open};
use runner::Files;
use serde_json::{Value, json};
use std::cell::Cell;
use std::io;
use std::path::Path;

const FALL: &str = "---\nuntil: 1 [s]\nstep: 0.25\n---\n\n```model\nparameter g = 10 [m/s^2] in 0..20\n\
                    y'' = -g\ny(0) = 2 [m]\ny'(0) = 0\nhigh = y > 1 [m]\nside = if high then \"up\" else \"down\"\n```\n";

/// A host without files, which ends the work after some questions.
struct Alone(Cell<u32>);

impl Files for Alone {
    fn read(&self, _: &Path) -> io::Result<Vec<u8>> {
        Err(io::Error::other("there are no files"))
    }

    fn is_folder(&self, _: &Path) -> bool {
        false
    }

    fn names(&self, _: &Path) -> Vec<String> {
        Vec::new()
    }
}

impl Host for Alone {
    fn player(&self) -> Option<String> {
        None
    }

    fn seconds(&self) -> f64 {
        0.0
    }

    fn goes_on(&self) -> bool {
        self.0.set(self.0.get().saturating_sub(1));
        self.0.get() > 0
    }
}

fn host() -> Alone {
    Alone(Cell::new(u32::MAX))
}

fn opened() -> Opened {
    let (opened, reply) = open(&host(), &json!({ "texts": [["document", FALL]] }).to_string());
    let answer: Value = serde_json::from_str(&reply.json).unwrap();
    assert_eq!(answer["parameters"], json!([["g", 10.0, "m/s^2"]]));
    opened.unwrap()
}

fn asked(name: &str, request: &Value, numbers: &[Vec<f64>]) -> (Value, Vec<Buffer>) {
    let Reply { json, buffers } = call(&host(), name, &[&opened()], &request.to_string(), numbers);
    (serde_json::from_str(&json).unwrap(), buffers)
}

#[test]
fn numbers_and_truths_of_a_run_are_arrays() {
    let (answer, buffers) = asked("run", &json!({ "columns": ["t, high", "side"], "settings": {} }), &[]);
    let columns = json!([
        ["t", "s", "", "numbers", null],
        ["high", "", "", "truths", null],
        ["side", "", "", "texts", ["up", "up", "down", "down", "down"]],
    ]);
    assert_eq!(answer, json!({ "columns": columns, "notices": [], "ended": null }));
    assert_eq!(buffers, [Buffer::Numbers(vec![0.0, 0.25, 0.5, 0.75, 1.0]), Buffer::Truths(vec![1, 1, 0, 0, 0])]);
}

#[test]
fn a_sweep_takes_its_values_from_an_array() {
    let over = json!([{ "numbers": ["g", 0] }]);
    let prepare = json!({ "over": over, "keep": ["y at end"], "settings": { "until": "1 s" } });
    let request = json!({ "prepare": prepare, "seed": 1 });
    let (answer, buffers) = asked("sweep", &request, &[vec![0.0, 4.0]]);
    assert_eq!(answer["columns"][2], json!(["y at end", "m", "", "numbers", null]));
    let expected = [vec![1.0, 2.0], vec![0.0, 4.0], vec![2.0, 0.0]];
    assert_eq!(buffers, expected.map(Buffer::Numbers));
}

#[test]
fn errors_have_the_names_of_exceptions() {
    let run = |settings: Value| json!({ "columns": null, "settings": settings });
    for (name, request, error, text) in [
        ("run", run(json!({ "untill": "3" })), "TypeError", "unknown field `untill`"),
        ("run", run(json!({ "until": "-1" })), "SettingError", "until must be greater than 0"),
        ("run", run(json!({ "draw": [["f", "f.csv"]] })), "SettingError", ""),
        ("page", json!(null), "ValueError", "without the player"),
        ("jump", json!(null), "ValueError", "there is no request `jump`"),
    ] {
        let (answer, buffers) = asked(name, &request, &[]);
        assert_eq!(answer["error"], error, "{answer}");
        let said = format!("{}{}", answer["message"], answer["diagnostics"]);
        assert!(said.contains(text) && buffers.is_empty(), "{said}");
    }
    let (none, reply) = open(&host(), &json!({ "path": "fall.md" }).to_string());
    assert!(none.is_none() && reply.json.contains("cannot read fall.md: there are no files"), "{}", reply.json);
}

#[test]
fn the_host_ends_long_runs() {
    let request = json!({ "columns": ["t"], "settings": { "until": "1e9", "step": "1e-3" } });
    let reply = call(&Alone(Cell::new(2)), "run", &[&opened()], &request.to_string(), &[]);
    assert!(reply.json.contains("KeyboardInterrupt"), "{}", reply.json);
}

//! Shared code of the tests: fits of theories of the gallery to a record with known truth.
#![allow(dead_code, missing_docs, reason = "no test uses all of it")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by them")]

use analysis::fit::{Fit, Interval, Observation, Outcome, Record, Task, Trace, Varied, profile};
use document::Document;
use report::Report;
use std::path::Path;

/// A theory of the gallery with its translation.
pub fn theory(name: &str) -> Document {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../simulations/theories");
    let read = |name: String| std::fs::read_to_string(folder.join(&name)).unwrap_or_else(|_| panic!("{name}"));
    document::open(&read(format!("{name}.md")), &[&read(format!("{name}.es.md"))]).document.unwrap()
}

/// Data of a report.
pub struct Fitted {
    pub document: Document,
    pub name: String,
    pub task: Task,
    pub outcome: Outcome,
    pub traces: Vec<Trace>,
    pub intervals: Vec<Option<[Interval; 2]>>,
    pub notes: Vec<Vec<String>>,
}

/// Times in s and levels in m of a column with 10 rad/s and a damping of 0.4 /s, with independent noise, at 30 frames
/// per second.
pub fn level() -> (Vec<f64>, Vec<f64>) {
    let times: Vec<f64> = (0..240).map(|frame| f64::from(frame) / 30.0).collect();
    let mut state = 12345_u32;
    let mut chance = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 8) / f64::from(1 << 24) - 0.5
    };
    let mut scatter = || 1e-3 * (0..12).map(|_| chance()).sum::<f64>();
    let values = times.iter().map(|t| 0.045 * libm::exp(-0.4 * t) * libm::cos(10.0 * t) - 0.003 + scatter());
    let values = values.collect();
    (times, values)
}

/// An observation of an expression.
pub fn observed(document: &mut Document, expression: &str, times: &[f64], values: &[f64]) -> Observation {
    let (tree, unit, _) = model::parse_expression(expression, 0..expression.len());
    Observation {
        name: expression.to_owned(),
        observed: model::Compiler::new(&mut document.program.model).compile(&tree, unit.as_ref()).unwrap(),
        times: times.to_vec(),
        values: values.to_vec(),
        errors: None,
        derived_from: None,
    }
}

/// A finished fit of the parameters that the theory varies by default.
pub fn fitted(name: &str, document: Document, records: Vec<Record>, change: impl FnOnce(&mut Task)) -> Fitted {
    let mut task = Task {
        parameters: document.program.model.parameters.iter().map(|parameter| parameter.value).collect(),
        method: document.program.method.unwrap(),
        varied: document.program.vary.iter().map(|&index| Varied::parameter(index)).collect(),
        records,
        ..Task::default()
    };
    change(&mut task);
    let mut fit = Fit::new(&document.program.model, task.clone()).unwrap();
    fit.complete();
    let outcome = fit.outcome().unwrap();
    let traces = fit.traces(600);
    let first = outcome.parameters[0].stderr.map(|stderr| profile(&mut fit, 0, stderr, outcome.dof));
    let mut intervals = vec![None; outcome.parameters.len()];
    intervals[0] = first;
    Fitted { document, name: format!("{name}.md"), task, outcome, traces, intervals, notes: Vec::new() }
}

impl Fitted {
    pub fn report<'a>(&'a self, language: &'a str) -> Report<'a> {
        Report {
            document: &self.document,
            document_name: &self.name,
            language: catalogues::with(units::Language::of(language)),
            task: &self.task,
            outcome: &self.outcome,
            traces: &self.traces,
            intervals: &[],
            notes: &self.notes,
            films: &[],
            command: "meniscus fit linear.md U3.txt --observe y --until 6",
            version: "0.1.0",
            date: "21 November 2026",
        }
    }
}

/// A record of one observation of `y`.
pub fn record(document: &mut Document, name: &str, times: &[f64], values: &[f64]) -> Record {
    Record { name: name.to_owned(), observations: vec![observed(document, "y", times, values)], ..Record::default() }
}

/// A page as well-formed XML: without its doctype, and with closed `meta` elements.
pub fn parsed(page: &str) -> String {
    let page = page.replace("<!doctype html>", "");
    let mut closed = String::new();
    for (number, piece) in page.split("<meta ").enumerate() {
        match piece.split_once('>') {
            Some((attributes, rest)) if number > 0 => closed += &format!("<meta {attributes}/>{rest}"),
            _ => closed += piece,
        }
    }
    closed
}

/// The text of a page.
pub fn texts(page: &str) -> String {
    let source = parsed(page);
    let tree = roxmltree::Document::parse(&source).unwrap_or_else(|error| panic!("{error}"));
    let texts =
        tree.descendants().filter(|node| node.is_text() && node.parent_element().unwrap().tag_name().name() != "style");
    texts.filter_map(|node| node.text()).collect::<Vec<_>>().join(" ")
}

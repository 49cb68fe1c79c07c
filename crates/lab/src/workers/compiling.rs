//! Texts that the worker of a page with the player alone compiles (`crates/player/element`).

use document::Document;
use js_sys::{Array, Object, Reflect, Uint8Array};
use model::{Diagnostic, Severity};
use program::bundle;
use units::Words;
use wasm_bindgen::JsValue;
use web_sys::DedicatedWorkerGlobalScope;

/// Opens a document and sends `{ bundle, findings }`: the compiled simulation, undefined if the text gives none, and what is wrong
/// with it, `{ severity, message, remedy, line, column }` with places from 1.
pub fn compile(text: &str, page: &DedicatedWorkerGlobalScope) {
    let opened = document::open(text, &[]);
    let bundle = opened.document.as_ref().and_then(|document: &Document| bundle::write(&document.program).ok());
    let bundle = bundle.map_or(JsValue::UNDEFINED, |bytes| Uint8Array::from(bytes.as_slice()).into());
    let findings: Array = opened.diagnostics.iter().map(|(_, found)| finding(text, found)).collect();
    let _ = page.post_message(&object(&[("bundle", bundle), ("findings", findings.into())]));
}

fn finding(text: &str, found: &Diagnostic) -> JsValue {
    let severity = if found.severity == Severity::Error { "error" } else { "warning" };
    let before = &text[..text.floor_char_boundary(found.span().start.min(text.len()))];
    let line = before.rfind('\n').map_or(0, |newline| newline + 1);
    let remedy = found.hints.iter().map(Words::english).collect::<Vec<_>>().join("; ");
    object(&[
        ("severity", severity.into()),
        ("message", found.message.english().into()),
        ("remedy", remedy.into()),
        ("line", JsValue::from((1 + before.matches('\n').count()) as f64)),
        ("column", JsValue::from((1 + before[line..].chars().count()) as f64)),
    ])
}

fn object(members: &[(&str, JsValue)]) -> JsValue {
    let object = Object::new();
    for (name, value) in members {
        let _ = Reflect::set(&object, &(*name).into(), value);
    }
    object.into()
}

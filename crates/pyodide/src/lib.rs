//! The module of the Python package in Pyodide: the requests of `crates/requests`, through JavaScript (`wasm-bindgen`).
//!
//! `core.py` beside it loads the module and gives it the files that Python sees: Pyodide's own toolchain would be needed for
//! the module of `crates/python`. Documents have numbers here, which Python closes. Steps of runs are emitted code (`host`).
//! The module is compiled while Python imports it; Chromium allows that outside workers up to 8 MB. The wheel,
//! `py3-none-any`, has the Python sources of `crates/python`.
//!
//! - **Invariant:** the same requests, replies and bits as in `crates/python`.

mod surroundings;

use js_sys::{Array, Float64Array, Uint8Array};
use requests::{Buffer, Opened, Reply};
use std::cell::RefCell;
use std::collections::BTreeMap;
use surroundings::{Python, Surroundings};
use wasm_bindgen::prelude::{JsCast, JsValue, wasm_bindgen};

thread_local! {
    /// Opened documents by their numbers.
    static OPENED: RefCell<BTreeMap<u32, Opened>> = const { RefCell::new(BTreeMap::new()) };
}

/// Opens a document. Returns its number, 0 if it has errors, and the reply.
#[wasm_bindgen]
pub fn open(python: &Python, request: &str) -> Array {
    let (opened, reply) = requests::open(&Surroundings::new(python), request);
    let number = opened.map_or(0, |opened| {
        OPENED.with_borrow_mut(|all| {
            let number = all.last_key_value().map_or(1, |(last, _)| last + 1);
            all.insert(number, opened);
            number
        })
    });
    let [json, buffers] = sent(&reply);
    Array::of3(&number.into(), &json, &buffers)
}

/// Version of the package.
#[wasm_bindgen]
pub fn version() -> String {
    program::VERSION.to_owned()
}

/// Number of the bits of the results ([`program::BITS`]).
#[wasm_bindgen]
pub fn bits() -> u32 {
    program::BITS
}

/// Forgets a document.
#[wasm_bindgen]
pub fn close(number: u32) {
    OPENED.with_borrow_mut(|all| all.remove(&number));
}

/// Fulfils a request about documents, given by their numbers. Returns the reply: its JSON, and an array of typed arrays.
///
/// # Errors
/// The exception with which Python ends the work.
#[wasm_bindgen]
pub fn call(python: &Python, name: &str, documents: &[u32], request: &str, numbers: &Array) -> Result<Array, JsValue> {
    let surroundings = Surroundings::new(python);
    let documents = OPENED.with_borrow(|all| documents.iter().filter_map(|number| all.get(number).cloned()).collect());
    let documents: Vec<Opened> = documents;
    let numbers = numbers.iter().filter_map(|array| array.dyn_into::<Float64Array>().ok());
    let numbers: Vec<Vec<f64>> = numbers.map(|array| array.to_vec()).collect();
    let reply = requests::call(&surroundings, name, &documents.iter().collect::<Vec<_>>(), request, &numbers);
    surroundings.ended()?;
    let [json, buffers] = sent(&reply);
    Ok(Array::of2(&json, &buffers))
}

/// A reply as values of JavaScript.
fn sent(reply: &Reply) -> [JsValue; 2] {
    let buffer = |buffer: &Buffer| -> JsValue {
        match buffer {
            Buffer::Numbers(numbers) => Float64Array::from(numbers.as_slice()).into(),
            Buffer::Truths(truths) => Uint8Array::from(truths.as_slice()).into(),
        }
    };
    [reply.json.as_str().into(), reply.buffers.iter().map(buffer).collect::<Array>().into()]
}

//! The library as a WebAssembly module. It is a program without work of its own, since a library that is also linked into
//! others is not optimized as a whole.

use wasm_bindgen::prelude::wasm_bindgen;

/// The module; nothing if its streams are damaged.
#[wasm_bindgen]
#[must_use]
pub fn join(streams: &[u8]) -> Option<Vec<u8>> {
    unpack::join(streams)
}

fn main() {}

//! Messages of a worker to the page.

use js_sys::{Array, Uint8Array};
use serde::Serialize;
use web_sys::DedicatedWorkerGlobalScope;

/// Answers the order of this number.
pub fn answer(page: &DedicatedWorkerGlobalScope, number: u32, answer: &impl Serialize) {
    let bytes = Uint8Array::from(postcard::to_allocvec(&(number, answer)).unwrap_or_default().as_slice());
    let _ = page.post_message_with_transfer(&bytes, &Array::of1(&bytes.buffer()));
}

//! What happens in a worker: it computes what the page sends, one fit after the other, and reports.

use desk::{FitNews, FitWork};
use js_sys::{Date, Uint8Array};
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;
use web_sys::{DedicatedWorkerGlobalScope, MessageEvent};

/// Time between two reports of progress, in milliseconds.
const BETWEEN: f64 = 100.0;

/// True in a worker.
pub fn is_worker() -> bool {
    js_sys::global().is_instance_of::<DedicatedWorkerGlobalScope>()
}

/// Accepts work. The page waits for the first message, which is empty.
pub fn serve() {
    let Ok(worker) = js_sys::global().dyn_into::<DedicatedWorkerGlobalScope>() else { return };
    let to_page = worker.clone();
    let accept = Closure::<dyn FnMut(MessageEvent)>::new(move |event: MessageEvent| {
        let bytes = event.data().dyn_into::<Uint8Array>().map(|bytes| bytes.to_vec()).unwrap_or_default();
        let work: Option<FitWork> = postcard::from_bytes(&bytes).ok();
        match work {
            Some(work) => compute(work, &to_page),
            None => report(&to_page, &FitNews::Found(None)),
        }
    });
    worker.set_onmessage(Some(accept.as_ref().unchecked_ref()));
    // The worker accepts work as long as it lives.
    accept.forget();
    let _ = worker.post_message(&Uint8Array::new_with_length(0));
}

/// Computes a fit. The page ends the worker if it does not want the result any more.
fn compute(work: FitWork, page: &DedicatedWorkerGlobalScope) {
    let mut computation = work.start();
    let mut reported = Date::now();
    loop {
        let news = computation.advance();
        let is_last = matches!(news, FitNews::Found(_));
        let now = Date::now();
        if is_last || now - reported >= BETWEEN {
            report(page, &news);
            reported = now;
        }
        if is_last {
            return;
        }
    }
}

fn report(page: &DedicatedWorkerGlobalScope, news: &FitNews) {
    let bytes = Uint8Array::from(postcard::to_allocvec(news).unwrap_or_default().as_slice());
    let _ = page.post_message_with_transfer(&bytes, &js_sys::Array::of1(&bytes.buffer()));
}

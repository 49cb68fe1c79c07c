//! What happens in a worker: it does what the page orders, one order after the other, and answers.

use super::answer::answer;
use super::compiling::compile;
use super::order::Order;
use super::sweeping::Sweeping;
use class::collection::{Calculator, Computed};
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

/// Accepts orders. The page waits for the first message, which is empty.
pub fn serve() {
    let Ok(worker) = js_sys::global().dyn_into::<DedicatedWorkerGlobalScope>() else { return };
    let Some(sweeping) = Sweeping::new(&worker) else { return };
    let (page, mut calculator) = (worker.clone(), Calculator::default());
    let accept = Closure::<dyn FnMut(MessageEvent)>::new(move |event: MessageEvent| {
        if let Some(text) = event.data().as_string() {
            return compile(&text, &page);
        }
        let message = postcard::from_bytes::<(u32, Order)>(&Uint8Array::new(&event.data()).to_vec());
        let Ok((number, order)) = message else { return };
        match order {
            Order::Fit(work) => fit(*work, number, &page),
            Order::HandIns(orders) => {
                let computed: Vec<Option<Computed>> = orders.iter().map(|order| calculator.compute(order)).collect();
                answer(&page, number, &computed);
            }
            Order::Sweep(work) => sweeping.begin(number, *work),
            Order::Stop => sweeping.stop(),
        }
    });
    worker.set_onmessage(Some(accept.as_ref().unchecked_ref()));
    // The worker accepts orders as long as it lives.
    accept.forget();
    let _ = worker.post_message(&Uint8Array::new_with_length(0));
}

/// Computes a fit. The page ends the worker if it does not want the result any more.
fn fit(work: FitWork, number: u32, page: &DedicatedWorkerGlobalScope) {
    let mut computation = work.start();
    // Models that cannot be compiled, or whose code the browser refuses, are interpreted.
    computation.compile(|listing| host::compile(Ok(listing)).ok());
    let mut reported = Date::now();
    loop {
        let news = computation.advance();
        let is_last = matches!(news, FitNews::Found(_));
        let now = Date::now();
        if is_last || now - reported >= BETWEEN {
            answer(page, number, &news);
            reported = now;
        }
        if is_last {
            return;
        }
    }
}

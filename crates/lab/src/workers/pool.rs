//! Workers of the page, and what they report.

use super::order::Order;
use js_sys::{Function, Uint8Array};
use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;
use view::views::window;
use wasm_bindgen::prelude::*;

/// Maximum number of workers of a pool. Each takes about 2 MB.
const MOST_WORKERS: usize = 2;

#[wasm_bindgen]
extern "C" {
    /// A worker with the module of the laboratory, of `crates/lab/page/opening.js`.
    type BrowserWorker;

    /// Starts a worker. `heard` gets each message; `failed` is called if the worker cannot be started, or has stopped.
    #[wasm_bindgen(js_namespace = opening, js_name = worker)]
    fn start(heard: &Function, failed: &Function) -> BrowserWorker;

    /// Sends bytes, which this page loses.
    #[wasm_bindgen(method)]
    fn post(this: &BrowserWorker, bytes: &Uint8Array);

    /// Ends the worker at once.
    #[wasm_bindgen(method)]
    fn end(this: &BrowserWorker);
}

/// Workers of the page. Each has one order at a time.
#[derive(Default)]
pub struct Pool {
    /// Called when something has been heard.
    wake: Option<Rc<dyn Fn()>>,
    members: Vec<Member>,
    /// Reports of the workers that are not read yet.
    inbox: Rc<RefCell<VecDeque<Report>>>,
    /// Number of members so far; it names the next one.
    started: u32,
    /// Number of orders so far; it names the next one.
    ordered: u32,
    /// True if the browser has no workers.
    is_refused: bool,
}

/// Name of a worker, and its answer; `None` if it has stopped.
type Report = (u32, Option<Vec<u8>>);

/// A worker and its order.
struct Member {
    name: u32,
    worker: BrowserWorker,
    order: Option<u32>,
    /// True once it waits for orders.
    is_ready: bool,
    /// True once it has answered an order.
    answers: bool,
    /// Functions that the worker calls.
    _calls: [Closure<dyn FnMut(JsValue)>; 2],
}

impl Member {
    fn send(&self, number: u32, order: &Order) {
        // Numbers and texts can always be written.
        let bytes = postcard::to_allocvec(&(number, order)).unwrap_or_default();
        self.worker.post(&Uint8Array::from(bytes.as_slice()));
    }
}

/// Message of a worker about an order.
pub enum Heard {
    /// An answer. The worker keeps the order until [`Pool::finish`].
    Answer(Vec<u8>),
    /// The worker has stopped because of a fault.
    Stopped,
    /// The browser has no workers.
    Refused,
}

impl Pool {
    /// Sets what is to be done when something has been heard.
    pub fn wake_by(&mut self, wake: impl Fn() + 'static) {
        self.wake = Some(Rc::new(wake));
    }

    /// True if the browser has no workers.
    pub fn is_refused(&self) -> bool {
        self.is_refused
    }

    /// Number of workers that can be had.
    pub fn count(&self) -> usize {
        (window().navigator().hardware_concurrency() as usize).clamp(1, MOST_WORKERS)
    }

    /// Number of workers without an order.
    pub fn free(&self) -> usize {
        self.count().saturating_sub(self.members.iter().filter(|member| member.order.is_some()).count())
    }

    /// Number of orders so far.
    pub fn ordered(&self) -> u32 {
        self.ordered
    }

    /// Gives an order to a free worker, and returns its number.
    pub fn begin(&mut self, order: &Order) -> u32 {
        self.ordered += 1;
        let number = self.ordered;
        let member = match self.members.iter().position(|member| member.order.is_none()) {
            Some(place) => &mut self.members[place],
            None => self.start(),
        };
        member.order = Some(number);
        member.send(number, order);
        number
    }

    /// Starts all workers that can be had.
    pub fn start_all(&mut self) {
        while !self.is_refused && self.members.len() < self.count() {
            self.start();
        }
    }

    /// True if all workers that can be had have been started and can take orders.
    pub fn is_ready(&self) -> bool {
        self.members.len() >= self.count() && self.members.iter().all(|member| member.is_ready)
    }

    fn start(&mut self) -> &mut Member {
        self.started += 1;
        let name = self.started;
        let report = |read: fn(JsValue) -> Option<Vec<u8>>| {
            let (inbox, wake) = (Rc::clone(&self.inbox), self.wake.clone());
            Closure::<dyn FnMut(JsValue)>::new(move |message| {
                inbox.borrow_mut().push_back((name, read(message)));
                if let Some(wake) = &wake {
                    wake();
                }
            })
        };
        let calls = [report(|message| Some(Uint8Array::new(&message).to_vec())), report(|_| None)];
        let worker = start(calls[0].as_ref().unchecked_ref(), calls[1].as_ref().unchecked_ref());
        self.members.push_mut(Member { name, worker, order: None, is_ready: false, answers: false, _calls: calls })
    }

    /// Messages since the last call, in the order of time, with the numbers of the orders.
    pub fn hear(&mut self) -> Vec<(u32, Heard)> {
        let mut all = Vec::new();
        let inbox = std::mem::take(&mut *self.inbox.borrow_mut());
        for (name, answer) in inbox {
            let Some(place) = self.members.iter().position(|member| member.name == name) else { continue };
            let Some(answer) = answer else {
                all.extend(self.lose(place));
                continue;
            };
            let member = &mut self.members[place];
            member.is_ready = true;
            // The first message is empty. Answers about an order that is not wanted any more may still come.
            let Ok((number, answer)) = postcard::take_from_bytes::<u32>(&answer) else { continue };
            member.answers = true;
            if member.order == Some(number) {
                all.push((number, Heard::Answer(answer.to_vec())));
            }
        }
        all
    }

    /// Ends a worker that has stopped. One that has never answered shows that the browser has none.
    fn lose(&mut self, place: usize) -> Vec<(u32, Heard)> {
        let lost = self.members.swap_remove(place);
        lost.worker.end();
        if lost.answers {
            return lost.order.map(|order| (order, Heard::Stopped)).into_iter().collect();
        }
        self.is_refused = true;
        let left = std::iter::once(lost).chain(self.members.drain(..));
        let end = |member: Member| {
            member.worker.end();
            Some((member.order?, Heard::Refused))
        };
        left.filter_map(end).collect()
    }

    /// An order is done; its worker is free.
    pub fn finish(&mut self, order: u32) {
        let has = |member: &&mut Member| member.order == Some(order);
        if let Some(member) = self.members.iter_mut().find(has) {
            member.order = None;
        }
    }

    /// Ends the workers whose orders are not wanted.
    pub fn keep(&mut self, wanted: &[u32]) {
        self.members.retain(|member| {
            let keeps = member.order.is_none_or(|order| wanted.contains(&order));
            if !keeps {
                member.worker.end();
            }
            keeps
        });
    }

    /// Tells the workers whose orders are not wanted to stop. They can take another order at once.
    pub fn stop_others(&mut self, wanted: &[u32]) {
        for member in &mut self.members {
            if let Some(number) = member.order.take_if(|order| !wanted.contains(order)) {
                member.send(number, &Order::Stop);
            }
        }
    }

    /// Ends all workers.
    pub fn end(&mut self) {
        self.members.drain(..).for_each(|member| member.worker.end());
    }
}

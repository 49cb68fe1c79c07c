//! Runs of a plot over a parameter in a worker. They are made in slices: between them the worker hears that they are not
//! wanted any more, so that it need not be ended, and the next ones begin without a start of a worker.

use super::answer::answer;
use js_sys::Date;
use play::engine::Compiler;
use play::{SweepComputation, SweepNews, SweepWork, TakenRun, WORK_PER_TICK};
use std::cell::{Cell, RefCell};
use std::rc::Rc;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{DedicatedWorkerGlobalScope, MessageChannel, MessagePort};

/// Duration of a slice, in milliseconds.
const SLICE: f64 = 16.0;

/// Time between two reports, in milliseconds.
const BETWEEN: f64 = 50.0;

/// The runs in progress.
pub struct Sweeping {
    page: DedicatedWorkerGlobalScope,
    /// Keeps the code of the last models.
    compiler: Rc<host::Compiler>,
    batch: RefCell<Option<Batch>>,
    /// Asks for the next slice by a message to the worker itself. Timers would wait 4 ms between slices.
    next: MessagePort,
    /// True while the next slice is asked for.
    is_asked: Cell<bool>,
}

/// A batch in progress.
struct Batch {
    /// Number of its order.
    number: u32,
    computation: SweepComputation,
    /// Values and points of complete runs that are not reported.
    taken: Vec<TakenRun>,
    /// Time of the last report, in milliseconds.
    reported: f64,
}

impl Sweeping {
    /// Nothing is in progress. `None` if the browser has no message channels.
    pub fn new(page: &DedicatedWorkerGlobalScope) -> Option<Rc<Self>> {
        let channel = MessageChannel::new().ok()?;
        let sweeping = Rc::new(Self {
            page: page.clone(),
            compiler: Rc::default(),
            batch: RefCell::default(),
            next: channel.port2(),
            is_asked: Cell::default(),
        });
        let own = Rc::clone(&sweeping);
        let go_on = Closure::<dyn FnMut()>::new(move || own.go_on());
        channel.port1().set_onmessage(Some(go_on.as_ref().unchecked_ref()));
        // The worker goes on as long as it lives.
        go_on.forget();
        Some(sweeping)
    }

    /// Begins a batch. It takes the place of the one in progress.
    pub fn begin(&self, number: u32, work: SweepWork) {
        let computation = work.start(Some(Rc::<host::Compiler>::clone(&self.compiler) as Rc<dyn Compiler>));
        let batch = Batch { number, computation, taken: Vec::new(), reported: Date::now() };
        *self.batch.borrow_mut() = Some(batch);
        self.ask();
    }

    /// Gives up the batch in progress.
    pub fn stop(&self) {
        *self.batch.borrow_mut() = None;
    }

    fn ask(&self) {
        if !self.is_asked.replace(true) {
            let _ = self.next.post_message(&JsValue::NULL);
        }
    }

    /// Computes for one slice, and reports.
    fn go_on(&self) {
        self.is_asked.set(false);
        let mut present = self.batch.borrow_mut();
        let Some(batch) = present.as_mut() else { return };
        let end = Date::now() + SLICE;
        while !batch.computation.is_complete() && Date::now() < end {
            batch.taken.extend(batch.computation.advance(WORK_PER_TICK));
        }
        let (is_last, now) = (batch.computation.is_complete(), Date::now());
        if is_last || (!batch.taken.is_empty() && now - batch.reported >= BETWEEN) {
            batch.reported = now;
            let runs = std::mem::take(&mut batch.taken);
            answer(&self.page, batch.number, &SweepNews::Taken { runs, is_last });
        }
        if is_last {
            *present = None;
        } else {
            self.ask();
        }
    }
}

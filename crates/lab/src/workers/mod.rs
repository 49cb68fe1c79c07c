//! Long work beside the page: workers that run the page's own module, so that the page stays responsive. Where a browser
//! refuses workers, the page computes in slices.

mod served;

use desk::{FitNews, FitWork, InProcess, Workers};
use js_sys::{Function, Uint8Array};
use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;
use view::views::window;
use wasm_bindgen::prelude::*;

pub use served::{is_worker, serve};

/// Maximum number of workers. Each takes about 2 MB.
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

/// Workers of the page.
#[derive(Default)]
pub struct Pool {
    /// Called when there is news.
    wake: Option<Rc<dyn Fn()>>,
    members: Vec<Member>,
    /// What the workers have reported, until it is read.
    inbox: Rc<RefCell<VecDeque<Report>>>,
    /// Number of members so far; it names the next one.
    started: u32,
    /// Number of fits so far; it names the next one.
    issued: u32,
    /// Computes here if the browser has no workers.
    here: Option<InProcess>,
}

/// A worker and its work.
struct Member {
    name: u32,
    worker: BrowserWorker,
    /// Number of the fit that it computes.
    fit: Option<u32>,
    /// True once it has reported something.
    answers: bool,
    /// Functions that the worker calls.
    _calls: [Closure<dyn FnMut(JsValue)>; 2],
}

/// What a worker reports; the number is the name of the member.
enum Report {
    News(u32, FitNews),
    /// It could not be started, or has stopped.
    Failed(u32),
}

impl Pool {
    /// Sets what is to be done when there is news.
    pub fn wake_by(&mut self, wake: impl Fn() + 'static) {
        self.wake = Some(Rc::new(wake));
    }

    /// True if the page itself computes, so that it has to be asked again and again.
    pub fn is_here(&self) -> bool {
        self.here.is_some()
    }

    fn start(&mut self) -> &mut Member {
        self.started += 1;
        let name = self.started;
        let report = |read: fn(u32, JsValue) -> Report| {
            let (inbox, wake) = (Rc::clone(&self.inbox), self.wake.clone());
            Closure::<dyn FnMut(JsValue)>::new(move |message| {
                inbox.borrow_mut().push_back(read(name, message));
                if let Some(wake) = &wake {
                    wake();
                }
            })
        };
        let calls = [report(read), report(|name, _| Report::Failed(name))];
        let worker = start(calls[0].as_ref().unchecked_ref(), calls[1].as_ref().unchecked_ref());
        self.members.push_mut(Member { name, worker, fit: None, answers: false, _calls: calls })
    }

    /// Takes the end of a worker into account. A worker that has never answered shows that the browser has none.
    fn lose(&mut self, name: u32) -> Vec<(u32, FitNews)> {
        let Some(place) = self.members.iter().position(|member| member.name == name) else { return Vec::new() };
        let lost = self.members.swap_remove(place);
        lost.worker.end();
        if lost.answers {
            return lost.fit.map(|fit| (fit, FitNews::Found(None))).into_iter().collect();
        }
        self.here = Some(InProcess::after(self.issued));
        let left = std::iter::once(lost).chain(self.members.drain(..));
        left.filter_map(|member| {
            member.worker.end();
            Some((member.fit?, FitNews::Lost))
        })
        .collect()
    }
}

/// Reads the message of a worker.
fn read(name: u32, message: JsValue) -> Report {
    let news = message.dyn_into::<Uint8Array>().ok().and_then(|bytes| postcard::from_bytes(&bytes.to_vec()).ok());
    news.map_or(Report::Failed(name), |news| Report::News(name, news))
}

impl Workers for Pool {
    fn count(&self) -> usize {
        match self.here {
            Some(_) => 1,
            None => (window().navigator().hardware_concurrency() as usize).clamp(1, MOST_WORKERS),
        }
    }

    fn begin(&mut self, work: FitWork) -> u32 {
        if let Some(here) = &mut self.here {
            return here.begin(work);
        }
        self.issued += 1;
        let number = self.issued;
        let member = match self.members.iter().position(|member| member.fit.is_none()) {
            Some(place) => &mut self.members[place],
            None => self.start(),
        };
        member.fit = Some(number);
        // Numbers and texts can always be written.
        member.worker.post(&Uint8Array::from(postcard::to_allocvec(&work).unwrap_or_default().as_slice()));
        number
    }

    fn news(&mut self) -> Vec<(u32, FitNews)> {
        if let Some(here) = &mut self.here {
            return here.news();
        }
        let mut all = Vec::new();
        let reports = std::mem::take(&mut *self.inbox.borrow_mut());
        for report in reports {
            match report {
                Report::News(name, news) => {
                    let Some(member) = self.members.iter_mut().find(|member| member.name == name) else { continue };
                    member.answers = true;
                    let fit = if matches!(news, FitNews::Found(_)) { member.fit.take() } else { member.fit };
                    all.extend(fit.map(|fit| (fit, news)));
                }
                Report::Failed(name) => all.extend(self.lose(name)),
            }
        }
        all
    }

    fn keep(&mut self, wanted: &[u32]) {
        if let Some(here) = &mut self.here {
            return here.keep(wanted);
        }
        self.members.retain(|member| {
            let keeps = member.fit.is_none_or(|fit| wanted.contains(&fit));
            if !keeps {
                member.worker.end();
            }
            keeps
        });
    }
}

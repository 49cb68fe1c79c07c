//! The simulation of the page, and its program.

use crate::answers;
use crate::course::Course;
use crate::surrounding::Surrounding;
use play::{Embedding, Play};
use program::bundle;
use std::cell::{Cell, OnceCell, RefCell};
use units::Language;
use view::page::opening::Opening;
use view::page::{shell, welcome};
use view::views::View;
use view::{App, Host};
use wasm_bindgen::{JsCast, JsValue};

/// The simulation; `None` until it has been read.
#[derive(Default)]
pub struct Simulation {
    pub play: RefCell<Option<Play>>,
    /// Handle of its views.
    pub app: OnceCell<App>,
    /// Page around this one, once it is followed.
    pub surrounding: OnceCell<&'static Surrounding>,
    /// Course that the page belongs to, if it does.
    pub course: Option<Course>,
    /// Options in the address of the page.
    embedding: Embedding,
    /// True if the laboratory will take the simulation over; it keeps the answers.
    is_passed_on: bool,
    /// Revision of the answers saved last.
    saved: Cell<u64>,
}

impl Simulation {
    /// Creates the host without a simulation, for a page with these options.
    pub fn new(embedding: Embedding) -> Self {
        Self { embedding, course: Course::of_page(), ..Self::default() }
    }

    /// Creates the host for the page of a laboratory with these options.
    pub fn of_laboratory(embedding: Embedding) -> Self {
        Self { is_passed_on: true, embedding, ..Self::default() }
    }
}

/// Opens the simulation of the page, with an `App` for its views. The last value is true if it runs.
pub fn open(simulation: Simulation, language: Language) -> (App, &'static Simulation, bool) {
    // It lives as long as the page, or until the laboratory takes it over.
    let simulation: &'static Simulation = Box::leak(Box::new(simulation));
    let app = App::new(simulation, language);
    shell::prepare(app);
    let play = of_page();
    let runs = play.is_some();
    simulation.play.replace(play);
    app.read(|play| play.set_language(language.tag()));
    (app, simulation, runs)
}

impl Host for Simulation {
    fn with_play(&self, work: &mut dyn FnMut(&mut Play)) {
        let play = self.play.try_borrow_mut();
        debug_assert!(play.is_ok(), "the simulation is used inside another use of it");
        if let Some(play) = play.ok().as_deref_mut().and_then(Option::as_mut) {
            work(play);
        }
    }

    fn embedding(&self) -> Embedding {
        self.embedding.clone()
    }

    fn door(&self) -> View {
        let opening = Opening::of_page().filter(|_| self.is_passed_on).filter(welcome::is_home);
        match (self.app.get(), opening) {
            (Some(app), Some(opening)) => welcome::door(*app, move || opening.ask(welcome::SEE)).into(),
            _ => View::new(),
        }
    }

    fn has_fixed_seat(&self) -> bool {
        self.course.as_ref().is_some_and(Course::has_begun)
    }

    fn raise(&self) {
        let answers = self.play.try_borrow().ok().and_then(|play| Some(play.as_ref()?.revision().answers));
        let (Some(answers), Some(app)) = (answers, self.app.get()) else { return };
        if self.is_passed_on || self.saved.replace(answers) == answers {
            return;
        }
        if let Some(surrounding) = self.surrounding.get() {
            surrounding.answers_changed(*app);
        }
        match &self.course {
            Some(course) if !course.is_alone() => course.answers_changed(*app),
            _ if answers::save(*app) => {}
            _ => app.complain(app.words().answers_not_saved.to_owned()),
        }
    }
}

/// Simulation from the bundle that the page's script has inflated; `None` if there is none or it is damaged.
fn of_page() -> Option<Play> {
    let bytes = js_sys::Reflect::get(&js_sys::global(), &JsValue::from_str("bundle")).ok()?;
    let bytes: js_sys::Uint8Array = bytes.dyn_into().ok()?;
    bundle::read(&bytes.to_vec()).ok().map(Play::open)
}

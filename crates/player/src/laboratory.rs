//! Page of the laboratory until the laboratory takes the simulation over: the same views, with its tabs and buttons, which ask
//! for it.

use crate::page::damaged;
use crate::simulation::{self, Simulation};
use play::Embedding;
use std::rc::Rc;
use sycamore_reactive::create_root;
use units::Language;
use view::page::everything;
use view::page::opening::{self, Handed, Opening};
use view::panel::{self, Tab};
use view::views::*;
use view::{App, browser, page::header, page::shell, page::texts, page::welcome, panel::tabs, stage};
use web_sys::HtmlElement;

/// Key prefix of the state in which the laboratory left a document.
const STATE: &str = "state:";

/// Shows the simulation of the page in the element `lab`.
pub fn open(opening: Opening) {
    let Some(place) = browser::by_id::<HtmlElement>("lab") else { return };
    let embedding = shell::embedding();
    let language = shell::language(&embedding);
    texts::when_there(texts::PLAYER, language, move || show(place, embedding, language, opening));
}

/// Shows the page, and offers its simulation to the laboratory.
fn show(place: HtmlElement, embedding: Embedding, language: Language, opening: Opening) {
    place.set_inner_html("");
    let opening = Rc::new(opening);
    let mut shown = None;
    let root = create_root(|| {
        let view = || {
            let (app, simulation, runs) = simulation::open(Simulation::of_laboratory(embedding), language);
            // Set here for the first time, so this cannot fail.
            let _ = simulation.app.set(app);
            restore(app, &opening);
            everything::restore(app);
            opening::keep_tab(app);
            shown = runs.then_some((app, simulation));
            let opening = opening.clone();
            shell::view(app, move || if runs { content(app, &opening) } else { damaged(app) })
        };
        sycamore_web::render_in_scope(view, &place);
    });
    let give = shown.map(|(app, simulation)| {
        move || {
            let handed = Handed::of(app);
            opening::end(app);
            place.set_inner_html("");
            root.dispose();
            simulation.play.replace(None);
            handed
        }
    });
    opening.offer(give);
}

/// Restores the state in the address, otherwise that of the last visit.
fn restore(app: App, opening: &Opening) {
    let title = app.read(|play| play.program().title.clone());
    let left = || browser::remembered(&format!("{STATE}{}:{title}", opening.name())).unwrap_or_default();
    let state = Some(opening.state()).filter(|state| !state.is_empty()).unwrap_or_else(left);
    if let Some(refusal) = app.attempt(|play| play.restore(&state)) {
        app.complain(refusal);
    }
}

fn content(app: App, opening: &Rc<Opening>) -> View {
    let ask = |opening: &Rc<Opening>| {
        let opening = opening.clone();
        move || opening.ask("")
    };
    let press = |button: HtmlButton, id: &'static str| {
        let opening = opening.clone();
        button.when(events::click, move |_| opening.ask(id))
    };
    let words = app.words();
    let own = View::from((
        press(header::browse(app), "browse"),
        press(header::publish(app), "share"),
        press(header::everything(app), "everything"),
    ));
    let in_menu = View::from(press(header::open(app), "open"));
    let later = |tab: Tab| tab.waiting(app, ask(opening));
    let tabs = vec![
        Tab::explore(app),
        later(Tab::questions(app)),
        later(Tab::new(tabs::MEASURE, words.tab_measure, View::new)),
        later(Tab::theory(app, View::new)),
        later(Tab::lasting(tabs::WRITE, words.tab_write, View::new)),
        later(Tab::lasting(tabs::CLASS, words.tab_class, View::new)),
    ];
    let panel = panel::view(app, panel::shown(app, tabs));
    let body = main().class("laboratory").child(stage::view(app)).child(panel);
    let asking = opening.clone();
    let line =
        welcome::is_home(opening).then(|| welcome::line(app, welcome::is_first_visit(), move |id| asking.ask(id)));
    View::from((header::view(app, line.map_or_else(View::new, View::from), own, in_menu), body))
}

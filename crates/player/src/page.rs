//! The page: head, stage, and a panel to play, to answer and to read.

use crate::simulation::{self, Simulation};
use crate::{answers, site, source};
use units::Language;
use view::browser::{self, address, fragment, is_heading};
use view::panel::Tab;
use view::views::*;
use view::{App, header, panel, shell, stage};

/// Starts the page in the element `lab`.
pub fn start() {
    let Some(place) = browser::by_id::<web_sys::HtmlElement>("lab") else { return };
    let tag = site::asked_language()
        .or_else(|| browser::remembered("language"))
        .or_else(|| window().navigator().language())
        .unwrap_or_default();
    place.set_inner_html("");
    let page = move || {
        // The page is open as long as the simulation is.
        let simulation: &'static Simulation = Box::leak(Box::default());
        let app = App::new(simulation, Language::of(&tag));
        shell::prepare(app);
        let play = simulation::of_page();
        let runs = play.is_some();
        simulation.play.replace(play);
        app.read(|play| play.set_language(Language::of(&tag).tag()));
        answers::restore(app);
        follow_link(app);
        browser::listen("hashchange", move |_: &web_sys::Event| follow_link(app));
        // It is empty, since it was just made. What is answered from here on is saved.
        let _ = simulation.app.set(app);
        shell::view(app, move || if runs { content(app) } else { damaged(app) })
    };
    sycamore_web::render_to(page, &place);
}

fn content(app: App) -> View {
    let tabs = vec![Tab::play(app), Tab::activities(app), Tab::theory(app, View::new)];
    let panel = panel::view(app, tabs);
    let own = View::from((site::links(app), source::button_of(app)));
    let head = header::view(app, own, move || share(app));
    View::from((head, main().class("laboratory").child(stage::view(app)).child(panel)))
}

/// What is said where the simulation in the page cannot be read.
fn damaged(app: App) -> View {
    main().child(p().class("waiting").role("alert").child(app.words().damaged)).into()
}

/// Shows the state that the address asks for.
fn follow_link(app: App) {
    let fragment = fragment();
    if !is_heading(&fragment)
        && let Some(refusal) = app.attempt(|play| play.restore(&fragment))
    {
        app.complain(refusal);
    }
}

/// Copies a link to what is seen, and says what it does not hold.
fn share(app: App) {
    let words = app.words();
    let (state, missing) = app.read(|play| (play.share(), play.missing_in_link()));
    browser::copy(&address(&state), move |allowed| {
        let copied = if allowed { words.link_copied } else { words.link_not_copied };
        let without = (!missing.is_empty()).then(|| format!(" {}: {}.", words.link_without, missing.join(", ")));
        let sentences = format!("{copied}.{}", without.unwrap_or_default());
        if allowed { app.notify(&sentences) } else { app.complain(sentences) }
    });
}

//! Layout of the page: header, stage, and a panel with the tabs *Explore*, *Questions* and *Theory*.

use crate::simulation::{self, Simulation};
use crate::{answers, class, hand_in, height, site, source, surrounding};
use play::{Embedding, PagePart};
use units::Language;
use view::browser::{self, address, fragment, is_heading};
use view::panel::Tab;
use view::views::*;
use view::{App, page::header, page::shell, page::texts, panel, pieces::icons, stage};
use web_sys::HtmlElement;

/// Starts the page in the element `lab`.
pub fn start() {
    let Some(place) = browser::by_id::<HtmlElement>("lab") else { return };
    let embedding = shell::embedding();
    if embedding.hides(PagePart::Head)
        && let Some(root) = document().document_element()
    {
        let _ = root.set_attribute("data-head", "hidden");
    }
    if embedding.follows_content {
        height::tell();
    }
    let language = shell::language(&embedding);
    texts::when_there(texts::PLAYER, language, move || show(&place, embedding, language));
}

/// Shows the page.
fn show(place: &HtmlElement, embedding: Embedding, language: Language) {
    place.set_inner_html("");
    let page = move || {
        let (app, simulation, runs) = simulation::open(Simulation::new(embedding), language);
        // Answers in this browser may be those of another student of the course.
        if simulation.course.is_none() {
            answers::restore(app);
        }
        follow_link(app);
        if let Some(around) = surrounding::follow(app) {
            // Set here for the first time, so this cannot fail.
            let _ = simulation.surrounding.set(around);
        }
        class::listen(app);
        browser::listen("hashchange", move |_: &web_sys::Event| follow_link(app));
        // Set here for the first time, so this cannot fail. Answers are saved from now on.
        let _ = simulation.app.set(app);
        shell::view(app, move || if runs { content(app, simulation) } else { damaged(app) })
    };
    sycamore_web::render_to(page, place);
}

fn content(app: App, simulation: &'static Simulation) -> View {
    let embedding = app.host().embedding();
    let tabs = panel::shown(app, vec![Tab::explore(app), Tab::questions(app), Tab::theory(app, View::new)]);
    let class = if tabs.is_empty() { "laboratory alone" } else { "laboratory" };
    let body = main().class(class).child(stage::view(app));
    let body = body.maybe((!tabs.is_empty()).then(|| panel::view(app, tabs)));
    let course = simulation.course.as_ref().map_or_else(View::new, |course| course.dialog(app));
    let head = if embedding.hides(PagePart::Head) { hidden_head(app) } else { head(app).into() };
    View::from((head, body, hand_in::dialog(app), course))
}

fn head(app: App) -> HtmlHeader {
    let words = app.words();
    let share = labelled(icons::link(), words.share)
        .id("share")
        .title(words.share_title)
        .when(events::click, move |_| share(app));
    let own = View::from((site::links(app), hand_in::button_of(app), share));
    header::view(app, View::new(), own, source::button_of(app))
}

/// Heading for screen readers if the header is hidden.
fn hidden_head(app: App) -> View {
    tags::header().class("visually-hidden").child(h1().child(view::title(app))).into()
}

/// Message if the simulation in the page cannot be read.
pub fn damaged(app: App) -> View {
    main().child(p().class("waiting").role("alert").child(app.words().damaged)).into()
}

/// Restores the state in the fragment of the address.
fn follow_link(app: App) {
    let fragment = fragment();
    if !is_heading(&fragment)
        && let Some(refusal) = app.attempt(|play| play.restore(&fragment))
    {
        app.complain(refusal);
    }
}

/// Copies a link to the present state and reports what the link does not contain.
fn share(app: App) {
    let words = app.words();
    let (state, missing) = app.read(|play| (play.share(), play::missing_in_link(play)));
    browser::copy(&address(&state), move |allowed| {
        let copied = if allowed { words.link_copied } else { words.link_not_copied };
        let without = (!missing.is_empty()).then(|| format!(" {}: {}.", words.link_without, missing.join(", ")));
        let sentences = format!("{copied}.{}", without.unwrap_or_default());
        if allowed { app.notify(&sentences) } else { app.complain(sentences) }
    });
}

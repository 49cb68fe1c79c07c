//! The whole page: header, stage, panel, and the live region for screen readers.

use crate::app::App;
use crate::{
    class, documents::links, documents::navigation, documents::opening, documents::served, film, fit, header, idle,
    library, library::list as library_list, measuring::drop, panel, publish, verifying,
};
use view::page::opening::{Handed, Opening};
use view::views::*;
use view::{browser, page::everything, page::shell, page::texts, stage};
use web_sys::HtmlElement;

/// Starts the laboratory in the element `lab`.
pub fn start() {
    let Some(place) = browser::by_id::<HtmlElement>("lab") else { return };
    // The documents are read while the player still shows its simulation.
    drop(library::home());
    let Some(opening) = Opening::of_page().filter(Opening::is_offered) else { return open(place) };
    let language = opening.language();
    texts::when_there(texts::LABORATORY, language, move || match opening.take() {
        Some(handed) => take_over(handed, &place),
        None => open(place),
    });
}

/// Opens what the address names.
fn open(place: HtmlElement) {
    let embedding = shell::embedding();
    let language = shell::language(&embedding);
    wasm_bindgen_futures::spawn_local(async move {
        texts::load(texts::LABORATORY, language).await;
        // A link may contain its document, which the browser must inflate.
        let arrival = links::first().await;
        place.set_inner_html("");
        // The laboratory lives as long as the page.
        let laboratory = move || {
            let app = App::new(language, embedding);
            everything::restore(app.page);
            prepare(app);
            opening::arrive(app, arrival);
            page(app)
        };
        sycamore_web::render_to(laboratory, &place);
    });
}

/// Takes the simulation over from the player, within one frame.
fn take_over(mut handed: Handed, place: &HtmlElement) {
    let mut shown = None;
    let laboratory = || {
        let app = App::new(handed.language(), shell::embedding());
        prepare(app);
        opening::take_over(app, &mut handed);
        shown = Some(app);
        page(app)
    };
    sycamore_web::render_to(laboratory, place);
    if let Some(app) = shown {
        handed.finish(app.page);
    }
}

fn prepare(app: App) {
    shell::prepare(app.page);
    app.with(|lab| {
        lab.workers.wake_by(move || fit::go_on(app));
        lab.sweeps.wake_by(move || app.page.wake());
    });
    view::page::opening::keep_tab(app.page);
    opening::save_when_left(app);
    navigation::listen(app);
    drop::listen(app);
    served::follow(app);
    class::listen(app);
    panel::follow(app);
    film::mark_page(app);
    film::follow(app);
    film::follow_story(app);
    fit::follow(app);
}

fn page(app: App) -> View {
    View::from((shell::view(app.page, move || build(app)), drop::view(app), publish::solutions(app)))
}

/// The whole content, for the present document and language.
fn build(app: App) -> View {
    let runs = memo(move || {
        app.changes.program.track();
        app.read(|_| true)
    });
    let stage = move || if runs.get() { stage::view(app.page) } else { idle::stage(app).into() };
    let body = main().class("laboratory").child(changing(stage)).child(panel::view(app));
    View::from((
        header::view(app),
        body,
        library_list::dialog(app),
        publish::dialog(app),
        class::dialogs(app),
        verifying::dialog::dialog(app),
    ))
}

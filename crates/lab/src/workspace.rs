//! The whole page: header, stage, panel, and the live region for screen readers.

use crate::app::App;
use crate::{
    class, documents::links, documents::navigation, documents::opening, documents::served, film, fit, header, idle,
    library, library::list as library_list, measuring::drop, panel, publish, verifying,
};
use view::page::opening::Opening;
use view::views::*;
use view::{browser, page::everything, page::shell, page::texts, stage};
use wasm_bindgen::JsCast;
use web_sys::HtmlElement;

/// Starts the laboratory in the element `lab`.
pub fn start() {
    let Some(place) = browser::by_id::<HtmlElement>("lab") else { return };
    match Opening::of_page().filter(Opening::is_offered) {
        Some(opening) => wasm_bindgen_futures::spawn_local(take_over(opening, place)),
        None => open(place),
    }
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

/// Makes the page of the laboratory part by part, beside what the player shows, and then takes the simulation over in one task.
async fn take_over(opening: Opening, place: HtmlElement) {
    let language = opening.language();
    texts::load(texts::LABORATORY, language).await;
    let turn = async || opening.turn(false).await;
    turn().await;
    // The documents are read while nothing depends on it yet.
    drop(library::home());
    let home = opening::home(language, turn).await;
    turn().await;
    let own: HtmlElement = place.clone_node().map_or_else(|_| place.clone(), JsCast::unchecked_into);
    let mut shown = None;
    let laboratory = || {
        let app = App::new(language, shell::embedding());
        everything::restore(app.page);
        app.build_parts(0);
        home.place(app);
        shown = Some(app);
        page(app)
    };
    sycamore_web::render_to(laboratory, &own);
    let Some(app) = shown else { return };
    for part in 1..=PARTS {
        turn().await;
        app.build_parts(part);
    }
    opening.turn(true).await;
    if opening.language() != language {
        // It was changed meanwhile.
        texts::load(texts::LABORATORY, opening.language()).await;
        opening.turn(true).await;
    }
    let Some(mut handed) = opening.take() else { return };
    let _ = place.replace_with_with_node_1(&own);
    app.page.within(|| prepare(app));
    opening::take_over(app, &mut handed);
    let now = handed.language();
    if now == language {
        handed.finish(app.page);
    } else {
        app.page.set_language(now, move || handed.finish(app.page));
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

/// Number of parts in which the page is built beside another one.
const PARTS: usize = 3;

/// The whole content, for the present document and language.
fn build(app: App) -> View {
    let runs = memo(move || {
        app.changes.program.track();
        app.read(|_| true)
    });
    let stage = move || if runs.get() { stage::view(app.page) } else { idle::stage(app).into() };
    let panel = app.part(1, move || panel::view(app).into());
    let body = main().class("laboratory").child(app.part(0, move || changing(stage))).child(panel);
    let dialogs = move || {
        View::from((
            library_list::dialog(app),
            publish::dialog(app),
            class::dialogs(app),
            verifying::dialog::dialog(app),
        ))
    };
    View::from((header::view(app), body, app.part(2, dialogs)))
}

//! The page as a whole: head, stage, panel, and what is said to those who do not see it.

use crate::app::App;
use crate::links::Arrival;
use crate::theme::Theme;
use crate::views::*;
use crate::{
    browser, diagnostics, drop, frame, header, keys, library, links, messages, opening, panel, presenter, stage,
    visited, worksheet,
};
use units::Language;

/// Starts the laboratory in the element `lab`.
pub fn start() {
    let Some(place) = browser::by_id::<web_sys::HtmlElement>("lab") else { return };
    let tag = browser::remembered("language").or_else(|| window().navigator().language()).unwrap_or_default();
    let single_keys = browser::remembered("keys").is_none();
    wasm_bindgen_futures::spawn_local(async move {
        // A link may hold its document, which the browser inflates.
        let arrival = links::first().await;
        place.set_inner_html("");
        // The laboratory lives as long as the page.
        let laboratory = move || {
            let app = App::new(Language::of(&tag), single_keys);
            prepare(app, arrival);
            page(app)
        };
        sycamore_web::render_to(laboratory, &place);
    });
}

fn prepare(app: App, arrival: Arrival) {
    Theme::remembered().apply(app);
    presenter::remembered(app);
    browser::on_match_change("(prefers-color-scheme: dark)", move || Theme::remembered().apply(app));
    browser::on_match_change(stage::NARROW, move || app.narrow.set(browser::matches(stage::NARROW)));
    frame::start(app);
    opening::arrive(app, arrival);
    opening::save_when_left(app);
    visited::listen(app);
    drop::listen(app);
    worksheet::listen(app);
    keys::listen(app);
}

fn page(app: App) -> View {
    View::from((
        changing(move || {
            app.changes.document.track();
            build(app)
        }),
        p().class("visually-hidden")
            .role("status")
            .attr("aria-live", "polite")
            .id("spoken")
            .child(text(move || app.spoken.get_clone())),
        messages::view(app),
        drop::view(app),
        worksheet::view(app),
    ))
}

/// Everything, for the document and the language as they are.
fn build(app: App) -> View {
    let words = app.words();
    app.with(|lab| lab.stage.clear());
    if let Some(root) = document().document_element() {
        let _ = root.set_attribute("lang", app.language.get_untracked().tag());
    }
    let title = header::title(app);
    document().set_title(&if title == "Meniscus" { title } else { format!("{title} · Meniscus") });
    let runs = app.read(|_| true);
    let body = if runs {
        main().class("laboratory").child(stage::view(app)).child(panel::view(app)).into()
    } else {
        View::from((main().child(diagnostics::view(app)), footer().child(p().child(words.footer))))
    };
    View::from((
        a().class("skip").href("#apparatus").child(words.skip),
        header::view(app),
        body,
        keys::dialog(app),
        library::dialog(app),
    ))
}

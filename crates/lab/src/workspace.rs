//! The page as a whole: head, apparatus, notebook, and what is said to those who do not see it.

use crate::app::App;
use crate::links::Arrival;
use crate::scene::SceneNodes;
use crate::theme::Theme;
use crate::views::*;
use crate::{
    browser, controls, diagnostics, drop, frame, header, keys, library, links, messages, notebook, opening, plots,
    readouts, transport, visited, worksheet,
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
    browser::on_match_change("(prefers-color-scheme: dark)", move || Theme::remembered().apply(app));
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
        View::from((jump(app), main().child(apparatus(app)).child(notebook::view(app))))
    } else {
        main().child(diagnostics::view(app)).into()
    };
    View::from((
        a().class("skip").href("#apparatus").child(words.skip),
        header::view(app),
        body,
        footer().child(p().child(words.footer)),
        keys::dialog(app),
        library::dialog(app),
    ))
}

/// On a small screen everything stands in one column: the way to its parts.
fn jump(app: App) -> HtmlNav {
    let words = app.words();
    let links = [
        ("#scene", words.scene),
        ("#plots", words.plots),
        ("#controls", words.controls),
        ("#readouts", words.readouts),
        ("#notebook", words.notebook),
    ];
    let link = |(place, name): (&'static str, &'static str)| a().href(place).child(name);
    nav().class("jump").attr("aria-label", words.jump).each(links, link)
}

fn apparatus(app: App) -> HtmlSection {
    let words = app.words();
    section()
        .class("apparatus")
        .id("apparatus")
        .tabindex("-1")
        .attr("aria-label", words.apparatus)
        .child(scene(app))
        .child(transport::view(app))
        .child(plots::view(app))
        .child(controls::view(app))
        .child(readouts::view(app))
}

fn scene(app: App) -> HtmlSection {
    let words = app.words();
    let mut place = div().class("drawing");
    let language = app.language.get_untracked().tag();
    let scene = app.read(|session| session.document().program.scene(language).cloned());
    let (exists, draggable) = (scene.is_some(), scene.as_ref().is_some_and(|scene| has_handle(&scene.root)));
    if let Some(scene) = &scene {
        let nodes = SceneNodes::build(app, scene, &place.node(), words.scene);
        app.with(|lab| lab.stage.scene = nodes);
        frame::wake(app);
    }
    part("scene", "scene card", words.scene)
        .child(place)
        .child(changing(move || outline_legend(app)))
        .maybe(draggable.then(|| drag_hint(app)))
        .maybe((!exists).then(|| p().class("empty").child(words.no_scene)))
}

/// What the dashed outline in the scene is; nothing while there is none.
fn outline_legend(app: App) -> View {
    app.changes.records.track();
    let records = app.read(|session| session.ghost_records());
    if records.is_empty() {
        return View::new();
    }
    let sample = span().class("outline-sample").attr("aria-hidden", "true");
    p().class("note scene-legend")
        .child(sample)
        .child(format!("{}: {}", app.words().outline, records.join(", ")))
        .into()
}

/// How to drag, for the device in hand: who has no keyboard does not read of keys.
fn drag_hint(app: App) -> HtmlP {
    let words = app.words();
    let keys = span().class("for-keys").child(words.drag_hint);
    note(keys).child(span().class("for-touch").child(words.drag_hint_touch))
}

fn has_handle(element: &program::Element) -> bool {
    element.drag.is_some()
        || element.children.iter().any(|child| matches!(child, program::Child::Element(child) if has_handle(child)))
}

//! The page as a whole: head, apparatus, notebook, and what is said to those who do not see it.

use crate::app::App;
use crate::scene::SceneNodes;
use crate::theme::Theme;
use crate::words::Language;
use crate::{
    browser, controls, diagnostics, frame, header, keys, library, notebook, opening, plots, readouts, transport,
};
use leptos::html;
use leptos::prelude::*;

/// Starts the laboratory in the element `lab`.
pub fn start() {
    let Some(place) = browser::by_id::<web_sys::HtmlElement>("lab") else { return };
    place.set_inner_html("");
    let tag = browser::remembered("language").or_else(|| window().navigator().language()).unwrap_or_default();
    let single_keys = browser::remembered("keys").is_none();
    // The laboratory lives as long as the page.
    mount_to(place, move || {
        let app = App::new(Language::of(&tag), single_keys);
        prepare(app);
        page(app)
    })
    .forget();
}

fn prepare(app: App) {
    Theme::remembered().apply(app);
    browser::on_match_change("(prefers-color-scheme: dark)", move || Theme::remembered().apply(app));
    frame::start(app);
    opening::open_embedded(app);
    opening::remember_state(app);
    opening::accept_drops(app);
    keys::listen(app);
}

fn page(app: App) -> impl IntoView {
    view! {
        {move || {
            app.changes.document.track();
            build(app)
        }}
        <p class="visually-hidden" role="status" aria-live="polite" id="spoken">{move || app.spoken.get()}</p>
    }
}

/// Everything, for the document and the language as they are.
fn build(app: App) -> impl IntoView {
    let words = app.words();
    app.with(|lab| lab.stage.clear());
    if let Some(root) = document().document_element() {
        let _ = root.set_attribute("lang", app.language.get_untracked().tag());
    }
    let title = header::title(app);
    document().set_title(&if title == "Meniscus" { title } else { format!("{title} · Meniscus") });
    let runs = app.read(|_| true);
    let body = if runs {
        view! {
            {jump(app)}
            <main>
                {apparatus(app)}
                {notebook::view(app)}
            </main>
        }
        .into_any()
    } else {
        view! { <main>{diagnostics::view(app)}</main> }.into_any()
    };
    view! {
        <a class="skip" href="#apparatus">{words.skip}</a>
        {header::view(app)}
        {body}
        <footer><p>{words.footer}</p></footer>
        {keys::dialog(app)}
        {library::dialog(app)}
    }
}

/// On a small screen everything stands in one column: the way to its parts.
fn jump(app: App) -> impl IntoView {
    let words = app.words();
    let links = [
        ("#scene", words.scene),
        ("#plots", words.plots),
        ("#controls", words.controls),
        ("#readouts", words.readouts),
        ("#notebook", words.notebook),
    ]
    .into_iter()
    .map(|(place, name)| view! { <a href=place>{name}</a> })
    .collect_view();
    view! { <nav class="jump" aria-label=words.jump>{links}</nav> }
}

fn apparatus(app: App) -> impl IntoView {
    let words = app.words();
    view! {
        <section class="apparatus" id="apparatus" tabindex="-1" aria-label=words.apparatus>
            {scene(app)}
            {transport::view(app)}
            {plots::view(app)}
            {controls::view(app)}
            {readouts::view(app)}
        </section>
    }
}

fn scene(app: App) -> impl IntoView {
    let words = app.words();
    let place = NodeRef::<html::Div>::new();
    let language = app.language.get_untracked().tag();
    let scene = app.read(|session| session.document().scene(language).cloned());
    let (exists, draggable) = (scene.is_some(), scene.as_ref().is_some_and(|scene| has_handle(&scene.root)));
    place.on_load(move |place| {
        if let Some(scene) = &scene {
            let nodes = SceneNodes::build(app, scene, &place, words.scene);
            app.with(|lab| lab.stage.scene = nodes);
            frame::wake(app);
        }
    });
    view! {
        <section class="scene card" id="scene" aria-labelledby="scene-title">
            <h2 id="scene-title" class="visually-hidden">{words.scene}</h2>
            <div class="drawing" node_ref=place></div>
            {draggable.then(|| view! { <p class="note">{words.drag_hint}</p> })}
            {(!exists).then(|| view! { <p class="empty">{words.no_scene}</p> })}
        </section>
    }
}

fn has_handle(element: &document::Element) -> bool {
    element.drag.is_some()
        || element.children.iter().any(|child| matches!(child, document::Child::Element(child) if has_handle(child)))
}

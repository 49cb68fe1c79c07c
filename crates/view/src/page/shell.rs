//! Parts common to all pages: colours, keys, the worksheet for printing, and the live region for screen readers.

use crate::app::{App, title};
use crate::page::theme::Theme;
use crate::views::*;
use crate::{browser, frame, page::keys, page::messages, page::projector, panel::worksheet, stage};
use play::Embedding;
use units::Language;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{Event, HtmlElement, Node};

/// Attribute of the root with the options of a page that has no address of its own: the text of a frame.
const OPTIONS: &str = "data-options";

/// Options of the page: those of its address, or of a page without one.
pub fn embedding() -> Embedding {
    Embedding::read(&options().unwrap_or_else(|| window().location().search().unwrap_or_default()))
}

/// Options of a page without an address.
fn options() -> Option<String> {
    document().document_element()?.get_attribute(OPTIONS)
}

/// Language of the page: the one in its address, otherwise the one chosen at an earlier visit, otherwise that of the browser. The
/// language in the address is treated like a choice with the language switch. If the browser stores it, it is removed from the
/// address, so that a later choice survives a reload.
pub fn language(embedding: &Embedding) -> Language {
    if let Some(language) = embedding.language {
        // Other pages of the site around it, whose store it has, are not concerned.
        if options().is_some() {
            return language;
        }
        let location = window().location();
        let query = location.search().unwrap_or_default();
        let fields = query.trim_start_matches('?').split('&').filter(|field| !field.starts_with("language="));
        let fields: Vec<&str> = fields.filter(|field| !field.is_empty()).collect();
        if browser::remember("language", language.tag())
            && let (Ok(path), Ok(history)) = (location.pathname(), window().history())
        {
            let query = if fields.is_empty() { String::new() } else { format!("?{}", fields.join("&")) };
            let address = format!("{path}{query}{}", location.hash().unwrap_or_default());
            let _ = history.replace_state_with_url(&JsValue::NULL, "", Some(&address));
        }
        return language;
    }
    let tag = browser::remembered("language").or_else(|| window().navigator().language()).unwrap_or_default();
    Language::of(&tag)
}

/// Installs the listeners for the whole page.
pub fn prepare(app: App) {
    Theme::remembered().apply(app);
    projector::follow(app);
    browser::on_match_change("(prefers-color-scheme: dark)", move || Theme::remembered().apply(app));
    browser::on_match_change(stage::NARROW, move || app.narrow.set(browser::matches(stage::NARROW)));
    browser::listen("pointerdown", close_menus);
    frame::start(app);
    worksheet::listen(app);
    keys::listen(app);
}

/// Closes an open menu by a press outside of it. Some browsers give a pressed button no focus, so that a menu cannot be left.
fn close_menus(event: &Event) {
    let pressed: Option<Node> = event.target().and_then(|target| target.dyn_into().ok());
    let open = document()
        .query_selector(".head-menu-place > [aria-expanded=true], .tools > [aria-expanded=true]")
        .ok()
        .flatten();
    if let Some(button) = open.and_then(|button| button.dyn_into::<HtmlElement>().ok())
        && !button.parent_element().is_some_and(|menu| menu.contains(pressed.as_ref()))
    {
        button.click();
    }
}

/// The page. Its content is rebuilt for another document or language.
pub fn view(app: App, mut content: impl FnMut() -> View + 'static) -> View {
    let build = move || {
        app.changes.document.track();
        app.nodes(|nodes| nodes.clear());
        if let Some(root) = document().document_element() {
            let _ = root.set_attribute("lang", app.language.get_untracked().tag());
        }
        let skip = |place, words: &'static str| a().class("skip").href(place).child(words);
        let words = app.words();
        let skips = (skip("#apparatus", words.skip), skip("#panel", words.skip_to_panel));
        // A landmark: a class server puts its line, with links, before it.
        let skips = nav().attr("aria-label", words.skip_links).child(skips.0).child(skips.1);
        View::from((skips, content(), keys::dialog(app)))
    };
    effect(move || {
        app.changes.document.track();
        app.changes.program.track();
        let title = title(app);
        document().set_title(&if title == "Meniscus" { title } else { format!("{title} · Meniscus") });
    });
    View::from((
        changing(build),
        p().class("visually-hidden")
            .role("status")
            .attr("aria-live", "polite")
            .id("spoken")
            .child(text(move || app.spoken.get_clone())),
        messages::view(app),
        worksheet::view(app),
    ))
}

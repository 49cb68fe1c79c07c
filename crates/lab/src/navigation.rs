//! Follows the browser's history, and links to other states of this page.

use crate::app::App;
use crate::{links, opening, saved, visited};
use view::browser;
use web_sys::Event;

/// Follows the history, and links to other states of this page.
pub fn listen(app: App) {
    browser::listen("popstate", move |_: &Event| {
        if let Some(before) = visited::present().filter(|before| before.sources != visited::sources(app)) {
            // The step has changed already: what is typed in this moment is not noted in it.
            saved::now(app);
            opening::open(app, before.sources, "");
        }
    });
    browser::listen("hashchange", move |_: &Event| {
        if visited::present().is_some() {
            // Back or forward: the document is open already.
            return;
        }
        let fragment = browser::fragment();
        if browser::is_heading(&fragment) {
            return visited::note(app, None);
        }
        wasm_bindgen_futures::spawn_local(async move {
            let arrival = links::read(&fragment).await;
            opening::arrive(app, arrival);
        });
    });
}

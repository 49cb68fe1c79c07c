//! Reacts to the browser history and to links to other states of this page.

use crate::app::App;
use crate::{documents::links, documents::opening, documents::saved, documents::visited};
use view::browser;
use web_sys::Event;

/// Installs the listeners for the history and for changes of the fragment.
pub fn listen(app: App) {
    browser::listen("popstate", move |_: &Event| {
        if let Some(before) = visited::present().filter(|before| before.sources != visited::sources(app)) {
            // The history entry has already changed: text typed just now is not stored in it.
            saved::now(app);
            opening::open(app, before.sources, "");
        }
    });
    browser::listen("hashchange", move |_: &Event| {
        if visited::present().is_some() {
            // Back or forward: the document is already open.
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

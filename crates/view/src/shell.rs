//! Parts common to all pages: colours, keys, the worksheet for printing, and the live region for screen readers.

use crate::app::{App, title};
use crate::theme::Theme;
use crate::views::*;
use crate::{browser, frame, keys, messages, projector, stage, worksheet};

/// Installs the listeners for the whole page.
pub fn prepare(app: App) {
    Theme::remembered().apply(app);
    projector::follow(app);
    browser::on_match_change("(prefers-color-scheme: dark)", move || Theme::remembered().apply(app));
    browser::on_match_change(stage::NARROW, move || app.narrow.set(browser::matches(stage::NARROW)));
    frame::start(app);
    worksheet::listen(app);
    keys::listen(app);
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
        View::from((skips.0, skips.1, content(), keys::dialog(app)))
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

//! The tab *Write*: the texts of the open document in an editor, their diagnostics, and new documents.
//!
//! `crates/lab/editor` has CodeMirror and what it needs of Meniscus: colours and proposals; its texts come from the
//! catalogues. xtask bundles it with esbuild. The bundle stands in the page deflated (`document::page::EDITOR`) and is
//! inflated and started when the tab is first opened; in a site it is a file of its own, because pages there run no script of
//! their own. CodeMirror adds its styles as `<style>` elements, which the policy of both allows.
//!
//! The editor counts places in UTF-16 and knows no meaning. Each text goes to `Desk::write`: at each key where the last check
//! took no more than 100 ms, and otherwise when its writer has rested for 150 ms. Marks and proposals come back. `panels.rs`
//! has the forms in which the document is written besides: `model`, `view`, `questions`, `translation.rs`. All of them change
//! the texts through the editor (`typing.rs`), also one that it does not show, so that its history takes everything back; the
//! editor's text is the only one, and each view is read from it again. Views are built for the shape of the model and stay
//! while a statement is typed, whatever it becomes on the way.
//!
//! `insight.rs` explains what is under the cursor. What was written is in the step of the history (`documents/visited.rs`),
//! with its draft where that does not run, and in the storage (`kept.rs`), where a document that another page has changed
//! meanwhile is kept beside this one. `versions.rs` makes versions of the text before changes.

mod briefs;
mod changes;
mod draft;
mod editor;
mod fields;
mod findings;
mod imported;
mod insight;
pub mod kept;
mod layout;
mod model;
mod panel;
mod panels;
mod phrases;
mod questions;
mod times;
mod toolbar;
mod tools;
mod translation;
mod typing;
mod unfolded;
mod version_list;
mod versions;
mod view;

pub use changes::{follow_file, restore};
pub use draft::{flush, resume};
pub use editor::Editor;
pub use findings::{FINDINGS, summary};
pub use panel::Panel;
pub use times::time_text;

use crate::app::App;
use ::view::views::*;
use units::Language;
use web_sys::Element;

/// Content of the tab.
pub fn view(app: App) -> View {
    changes::begin(app);
    let mut place = div().class("editor-place");
    let node: Element = place.node();
    let waiting = create_signal(true);
    let wait = move || if waiting.get() { note(app.words().editor_waiting).into() } else { View::new() };
    wasm_bindgen_futures::spawn_local(async move {
        let shown = show(app, &node).await;
        // The tab may have been rebuilt in another language meanwhile.
        if waiting.is_alive() {
            waiting.set(false);
        }
        if shown.is_none() {
            app.complain(app.words().editor_missing.to_owned());
        }
    });
    let text = panels::body(app, Panel::Text)
        .child(p().id("editor-keys").hidden(true).child(app.words().editor_keys))
        .child(place.child(changing(wait)));
    let built = move |panel: Panel, content: fn(App) -> View| {
        let shown = memo(move || !waiting.get() && app.writing_panel.get() == panel);
        let content = move || View::from((content(app), panels::way_back(app, panel)));
        panels::body(app, panel).child(changing(move || if shown.get() { content() } else { View::new() }))
    };
    div()
        .class("writing")
        .child(tools::view(app))
        .child(panels::tabs(app))
        .child(text)
        .child(built(Panel::Model, model::view))
        .child(built(Panel::View, view::view))
        .child(built(Panel::Questions, questions::view))
        .child(built(Panel::Translation, translation::view))
        .child(insight::view(app))
        .child(
            div()
                .class("writing-foot")
                .when(events::mousedown, |event| tools::keep_focus(&event))
                .child(findings::status(app))
                .child(findings::lead(app))
                .child(layout::view(app)),
        )
        .child(findings::view(app))
        .child(imported::view(app))
        .into()
}

/// Index of the text in a language; 0, the document itself, if there is none.
fn in_language(texts: &[String], language: Language) -> usize {
    texts.iter().position(|text| document::card(text).language == language.tag()).unwrap_or(0)
}

/// Inserts the editor into its place; starts it on first use.
async fn show(app: App, place: &Element) -> Option<()> {
    let started = app.with(|lab| lab.editor.clone()).flatten();
    let editor = match started {
        Some(editor) => editor,
        None => {
            let propose = move |text: String, place| {
                (app.read_desk(|desk| desk::propose(&text, desk.play().program(), place)), app.language.get_untracked())
            };
            let written = move |file, text| changes::written(app, file, text);
            let started = Editor::start(written, propose, move |text, place| insight::look(app, &text, place)).await?;
            // The tab may have been built twice while the script was loading.
            app.with(|lab| lab.editor.get_or_insert(started).clone())?
        }
    };
    if !app.with(|lab| std::mem::replace(&mut lab.editor_is_current, true))? {
        let texts = app.read_writing(|writing| writing.texts().to_vec());
        let file = in_language(&texts, app.language.get_untracked());
        app.written_file.set(file);
        editor.open(&texts);
        if file > 0 {
            editor.select(file);
        }
        app.typed.update(|count| *count += 1);
    }
    editor.mount(place);
    editor.speak(app.words().editor_label, app.language.get_untracked());
    findings::mark(app);
    if app.with(|lab| std::mem::take(&mut lab.focuses_editor))? {
        editor.focus();
    }
    Some(())
}

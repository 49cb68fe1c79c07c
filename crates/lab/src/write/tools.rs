//! Tools above the editor: choice of the file, new documents, saving.

use super::draft::flush;
use super::unfolded::Unfolded;
use super::{kept, toolbar, version_list};
use crate::app::App;
use crate::{documents::opening, documents::visited};
use document::page::Source;
use document::{TEMPLATES, Template};
use view::browser;
use view::views::*;
use wasm_bindgen::JsCast;
use web_sys::{Element, KeyboardEvent, MouseEvent};

/// The tools.
pub fn view(app: App) -> HtmlDiv {
    let words = app.words();
    let unfolded = create_signal(None::<Unfolded>);
    let save = button()
        .class("quiet outlined")
        .id("save-writing")
        .title(words.save_writing_title)
        .when(events::click, move |_| save(app))
        .child(words.save_writing);
    let language = app.language.get_untracked();
    let template = move |template: &Template| {
        let template = *template;
        let name = if template.is_empty() { words.new_empty.to_owned() } else { template.title(language) };
        button().class("chip").when(events::click, move |_| begin_with(app, template)).child(name)
    };
    let chips =
        div().class("chips").role("group").attr("aria-label", words.new_document_from).each(&TEMPLATES, template);
    let choosing = move || unfolded.get() == Some(Unfolded::New);
    let new = Unfolded::New.button(unfolded, "templates", words.new_document);
    let kept = move || {
        let documents = if choosing() { kept::documents(app.language.get_untracked().tag()) } else { Vec::new() };
        let document = |document: kept::Document| {
            let mut kept = Some(document.kept);
            let open = move |_| kept.take().into_iter().for_each(|kept| opening::open_kept(app, kept));
            button().class("chip").when(events::click, open).child(document.title)
        };
        let chips = |documents: Vec<kept::Document>| {
            div().class("chips").role("group").attr("aria-label", words.kept_documents).each(documents, document)
        };
        if documents.is_empty() { View::new() } else { View::from((note(words.kept_documents), chips(documents))) }
    };
    let (versions, version_list) = version_list::view(app, unfolded);
    let templates = div().class("templates").id("templates").hidden(move || !choosing());
    // Escape closes the open section; the focus returns to its button.
    let fold = move |event: KeyboardEvent| {
        if let Some(open) = unfolded.get_untracked().filter(|_| event.key() == "Escape") {
            event.prevent_default();
            unfolded.set(None);
            browser::focus(open.id());
        }
    };
    div()
        .class("writing-tools")
        .when(events::keydown, fold)
        .when(events::mousedown, |event| keep_focus(&event))
        .child(toolbar::view(
            words.writing_tools,
            [(Unfolded::New.id(), new), ("save-writing", save), (Unfolded::Versions.id(), versions)],
        ))
        .maybe(file_choice(app))
        .child(templates.child(note(words.new_document_from)).child(chips).child(changing(kept)))
        .child(version_list)
}

/// Keeps the focus in the text when a button is pressed. On a phone, losing the focus changes the layout, and the
/// button would move before the finger is lifted.
pub fn keep_focus(event: &MouseEvent) {
    let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
    if target.is_some_and(|target| target.closest("button").ok().flatten().is_some()) {
        event.prevent_default();
    }
}

/// Choice of the file shown; `None` if there is only one.
fn file_choice(app: App) -> Option<HtmlSelect> {
    let names: Vec<String> = visited::sources(app).into_iter().map(|source| source.name).collect();
    if names.len() < 2 {
        return None;
    }
    let option = |(number, name): (usize, String)| {
        let selected = move || app.written_file.get() == number;
        option().value(number.to_string()).prop("selected", selected).child(name)
    };
    let choose = move |event| {
        let Ok(file) = value_of(&event).parse::<usize>() else { return };
        let Some(editor) = app.with(|lab| lab.editor.clone()).flatten() else { return };
        editor.select(file);
        app.written_file.set(file);
        super::findings::mark(app);
    };
    let select = select().id("writing-file").attr("aria-label", app.words().writing_file).when(events::change, choose);
    Some(select.each(names.into_iter().enumerate(), option))
}

/// Opens a template as a document of the user's own.
fn begin_with(app: App, template: Template) {
    let text = template.text(app.language.get_untracked()).to_owned();
    flush(app);
    app.with(|lab| lab.focuses_editor = true);
    opening::open_sources(app, vec![Source { name: format!("{}.md", template.name), text }]);
}

/// Saves the file shown, with its text in the editor.
fn save(app: App) {
    flush(app);
    if let Some(file) = visited::files(app).get(app.written_file.get_untracked()) {
        browser::save_text(&file.name, "text/markdown", &file.text);
    }
}

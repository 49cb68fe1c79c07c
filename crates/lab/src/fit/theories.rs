//! Selection of the theory: in the strip by its title, in the panel with its equation. Selecting a theory opens it; the page
//! keeps its scroll position.

use crate::app::App;
use crate::{documents::opening, library};
use document::Document;
use view::browser;
use view::views::*;

/// A theory in the list.
#[derive(Clone, PartialEq)]
struct Theory {
    /// File name; `None` for an open document that is not in the library.
    file: Option<String>,
    title: String,
    chosen: bool,
}

/// List of the titles.
pub fn choice(app: App) -> HtmlSelect {
    let theories = theories(app);
    let titles: Vec<String> = theories.iter().map(|theory| theory.title.clone()).collect();
    let open = titles.first().cloned().unwrap_or_default();
    let choose = move |event| {
        let title = value_of(&event);
        if let Some(theory) = theories.iter().find(|theory| theory.title == title) {
            theory.choose(app, "fit-theory");
        }
    };
    // Nothing is preselected while the open document cannot hold the record.
    let objection = move || app.fit.objection().is_some();
    let none = option().value("").disabled(true).hidden(move || !objection()).child(app.words().fit_choose_theory);
    select()
        .id("fit-theory")
        .when(events::change, choose)
        .child(none)
        .each(titles, |title| option().value(title.clone()).child(title))
        .prop("value", move || if objection() { String::new() } else { open.clone() })
}

/// List of the theories with their equations.
pub fn view(app: App) -> View {
    let chips = theories(app).into_iter().enumerate();
    let list = div().class("theories").role("group").attr("aria-label", app.words().fit_theory);
    let list = list.each(chips, |(number, theory)| chip(app, number, theory));
    write_equations(app);
    list.into()
}

impl Theory {
    /// Opens the theory; the focus goes to the element `focus`. The open one is chosen in spite of what speaks against it.
    fn choose(&self, app: App, focus: &str) {
        if self.chosen {
            app.fit.insists.set(true);
        } else if let Some(files) = self.file.as_deref().and_then(library::find) {
            opening::change_theory(app, files);
            browser::focus_later(focus.to_owned());
        }
    }
}

fn theories(app: App) -> Vec<Theory> {
    let language = app.language.get_untracked().tag();
    let open = app.with(|lab| lab.sources.clone()).unwrap_or_default();
    let mut theories: Vec<Theory> = Vec::new();
    for entry in library::theories() {
        let (file, title, chosen) = (entry.file().to_owned(), entry.title(language), entry.files == open);
        theories.push(Theory { file: Some(file), title, chosen });
    }
    // The open document comes first, whether the page carries it or not.
    match theories.iter().position(|theory| theory.chosen) {
        Some(place) => theories.get_mut(..=place).into_iter().for_each(|before| before.rotate_right(1)),
        None => theories.insert(0, Theory { file: None, title: view::title(app.page), chosen: true }),
    }
    theories
}

fn chip(app: App, number: usize, theory: Theory) -> HtmlButton {
    let equation = match &theory.file {
        Some(file) => {
            let file = file.clone();
            let written = memo(move || app.equations.with(|known| known.get(&file).cloned().unwrap_or_default()));
            changing(move || span().class("equation").inner_html(written.get_clone()))
        }
        None => span().class("equation").inner_html(app.read_desk(|desk| equation(desk.document()))).into(),
    };
    let (chosen, title) = (theory.chosen, theory.title.clone());
    button()
        .class("theory-chip")
        .id(format!("theory-{number}"))
        .attr("aria-pressed", move || (chosen && app.fit.objection().is_none()).to_string())
        .when(events::click, move |_| theory.choose(app, "theory-0"))
        .child(span().class("name").child(title))
        .child(equation)
}

/// First equation of motion (second order) of a document, otherwise its first equation.
fn equation(document: &Document) -> String {
    let lines = document.program.editions.first().map_or(&[][..], |edition| &edition.equations);
    let motion = lines.iter().find(|line| line.contains("<mo>″</mo>"));
    motion.or(lines.first()).cloned().unwrap_or_default()
}

/// Reads the equations of all theories once, one after the other, yielding to the browser in between.
fn write_equations(app: App) {
    if app.with(|lab| std::mem::replace(&mut lab.reads_equations, true)).unwrap_or(true) {
        return;
    }
    wasm_bindgen_futures::spawn_local(async move {
        for entry in library::theories() {
            browser::breathe().await;
            if let Some(document) = entry.open() {
                app.equations.update(|known| drop(known.insert(entry.file().to_owned(), equation(&document))));
            }
        }
    });
}

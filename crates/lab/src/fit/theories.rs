//! Selection of the theory, each shown with its equation. Selecting a theory opens it; the page keeps its scroll
//! position.

use crate::app::App;
use crate::{documents::opening, library};
use desk::{PeriodComparison, PeriodQuestion};
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

/// Choice of the open document as the theory of the next fit. One that cannot hold the record is not preselected.
#[derive(Clone, Copy)]
pub struct Suitability {
    /// Question that was asked last.
    asked: Signal<Option<PeriodQuestion>>,
    /// True while its answer is being computed.
    waits: Signal<bool>,
    /// Reason why the open document cannot hold the record, if any: the last answer.
    reason: Signal<Option<String>>,
    /// True if the user has chosen the open document in spite of the reason.
    insists: Signal<bool>,
}

impl Suitability {
    /// Suitability of the open document for the chosen record.
    pub fn new(app: App) -> Self {
        let suitability = Self {
            asked: create_signal(None),
            waits: create_signal(false),
            reason: create_signal(None),
            insists: create_signal(false),
        };
        effect(move || {
            app.records.track();
            app.fits.track();
            suitability.ask(app);
        });
        suitability
    }

    /// Asks again if anything has changed on which the answer depends.
    fn ask(self, app: App) {
        let question = app.read_desk(|desk| desk.fits().period_question(desk.revision()));
        if self.asked.with_untracked(|asked| *asked == question) {
            return;
        }
        self.asked.set(question.clone());
        let comparison = question.and_then(|question| app.read_desk(|desk| desk.fits().compare_periods(question)));
        self.waits.set(comparison.is_some());
        match comparison {
            Some(comparison) => wasm_bindgen_futures::spawn_local(self.compute(app, comparison)),
            None => self.answer(None),
        }
    }

    /// Computes the answer, one period in each task of the browser, unless something else is asked meanwhile.
    async fn compute(self, app: App, mut comparison: PeriodComparison) {
        loop {
            browser::breathe().await;
            let is_asked = |asked: &Option<PeriodQuestion>| asked.as_ref() == Some(comparison.question());
            if !self.asked.is_alive() || !self.asked.with_untracked(is_asked) {
                return;
            }
            if comparison.advance() {
                break;
            }
        }
        self.waits.set(false);
        self.answer(app.read_desk(|desk| desk.fits().cannot_hold(&comparison)));
    }

    fn answer(self, reason: Option<String>) {
        if self.reason.with_untracked(|before| *before != reason) {
            self.reason.set(reason);
        }
    }

    /// Waits for the answer. Returns false if the views are gone meanwhile.
    pub async fn known(self) -> bool {
        while self.waits.is_alive() && self.waits.get_untracked() {
            browser::breathe().await;
        }
        self.waits.is_alive()
    }

    /// Reason why the open document is not the theory of the next fit, if any.
    pub fn objection(self) -> Option<String> {
        if self.insists.get() { None } else { self.reason.get_clone() }
    }
}

/// List of the theories.
pub fn view(app: App, suitability: Suitability) -> View {
    let words = app.words();
    let chips = theories(app).into_iter().enumerate();
    let list = div().class("theories").role("group").attr("aria-label", words.fit_theory);
    let list = list.each(chips, |(number, theory)| chip(app, number, theory, suitability));
    write_equations(app);
    let objection = changing(move || match suitability.objection() {
        Some(reason) => note(reason).id("unsuitable").into(),
        None => View::new(),
    });
    View::from((list, objection))
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

fn chip(app: App, number: usize, theory: Theory, suitability: Suitability) -> HtmlButton {
    let Theory { file, title, chosen } = theory;
    let id = format!("theory-{number}");
    let equation = match &file {
        Some(file) => {
            let file = file.clone();
            let written = memo(move || app.equations.with(|known| known.get(&file).cloned().unwrap_or_default()));
            changing(move || span().class("equation").inner_html(written.get_clone()))
        }
        None => span().class("equation").inner_html(app.read_desk(|desk| equation(desk.document()))).into(),
    };
    let choose = move |_| {
        if chosen {
            suitability.insists.set(true);
        }
        if let Some(files) = file.as_deref().and_then(library::find)
            && !chosen
        {
            opening::change_theory(app, files);
            browser::focus_later("theory-0".to_owned());
        }
    };
    button()
        .class("theory-chip")
        .id(id)
        .attr("aria-pressed", move || (chosen && suitability.objection().is_none()).to_string())
        .when(events::click, choose)
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

//! Options in an address, for frames and for links of a teacher: parts that are shown, fixed values, language.

use super::words::{self, Words};
use crate::app::App;
use play::{Embedding, PagePart};
use units::Language;
use units::order::sort_by_key;
use view::browser;
use view::views::*;

/// Options that are being chosen. The ids of their controls begin with `id`.
#[derive(Clone, Copy)]
pub struct Options {
    app: App,
    id: &'static str,
    /// The chosen options.
    pub chosen: Signal<Embedding>,
}

impl Options {
    /// Options with which everything is shown.
    pub fn new(app: App, id: &'static str) -> Self {
        Self { app, id, chosen: create_signal(Embedding::default()) }
    }

    /// A check box for each of these parts.
    pub fn parts(self, parts: impl IntoIterator<Item = PagePart>) -> HtmlFieldset {
        let words = words::of(self.app);
        let tick = |part: PagePart| {
            let show = move |shown: bool| {
                self.chosen.update(|chosen| {
                    chosen.hidden.retain(|other| *other != part);
                    if !shown {
                        chosen.hidden.push(part);
                        sort_by_key(&mut chosen.hidden, |part| PagePart::ALL.iter().position(|other| other == part));
                    }
                });
            };
            switch(tick(format!("{}-{}", self.id, part.name()), true, show), name(words, part))
        };
        fieldset().class("ticks").child(legend().child(words.frame_shown)).each(parts, tick)
    }

    /// Check box that fixes the values.
    pub fn locked(self) -> HtmlLabel {
        let lock = move |on| self.chosen.update(|chosen| chosen.locked = on);
        switch(tick(format!("{}-locked", self.id), false, lock), words::of(self.app).frame_locked)
    }

    /// Choice of a language of the document.
    pub fn language(self) -> HtmlLabel {
        let words = words::of(self.app);
        let known: Vec<String> = self.app.read(|play| play.program().languages().map(str::to_owned).collect());
        let offered = Language::ALL.into_iter().filter(|language| known.iter().any(|tag| tag == language.tag()));
        let choose = move |event| {
            let tag = value_of(&event);
            let language = Language::ALL.into_iter().find(|language| language.tag() == tag);
            self.chosen.update(|chosen| chosen.language = language);
        };
        let select = select()
            .id(format!("{}-language", self.id))
            .when(events::change, choose)
            .child(option().value("").child(words.frame_any_language))
            .each(offered, |language| option().value(language.tag()).child(language.name()));
        label().class("field").child(span().child(words.frame_language)).child(select)
    }

    /// The present code or address under the name `called`, with a button that copies it.
    pub fn result(self, code: ReadSignal<String>, called: &'static str, copy_title: &'static str) -> View {
        let words = words::of(self.app);
        let copied = create_signal(None::<&'static str>);
        let copy = move |_| {
            browser::copy(&code.get_clone_untracked(), move |allowed| {
                // The dialog may have been closed meanwhile.
                if copied.is_alive() {
                    copied.set(Some(if allowed { words.frame_copied } else { words.frame_not_copied }));
                }
            });
        };
        let shown = pre().class("code").id(format!("{}-code", self.id)).role("region").tabindex("0");
        let shown = shown.attr("aria-label", called).child(text(move || code.get_clone()));
        let said = span().class("note").role("status").child(text(move || copied.get().unwrap_or_default().to_owned()));
        let copy = button().class("action").id(format!("copy-{}", self.id)).when(events::click, copy).child(copy_title);
        View::from((shown, div().class("ways").child(copy).child(said)))
    }
}

fn name(words: &Words, part: PagePart) -> &'static str {
    match part {
        PagePart::Head => words.part_head,
        PagePart::Scene => words.part_scene,
        PagePart::Plots => words.part_plots,
        PagePart::Parameters => words.part_parameters,
        PagePart::Values => words.part_values,
        PagePart::Activities => words.part_activities,
        PagePart::Measure => words.part_measure,
        PagePart::Text => words.part_text,
    }
}

//! Text of the document, for reading, copying and saving.

use crate::app::App;
use crate::documents::diagnostics;
use document::page::Source;
use view::views::*;
use view::{browser, panel::reading};

/// The text, initially folded.
pub fn view(app: App) -> View {
    let words = app.words();
    let fold = details().class("card fold").id("source").child(summary().child(h3().child(words.source)));
    fold.child(source(app)).into()
}

/// The text of each file.
fn source(app: App) -> HtmlDiv {
    let words = app.words();
    let sources = app.with(|lab| lab.sources.clone()).unwrap_or_default();
    let file = |file: Source| {
        let (name, text, copied) = (file.name.clone(), file.text.clone(), file.text.clone());
        let copy = button()
            .class("quiet")
            .attr("aria-label", format!("{}: {}", words.copy, file.name))
            .when(events::click, move |_| reading::copy(app.page, &copied))
            .child(words.copy);
        let save = button()
            .class("quiet")
            .attr("aria-label", format!("{}: {}", words.save_source, file.name))
            .when(events::click, move |_| browser::save_text(&name, "text/markdown", &text))
            .child(words.save_source);
        let actions = div().class("actions").child(copy).child(save);
        div()
            .class("file")
            .child(div().class("block-head").child(h3().child(file.name.clone())).child(actions))
            .child(pre().tabindex("0").attr("aria-label", file.name).child(code().child(file.text)))
    };
    div().class("source").child(note(words.source_intro)).child(diagnostics::remarks(app)).each(sources, file)
}

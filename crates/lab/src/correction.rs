//! The text of a document that does not run, to be corrected where its errors are shown.

use crate::app::App;
use crate::opening;
use document::page::Source;
use view::browser;
use view::views::*;
use web_sys::HtmlTextAreaElement;

/// A field for each file, and the button that checks them again. What has been typed stays, in another language too.
pub fn view(app: App, sources: Vec<Source>) -> HtmlDiv {
    let words = app.words();
    let drafts = app.with(|lab| lab.drafts.clone()).unwrap_or_default();
    let names: Vec<String> = sources.iter().map(|source| source.name.clone()).collect();
    let count = sources.len();
    let check = move |_| {
        let text = |number: usize| browser::by_id::<HtmlTextAreaElement>(&id(number)).map(|area| area.value());
        let sources = (0..count)
            .zip(&names)
            .filter_map(|(number, name)| Some(Source { name: name.clone(), text: text(number)? }));
        opening::check_again(app, sources.collect());
    };
    let save = move |_| save(app);
    let area = |(number, source): (usize, Source)| {
        let typed = drafts.get(number).cloned().unwrap_or(source.text);
        let mut area = textarea().id(id(number)).rows("18").attr("spellcheck", "false").autocomplete("off");
        let node: HtmlTextAreaElement = area.node();
        node.set_value(&typed);
        let keep = move |_| keep(app, number, &node.value());
        let area = area.when(events::input, keep);
        div().class("draft").child(label().r#for(id(number)).child(source.name)).child(area)
    };
    let actions = div()
        .class("actions")
        .child(button().class("primary").id("check-again").when(events::click, check).child(words.check_again))
        .child(button().class("quiet").when(events::click, save).child(words.save_source));
    div()
        .class("correction")
        .child(h3().child(words.correct))
        .child(note(words.correct_intro))
        .each(sources.into_iter().enumerate(), area)
        .child(actions)
}

fn id(number: usize) -> String {
    format!("draft-{number}")
}

/// Remembers what has been typed.
fn keep(app: App, number: usize, typed: &str) {
    app.with(|lab| {
        if lab.drafts.is_empty() {
            lab.drafts = lab.sources.iter().map(|source| source.text.clone()).collect();
        }
        if let Some(draft) = lab.drafts.get_mut(number) {
            typed.clone_into(draft);
        }
    });
}

/// Saves the text as it stands.
fn save(app: App) {
    let sources = app.with(|lab| lab.sources.clone()).unwrap_or_default();
    let drafts = app.with(|lab| lab.drafts.clone()).unwrap_or_default();
    for (number, source) in sources.iter().enumerate() {
        browser::save_text(&source.name, "text/markdown", drafts.get(number).unwrap_or(&source.text));
    }
}

/// Goes to a place in the text of a file, given in bytes of the text that was checked.
pub fn go_to(file: usize, start: usize) {
    let Some(area) = browser::by_id::<HtmlTextAreaElement>(&id(file)) else { return };
    let text = area.value();
    let line_start = text.get(..start.min(text.len())).map_or(0, |before| before.rfind('\n').map_or(0, |at| at + 1));
    let line_end = text.get(line_start..).and_then(|rest| rest.find('\n')).map_or(text.len(), |at| line_start + at);
    // The browser counts in UTF-16.
    let units = |bytes: usize| text.get(..bytes).map_or(0, |before| before.encode_utf16().count() as u32);
    let _ = area.focus();
    let _ = area.set_selection_range(units(line_start), units(line_end));
    // A selection is not scrolled to in every browser; lines are equally high and not wrapped.
    let lines = text.matches('\n').count().max(1) as f64;
    let line = text.get(..line_start).map_or(0, |before| before.matches('\n').count()) as f64;
    let height = f64::from(area.scroll_height()) / (lines + 1.0);
    area.set_scroll_top(((line - 4.0) * height).max(0.0) as i32);
}

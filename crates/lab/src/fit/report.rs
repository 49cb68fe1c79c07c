//! Saving a report with the data from which its values are computed again.

use crate::app::App;
use crate::documents::packing;
use crate::documents::visited::files;
use crate::verifying::recomputing;
use crate::verifying::sender::sender;
use class::verify::Recomputation;
use desk::Export;
use desk::document::page::Source;
use desk::saved::carried::{carry, carry_nothing};
use desk::saved::hand_in::{HandIn, Part};
use desk::saved::project::Project;
use units::words;
use view::browser;

/// Computes the values of a report again, and saves the page with them and its data. `all`: the report has all fits of the same
/// values.
pub fn save(app: App, id: u32, all: bool, file: Export) {
    let Ok(page) = String::from_utf8(file.bytes) else { return };
    let work = work(app, id, all);
    wasm_bindgen_futures::spawn_local(async move {
        let page = carrying(app, page, work).await;
        browser::save_bytes(&file.name, file.kind, page.as_bytes());
    });
}

/// The open document as it runs, its state, and what the fit follows from.
fn work(app: App, id: u32, all: bool) -> Project {
    let now = js_sys::Date::now() as u64;
    let (texts, state, items) = app.read_desk(|desk| {
        let document = desk.document();
        let texts: Vec<String> = std::iter::once(&document.source).chain(&document.translations).cloned().collect();
        (texts, desk.play().share(), desk::items_of_fit(desk, id, all, now))
    });
    let names = files(app).into_iter().map(|file| file.name);
    let names = names.chain((1..).map(|number| format!("{number}.md")));
    let documents = names.zip(texts).map(|(name, text)| Source { name, text }).collect();
    Project { documents, state, items }
}

async fn carrying(app: App, page: String, work: Project) -> String {
    let language = app.language.get_untracked();
    let (facts, left_out) = match Recomputation::begin(&work) {
        Ok(recomputation) => {
            let done = recomputing::finished(recomputation).await;
            let left_out = done.left_out().next().cloned();
            (done.facts(), left_out)
        }
        Err(why) => (Vec::new(), Some(why)),
    };
    if facts.iter().all(|fact| fact.part != Part::Fit) {
        // Without a reason, the record was too long to be stored.
        let why = left_out.unwrap_or_else(|| words("its data are too long"));
        let why = words!("This page does not carry its data, and cannot be verified: {why}.");
        return carry_nothing(&page, &why.text(language), language);
    }
    let sender = sender(app, String::new());
    let text = HandIn::new(js_sys::Date::now() as u64, sender, work, facts).of_page(&page, language).write();
    let packed = packing::zlib(text.as_bytes()).await.unwrap_or_else(|| text.into_bytes());
    carry(&page, &packed, language)
}

//! Hand-in of the work in this page, in the format of `saved::hand_in`: the document, the state, the answers, and the values that
//! follow from them. It is written without a library for JSON, which would be larger than this file.

use crate::{source, words};
use js_sys::JSON;
use play::{Answer, Attempt, Conditions, Fact, FactValue, Play, facts_of_answers, facts_of_run, name_of};
use program::{BITS, VERSION};
use view::views::*;
use view::{App, browser, page::handing, pieces::icons};
use wasm_bindgen::JsValue;
use web_sys::HtmlDialogElement;

/// Id of the dialog.
const ID: &str = "hand-in-dialog";

/// Version of the format of hand-ins, of projects, and of items.
const VERSIONS: [u32; 3] = [2, 1, 3];

/// Button of the header; empty if the page does not contain its document.
pub fn button_of(app: App) -> View {
    if source::files().is_empty() {
        return View::new();
    }
    let open = move |_| {
        if let Some(dialog) = browser::by_id::<HtmlDialogElement>(ID) {
            let _ = dialog.show_modal();
        }
    };
    labelled(icons::up(), app.words().hand_in)
        .id("hand-in")
        .attr("aria-haspopup", "dialog")
        .when(events::click, open)
        .into()
}

/// The dialog with the form.
pub fn dialog(app: App) -> View {
    let form = handing::form(app, move |name, done| {
        let (file, text, count) = app.read(|play| made(play, &name)).unwrap_or_default();
        browser::save_text(&file, "application/json", &text);
        done(handing::saved(app, &file, count));
    });
    let words = words::of(app);
    let content = div().class("publishing").child(note(words.hand_in_intro)).child(form);
    view::views::dialog(ID, "hand-in-title", app.words().hand_in, words.close).child(content).into()
}

/// Name and text of the file, and the number of its values. The values are computed again from the state, as they are when the
/// file is verified.
fn made(play: &mut Play, name: &str) -> Option<(String, String, usize)> {
    let files = source::files();
    let (first, text) = files.first()?;
    let state = play.share();
    let mut again = Play::open(play.program().clone());
    // Parts that cannot be restored are missing when the file is verified, too.
    let _ = again.restore(&state);
    let saved = play.answers().saved(play.basis());
    for (question, answer) in &saved {
        again.change_answers(|answers, run| answers.restore(run, question, answer));
    }
    let facts = [facts_of_run(&again, name_of(&[text])), facts_of_answers(&again)];
    let count = facts.iter().map(Vec::len).sum();
    let facts =
        facts.iter().zip(["run", "answer"]).flat_map(|(facts, part)| facts.iter().map(move |one| fact(part, one)));
    let (seat, assignment) = play.basis().seat().map_or((None, String::new()), |seat| (seat.number, seat.assignment));
    let seat = seat.map_or_else(String::new, |seat| format!(",\"seat\":{seat},\"assignment\":{}", quoted(&assignment)));
    let now = js_sys::Date::now();
    let items = saved.iter().map(|(question, answer)| item(question, answer, now));
    let documents = files.iter().map(|(name, text)| format!("{{\"name\":{},\"text\":{}}}", quoted(name), quoted(text)));
    let [version, project, _] = VERSIONS;
    let written = format!(
        "{{\"meniscus hand-in\":{version},\"program\":{},\"bits\":{BITS},\"made\":{now},\"sender\":{{\"name\":{}{seat}}},\
         \"work\":{{\"meniscus project\":{project},\"documents\":{},\"state\":{},\"items\":{}}},\"facts\":{}}}",
        quoted(VERSION),
        quoted(name),
        list(documents),
        quoted(&state),
        list(items),
        list(facts),
    );
    let stem = first.split('.').next().filter(|stem| !stem.is_empty()).unwrap_or("work");
    Some((format!("{stem}.hand-in"), written, count))
}

/// An answer as an item of a project. `now`: time of storage, in milliseconds.
fn item(question: &str, answer: &Answer, now: f64) -> String {
    let attempt = |one: &Attempt| {
        let conditions = one.conditions.as_ref().map_or_else(String::new, |Conditions { language, values }| {
            let values = values.iter().map(|(name, value)| format!("[{},{}]", quoted(name), number(*value)));
            format!(",\"language\":{},\"values\":{}", quoted(language), list(values))
        });
        format!("{{\"typed\":{},\"grade\":\"{}\"{conditions}}}", quoted(&one.typed), one.grade.code())
    };
    let shown = answer.shown.map_or_else(String::new, |before| format!(",\"shown\":{before},\"revealed\":true"));
    let grade = answer.grade.map_or_else(String::new, |grade| format!(",\"grade\":\"{}\"", grade.code()));
    format!(
        "{{\"name\":{},\"item\":{{\"meniscus\":{},\"since\":{now},\"item\":{{\"answer\":{{\"typed\":{}{grade}{shown},\
         \"attempts\":{}}}}}}}}}",
        quoted(question),
        VERSIONS[2],
        quoted(&answer.typed),
        list(answer.attempts.iter().map(attempt)),
    )
}

fn fact(part: &str, fact: &Fact) -> String {
    let value = match &fact.value {
        FactValue::Number(value) => format!("\"number\":{}", number(*value)),
        FactValue::Text(text) => format!("\"text\":{}", quoted(text)),
    };
    format!("{{\"part\":\"{part}\",\"item\":{},\"quantity\":{},{value}}}", quoted(&fact.item), quoted(&fact.quantity))
}

/// A number as JSON, which has no infinities and NaN.
fn number(value: f64) -> String {
    if value.is_finite() { format!("{value:e}") } else { format!("\"{value}\"") }
}

/// A text as JSON.
fn quoted(text: &str) -> String {
    JSON::stringify(&JsValue::from(text)).map(String::from).unwrap_or_default()
}

/// Parts as a list in JSON.
fn list(parts: impl Iterator<Item = String>) -> String {
    format!("[{}]", parts.collect::<Vec<_>>().join(","))
}

//! Tab *Measure*: fits, records and their analysis cycle by cycle, and the ways to another record. Without records, these ways
//! come first.

use crate::app::App;
use crate::measuring::intake::{self, refuse};
use crate::{film, fit, library, measuring::cycles, measuring::files, measuring::records, measuring::virtual_form};
use desk::SAMPLES;
use view::browser;
use view::panel::tabs;
use view::views::*;
use web_sys::{File, HtmlInputElement, HtmlTextAreaElement};

/// Content of the tab.
pub fn view(app: App) -> HtmlDiv {
    let has_records = memo(move || {
        app.records.track();
        app.read_desk(|desk| !desk.records().list().is_empty())
    });
    let has_film = memo(move || app.films.open.get());
    div()
        .class("measurements")
        .child(film::acts::view(app))
        .child(intake::view(app))
        // Not a live region: the line of messages has already announced it.
        .child(
            p().class("refusal")
                .id("record-refusal")
                .child(text(move || app.record_refusal.get_clone().unwrap_or_default())),
        )
        .child(intake::dates_view(app))
        .child(fit::view(app))
        .child(records::view(app))
        .child(cycles::view(app))
        .child(changing(move || ways_in(app, has_records.get() || has_film.get())))
        .child(virtual_form::view(app))
        .child(film::virtual_camera(app))
}

/// Ways to a record: the sample film and a sample, where they can be measurements of the document, a file, and folded all others.
fn ways_in(app: App, has_begun: bool) -> View {
    let words = app.words();
    let mut input = input().r#type("file");
    let node: HtmlInputElement = input.node();
    let chosen = node.clone();
    let read = move |_| {
        if let Some(files) = chosen.files() {
            files::open(app, &files);
        }
        chosen.set_value("");
    };
    let input = input
        .id("record-file")
        .hidden(true)
        .multiple(true)
        .attr("aria-label", words.choose_record)
        .when(events::change, read);
    let way = |id: &'static str, name: &'static str, about: String| {
        button().class("way-in").id(id).child(strong().child(name)).child(span().child(about))
    };
    let mut samples: Vec<(usize, String)> = samples(app).into_iter().enumerate().collect();
    let take = move |number: usize| move |_| sample(app, number);
    let our_film = (!samples.is_empty()).then(|| {
        way("open-sample", words.sample_film, words.sample_film_about.to_owned())
            .when(events::click, move |_| film::open_sample(app))
    });
    let first = (!samples.is_empty()).then(|| samples.remove(0));
    let ways = div()
        .class("ways")
        .maybe(our_film)
        .child(
            way("choose-record", words.choose_record, words.choose_record_about.to_owned())
                .when(events::click, move |_| node.click()),
        )
        .maybe(first.map(|(number, name)| {
            way("sample-record", words.sample_record, name).title(words.sample_title).when(events::click, take(number))
        }));
    let chip =
        |(number, name)| button().class("chip").title(words.sample_title).when(events::click, take(number)).child(name);
    let further = (!samples.is_empty()).then(|| {
        div()
            .class("chips")
            .role("group")
            .attr("aria-label", words.sample_records)
            .child(span().class("note").attr("aria-hidden", "true").child(words.sample_records))
            .each(samples, chip)
    });
    let others = details()
        .class("paste")
        .id("other-ways")
        .child(summary().child(words.other_ways))
        .child(div().class("intake").child(film::camera_button(app)))
        .maybe(further)
        .child(pasted(app));
    let title = if has_begun { words.another_record } else { words.measurements_title };
    let intro = (!has_begun).then(|| note(words.measurements_intro));
    View::from((
        h3().id("another-record").child(title),
        ways,
        input,
        film::acts::warning(app),
        intro.map_or_else(View::new, View::from),
        others,
    ))
}

/// A table typed or pasted as text.
fn pasted(app: App) -> HtmlDiv {
    let words = app.words();
    let read = move |_| {
        if let Some(area) = browser::by_id::<HtmlTextAreaElement>("paste-record")
            && add(app, words.paste_name, area.value().as_bytes())
        {
            area.set_value("");
        }
    };
    div()
        .child(label().r#for("paste-record").child(words.paste_label))
        .child(textarea().id("paste-record").rows("6").attr("spellcheck", "false").autocomplete("off"))
        .child(button().class("primary").id("read-record").when(events::click, read).child(words.read_record))
}

/// Names of the sample records; none where they cannot be measurements of the document.
fn samples(app: App) -> Vec<String> {
    let names = || SAMPLES.each_ref().map(|sample| sample.name(app.language.get_untracked())).to_vec();
    if fits_samples(app) { names() } else { Vec::new() }
}

/// True if the sample records, which are of liquid columns, can be measurements of the open document: of a document that the page
/// carries, if it is about such a column.
fn fits_samples(app: App) -> bool {
    let files = app.with(|lab| lab.sources.first().map(|file| file.name.clone())).flatten().unwrap_or_default();
    let is_column = |file: &str| file.starts_with("theories/") || file.starts_with("tube") || file.starts_with("utube");
    is_column(&files) || library::find(&files).is_none()
}

/// Adds a sample record.
pub fn sample(app: App, number: usize) {
    let file = SAMPLES.get(number).map_or("", |sample| sample.file);
    let theory = library::theories().into_iter().find(|entry| entry.file() == file).and_then(|entry| entry.open());
    if let Some(theory) = theory {
        refuse(
            app,
            app.attempt_on_desk(|desk| {
                desk.change_records(|records, open| records.add_sample(open, number, theory)).map(|_| ())
            }),
        );
    }
}

/// Adds a record and opens the tab, or shows why it could not be read. Returns true if it was added.
fn add(app: App, name: &str, bytes: &[u8]) -> bool {
    let mut asks_dates = false;
    let refusal = app.attempt_on_desk(|desk| {
        let added = desk.add_record(name, bytes).map(|_| ());
        added.inspect_err(|refusal| asks_dates = refusal.asks_dates())
    });
    let added = refusal.is_none();
    app.undated.set(Vec::new());
    if asks_dates
        && let Ok(file) = File::new_with_u8_slice_sequence(&js_sys::Array::of1(&js_sys::Uint8Array::from(bytes)), name)
    {
        intake::ask_dates(app, file);
    }
    refuse(app, refusal);
    app.tab.set(tabs::MEASURE);
    added
}

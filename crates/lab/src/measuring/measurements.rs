//! Tab *Measure*: fits, records and their analysis cycle by cycle, and the ways to another record. Without records, these ways
//! come first.

use crate::app::App;
use crate::measuring::intake::{self, refuse};
use crate::{film, fit, library, measuring::cycles, measuring::records, measuring::virtual_form};
use desk::SAMPLES;
use view::panel::tabs;
use view::views::*;
use view::{browser, pieces::icons};
use web_sys::{File, HtmlInputElement, HtmlTextAreaElement};

/// Content of the tab.
pub fn view(app: App) -> HtmlDiv {
    let words = app.words();
    let has_records = memo(move || {
        app.records.track();
        app.read_desk(|desk| !desk.records().list().is_empty())
    });
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
        .child(changing(move || match has_records.get() {
            true => h3().id("another-record").child(words.another_record).into(),
            false => View::from(note(words.measurements_intro)),
        }))
        .child(ways_in(app))
        .child(film::virtual_camera(app))
        .child(virtual_form::view(app))
}

/// Inputs for records: a file, a pasted table.
fn ways_in(app: App) -> View {
    let words = app.words();
    let mut input = input().r#type("file");
    let node: HtmlInputElement = input.node();
    let chosen = node.clone();
    let read = move |_| {
        if let Some(area) = browser::by_id::<HtmlTextAreaElement>("paste-record")
            && add(app, words.paste_name, area.value().as_bytes())
        {
            area.set_value("");
        }
    };
    let names =
        app.read_desk(|desk| SAMPLES.each_ref().map(|sample| sample.name(desk.play().basis().language())).to_vec());
    let choose = |(number, name): (usize, String)| {
        button().class("chip").when(events::click, move |_| sample(app, number)).child(name)
    };
    let read_chosen = move |_| {
        if let Some(files) = chosen.files() {
            intake::read(app, (0..files.length()).filter_map(|index| files.get(index)).collect());
        }
        chosen.set_value("");
    };
    let open =
        labelled(icons::folder(), words.choose_record).id("choose-record").when(events::click, move |_| node.click());
    let input = input
        .id("record-file")
        .hidden(true)
        .multiple(true)
        .attr("aria-label", words.choose_record)
        .when(events::change, read_chosen);
    let samples = div()
        .class("chips")
        .hidden(!fits_samples(app))
        .role("group")
        .attr("aria-label", words.sample_records)
        .title(words.sample_title)
        .child(span().class("note").attr("aria-hidden", "true").child(words.sample_records))
        .each(names.into_iter().enumerate(), choose);
    let paste = details()
        .class("paste")
        .child(summary().child(words.paste_record))
        .child(label().r#for("paste-record").child(words.paste_label))
        .child(textarea().id("paste-record").rows("6").attr("spellcheck", "false").autocomplete("off"))
        .child(button().class("primary").id("read-record").when(events::click, read).child(words.read_record));
    View::from((div().class("intake").child(film::acts::way_in(app)).child(open).child(input).child(samples), paste))
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

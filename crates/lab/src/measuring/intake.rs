//! Reading files as records: one after the other, in slices between which the page reacts, with a progress bar and a
//! cancel button.

use crate::app::App;
use crate::film;
use desk::{DateOrder, Gathering, LONGEST_RECORD, RecordProgress, Refusal};
use view::page::message::Message;
use view::panel::tabs;
use view::views::*;
use view::{browser, page::messages};
use web_sys::File;

/// Duration of a slice, in milliseconds: half a frame, because its last part can take longer.
const SLICE: f64 = 8.0;
/// Number of bytes read at once; a slice consists of several such reads.
const BUDGET: usize = 64 << 10;

/// Progress bar while a file is being read.
pub fn view(app: App) -> View {
    let name = memo(move || app.record_progress.with(|now| now.as_ref().map(|now| now.name.clone())));
    // The name is copied first: no view may be built while a signal is borrowed.
    changing(move || name.get_clone().map_or_else(View::new, |name| bar(app, &name)))
}

fn bar(app: App, name: &str) -> View {
    let words = app.words();
    let title = format!("{} {name}", words.reading_record);
    let percent = move || {
        let part = app.record_progress.with(|now| now.as_ref().map_or(0.0, |now| now.part));
        (100.0 * part).floor().to_string()
    };
    let name = name.to_owned();
    let cancel = move |_| {
        app.act_on_desk(|desk| desk.change_records(|records, _| records.cancel(&name)));
        app.record_progress.set(None);
        browser::focus("choose-record");
    };
    div()
        .class("intake")
        .child(
            tags::progress().id("reading").attr("aria-label", title.clone()).max("100").value(move || Some(percent())),
        )
        .child(span().class("note").child(text(move || format!("{title}: {} %", percent()))))
        .child(button().class("quiet").id("cancel-reading").when(events::click, cancel).child(words.cancel_reading))
        .into()
}

/// Question for the order of day and month of each file that has open dates.
pub fn dates_view(app: App) -> View {
    changing(move || {
        View::from(app.undated.get_clone().into_iter().map(|file| question(app, file)).collect::<Vec<_>>())
    })
}

fn question(app: App, file: File) -> View {
    let words = app.words();
    let title = format!("{} {}", file.name(), words.dates_asked);
    let choice = |order: DateOrder| {
        let file = file.clone();
        let choose = move |_| {
            let others = app.undated.with(|all| all.iter().filter(|other| **other != file).cloned().collect());
            app.undated.set(others);
            queue(app, [(file.clone(), Some(order))]);
            browser::focus("choose-record");
        };
        let name = match order {
            DateOrder::DayFirst => words.day_first,
            DateOrder::MonthFirst => words.month_first,
        };
        button().class("chip").attr("data-dates", order.code()).when(events::click, choose).child(name)
    };
    div()
        .class("intake dates")
        .role("group")
        .attr("aria-label", title.clone())
        .child(span().attr("aria-hidden", "true").child(title))
        .each(DateOrder::ALL, choice)
        .into()
}

/// Asks for the order of day and month in a file that was refused.
pub fn ask_dates(app: App, file: File) {
    app.undated.update(|files| files.push(file));
}

/// Appends files to the queue of files to be read as records.
pub fn read(app: App, files: Vec<File>) {
    app.undated.set(Vec::new());
    queue(app, files.into_iter().map(|file| (file, None)));
}

fn queue(app: App, files: impl IntoIterator<Item = (File, Option<DateOrder>)>) {
    let begins = app.with(|lab| {
        lab.files.extend(files);
        !lab.files.is_empty() && !std::mem::replace(&mut lab.reading, true)
    });
    if begins.unwrap_or_default() {
        wasm_bindgen_futures::spawn_local(async move {
            let earlier = messages::errors(app.page);
            let mut all_read = true;
            while let Some((file, dates)) = app.with(|lab| lab.files.pop_front()).flatten() {
                let refusal = read_file(app, &file, dates, all_read.then_some(&*earlier)).await;
                app.record_progress.set(None);
                all_read &= refusal.is_none();
                refuse(app, refusal);
                app.tab.set(tabs::MEASURE);
            }
            app.with(|lab| lab.reading = false);
        });
    }
}

/// Reads one file. Returns the reason if it could not be read. `earlier`: errors that were shown when the
/// queue began, which are removed when the file has been read; `None` if a file before it in the queue was refused. An error
/// raised meanwhile stays.
async fn read_file(app: App, file: &File, dates: Option<DateOrder>, earlier: Option<&[Message]>) -> Option<String> {
    let name = file.name();
    refuse(app, None);
    app.record_progress.set(Some(RecordProgress { name: name.clone(), part: 0.0 }));
    app.tab.set(tabs::MEASURE);
    app.say(format!("{} {name}", app.words().reading_record));
    let gathered = gathered(file).await;
    let given_up = || app.record_progress.with_untracked(Option::is_none);
    // Cancelled while the browser was reading the file.
    if given_up() {
        return None;
    }
    let begun = match gathered {
        Some(gathering) => {
            app.read_desk(|desk| Some(desk.change_records(|records, _| records.begin_project(&name, gathering))))
        }
        None => Some(Ok(false)),
    };
    let mut refusal = match begun {
        Some(Ok(true)) => None,
        Some(Err(why)) => app.attempt_on_desk(|_| Err(why)),
        // Too large files are refused without reading them.
        _ if file.size() > LONGEST_RECORD as f64 => {
            app.attempt_on_desk(|_| Err(Refusal::RecordTooLong { most: LONGEST_RECORD >> 20 }))
        }
        _ => {
            let Ok(buffer) = browser::wait(file.array_buffer()).await else {
                return Some(format!("{} {name}", app.words().file_not_read));
            };
            if given_up() {
                return None;
            }
            let bytes = js_sys::Uint8Array::new(&buffer).to_vec();
            app.attempt_on_desk(|desk| desk.change_records(|records, open| records.begin(open, &name, bytes, dates)))
        }
    };
    let mut asks_dates = false;
    while refusal.is_none() && app.read_desk(|desk| desk.records().progress().is_some()) {
        browser::breathe().await;
        let end = js_sys::Date::now() + SLICE;
        refusal = app.read_desk(|desk| {
            loop {
                if let Err(refusal) = desk.advance_record(BUDGET) {
                    asks_dates = refusal.asks_dates();
                    return Some(refusal.text(desk.play()));
                }
                // To add a long record takes a slice of its own.
                if desk.records().progress().is_none() || desk.records().is_read() || js_sys::Date::now() >= end {
                    return None;
                }
            }
        });
        let progress = app.read_desk(|desk| desk.records().progress());
        if progress.is_some() {
            app.record_progress.set(progress);
        }
    }
    // The views of the new record are built in a separate slice.
    browser::breathe().await;
    app.act(|_| ());
    if asks_dates {
        ask_dates(app, file.clone());
    }
    if refusal.is_none() {
        messages::forget(app.page, earlier.unwrap_or_default());
        film::open_of_project(app, file).await;
    }
    refusal
}

/// Parts of an archive needed for a Tracker project. The archive may contain a large film and is not read completely.
/// `None` for other files.
async fn gathered(file: &File) -> Option<Gathering> {
    let name = file.name().to_lowercase();
    if ![".trz", ".zip"].iter().any(|ending| name.ends_with(ending)) {
        return None;
    }
    let mut gathering = desk::gathering(file.size() as u64);
    while let Some(range) = gathering.wanted() {
        let part = file.slice_with_f64_and_f64(range.start as f64, range.end as f64).ok()?;
        let buffer = browser::wait(part.array_buffer()).await.ok()?;
        gathering.supply(js_sys::Uint8Array::new(&buffer).to_vec());
    }
    Some(gathering)
}

/// Shows the reason why a record was refused, in the line of messages and beside the input of records; `None` clears
/// it.
pub fn refuse(app: App, refusal: Option<String>) {
    if let Some(why) = &refusal {
        app.complain(why.clone());
    }
    app.record_refusal.set(refusal);
}

//! The tab of measured data: records come in, are looked at, and are fitted.

use crate::app::App;
use crate::{browser, cycles, fitting, icons, library, records, virtual_form};
use leptos::html;
use leptos::prelude::*;
use web_sys::{File, FileList, HtmlTextAreaElement};

/// The tab.
pub fn view(app: App) -> AnyView {
    let words = app.words();
    view! {
        <div class="measurements">
            <p class="note">{words.measurements_intro}</p>
            {intake(app)}
            <p class="refusal" role="alert" id="record-refusal">{move || app.record_refusal.get()}</p>
            {records::view(app)}
            {cycles::view(app)}
            {fitting::view(app)}
            {virtual_form::view(app)}
        </div>
    }
    .into_any()
}

/// The ways in: a file, a pasted table.
fn intake(app: App) -> AnyView {
    let words = app.words();
    let input = NodeRef::<html::Input>::new();
    let read = move |_| {
        if let Some(area) = browser::by_id::<HtmlTextAreaElement>("paste-record")
            && add(app, words.paste_name, area.value().as_bytes())
        {
            area.set_value("");
        }
    };
    let samples: Vec<AnyView> = app
        .read(|session| session.sample_names().to_vec())
        .into_iter()
        .enumerate()
        .map(|(number, name)| {
            view! { <button type="button" class="chip" on:click=move |_| sample(app, number)>{name}</button> }
                .into_any()
        })
        .collect();
    view! {
        <div class="intake">
            <button type="button" class="quiet with-icon" id="choose-record" on:click=move |_| if let Some(input) = input.get_untracked() { input.click() }>
                {icons::folder()}<span>{words.choose_record}</span>
            </button>
            <input node_ref=input type="file" id="record-file" hidden multiple aria-label=words.choose_record
                on:change=move |_| if let Some(input) = input.get_untracked() {
                    if let Some(files) = input.files() { read_files(app, &files); }
                    input.set_value("");
                } />
            <div class="chips" role="group" aria-label=words.sample_records title=words.sample_title>
                <span class="note" aria-hidden="true">{words.sample_records}</span>{samples}
            </div>
        </div>
        <details class="paste">
            <summary>{words.paste_record}</summary>
            <label for="paste-record">{words.paste_label}</label>
            <textarea id="paste-record" rows="6" spellcheck="false" autocomplete="off"></textarea>
            <button type="button" class="primary" id="read-record" on:click=read>{words.read_record}</button>
        </details>
    }
    .into_any()
}

/// Adds a sample record.
fn sample(app: App, number: usize) {
    let file = session::SAMPLES.get(number).map_or("", |sample| sample.file);
    let theory = library::theories().into_iter().find(|entry| entry.file() == file).and_then(|entry| entry.open());
    if let Some(theory) = theory {
        app.record_refusal.set(app.attempt(|session| session.add_sample(number, theory).map(|_| ())));
    }
}

/// Reads files as records.
pub fn read_files(app: App, files: &FileList) {
    let files = (0..files.length()).filter_map(|index| files.get(index)).collect();
    leptos::task::spawn_local(async move { read_all(app, files).await });
}

/// The same for files in hand.
pub async fn read_all(app: App, files: Vec<File>) {
    for file in files {
        let name = file.name();
        // What is too large is refused unread.
        let bytes = if file.size() > session::LONGEST_RECORD as f64 {
            vec![0; session::LONGEST_RECORD + 1]
        } else {
            let Ok(buffer) = browser::wait(file.array_buffer()).await else { continue };
            js_sys::Uint8Array::new(&buffer).to_vec()
        };
        add(app, &name, &bytes);
    }
}

/// Adds a record and shows it, or says why it could not be read. Whether it was added.
fn add(app: App, name: &str, bytes: &[u8]) -> bool {
    let refusal = app.attempt(|session| session.add_record(name, bytes).map(|_| ()));
    let added = refusal.is_none();
    app.record_refusal.set(refusal);
    app.tab.set(app.measurements_tab.get_untracked());
    added
}

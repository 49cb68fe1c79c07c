//! Hand-ins that are chosen or dropped, also as folders.

use super::folder::files_in;
use super::{survey, window, words};
use crate::app::App;
use crate::documents::visited;
use crate::verifying::reading::read;
use class::collection::Collection;
use desk::saved::hand_in::{HAND_IN_ENDING, HandInError};
use desk::saved::survey::SHEET_ENDING;
use std::collections::VecDeque;
use units::order::sort_by_key;
use view::browser;
use view::views::*;
use web_sys::{File, FileSystemEntry, HtmlInputElement};

/// Number of files that the browser reads ahead.
const AHEAD: usize = 64;
/// Duration of a slice of the reading, in milliseconds.
const SLICE: f64 = 25.0;

/// True if a file is a hand-in, by the ending of its name.
pub fn is_hand_in(file: &File) -> bool {
    file.name().to_lowercase().ends_with(HAND_IN_ENDING)
}

/// Reads hand-ins into the dashboard, which opens, and computes them.
pub async fn add(app: App, files: Vec<File>) {
    window::open(app);
    read_all(app, files, false).await;
}

/// Reads files, several at a time, and begins to compute them. Returns the number of hand-ins.
async fn read_all(app: App, files: Vec<File>, is_of_folder: bool) -> usize {
    app.class.refuse("");
    app.class.offer_document(visited::files(app));
    let (mut files, mut ahead, mut taken) = (files.into_iter(), VecDeque::new(), 0);
    let mut end = js_sys::Date::now() + SLICE;
    loop {
        ahead.extend(files.by_ref().take(AHEAD - ahead.len()).map(|file| (file.name(), read(&file))));
        let Some((name, content)) = ahead.pop_front() else { break };
        let content = content.await.unwrap_or(Err(HandInError::Damaged));
        taken += usize::from(app.class.add(&name, content, is_of_folder));
        if js_sys::Date::now() > end {
            browser::breathe().await;
            app.class.show_sometimes().await;
            end = js_sys::Date::now() + SLICE;
        }
    }
    app.class.show().await;
    app.class.compute();
    taken
}

/// Reads the hand-ins of dropped folders, and the reports that carry one; a message if there are none.
pub async fn add_of_folders(app: App, folders: Vec<FileSystemEntry>) {
    let files = files_in(folders).await;
    choose(app, files, true).await;
}

/// Adds the hand-ins, the reports and the answers to surveys among files; a message if there are none.
async fn choose(app: App, files: Vec<File>, is_of_folder: bool) {
    let (sheets, mut files): (Vec<File>, Vec<File>) = files.into_iter().partition(survey::is_sheet);
    let has_sheets = !sheets.is_empty();
    if has_sheets {
        window::open(app);
        survey::add(app, sheets).await;
    }
    files.retain(|file| Collection::is_candidate(&file.name()));
    sort_by_key(&mut files, File::name);
    if !files.is_empty() {
        // The dashboard opens at once if there are hand-ins, and for reports when one of them carries its data.
        if files.iter().any(is_hand_in) {
            window::open(app);
        }
        if read_all(app, files, is_of_folder).await > 0 {
            return window::open(app);
        }
    }
    if has_sheets {
        return;
    }
    let why = words::of(app).no_hand_in;
    if !app.class.refuse(why) {
        app.complain(why.to_owned());
    }
}

/// Button that lets the user choose files, or a folder.
pub fn choice(app: App, id: &'static str, label: &'static str, is_folder: bool) -> View {
    let mut input = input().r#type("file");
    let node: HtmlInputElement = input.node();
    let chosen = node.clone();
    let read = move |_| {
        let list = chosen.files();
        let all = list.iter().flat_map(|files| (0..files.length()).filter_map(|index| files.get(index)));
        let files: Vec<File> = all.collect();
        chosen.set_value("");
        wasm_bindgen_futures::spawn_local(choose(app, files, is_folder));
    };
    let input = input
        .id(format!("{id}-files"))
        .hidden(true)
        .multiple(true)
        .attr("aria-label", label)
        .attr("webkitdirectory", is_folder.then_some(""))
        .when(events::change, read);
    let input = if is_folder { input } else { input.accept([HAND_IN_ENDING, SHEET_ENDING, ".html", ".htm"].join(",")) };
    View::from((button().class("quiet").id(id).when(events::click, move |_| node.click()).child(label), input))
}
